#pragma once

#include "engine/equilibrium/Equilibrium.hpp"
#include "engine/wall/MembraneLanes.hpp"

namespace thinwall {

/// A triangle of a body's wall at a position, (unknowns), metres, with what it remembers. What is given outlives it.
inline MembraneTriangle wall_triangle(const BodyModel& model, const WallMemory& memory, const Eigen::VectorXd& position,
                                      int triangle) {
  MembraneTriangle made{.rest = &model.rest[triangle],
                        .material = &model.material(triangle),
                        .corners = corners_of(model.surface[triangle], position),
                        .memory = memory.of(triangle)};
  made.memory.tension_field = model.definition.tension_field;
  made.memory.slack_stiffness = model.slack_stiffness;
  return made;
}

}  // namespace thinwall
