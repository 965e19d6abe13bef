#include "engine/shell/BendingElement.hpp"

#include <cmath>
#include <numbers>

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

/// What counts of the angle at a side, and its derivatives by the angle: all of it up to `fold`, and on from there,
/// twice smoothly, the tangent that goes to infinity at half a turn.
struct CountedAngle {
  double value, slope, curvature;
};

CountedAngle counted_angle(double angle, double fold) {
  const double beyond = std::abs(angle) - fold;
  if (beyond <= 0) return {.value = angle, .slope = 1, .curvature = 0};
  const double stretch = 0.5 * std::numbers::pi / (std::numbers::pi - fold), tangent = std::tan(stretch * beyond);
  const double slope = 1 + tangent * tangent;
  return {.value = std::copysign(fold + tangent / stretch, angle),
          .slope = slope,
          .curvature = std::copysign(2 * stretch * tangent * slope, angle)};
}

/// Derivatives of what counts of the angle at a side by the patch's positions.
struct SideDerivatives {
  std::array<int, 4> place;  // in the patch, of the hinge's points
  HingeDerivatives by;
};

SideDerivatives derivatives_at(const BendingRest& rest, const BendingPatch& patch, int side,
                               const CountedAngle& counted) {
  const Hinge hinge = hinge_at(rest, patch, side);
  SideDerivatives result{.place = {side, (side + 1) % 3, (side + 2) % 3, 3 + side}, .by = hinge_derivatives(hinge)};
  if (counted.slope != 1) {
    result.by.hessian *= counted.slope;
    result.by.hessian += counted.curvature * result.by.gradient * result.by.gradient.transpose();
    result.by.gradient *= counted.slope;
  }
  if (!rest.sides[side].clamped) return result;
  // Half of what moves the held plane's point comes from either end of the side.
  Eigen::Matrix<double, 12, 12> along = Eigen::Matrix<double, 12, 12>::Identity();
  along.block<3, 3>(9, 9).setZero();
  along.block<3, 3>(9, 0) = along.block<3, 3>(9, 3) = 0.5 * Eigen::Matrix3d::Identity();
  result.by.gradient = (along.transpose() * result.by.gradient).eval();
  result.by.hessian = (along.transpose() * result.by.hessian * along).eval();
  return result;
}

/// Of all sides that have one; what is missing is a flat one.
std::array<CountedAngle, 3> counted_angles(const BendingRest& rest, const BendingPatch& patch) {
  std::array<CountedAngle, 3> counted = {};
  for (int side = 0; side < 3; ++side) {
    const BendingSide& own = rest.sides[side];
    if (own.share != 0) counted[side] = counted_angle(hinge_angle(hinge_at(rest, patch, side)), own.fold);
  }
  return counted;
}

Eigen::Vector3d side_angles(const BendingRest& rest, const BendingPatch& patch,
                            const std::array<CountedAngle, 3>& counted) {
  Eigen::Vector3d angles;
  for (int side = 0; side < 3; ++side) {
    const BendingSide& own = rest.sides[side];
    angles[side] = own.turn_share * patch.turns[side] + own.share * counted[side].value;
  }
  return angles;
}

Eigen::Vector3d bending_strain(const BendingRest& rest, const Eigen::Vector3d& angles) {
  Eigen::Vector3d turned;
  for (int side = 0; side < 3; ++side) turned[side] = angles[side] - rest.sides[side].rest_angle;
  return rest.weights * turned;
}

}  // namespace

Eigen::Vector3d side_angles(const BendingRest& rest, const BendingPatch& patch) {
  return side_angles(rest, patch, counted_angles(rest, patch));
}

Eigen::Vector3d bending_strain(const BendingRest& rest, const BendingPatch& patch) {
  return bending_strain(rest, side_angles(rest, patch));
}

BendingTerms bending_terms(const BendingRest& rest, const BendingPatch& patch, const BendingMemory& memory) {
  const std::array<CountedAngle, 3> counted = counted_angles(rest, patch);
  const Eigen::Vector3d strain = bending_strain(rest, side_angles(rest, patch, counted));
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
    const SideDerivatives at = derivatives_at(rest, patch, side, counted[side]);
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
