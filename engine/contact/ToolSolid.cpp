#include "engine/contact/ToolSolid.hpp"

#include <algorithm>
#include <cmath>

namespace thinwall {
namespace {

/// Crown of an edge over the radius of the rim of a box that it lies on. A blade, thin as its rims are round, needs
/// none.
constexpr double kCrown = 4e-3;

/// Nearer to a centre or an axis than this, metres, the normal is taken along x' and the curvature as at this distance:
/// a wall that deep inside a tool only has to be pushed out.
constexpr double kNoDirection = 1e-12;

/// `offset`: from the centre, of that length.
SignedDistance outside_ball(const Eigen::Vector3d& offset, double length, double radius) {
  SignedDistance distance{.value = length - radius, .normal = offset / length};
  distance.curvature = (Eigen::Matrix3d::Identity() - distance.normal * distance.normal.transpose()) / length;
  return distance;
}

/// From the nearest point of the core, in the solid's own frame.
Eigen::Vector3d offset_from_core(const ToolSolid& solid, const Eigen::Vector3d& point) {
  return point - point.cwiseMax(-solid.core).cwiseMin(solid.core);
}

/// As of from_box, without what a wall that is far away does not need.
double value_from_box(const ToolSolid& solid, const Eigen::Vector3d& point) {
  const double length = offset_from_core(solid, point).norm();
  return (length > kNoDirection ? length : -(solid.core - point.cwiseAbs()).minCoeff()) - solid.radius;
}

/// In the solid's own frame, point relative to its centre.
SignedDistance from_box(const ToolSolid& solid, const Eigen::Vector3d& point) {
  SignedDistance distance;
  const Eigen::Vector3d offset = offset_from_core(solid, point);
  const double length = offset.norm();
  if (length > kNoDirection) {
    distance.value = length - solid.radius;
    distance.normal = offset / length;
    // Where the core has no size along an axis the nearest point cannot follow along it.
    const Eigen::Vector3d beyond = (point.array().abs() >= solid.core.array()).cast<double>().matrix();
    distance.curvature = beyond.asDiagonal();
    distance.curvature -= distance.normal * distance.normal.transpose();
    distance.curvature /= length;
    return distance;
  }
  // Inside the core: out through the nearest face.
  int face = 0;
  const Eigen::Vector3d depth = solid.core - point.cwiseAbs();
  depth.minCoeff(&face);
  distance.value = -depth[face] - solid.radius;
  distance.normal = (point[face] < 0 ? -1 : 1) * Eigen::Vector3d::Unit(face);
  distance.curvature.setZero();
  return distance;
}

/// Distance from a ball around a point of the z' axis.
SignedDistance from_ball(double height, double radius, const Eigen::Vector3d& point) {
  ToolSolid ball;
  ball.radius = radius;
  return from_box(ball, point - height * Eigen::Vector3d::UnitZ());
}

/// Distance from a cone, or a cylinder, around the z' axis whose normal leans towards +z' by asin(lean).
SignedDistance from_cone(double height, double radius, double lean, const Eigen::Vector3d& point) {
  const double out = std::sqrt(1 - lean * lean);
  const double from_axis = std::hypot(point.x(), point.y());
  const Eigen::Vector3d radial = from_axis > kNoDirection
                                     ? Eigen::Vector3d(point.x() / from_axis, point.y() / from_axis, 0)
                                     : Eigen::Vector3d::UnitX();
  const Eigen::Vector3d around(-radial.y(), radial.x(), 0);
  SignedDistance distance;
  distance.value = out * from_axis + lean * (point.z() - height) - radius;
  distance.normal = out * radial + lean * Eigen::Vector3d::UnitZ();
  distance.curvature = out / std::max(from_axis, kNoDirection) * around * around.transpose();
  return distance;
}

SignedDistance from_needle(const ToolSolid& solid, const Eigen::Vector3d& point) {
  const double tip = solid.core.z(), shoulder = solid.shoulder, end = -solid.core.z();
  const double lean = (solid.radius - solid.tip_radius) / (tip - shoulder);
  // Where the cone's normal through the point meets the axis.
  const double foot = point.z() - std::hypot(point.x(), point.y()) * lean / std::sqrt(1 - lean * lean);
  if (foot >= tip) return from_ball(tip, solid.tip_radius, point);
  if (foot > shoulder) return from_cone(tip, solid.tip_radius, lean, point);
  if (point.z() >= shoulder) return from_ball(shoulder, solid.radius, point);
  if (point.z() > end) return from_cone(shoulder, solid.radius, 0, point);
  return from_ball(end, solid.radius, point);
}

}  // namespace

SignedDistance signed_distance(const ToolSolid& solid, const Eigen::Vector3d& point) {
  if (solid.is_ball()) {
    // A frame makes no difference to a ball; `from_box` gives the direction at the very centre.
    const Eigen::Vector3d offset = point - solid.center;
    const double length = offset.norm();
    if (length > kNoDirection) return outside_ball(offset, length, solid.radius);
  }
  const Eigen::Vector3d local = solid.frame.transpose() * (point - solid.center);
  SignedDistance distance = solid.form == ToolSolid::Form::kNeedle ? from_needle(solid, local) : from_box(solid, local);
  distance.normal = solid.frame * distance.normal;
  distance.curvature = solid.frame * distance.curvature * solid.frame.transpose();
  return distance;
}

double distance_from(const ToolSolid& solid, const Eigen::Vector3d& point) {
  if (solid.is_ball()) return (point - solid.center).norm() - solid.radius;
  const Eigen::Vector3d local = solid.frame.transpose() * (point - solid.center);
  return solid.form == ToolSolid::Form::kNeedle ? from_needle(solid, local).value : value_from_box(solid, local);
}

std::vector<ToolSolid> rims_of(const ToolSolid& solid) {
  std::vector<ToolSolid> rims;
  if (solid.form != ToolSolid::Form::kRoundedBox || (solid.core.array() > 0).count() < 2) return rims;
  for (int axis = 0; axis < 3; ++axis) {
    if (solid.core[axis] == 0) continue;
    const int one = (axis + 1) % 3, other = (axis + 2) % 3;
    for (const double first : {-1.0, 1.0}) {
      for (const double second : {-1.0, 1.0}) {
        if ((solid.core[one] == 0 && first > 0) || (solid.core[other] == 0 && second > 0)) continue;
        ToolSolid rim = solid;
        rim.role = ToolSolid::Role::kRim;
        rim.core[one] = rim.core[other] = 0;
        if (solid.core.minCoeff() > 0) rim.crown = kCrown * rim.radius;
        rim.center +=
            solid.frame.col(one) * first * solid.core[one] + solid.frame.col(other) * second * solid.core[other];
        rims.push_back(rim);
      }
    }
  }
  return rims;
}

std::vector<ToolSolid> corners_of(const ToolSolid& solid) {
  std::vector<ToolSolid> corners;
  const auto add = [&](const Eigen::Vector3d& local, double radius) {
    ToolSolid corner;
    corner.role = ToolSolid::Role::kCorner;
    corner.center = solid.center + solid.frame * local;
    corner.frame = solid.frame;
    corner.radius = radius;
    corners.push_back(corner);
  };
  if (solid.is_ball()) return corners;
  if (solid.form == ToolSolid::Form::kNeedle) {
    add({0, 0, solid.core.z()}, solid.tip_radius);
    add({0, 0, solid.shoulder}, solid.radius);
    add({0, 0, -solid.core.z()}, solid.radius);
    return corners;
  }
  const auto sides = [&](int axis) { return solid.core[axis] > 0 ? std::vector{-1.0, 1.0} : std::vector{0.0}; };
  for (const double x : sides(0)) {
    for (const double y : sides(1)) {
      for (const double z : sides(2)) add(solid.core.cwiseProduct(Eigen::Vector3d(x, y, z)), solid.radius);
    }
  }
  return corners;
}

double silhouette(const ToolSolid& solid, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d local = (solid.frame.transpose() * direction).cwiseAbs();
  const Eigen::Vector3d size = 2 * (solid.core.array() + solid.radius);
  return local.x() * size.y() * size.z() + local.y() * size.z() * size.x() + local.z() * size.x() * size.y();
}

Eigen::Vector3d displacement_of(const ToolSolid& before, const ToolSolid& after, const Eigen::Vector3d& point) {
  return after.center + after.frame * (before.frame.transpose() * (point - before.center)) - point;
}

}  // namespace thinwall
