#include "engine/cutting/CutPlanning.hpp"

#include <algorithm>
#include <cmath>

#include "engine/cutting/CutQuality.hpp"
#include "engine/cutting/EdgeRoute.hpp"
#include "engine/cutting/MeshImprovement.hpp"
#include "engine/cutting/PathInsertion.hpp"
#include "engine/cutting/PathSnapping.hpp"

namespace thinwall {
namespace {

constexpr int kMostTrials = 12;
constexpr double kEnough = 0.45;  // radians, angles that are not improved further

/// One way to bring the path into the patch.
struct Trial {
  CutPatch patch;
  std::vector<PathNode> nodes;
  InsertedPath path;
  int trouble = -1;  // triangle or -1
  bool empty = false;
};

/// The sharpest triangle that breaks the rule, or one where lines meet that ought to be one; -1: none.
int find_trouble(const CutPatch& patch, double least) {
  int trouble = -1;
  const double meeting = least_meeting_angle(patch);
  double worst = std::cos(std::min(least, 0.5 * meeting)) + 1e-12;
  for (int t = 0; t < patch.triangle_count(); ++t) {
    if (!patch.changed[t]) continue;
    const double value = sharpness(patch, t);
    if (value <= worst) continue;
    worst = value;
    trouble = t;
  }
  if (trouble >= 0 || meeting >= kMergingAngle) return trouble;
  for (int t = 0; t < patch.triangle_count(); ++t) {  // the sharpest triangle at the path stands for the wedge
    const std::array<char, 3>& marks = patch.on_path[t];
    if (!(marks[0] || marks[1] || marks[2])) continue;
    if (trouble < 0 || sharpness(patch, t) > sharpness(patch, trouble)) trouble = t;
  }
  return trouble;
}

Trial try_nodes(const CutPatch& patch, std::span<const PathStop> stops, const RefusedChoices& refused, double least) {
  Trial trial{.patch = patch, .nodes = snap_path(patch, stops, refused, 1.05 * least), .path = {}};
  if (trial.nodes.size() < 2) {
    trial.empty = true;
    return trial;
  }
  trial.path = insert_path(trial.patch, trial.nodes);
  if (!trial.path.complete) return trial;
  if (!drop_closed_edges(trial.patch)) {
    trial.empty = true;
    return trial;
  }
  improve(trial.patch, 1.001 * least, std::max(kEnough, least));
  trial.trouble = find_trouble(trial.patch, least);
  return trial;
}

/// Refuses the choices behind a trial's trouble; false when there is none left to refuse.
bool refuse_culprits(const Trial& trial, RefusedChoices& refused) {
  const auto refuse = [&](const PathNode& node) { return refused.insert({node.stop, node.choice}).second; };
  if (!trial.path.complete) {
    const int stuck = trial.path.troubled_node;
    bool any = refuse(trial.nodes[stuck]);
    if (stuck + 1 < static_cast<int>(trial.nodes.size())) any |= refuse(trial.nodes[stuck + 1]);
    return any;
  }
  const Eigen::Vector3i& corners = trial.patch.triangles[trial.trouble];
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const int corner : corners) middle += trial.patch.positions[corner] / 3;
  bool any = false;
  for (std::size_t i = 0; i < trial.nodes.size(); ++i) {
    const bool at_corner = (corners.array() == trial.path.node_vertices[i]).any();
    if (at_corner && trial.nodes[i].place.kind != PlaceKind::kVertex) any |= refuse(trial.nodes[i]);
  }
  if (any) return true;
  // No new node is at the triangle: the nearest one that is left is refused.
  const PathNode* nearest = nullptr;
  double least = 1e300;
  for (const PathNode& node : trial.nodes) {
    const double penalty = node.place.kind == PlaceKind::kVertex ? 10 : 1;
    const double distance = penalty * (node.place.position - middle).norm();
    if (refused.count({node.stop, node.choice}) || distance >= least) continue;
    least = distance;
    nearest = &node;
  }
  return nearest && refuse(*nearest);
}

PlannedCut planned(Trial trial) {
  const PathNode& last = trial.nodes.back();
  PlannedCut plan{.patch = std::move(trial.patch),
                  .vertices = std::move(trial.path.vertices),
                  .reached_stop = last.passed,
                  .reached = last.wanted};
  for (const PathNode& node : trial.nodes) {
    plan.snapped_nodes += (node.place.position - node.wanted).squaredNorm() > 0;
  }
  return plan;
}

int nearest_vertex(const CutPatch& patch, const PatchPlace& place) {
  if (place.kind == PlaceKind::kVertex) return place.vertex;
  if (place.kind == PlaceKind::kSide) return place.along < 0.5 ? place.from : place.to;
  const int triangle = patch.locate(place.facet, place.position).first;
  int nearest = patch.triangles[triangle][0];
  for (const int vertex : patch.triangles[triangle]) {
    const auto& p = patch.positions;
    if ((p[vertex] - place.position).norm() < (p[nearest] - place.position).norm()) nearest = vertex;
  }
  return nearest;
}

/// Along edges that are there, through the vertices nearest to the stops.
PlannedCut plan_along_edges(const CutPatch& patch, std::span<const PathStop> stops) {
  PlannedCut plan{.patch = patch, .vertices = {}, .along_edges = true};
  const std::vector<Eigen::Vector3d> line = corners_of(stops);
  const int from = nearest_vertex(patch, stops.front().place), to = nearest_vertex(patch, stops.back().place);
  plan.vertices = route_along_edges(patch, from, to, line);
  if (plan.vertices.size() < 2) return {.patch = patch, .vertices = {}};
  for (std::size_t i = 0; i + 1 < plan.vertices.size(); ++i) {
    const int u = plan.vertices[i], v = plan.vertices[i + 1];
    PatchCorner side = plan.patch.side_between(u, v);
    if (side.triangle < 0) side = plan.patch.side_between(v, u);
    if (plan.patch.neighbours[side.triangle][side.corner] != CutPatch::kBorder) plan.patch.set_on_path(u, v);
  }
  if (!drop_closed_edges(plan.patch)) return {.patch = patch, .vertices = {}};
  plan.reached_stop = static_cast<int>(stops.size()) - 1;
  plan.reached = stops.back().place.position;
  plan.snapped_nodes = static_cast<int>(plan.vertices.size());
  return plan;
}

bool ends_at_border(const CutPatch& patch, const PatchPlace& place) {
  if (place.kind == PlaceKind::kVertex) return !patch.fan_of(place.vertex).closed;
  if (place.kind == PlaceKind::kFace) return false;
  return patch.side_between(place.from, place.to).triangle < 0 || patch.side_between(place.to, place.from).triangle < 0;
}

}  // namespace

PlannedCut plan_cut(const CutPatch& patch, std::span<const PathStop> stops) {
  if (stops.size() < 2) return {.patch = patch, .vertices = {}};
  const double least = std::min(kGoodAngle, least_angle(patch));
  RefusedChoices refused;
  for (int i = 0; i < kMostTrials; ++i) {
    Trial trial = try_nodes(patch, stops, refused, least);
    if (trial.empty) break;
    if (trial.path.complete && trial.trouble < 0) return planned(std::move(trial));
    if (!refuse_culprits(trial, refused)) break;
  }
  // A cut that cannot go on yet waits for the path to grow; one that ends at a border must get there.
  const std::vector<Eigen::Vector3d> line = corners_of(stops);
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
  const int facet = facets_at(patch, stops.front().place).front();
  const double scale = patch.scale[patch.locate(facet, line.front()).first];
  if (length < scale && !ends_at_border(patch, stops.back().place)) return {.patch = patch, .vertices = {}};
  return plan_along_edges(patch, stops);
}

}  // namespace thinwall
