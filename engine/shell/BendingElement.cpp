#include "engine/shell/BendingElement.hpp"

#include "engine/shell/HingeAngle.hpp"

namespace thinwall {
namespace {

/// The triangle and what lies beyond one of its sides: the neighbour, or the plane that holds a clamped side, which
/// goes with the side.
Hinge hinge_at(const BendingRest& rest, const BendingPatch& patch, int side) {
  const Eigen::Vector3d &p = patch.position[side], &q = patch.position[(side + 1) % 3];
  const BendingSide& own = rest.sides[side];
  const Eigen::Vector3d beyond = own.clamped ? (0.5 * (p + q) + own.held).eval() : patch.position[3 + side];
  return {p, q, patch.position[(side + 2) % 3], beyond};
}

/// Derivatives of the angle at a side by the patch's positions.
struct SideDerivatives {
  std::array<int, 4> place;  // in the patch, of the hinge's points
  HingeDerivatives by;
};

SideDerivatives derivatives_at(const BendingRest& rest, const BendingPatch& patch, int side) {
  SideDerivatives result{.place = {side, (side + 1) % 3, (side + 2) % 3, 3 + side},
                         .by = hinge_derivatives(hinge_at(rest, patch, side))};
  if (!rest.sides[side].clamped) return result;
  // Half of what moves the held plane's point comes from either end of the side.
  Eigen::Matrix<double, 12, 12> along = Eigen::Matrix<double, 12, 12>::Identity();
  along.block<3, 3>(9, 9).setZero();
  along.block<3, 3>(9, 0) = along.block<3, 3>(9, 3) = 0.5 * Eigen::Matrix3d::Identity();
  result.by.gradient = (along.transpose() * result.by.gradient).eval();
  result.by.hessian = (along.transpose() * result.by.hessian * along).eval();
  return result;
}

}  // namespace

Eigen::Vector3d side_angles(const BendingRest& rest, const BendingPatch& patch) {
  Eigen::Vector3d angles;
  for (int side = 0; side < 3; ++side) {
    const BendingSide& own = rest.sides[side];
    angles[side] = own.turn_share * patch.turns[side];
    if (own.share != 0) angles[side] += own.share * hinge_angle(hinge_at(rest, patch, side));
  }
  return angles;
}

Eigen::Vector3d bending_strain(const BendingRest& rest, const BendingPatch& patch) {
  Eigen::Vector3d angles = side_angles(rest, patch);
  for (int side = 0; side < 3; ++side) angles[side] -= rest.sides[side].rest_angle;
  return rest.weights * angles;
}

BendingTerms bending_terms(const BendingRest& rest, const BendingPatch& patch, const BendingMemory& memory) {
  const Eigen::Vector3d strain = bending_strain(rest, patch);
  const Eigen::Vector3d elastic = rest.stiffness * strain;
  const Eigen::Vector3d moment = rest.area * rest.weights.transpose() * (memory.scale * elastic + memory.overmoment);

  BendingTerms terms;
  terms.bending_energy = 0.5 * rest.area * strain.dot(elastic);
  terms.energy = memory.scale * terms.bending_energy + rest.area * memory.overmoment.dot(strain);
  terms.hessian.setZero();
  Eigen::Matrix<double, 3, 21> slopes = Eigen::Matrix<double, 3, 21>::Zero();  // of the angles
  for (int side = 0; side < 3; ++side) {
    const BendingSide& own = rest.sides[side];
    slopes(side, 18 + side) = own.turn_share;
    if (own.share == 0) continue;
    const SideDerivatives at = derivatives_at(rest, patch, side);
    for (int i = 0; i < 4; ++i) {
      slopes.block<1, 3>(side, 3 * at.place[i]) = own.share * at.by.gradient.segment<3>(3 * i).transpose();
      for (int j = 0; j < 4; ++j) {
        terms.hessian.block<3, 3>(3 * at.place[i], 3 * at.place[j]) +=
            own.share * moment[side] * at.by.hessian.block<3, 3>(3 * i, 3 * j);
      }
    }
  }
  terms.gradient = slopes.transpose() * moment;
  const Eigen::Matrix3d stiffness = memory.scale * rest.area * rest.weights.transpose() * rest.stiffness * rest.weights;
  const Eigen::Matrix<double, 3, 21> stiff = stiffness.lazyProduct(slopes);
  terms.hessian += slopes.transpose().lazyProduct(stiff);
  return terms;
}

}  // namespace thinwall
