#pragma once

#include <Eigen/Core>
#include <array>

namespace thinwall {

/// What two parts of a surface may meet by, given as four vertices.
enum class PairKind {
  kPointTriangle,  // vertex 0; the triangle 1, 2, 3
  kEdgeEdge        // the edge 0, 1; the edge 2, 3
};

using PairCorners = std::array<Eigen::Vector3d, 4>;  // metres

/// The shortest way between the two, as a combination of the vertices: offset = sum of weights_k x_k.
struct PairDistance {
  double distance = 0;                               // metres, unsigned
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();  // metres, from the second part to the first
  Eigen::Vector4d weights = Eigen::Vector4d::Zero();
  /// Ways in which the two closest points may slide within their parts: each column is a change of the weights.
  Eigen::Matrix<double, 4, 2> slides = Eigen::Matrix<double, 4, 2>::Zero();
  int slide_count = 0;
};

/// The distance of the closed parts: interiors, edges and corners. Where two edges are parallel their closest points
/// are not unique and the derivatives below jump; FoldPair fades such pairs out.
PairDistance pair_distance(PairKind kind, const PairCorners& corners);

/// No more than that distance, metres, at a fraction of its price: the gap along the line between the centres of the
/// two, below zero where they overlap along it.
double least_distance(PairKind kind, const PairCorners& corners);

/// Derivatives of the distance by the corners (x0, y0, z0, x1, ..., z3); for distances above zero. With the offset r,
/// weights w and T the slides' images (columns), the gradient of half the squared distance by corner a is w_a r, its
/// Hessian w_a w_b 1 - G_a^T (T^T T)^-1 G_b with G_a = w_a T^T + d_a r^T, d_a the slides' rows: the minimum over the
/// closest points, differentiated twice.
Eigen::Matrix<double, 12, 1> distance_gradient(const PairDistance& closest);
Eigen::Matrix<double, 12, 12> distance_hessian(const PairDistance& closest, const PairCorners& corners);

}  // namespace thinwall
