#include "engine/simulation/BladeWay.hpp"

#include <algorithm>

#include "engine/cutting/BorderCrossing.hpp"
#include "engine/cutting/SurfaceTrace.hpp"

namespace thinwall {
namespace {

/// Mean edges by which a blade is off a cut's tip or beginning, without a way from there to it or back on a wall that
/// it was off, when it begins another cut.
constexpr double kLeftBehind = 2;

/// Mean edges from a border within which a cut that begins or ends meets it: triangles tell no such bridge.
constexpr double kNearBorder = 0.25;

/// Mean edges ahead of a cut's tip from which on a border is no place of its own lips, but for rounding.
constexpr double kLeastAhead = 1e-3;

/// Cosine of the angle to a cut's way within which a border lies behind its beginning, and not beside it.
constexpr double kLeastBehind = 0.5;

/// A way longer than this times the distance of its ends, and an edge more, is not what a blade goes in a step: it
/// leads around a flap or the body.
constexpr double kMostDetour = 1.5;

/// The part of a vector across a unit line.
Eigen::Vector3d across(const Eigen::Vector3d& vector, const Eigen::Vector3d& line) {
  return vector - vector.dot(line) * line;
}

/// Whether a way goes over no gap and leads where it ends without a detour. `edge`: metres, of the wall.
bool is_direct(const SurfaceView& wall, const SurfaceTrace& way, double edge) {
  if (way.pieces.size() != 1) return false;
  const std::vector<SurfacePoint>& points = way.pieces.front().points;
  return length_of(wall, points) <=
         kMostDetour * (position_of(wall, points.back()) - position_of(wall, points.front())).norm() + edge;
}

}  // namespace

std::optional<SurfacePoint> BladeWay::place_below(const ToolPose& pose, double higher) const {
  const SurfaceView wall = surface();
  const Eigen::Vector3d top = pose.tip - (blade_.length + higher) * pose.direction;
  // Behind its edge a blade may pass other lobes of the body: it cuts where its tip has gone in, and goes on from
  // there.
  Eigen::Vector3d near = pose.tip;
  if (state_.cut.tip) {
    near = state_.equilibrium.position.segment<3>(3 * *state_.cut.tip);
  } else if (state_.cut.start) {
    near = place_on(model_, state_.cut.start->triangle, state_.cut.start->weights, state_.equilibrium.position);
  }
  const auto entry = nearest_entry_on_segment(wall, top, pose.tip, near);
  if (!entry) return std::nullopt;
  return snapped_to_edges(wall, {.triangle = entry->triangle, .weights = entry->weights});
}

bool BladeWay::is_in_wound(const ToolPose& pose) const {
  const CutProgress& cut = state_.cut;
  const SurfaceView wall = surface();
  if (cut.tip) {
    const Eigen::Vector3d tip = state_.equilibrium.position.segment<3>(3 * *cut.tip);
    if ((pose.tip - tip).dot(across(way_ahead(wall, *cut.tip), pose.direction)) >= 0) return false;
  }
  const std::optional<SurfacePoint> place = place_below(pose);
  if (!place) return cut.tip.has_value();
  // The flanks of a blade part the lips of a wound that does not gape.
  const double flank = 0.5 * blade_.thickness;
  const Eigen::Vector3d met = position_of(wall, *place);
  if (distance_from_border(wall, met) > flank) return false;
  if (cut.tip) return true;
  // It has gone in between the lips of an earlier cut where it has gone along them since: across them it goes on into
  // the wall.
  const Eigen::Vector3d start = position_of(wall, *cut.start);
  return (met - start).norm() > 2 * flank && distance_from_border(wall, start) <= flank;
}

std::optional<WayOn> BladeWay::out_of_wound(const ToolPose& pose) const {
  const std::optional<SurfacePoint> target = place_below(pose);
  if (!target || !state_.cut.tip) return std::nullopt;
  const SurfaceView wall = surface();
  const Eigen::Vector3d tip = state_.equilibrium.position.segment<3>(3 * *state_.cut.tip);
  const Eigen::Vector3d to = place_on(model_, target->triangle, target->weights, state_.equilibrium.position);
  const Eigen::Vector3d ahead = across(way_ahead(wall, *state_.cut.tip), pose.direction).normalized();
  const double before = (to - tip).dot(ahead);  // metres
  if (before >= 0) return std::nullopt;
  // Beside where the blade is, towards the middle of the wound.
  const auto lip = first_border(wall, to, tip + before * ahead, pose.direction);
  if (!lip) return std::nullopt;
  const SurfaceTrace way = trace(wall, snapped_to_edges(wall, *lip), *target);
  if (way.pieces.size() != 1) return std::nullopt;
  return WayOn{.path = {.from = {}, .points = way.pieces.front().points}};
}

std::optional<WayOn> BladeWay::on(const ToolPose& pose, double higher) const {
  const SurfaceView wall = surface();
  const std::optional<SurfacePoint> target = place_below(pose, higher);
  if (!target) return to_border(pose);
  const std::optional<int> tip = state_.cut.tip;
  const SurfacePoint from = tip ? point_at(wall.triangles, *tip) : *state_.cut.start;
  const SurfaceTrace way = trace(wall, from, *target);
  if (!is_direct(wall, way, model_.edge_length)) return to_border(pose);
  return WayOn{.path = {.from = tip, .points = way.pieces.front().points}};
}

std::optional<WayOn> BladeWay::to_border(const ToolPose& pose) const {
  if (!state_.cut.tip) return std::nullopt;
  const int tip = *state_.cut.tip;
  const SurfaceView wall = surface();
  const Eigen::Vector3d from = state_.equilibrium.position.segment<3>(3 * tip);
  const Eigen::Vector3d to = pose.tip + (from - pose.tip).dot(pose.direction) * pose.direction;
  // In its own wound, behind the tip, the blade has left no wall.
  if ((to - from).dot(way_ahead(wall, tip)) <= 0) return std::nullopt;
  const auto border = first_border(wall, from, to, pose.direction);
  if (!border) return std::nullopt;
  const SurfaceTrace way = trace(wall, point_at(wall.triangles, tip), snapped_to_edges(wall, *border));
  if (!is_direct(wall, way, model_.edge_length)) return std::nullopt;
  return WayOn{.path = {.from = tip, .points = way.pieces.front().points},
               .border = place_on(model_, border->triangle, border->weights, state_.equilibrium.position),
               .sense = (to - from).normalized()};
}

WayOn BladeWay::brought_to_border(WayOn way) const {
  if (!way.path.from) return way;
  const SurfaceView wall = surface();
  const SurfacePoint from = point_at(wall.triangles, *way.path.from), end = way.path.points.back();
  const Eigen::Vector3d tip = position_of(wall, from), stop = position_of(wall, end);
  const Eigen::Vector3d ahead = way_ahead(wall, *way.path.from).normalized();
  const double near = bridged();
  double shortest = near;
  for (SurfacePoint border : borders_around(wall, stop, near)) {
    // The other end of a cut is a vertex, and no place of one lip or the other beside it.
    Eigen::Index corner = 0;
    border.weights.maxCoeff(&corner);
    const SurfacePoint vertex{.triangle = border.triangle, .weights = Eigen::Vector3d::Unit(corner)};
    if ((position_of(wall, vertex) - stop).norm() <= near) border = vertex;
    // Its own lips begin at the tip, and lie behind it.
    if ((position_of(wall, border) - tip).dot(ahead) <= kLeastAhead * model_.edge_length) continue;
    // Of lips that lie together the way over the wall tells which one is on this side.
    const SurfaceTrace rest = trace(wall, end, border);
    if (rest.pieces.size() != 1 || length_of(wall, rest.pieces.front().points) > shortest) continue;
    const SurfaceTrace there = trace(wall, from, border);
    if (!is_direct(wall, there, model_.edge_length)) continue;
    shortest = length_of(wall, rest.pieces.front().points);
    way.path.points = there.pieces.front().points;
  }
  return way;
}

WayOn BladeWay::brought_from_border(WayOn way) const {
  if (way.path.from) return way;
  const SurfaceView wall = surface();
  const SurfacePoint end = way.path.points.back();
  const Eigen::Vector3d start = position_of(wall, way.path.points.front()), stop = position_of(wall, end);
  const double near = bridged();
  if (distance_from_border(wall, start) <= kLeastAhead * model_.edge_length) return way;
  double shortest = near;
  for (const SurfacePoint& border : borders_around(wall, start, near)) {
    const Eigen::Vector3d back = start - position_of(wall, border);
    if (back.norm() > shortest || back.dot((stop - start).normalized()) < kLeastBehind * back.norm()) continue;
    const SurfaceTrace from_there = trace(wall, snapped_to_edges(wall, border), end);
    if (!is_direct(wall, from_there, model_.edge_length)) continue;
    shortest = back.norm();
    way.path.points = from_there.pieces.front().points;
  }
  return way;
}

double BladeWay::bridged() const {
  return std::max(0.5 * blade_.thickness, kNearBorder * model_.edge_length);
}

bool BladeWay::is_far(const WayOn& way) const {
  return length_of(surface(), way.path.points) > kLeftBehind * model_.edge_length;
}

bool BladeWay::is_far(const SurfacePoint& place) const {
  const SurfaceView wall = surface();
  const SurfacePoint from = state_.cut.tip ? point_at(wall.triangles, *state_.cut.tip) : *state_.cut.start;
  return (position_of(wall, place) - position_of(wall, from)).norm() > kLeftBehind * model_.edge_length;
}

}  // namespace thinwall
