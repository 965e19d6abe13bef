// What keeps a shell's triangles from being folded through each other.

#include <algorithm>
#include <cmath>

#include "engine/equilibrium/Newton.hpp"
#include "engine/shell/HingeAngle.hpp"

namespace thinwall {
namespace {

/// Growth of the angle between two neighbours, radians, in a solution of a shell without line search that only a step
/// gone astray makes: past any energy it ends up with triangles folded over.
constexpr double kMostFolding = 1.5;

Hinge hinge_at(const std::array<int, 4>& vertices, const Eigen::VectorXd& position) {
  Hinge hinge;
  for (int k = 0; k < 4; ++k) hinge[k] = position.segment<3>(3 * vertices[k]);
  return hinge;
}

}  // namespace

std::vector<std::array<int, 4>> Newton::hinges_of(const BodyModel& model) {
  std::vector<std::array<int, 4>> hinges;
  for (const BendingRest& rest : model.bending) {
    for (int side = 0; side < 3; ++side) {
      const BendingSide& own = rest.sides[side];
      // One of both triangles at a side stands for it; beyond a clamped or a free one there is none.
      if (own.share == 0 || own.turn_share <= 0) continue;
      const auto& vertices = rest.vertices;
      hinges.push_back({vertices[side], vertices[(side + 1) % 3], vertices[(side + 2) % 3], vertices[3 + side]});
    }
  }
  return hinges;
}

bool Newton::folds_over(const Eigen::VectorXd& before, const Eigen::VectorXd& after) const {
  return std::ranges::any_of(hinges_, [&](const std::array<int, 4>& hinge) {
    const double grown = std::abs(hinge_angle(hinge_at(hinge, after))) - std::abs(hinge_angle(hinge_at(hinge, before)));
    return grown > kMostFolding;
  });
}

double Newton::safe_fraction(const Eigen::VectorXd& position, const Eigen::VectorXd& motion) {
  double fraction = self_contact_.safe_fraction(position, motion);
  for (const std::array<int, 4>& hinge : hinges_) {
    const Hinge from = hinge_at(hinge, position);
    if (!is_folded_back(from)) continue;
    const Hinge way = hinge_at(hinge, motion);
    const auto after = [&](double part) {
      Hinge to;
      for (int k = 0; k < 4; ++k) to[k] = from[k] + part * way[k];
      return to;
    };
    while (fraction > 0 && passes_through(from, after(fraction))) fraction *= 0.5;
  }
  return fraction;
}

}  // namespace thinwall
