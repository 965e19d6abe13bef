#pragma once

#include <optional>

#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// The same scenario with built-in shapes of about so many triangles where they have far more; nothing where none has,
/// or where a wall is read from a file and stays as it is.
std::optional<Scenario> coarse_scenario(const Scenario& scenario, int triangles);

}  // namespace thinwall
