#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "engine/contact/DeepestPoint.hpp"
#include "engine/contact/ToolSolid.hpp"

namespace thinwall {

/// Part of a triangle that keeps out of a solid.
enum class SitePart { kCorner, kEdge, kFace };

/// How many vertices it has, from its corner on around the triangle.
constexpr int vertex_count_of(SitePart part) {
  return part == SitePart::kCorner ? 1 : part == SitePart::kEdge ? 2 : 3;
}

/// Whether the second derivatives of a gap are wanted too: most of its cost, and of use only where something presses.
enum class GapTerms { kGradient, kHessian };

/// The gap between a solid and a corner, an edge or the whole of a triangle, and its derivatives by the three corners
/// (x0, y0, z0, x1, ..., z2).
struct SolidGap {
  double gap = 0;                                     // metres
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();   // unit, out of the solid
  Eigen::Vector3d weights = Eigen::Vector3d::Zero();  // barycentric, of the deepest point
  SitePart part = SitePart::kCorner;                  // where that lies: at a corner, within an edge, within the face
  Eigen::Matrix<double, 9, 1> gradient;               // a number
  Eigen::Matrix<double, 9, 9> hessian;                // 1 / metre; zero unless it was asked for
};

/// Whether the balls around a solid and a triangle show that no gap of its parts is below `reach`, metres.
bool is_out_of_reach(const ToolSolid& solid, double reach, const std::array<Eigen::Vector3d, 3>& corners);

/// The gap of corner `corner`, of the edge from it to the next, or of the whole triangle; nothing when it exceeds
/// `reach`, metres. The deepest point moves as the triangle does, so that a flat face may slide and roll on a ball
/// without resistance, and the wall as a whole stays outside, not its vertices only.
/// With n and H the gradient and the Hessian of the signed distance at the deepest point of weights w, and T the edges
/// (columns) that it may move along, the gradient by corner a is w_a n, the Hessian w_a w_b H - G_a^T (T^T H T)^-1 G_b
/// with G_a = w_a T^T H + d_a n^T, d_a the derivative of T^T by corner a (the minimum over w, differentiated twice).
/// Along edges on which the solid is flat the deepest point stays where it is.
std::optional<SolidGap> solid_gap(const ToolSolid& solid, double reach, const std::array<Eigen::Vector3d, 3>& corners,
                                  SitePart part, int corner = 0, GapTerms wanted = GapTerms::kHessian);

}  // namespace thinwall
