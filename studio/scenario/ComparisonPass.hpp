#pragma once

#include "studio/scenario/CheckedValue.hpp"
#include "studio/scenario/Diagnostics.hpp"
#include "studio/scenario/ParameterPass.hpp"
#include "studio/scenario/TextNode.hpp"

namespace thinwall {

/// Makes a scenario the second one of its `comparison`: each of `comparison.set` names a parameter (`thickness`) or the
/// path of a value (`bodies.organ.wall.thickness`, `timeline[1].palpate.depth`) and gives it another value. A last key
/// that is not there is added. Errors: a parameter or a place that the scenario does not have.
void change_for_comparison(TextNode& root, Diagnostics& diagnostics);

/// The overrides that a comparison leaves to its second scenario: not those of parameters that it sets itself.
Overrides overrides_for_comparison(const Overrides& overrides, const CheckedValue& comparison);

/// The halves of the pictures belong to the two takes: no cut may put another camera beside.
void comparison_lint(const CheckedValue& root, Diagnostics& diagnostics);

}  // namespace thinwall
