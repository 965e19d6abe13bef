#pragma once

#include <Eigen/Core>
#include <optional>

#include "engine/contact/NearPair.hpp"
#include "engine/contact/PairDistance.hpp"

namespace thinwall {

/// Value and slopes of a function of one distance.
struct DistanceTerms {
  double energy = 0;     // joule
  double slope = 0;      // newton
  double curvature = 0;  // newton / metre
};

/// The potential that keeps two parts of a wall from meeting, with x = distance / range:
///
///     -pressure area range (1 - x)^2 ln x   for 0 < x < 1, zero beyond
///
/// (the barrier of incremental potential contact, Li et al. 2020, scaled). Twice differentiable; at x = 1/2 the two
/// push each other with 1.2 pressure area, at x = 0.05 with 24 pressure area, and without bound as x goes to zero.
struct FoldPotential {
  double range = 1e-6;  // metres
  double pressure = 1;  // pascal
  double area = 1;      // metres^2, of the stress-free wall that the pair stands for

  DistanceTerms at(double distance) const;  // distance > 0
};

/// Energy of a pair of parts with its derivatives by the corners (x0, y0, z0, x1, ..., z3).
struct FoldTerms {
  double energy = 0;                      // joule
  Eigen::Matrix<double, 12, 1> gradient;  // newton
};

/// A pair in contact. Two edges that are nearly parallel fade out: with c the squared cross product of the edges and
/// e = `parallel`, the potential is multiplied by (2 - c/e) c/e where c < e, so that it stays smooth where the closest
/// points are not unique. Their end points, as points against triangles, take over there. So does a triangle that is
/// crushed to a line, by the cross product of two sides: where its third corner goes over from one side of that line to
/// the other the force jumps from some corners to others. Its sides, as edges against edges, take over there.
struct FoldPair {
  PairKind kind = PairKind::kPointTriangle;
  PairCorners corners;
  PairDistance closest;
  FoldPotential potential;
  double parallel = 0;  // metres^4; nothing fades out where it is 0

  FoldTerms terms() const;
  /// The second derivatives.
  Eigen::Matrix<double, 12, 12> hessian() const;
  /// Their convex part, positive semi-definite: of rank one, along the shortest way, or where the pair is crushed all
  /// that is left without the negative eigenvalues.
  Eigen::Matrix<double, 12, 12> convex_hessian() const;
};

/// The pair at a position, (3 vertices), metres, with a potential of that pressure, pascal; nothing where it is out of
/// range.
std::optional<FoldPair> fold_of(const NearPair& near, const Eigen::VectorXd& position, double pressure);

/// `parallel` of two edges, or two sides of the triangle, with the given stress-free corners: 1e-3 of the squared
/// product of their lengths.
double parallel_bound(PairKind kind, const PairCorners& rest_corners);

}  // namespace thinwall
