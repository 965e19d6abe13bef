#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "engine/equilibrium/BodyModel.hpp"

namespace thinwall {

/// A few vertices of a membrane that move while all others are held.
struct WallPatch {
  std::vector<char> has;       // (vertices), whether the vertex is in it
  std::vector<int> unknowns;   // those of its vertices that are not fixed, ascending
  std::vector<int> number;     // (unknowns of the body), place in `unknowns`; -1: none
  std::vector<int> triangles;  // of the wall, with a vertex in it, ascending
};

/// The vertices within two rings of triangles around those on which most of a force, (unknowns), newton, is left.
/// `held`: (vertices), those that stay where they are. Nothing where the force is spread over many vertices, or those
/// around them are many or no small part of the wall.
std::optional<WallPatch> patch_around(const BodyModel& model, const Eigen::VectorXd& force, std::span<const char> held);

}  // namespace thinwall
