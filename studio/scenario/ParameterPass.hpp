#pragma once

#include <string>
#include <utility>
#include <vector>

#include "studio/scenario/Diagnostics.hpp"
#include "studio/scenario/TextNode.hpp"

namespace thinwall {

/// Values from the command line: `--set name=value`.
using Overrides = std::vector<std::pair<std::string, std::string>>;

/// Puts the overrides into `parameters` and fills in each `${name}` of all values: a value that is `${name}` and
/// nothing else becomes the parameter's value, text or list; inside a longer text it becomes its text. Parameters may
/// use each other. An override that begins with `[` is read as a list. Errors: unknown names, cycles, a parameter that
/// nothing uses, an override without a parameter or given twice.
void parameter_pass(TextNode& root, const Overrides& overrides, Diagnostics& diagnostics);

}  // namespace thinwall
