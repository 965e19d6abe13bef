#pragma once

#include <optional>

#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// The same scenario with built-in shapes of about so many triangles where they have far more; nothing where none has,
/// or where a wall is read from a file and stays as it is.
std::optional<Scenario> coarse_scenario(const Scenario& scenario, int triangles);

/// How many triangles a coarse wall may have that answers within `limit`, seconds, where one of `triangles` took
/// `duration`, seconds: never more than those, and never so few that the force is that of single triangles.
int affordable_triangles(int triangles, double duration, double limit);

}  // namespace thinwall
