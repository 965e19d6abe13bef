#include "engine/tool/FirstContact.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "engine/contact/SolidGap.hpp"
#include "engine/tool/ToolSolids.hpp"

namespace thinwall {
namespace {

using Corners = std::array<Eigen::Vector3d, 3>;

/// Entry of a line into one triangle through its outer side (signed volumes; a hit on an edge belongs to both sides).
std::optional<SurfaceEntry> entry(const Corners& corners, const Eigen::Vector3d& origin,
                                  const Eigen::Vector3d& direction, bool both_sides) {
  const Eigen::Vector3d a = corners[0] - origin, b = corners[1] - origin, c = corners[2] - origin;
  Eigen::Vector3d weights(-direction.dot(b.cross(c)), -direction.dot(c.cross(a)), -direction.dot(a.cross(b)));
  const double sum = weights.sum();
  if (!(both_sides ? sum != 0 : sum > 0)) return std::nullopt;  // parallel, or through the inner side
  weights /= sum;
  if (weights.minCoeff() < -1e-12) return std::nullopt;
  return SurfaceEntry{{.triangle = 0, .weights = weights},
                      direction.dot(weights[0] * a + weights[1] * b + weights[2] * c)};
}

void keep_smaller(std::optional<double>& best, double value) {
  if (!best || value < *best) best = value;
}

/// How often Newton's method may go on towards a first contact; it takes some ten turns at most.
constexpr int kTravelTurns = 60;

/// Nearer than this a solid touches, metres.
constexpr double kTouch = 1e-15;

/// Travel of a solid along a unit vector until it touches a triangle. The gap between two convex sets is a convex
/// function of the travel, so that Newton's steps from ahead of the contact never pass it; where the gap stops falling
/// the solid passes beside the triangle.
std::optional<double> solid_travel(const Corners& corners, ToolSolid solid, const Eigen::Vector3d& motion) {
  const Eigen::Vector3d start = solid.center;
  const Eigen::Vector3d middle = (corners[0] + corners[1] + corners[2]) / 3;
  double extent = solid.extent();
  for (const Eigen::Vector3d& corner : corners) extent = std::max(extent, solid.extent() + (corner - middle).norm());
  const Eigen::Vector3d way = middle - start;
  if ((way - motion * motion.dot(way)).norm() > extent) return std::nullopt;
  // Far away the slope of the gap says little about where it ends: the balls around the two cannot touch before this.
  double travel = std::max(0.0, motion.dot(way) - extent);
  for (int turn = 0; turn < kTravelTurns; ++turn) {
    solid.center = start + travel * motion;
    const auto gap = solid_gap(solid, std::numeric_limits<double>::infinity(), corners, SitePart::kFace);
    if (std::abs(gap->gap) <= kTouch) return travel;
    const double closing = gap->normal.dot(motion);  // the gap falls by this for each length of travel
    if (closing <= 0) return gap->gap < 0 ? std::optional(gap->gap) : std::nullopt;
    const double next = travel + gap->gap / closing;
    if (next == travel) return travel;
    travel = next;
    if (travel > motion.dot(way) + extent) return std::nullopt;
  }
  return travel;
}

/// Coordinates in the frame of a pose: across (x'), along (y') and ahead (z') of the tip.
Eigen::Vector3d in_tool_frame(const ToolPose& pose, const Eigen::Vector3d& point) {
  const Eigen::Vector3d offset = point - pose.tip;
  return {offset.dot(pose.axis.cross(pose.direction)), offset.dot(pose.axis), offset.dot(pose.direction)};
}

std::optional<double> line_travel(const Corners& corners, double half_length, const ToolPose& pose) {
  std::array<Eigen::Vector3d, 3> local;
  for (int k = 0; k < 3; ++k) local[k] = in_tool_frame(pose, corners[k]);
  std::vector<Eigen::Vector2d> cut;  // (along, ahead) of the points where the plane of motion meets the edges
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d &from = local[k], &to = local[(k + 1) % 3];
    if (from.x() == 0) cut.emplace_back(from.y(), from.z());
    if (from.x() * to.x() < 0) {
      const double t = from.x() / (from.x() - to.x());
      const Eigen::Vector3d point = from + t * (to - from);
      cut.emplace_back(point.y(), point.z());
    }
  }
  std::optional<double> best;
  for (const Eigen::Vector2d& point : cut) {
    if (std::abs(point.x()) <= half_length) keep_smaller(best, point.y());
  }
  if (cut.size() < 2) return best;
  for (const double end : {-half_length, half_length}) {
    const double run = cut[1].x() - cut[0].x();
    const double t = (end - cut[0].x()) / run;
    if (run != 0 && t >= 0 && t <= 1) keep_smaller(best, cut[0].y() + t * (cut[1].y() - cut[0].y()));
  }
  return best;
}

/// Nearer than this part of an edge to its end, a crossing is taken to be the vertex: attachments at both would
/// prescribe nearly the same motion twice.
constexpr double kVertexSnap = 0.05;

/// A segment reaches this far beyond its ends, metres: a step that ends within round-off of the surface and the next
/// one, which begins there, must not both miss it.
constexpr double kSegmentSlack = 1e-9;

}  // namespace

std::optional<SurfaceEntry> first_entry(const SurfaceView& surface, const Eigen::Vector3d& origin,
                                        const Eigen::Vector3d& direction) {
  std::optional<SurfaceEntry> best;
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
    const auto hit = entry(corners_of(surface, t), origin, direction, surface.open);
    if (hit && (!best || hit->travel < best->travel)) {
      best = hit;
      best->triangle = t;
    }
  }
  return best;
}

std::optional<SurfaceEntry> first_entry_on_segment(const SurfaceView& surface, const Eigen::Vector3d& begin,
                                                   const Eigen::Vector3d& end) {
  return nearest_entry_on_segment(surface, begin, end, begin - (end - begin));
}

std::optional<SurfaceEntry> nearest_entry_on_segment(const SurfaceView& surface, const Eigen::Vector3d& begin,
                                                     const Eigen::Vector3d& end, const Eigen::Vector3d& place) {
  const double length = (end - begin).norm();
  if (length == 0) return std::nullopt;
  const Eigen::Vector3d direction = (end - begin) / length;
  const double wanted = (place - begin).dot(direction);  // metres from `begin`
  std::optional<SurfaceEntry> best;
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
    const auto hit = entry(corners_of(surface, t), begin, direction, surface.open);
    const bool reached = hit && hit->travel >= -kSegmentSlack && hit->travel <= length + kSegmentSlack;
    if (reached && (!best || std::abs(hit->travel - wanted) < std::abs(best->travel - wanted))) {
      best = hit;
      best->triangle = t;
    }
  }
  return best;
}

std::optional<SurfaceEntry> overrun_by(const SurfaceView& surface, const Eigen::VectorXd& before,
                                       const Eigen::Vector3d& point, const Eigen::Vector3d& direction) {
  const SurfaceView earlier{.triangles = surface.triangles, .position = before, .open = surface.open};
  std::optional<SurfaceEntry> best;
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
    const auto hit = entry(corners_of(surface, t), point, direction, surface.open);
    if (!hit || hit->travel > 0 || (best && hit->travel <= best->travel)) continue;
    const Corners corners = corners_of(earlier, t);
    Eigen::Vector3d was = -point;
    for (int k = 0; k < 3; ++k) was += hit->weights[k] * corners[k];
    if (was.dot(direction) <= 0) continue;
    best = hit;
    best->triangle = t;
  }
  return best;
}

std::optional<double> travel_to_contact(const SurfaceView& surface, const ToolDefinition& tool, const ToolPose& pose,
                                        const Eigen::Vector3d& motion) {
  if (tool.kind == ToolKind::kPoint) {
    const auto hit = first_entry(surface, pose.tip, motion);
    return hit ? std::optional<double>(hit->travel) : std::nullopt;
  }
  std::optional<double> best;
  if (tool.kind == ToolKind::kLine) {
    // A line slides along itself without meeting anything new; only its motion across itself counts.
    const Eigen::Vector3d across = motion - pose.axis * pose.axis.dot(motion);
    if (across.norm() < 1e-9) return std::nullopt;
    const ToolPose sweep{.tip = pose.tip, .direction = across.normalized(), .axis = pose.axis};
    for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
      if (const auto travel = line_travel(corners_of(surface, t), 0.5 * tool.length, sweep))
        keep_smaller(best, *travel);
    }
    if (best) *best /= across.norm();
    return best;
  }
  for (const ToolSolid& solid : tool_solids(tool, pose)) {
    for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
      if (const auto travel = solid_travel(corners_of(surface, t), solid, motion)) keep_smaller(best, *travel);
    }
  }
  return best;
}

std::vector<LineCrossing> line_crossings(const SurfaceView& surface, const ToolDefinition& tool, const ToolPose& pose) {
  std::vector<LineCrossing> crossings;
  std::set<std::pair<int, int>> seen;  // vertex pair of an edge, or a vertex twice
  const auto add = [&](int triangle, const Eigen::Vector3d& weights, std::pair<int, int> key) {
    if (!seen.insert(key).second) return;
    const Corners corners = corners_of(surface, triangle);
    const Eigen::Vector3d local =
        in_tool_frame(pose, weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2]);
    if (std::abs(local.y()) <= 0.5 * tool.length * (1 + 1e-9)) {
      crossings.push_back({.triangle = triangle, .weights = weights, .along = local.y(), .travel = local.z()});
    }
  };
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
    const Corners corners = corners_of(surface, t);
    const Eigen::Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    if (!surface.open && normal.dot(pose.direction) >= 0) continue;
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3;
      const double from = in_tool_frame(pose, corners[k]).x(), to = in_tool_frame(pose, corners[next]).x();
      const double reach = kVertexSnap * std::max(std::abs(from - to), 0.02 * (corners[next] - corners[k]).norm());
      const int vertex = surface.triangles[t][k], other = surface.triangles[t][next];
      if (std::abs(from) <= reach) {
        add(t, Eigen::Vector3d::Unit(k), {vertex, vertex});
      } else if (std::abs(to) > reach && from * to < 0) {
        Eigen::Vector3d weights = Eigen::Vector3d::Zero();
        weights[next] = from / (from - to);
        weights[k] = 1 - weights[next];
        add(t, weights, std::minmax(vertex, other));
      }
    }
  }
  return crossings;
}

}  // namespace thinwall
