#include "engine/simulation/Puncture.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/cutting/SurfacePath.hpp"
#include "engine/cutting/SurfaceTrace.hpp"
#include "engine/equilibrium/FrictionContact.hpp"

namespace thinwall {
namespace {

/// Radii around the middle of a puncture within which the wall is free on the needle: the length of its cone, on which
/// the wall lay before it gave way.
constexpr double kFreeRadii = 4;

/// How far beside its point a needle makes its way where a cut or a border leaves no room for a slit there, radii: the
/// wall around the slit is then drawn onto the shaft. In so many directions.
constexpr double kBeside[] = {1, 1.5, 2};
constexpr int kSides = 8;

/// How far the wall must be whole beyond the middle of such a slit, radii, along it and across.
constexpr double kClearEnds = 1.5;
constexpr double kClearSides = 0.75;

/// Chord over length of a way that meets no border, which ends would be brought to.
constexpr double kStraight = 0.9;

SurfaceView rest_view(const BodyModel& model) {
  return {.triangles = model.definition.mesh.triangles, .position = model.rest_position, .open = true};
}

Eigen::Vector3d rest_normal(const BodyModel& model, int triangle) {
  const auto corners = corners_of(model.surface[triangle], model.rest_position);
  return (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
}

/// What slits of a needle's width are laid on.
struct SlitFinder {
  SurfaceView view;
  double radius = 0;  // metres

  /// From one end to the other, so far on both sides of a place; nothing where a gap of the wall lies between.
  std::optional<CutPath> between(const Eigen::Vector3d& middle, const Eigen::Vector3d& along, double reach) const {
    const auto from = project(view, middle - reach * along, {}, radius).point;
    const auto to = project(view, middle + reach * along, {}, radius).point;
    if (!from || !to) return std::nullopt;
    const SurfaceTrace way = trace(view, *from, *to);
    if (way.pieces.size() != 1) return std::nullopt;
    return CutPath{.from = {}, .points = way.pieces.front().points};
  }

  /// Whether neither a border nor a cut comes near a slit that would be made there.
  bool is_whole(const Eigen::Vector3d& middle, const Eigen::Vector3d& along, const Eigen::Vector3d& across) const {
    for (const auto& [axis, reach] : {std::pair(along, kClearEnds * radius), std::pair(across, kClearSides * radius)}) {
      const auto way = between(middle, axis, reach);
      if (!way) return false;
      if ((position_of(view, way->points.back()) - position_of(view, way->points.front())).norm() <
          kStraight * 2 * reach)
        return false;
    }
    return true;
  }
};

/// On which side of a line through a vertex the triangles that have it lie, metres along `side`.
double side_of(const BodyModel& model, int vertex, const Eigen::Vector3d& side) {
  double sum = 0;
  for (int t = 0; t < model.triangles(); ++t) {
    if ((model.surface[t].array() != vertex).all()) continue;
    for (const Eigen::Vector3d& corner : corners_of(model.surface[t], model.rest_position)) {
      sum += side.dot(corner - model.rest_position.segment<3>(3 * vertex));
    }
  }
  return sum;
}

}  // namespace

bool Puncture::is_sealed() const {
  return tool && std::ranges::any_of(points, &ShaftPoint::touches);
}

std::optional<AxisMeeting> where_axis_meets(const std::array<Eigen::Vector3d, 3>& corners, const ToolPose& pose) {
  Eigen::Matrix3d system;
  system << corners[1] - corners[0], corners[2] - corners[0], -pose.direction;
  const double scale = system.leftCols<2>().colwise().norm().maxCoeff();
  if (std::abs(system.determinant()) <= std::numeric_limits<double>::epsilon() * scale * scale) return std::nullopt;
  const Eigen::Vector3d found = system.inverse() * (pose.tip - corners[0]);
  const Eigen::Vector3d weights(1 - found[0] - found[1], found[0], found[1]);
  if (weights.minCoeff() < 0) return std::nullopt;
  return AxisMeeting{.weights = weights, .ahead = found[2]};
}

std::optional<SurfacePoint> pressed_place(const BodyModel& model, const Eigen::VectorXd& position, const ToolPose& pose,
                                          double radius, const std::vector<char>& is_free) {
  std::optional<SurfacePoint> place;
  double nearest = 2 * radius;
  for (int t = 0; t < model.triangles(); ++t) {
    if (is_free[t]) continue;
    const auto met = where_axis_meets(corners_of(model.surface[t], position), pose);
    if (!met || std::abs(met->ahead) >= nearest) continue;
    nearest = std::abs(met->ahead);
    place = SurfacePoint{.triangle = t, .weights = met->weights};
  }
  return place;
}

bool try_slits(const BodyModel& model, const SurfacePoint& place, const ToolPose& pose, double radius,
               const std::function<bool(const CutPath&)>& fits) {
  const SlitFinder finder{.view = rest_view(model), .radius = radius};
  const Eigen::Vector3d middle = place_on(model, place.triangle, place.weights, model.rest_position);
  const Eigen::Vector3d normal = rest_normal(model, place.triangle);
  const auto on_wall = [&](const Eigen::Vector3d& axis) {
    return Eigen::Vector3d((axis - normal * normal.dot(axis)).normalized());
  };
  const std::array<Eigen::Vector3d, 2> axes = {on_wall(pose.axis), on_wall(pose.axis.cross(pose.direction))};
  const auto is_taken = [&](const Eigen::Vector3d& at, const Eigen::Vector3d& along) {
    const auto path = finder.between(at, along, radius);
    return path && fits(*path);
  };
  if (is_taken(middle, axes[0]) || is_taken(middle, axes[1])) return true;
  for (const double shift : kBeside) {
    for (int side = 0; side < kSides; ++side) {
      const double angle = 2 * std::numbers::pi * side / kSides;
      const Eigen::Vector3d aside = std::cos(angle) * axes[1] + std::sin(angle) * axes[0];
      const auto found = project(finder.view, middle + shift * radius * aside, {}, radius).point;
      if (!found) continue;
      const Eigen::Vector3d beside = position_of(finder.view, *found);
      for (int k = 0; k < 2; ++k) {
        if (finder.is_whole(beside, axes[k], axes[1 - k]) && is_taken(beside, axes[k])) return true;
      }
    }
  }
  return false;
}

Puncture puncture_of(const BodyModel& model, const Cut& slit, int tool, const ToolPose& pose, double radius) {
  assert(slit.lips.size() == 1);
  const std::vector<int>&left = slit.lips[0].left, &right = slit.lips[0].right;
  const auto at = [&](int vertex) -> Eigen::Vector3d { return model.rest_position.segment<3>(3 * vertex); };
  std::vector<double> along = {0};  // metres, rest, from the first tip
  for (std::size_t k = 1; k < left.size(); ++k) along.push_back(along.back() + (at(left[k]) - at(left[k - 1])).norm());
  const std::size_t middle = left.size() / 2;
  const Eigen::Vector3d axes[2] = {pose.axis.cross(pose.direction), pose.axis};
  const Eigen::Vector3d way = at(left.back()) - at(left.front());
  const Eigen::Vector2d forwards = Eigen::Vector2d(way.dot(axes[0]), way.dot(axes[1])).normalized();
  Eigen::Vector2d leftwards(-forwards.y(), forwards.x());
  if (side_of(model, left[middle], leftwards.x() * axes[0] + leftwards.y() * axes[1]) < 0) leftwards = -leftwards;
  Puncture puncture{.tool = tool, .reach = kFreeRadii * radius};
  const auto add = [&](int vertex, double part, double side) {
    const Eigen::Vector2d place = -std::cos(part) * forwards + side * std::sin(part) * leftwards;
    const char* fixed = &model.fixed[3 * vertex];
    puncture.points.push_back(
        {.vertex = vertex, .angle = std::atan2(place.y(), place.x()), .is_held = fixed[0] && fixed[1] && fixed[2]});
  };
  for (std::size_t k = 0; k < left.size(); ++k) {
    const double part = std::numbers::pi * along[k] / along.back();
    add(left[k], part, 1);
    if (right[k] != left[k]) add(right[k], part, -1);
  }
  return puncture;
}

void mark_free(const BodyModel& model, const Puncture& puncture, std::vector<char>& marks) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const ShaftPoint& point : puncture.points) middle += model.rest_position.segment<3>(3 * point.vertex);
  middle /= static_cast<double>(puncture.points.size());
  std::vector<char> is_reached(model.vertices(), 0);
  for (const ShaftPoint& point : puncture.points) is_reached[point.vertex] = 1;
  // From triangle to triangle, so that the far wall of a thin organ is not taken for near.
  for (bool grows = true; grows;) {
    grows = false;
    for (int t = 0; t < model.triangles(); ++t) {
      const Eigen::Vector3i& triangle = model.surface[t];
      const bool touches = is_reached[triangle[0]] || is_reached[triangle[1]] || is_reached[triangle[2]];
      if (marks[t] || !touches) continue;
      marks[t] = 1;
      grows = true;
      for (const int vertex : triangle) {
        const double distance = (model.rest_position.segment<3>(3 * vertex) - middle).norm();
        if (distance <= puncture.reach) is_reached[vertex] = 1;
      }
    }
  }
}

bool is_shut(const BodyModel& model, std::span<const Puncture> punctures, int opening) {
  const std::vector<int>& lips = model.openings[opening].lips;
  return std::ranges::any_of(punctures, [&](const Puncture& puncture) {
    return puncture.is_sealed() && std::ranges::all_of(lips, [&](int vertex) {
             return std::ranges::find(puncture.points, vertex, &ShaftPoint::vertex) != puncture.points.end();
           });
  });
}

std::vector<char> free_triangles(const BodyModel& model, std::span<const Puncture> punctures, int tool) {
  std::vector<char> marks(model.triangles(), 0);
  for (const Puncture& puncture : punctures) {
    if (puncture.tool == tool) mark_free(model, puncture, marks);
  }
  return marks;
}

}  // namespace thinwall
