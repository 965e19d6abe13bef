#pragma once

#include <Eigen/Core>
#include <vector>

namespace thinwall {

/// The signed distance from a solid at a point.
struct SignedDistance {
  double value = 0;                                     // metres, negative inside
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();     // its gradient, unit, outward
  Eigen::Matrix3d curvature = Eigen::Matrix3d::Zero();  // its Hessian, 1 / metre, positive semidefinite
};

/// A rigid convex solid in space whose signed distance has a closed form: what a tool, or one jaw of it, touches with.
struct ToolSolid {
  enum class Form {
    /// All points within `radius` of a box of half sizes `core`, any of which may be zero: a ball, a capsule, a plate,
    /// the flank of a blade, a jaw.
    kRoundedBox,
    /// The hull of three balls on a line along z': of `tip_radius` at +core.z(), of `radius` at `shoulder` and at
    /// -core.z(): a round shaft that a cone brings down to a small round tip.
    kNeedle
  };

  /// Which parts of a wall the solid keeps out.
  enum class Role {
    kWhole,  // all: a ball
    kBody,   // vertices and edges: what is round, so that no edge has two deepest points in it
    kHull,   // vertices: what is flat somewhere, so that an edge that lies on it has no deepest point
    kRim,    // edges: a capsule along an edge of a hull
    kCorner  // faces: a ball at a corner of a body or hull
  };

  Form form = Form::kRoundedBox;
  Role role = Role::kWhole;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();     // metres
  Eigen::Matrix3d frame = Eigen::Matrix3d::Identity();  // columns x', y', z', a rotation
  Eigen::Vector3d core = Eigen::Vector3d::Zero();       // metres, half sizes along x', y', z'
  double radius = 0;                                    // metres
  double tip_radius = 0;                                // metres, needle
  double shoulder = 0;                                  // metres along z' from the centre, needle
  double crown = 0;                                     // metres, of edges that lie on a rim: see deepest_on_edge

  /// Whether the solid belongs to a body or hull before it.
  bool is_part() const { return role == Role::kRim || role == Role::kCorner; }
  /// Whether it keeps out vertices, edges and faces.
  bool meets_vertices() const { return !is_part(); }
  bool meets_edges() const { return role == Role::kWhole || role == Role::kBody || role == Role::kRim; }
  bool meets_faces() const { return role == Role::kWhole || role == Role::kCorner; }
  bool is_ball() const { return form == Form::kRoundedBox && core.isZero(); }
  /// Smallest radius of curvature, metres.
  double sharpness() const { return form == Form::kNeedle ? tip_radius : radius; }
  /// Of a ball around the centre that holds the solid, metres.
  double extent() const { return core.norm() + radius; }
  /// Half of the smallest thickness, metres: a wall that is farther inside may leave through the wrong side.
  double half_thickness() const { return form == Form::kNeedle ? tip_radius : radius + core.minCoeff(); }
};

/// Exact outside, and inside as long as no other face is nearer than the one that the point came through. With q the
/// point of the box core nearest to x: |x - q| - radius, of Hessian (P - n n^T) / |x - q|, P onto the axes along which
/// x lies beyond the core. Of the needle: the distance from the ball, cone or cylinder on whose normal x lies.
SignedDistance signed_distance(const ToolSolid& solid, const Eigen::Vector3d& point);

/// Its value alone, metres.
double distance_from(const ToolSolid& solid, const Eigen::Vector3d& point);

/// The balls whose hull a solid is, each with the role of a corner: of a box at its corners, of a needle at its tip,
/// its shoulder and its back end. None of a ball.
std::vector<ToolSolid> corners_of(const ToolSolid& solid);

/// The capsules along the edges of a box that is flat somewhere, each with the role of a rim; none of other solids. A
/// wall's edge that lies on a flat side has no single deepest point in it, but one in each rim that it crosses.
std::vector<ToolSolid> rims_of(const ToolSolid& solid);

/// Area of the shadow that the solid throws along a unit vector, metres^2: that of the box around it.
double silhouette(const ToolSolid& solid, const Eigen::Vector3d& direction);

/// Displacement of the point of the solid that is at `point` before, when the solid moves from one pose to another.
Eigen::Vector3d displacement_of(const ToolSolid& before, const ToolSolid& after, const Eigen::Vector3d& point);

}  // namespace thinwall
