#include "engine/cutting/CutPlanning.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "engine/cutting/AreaOverlap.hpp"
#include "engine/cutting/CutQuality.hpp"
#include "engine/cutting/EdgeRoute.hpp"
#include "engine/cutting/MeshImprovement.hpp"
#include "engine/cutting/PathInsertion.hpp"
#include "engine/cutting/PathSnapping.hpp"

namespace thinwall {
namespace {

constexpr int kMostTrials = 12;

/// Choice of the node in the middle of an edge that is cut alone.
constexpr int kHalved = -1;

/// One way to bring the path into the patch.
struct Trial {
  CutPatch patch;
  std::vector<PathNode> nodes;
  InsertedPath path;
  std::vector<int> troubles;  // triangles
  bool empty = false;
};

/// Triangles that break the rule, the sharpest first and none with a vertex of one before it; where lines meet that
/// ought to be one, the sharpest triangle at the path stands for the wedge.
std::vector<int> find_troubles(const CutPatch& patch) {
  std::vector<std::pair<double, int>> sharp, at_path;
  for (int t = 0; t < patch.triangle_count(); ++t) {
    const std::array<char, 3>& marks = patch.on_path[t];
    if (patch.changed[t] && sharpness(patch, t) > allowed_sharpness(patch, t))
      sharp.emplace_back(-sharpness(patch, t), t);
    if (marks[0] || marks[1] || marks[2]) at_path.emplace_back(-sharpness(patch, t), t);
  }
  if (sharp.empty() && least_meeting_angle(patch) < kMergingAngle) sharp.push_back(*std::ranges::min_element(at_path));
  std::ranges::sort(sharp);
  std::vector<int> troubles;
  std::set<int> taken;
  for (const auto& [value, t] : sharp) {
    const Eigen::Vector3i& corners = patch.triangles[t];
    const bool apart = std::ranges::none_of(corners, [&](int corner) { return taken.count(corner) > 0; });
    if (apart) troubles.push_back(t);
    taken.insert(corners.begin(), corners.end());
  }
  return troubles;
}

/// A cut along one edge between places that stay single does not open: it opens in the middle of the edge.
void halve_single_edge(const CutPatch& patch, std::vector<PathNode>& nodes) {
  if (nodes.size() != 2) return;
  const PatchPlace &from = nodes[0].place, &to = nodes[1].place;
  if (from.kind != PlaceKind::kVertex || to.kind != PlaceKind::kVertex) return;
  if (!patch.are_joined(from.vertex, to.vertex)) return;
  PathNode middle = nodes.front();
  middle.choice = kHalved;
  middle.place = {.kind = PlaceKind::kSide,
                  .from = from.vertex,
                  .to = to.vertex,
                  .along = 0.5,
                  .position = 0.5 * (from.position + to.position)};
  middle.wanted = middle.place.position;
  nodes.insert(nodes.begin() + 1, middle);
}

Trial try_nodes(const CutPatch& patch, std::span<const PathStop> stops, const RefusedChoices& refused,
                bool halves_edges) {
  Trial trial{.patch = patch, .nodes = snap_path(patch, stops, refused), .path = {}, .troubles = {}};
  if (halves_edges) halve_single_edge(patch, trial.nodes);
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
  allow_wedges(trial.patch);
  improve(trial.patch);
  trial.troubles = find_troubles(trial.patch);
  return trial;
}

/// Refuses the choices of the new nodes at a bad triangle, or of the nearest node that is left.
bool refuse_at(const Trial& trial, int trouble, RefusedChoices& refused) {
  const auto refuse = [&](const PathNode& node) { return refused.insert({node.stop, node.choice}).second; };
  const Eigen::Vector3i& corners = trial.patch.triangles[trouble];
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const int corner : corners) middle += trial.patch.positions[corner] / 3;
  bool any = false;
  for (std::size_t i = 0; i < trial.nodes.size(); ++i) {
    const bool at_corner = (corners.array() == trial.path.node_vertices[i]).any();
    if (at_corner && trial.nodes[i].place.kind != PlaceKind::kVertex) any |= refuse(trial.nodes[i]);
  }
  if (any) return true;
  const PathNode* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const PathNode& node : trial.nodes) {
    const double penalty = node.place.kind == PlaceKind::kVertex ? 10 : 1;
    const double distance = penalty * (node.place.position - middle).norm();
    if (refused.count({node.stop, node.choice}) || distance >= least) continue;
    least = distance;
    nearest = &node;
  }
  return nearest && refuse(*nearest);
}

/// Refuses the choices behind a trial's troubles; false when there is none left to refuse.
bool refuse_culprits(const Trial& trial, RefusedChoices& refused) {
  bool any = false;
  if (!trial.path.complete) {
    const int stuck = trial.path.troubled_node;
    for (int i = stuck; i < std::min(stuck + 2, static_cast<int>(trial.nodes.size())); ++i) {
      any |= refused.insert({trial.nodes[i].stop, trial.nodes[i].choice}).second;
    }
  }
  for (const int trouble : trial.troubles) any |= refuse_at(trial, trouble, refused);
  return any;
}

PlannedCut planned(Trial trial, std::vector<TriangleSource> triangles) {
  const PathNode& last = trial.nodes.back();
  return {.patch = std::move(trial.patch),
          .vertices = std::move(trial.path.vertices),
          .triangles = std::move(triangles),
          .reached_stop = last.passed,
          .reached = last.wanted};
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

/// Along edges that are there, through the vertices nearest to some of the stops.
PlannedCut plan_along_edges(const CutPatch& patch, std::span<const PathStop> stops) {
  constexpr std::size_t kLeg = 4;  // stops
  PlannedCut plan{
      .patch = patch, .vertices = {nearest_vertex(patch, stops.front().place)}, .triangles = {}, .along_edges = true};
  for (std::size_t begin = 0; begin + 1 < stops.size(); begin += kLeg) {
    const std::size_t end = std::min(begin + kLeg, stops.size() - 1);
    const int to = nearest_vertex(patch, stops[end].place);
    const auto line = corners_of(stops.subspan(begin, end - begin + 1));
    const std::vector<int> leg = route_along_edges(patch, plan.vertices.back(), to, line);
    if (leg.empty()) return {.patch = patch, .vertices = {}, .triangles = {}};
    plan.vertices.insert(plan.vertices.end(), leg.begin() + 1, leg.end());
  }
  for (std::size_t i = 0; i + 1 < plan.vertices.size(); ++i) {
    const int u = plan.vertices[i], v = plan.vertices[i + 1];
    PatchCorner side = plan.patch.side_between(u, v);
    if (side.triangle < 0) side = plan.patch.side_between(v, u);
    if (!CutPatch::is_open(plan.patch.neighbours[side.triangle][side.corner])) plan.patch.set_on_path(u, v);
  }
  if (!drop_closed_edges(plan.patch)) return {.patch = patch, .vertices = {}, .triangles = {}};
  plan.reached_stop = static_cast<int>(stops.size()) - 1;
  plan.reached = stops.back().place.position;
  return plan;
}

bool ends_at_border(const CutPatch& patch, const PatchPlace& place) {
  if (place.kind == PlaceKind::kVertex) return !patch.fan_of(place.vertex).closed;
  if (place.kind == PlaceKind::kFace) return false;
  return patch.side_between(place.from, place.to).triangle < 0 || patch.side_between(place.to, place.from).triangle < 0;
}

/// Changed triangles that are sharper than what lay in their place allows, or strained far more.
std::vector<int> worse_than_before(const CutPatch& before, const CutPatch& patch,
                                   std::span<const TriangleSource> sources) {
  std::vector<int> worse;
  for (const TriangleSource& source : sources) {
    const bool good = sharpness(patch, source.triangle) <= allowed_sharpness(before, patch, source);
    if (!good || is_strained(before, patch, source)) worse.push_back(source.triangle);
  }
  return worse;
}

/// Snaps, inserts and improves until the rule is kept; without vertices where that cannot be. `halves_edges`: see
/// halve_single_edge.
PlannedCut plan_with_nodes(const CutPatch& before, const CutPatch& patch, std::span<const PathStop> stops,
                           bool halves_edges) {
  RefusedChoices refused;
  for (int i = 0; i < kMostTrials; ++i) {
    Trial trial = try_nodes(patch, stops, refused, halves_edges);
    if (trial.empty) break;
    if (trial.path.complete && trial.troubles.empty()) {
      std::vector<TriangleSource> sources = overlaps(before, trial.patch);
      trial.troubles = worse_than_before(before, trial.patch, sources);
      if (trial.troubles.empty()) return planned(std::move(trial), std::move(sources));
    }
    if (!refuse_culprits(trial, refused)) break;
  }
  return {.patch = patch, .vertices = {}, .triangles = {}};
}

/// The longest edge of the triangles at the vertices of a cut.
double longest_edge_at(const CutPatch& patch, std::span<const int> vertices) {
  double longest = 0;
  for (const int vertex : vertices) {
    for (const PatchCorner& corner : patch.fan_of(vertex).corners) {
      const Eigen::Vector3i& t = patch.triangles[corner.triangle];
      for (int k = 0; k < 3; ++k) {
        longest = std::max(longest, (patch.positions[t[(k + 1) % 3]] - patch.positions[t[k]]).norm());
      }
    }
  }
  return longest;
}

/// A cut that cannot go on yet waits for the path to grow; one that ends at a border must get there.
bool may_wait(const CutPatch& patch, std::span<const PathStop> stops) {
  const std::vector<Eigen::Vector3d> line = corners_of(stops);
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
  const int facet = facets_at(patch, stops.front().place).front();
  const double scale = patch.scale[patch.locate(facet, line.front()).first];
  return length < scale && !ends_at_border(patch, stops.back().place);
}

}  // namespace

std::vector<Eigen::Vector3d> corners_ahead(std::span<const PathStop> stops, const PlannedCut& plan) {
  if (plan.reached_stop + 1 >= static_cast<int>(stops.size())) return {};
  const PathStop& stop = stops[plan.reached_stop];
  std::vector<Eigen::Vector3d> line = {stop.place.position};
  line.insert(line.end(), stop.between.begin(), stop.between.end());
  line.push_back(stops[plan.reached_stop + 1].place.position);
  std::size_t segment = 0;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double distance = distance_to(std::span(line).subspan(i, 2), plan.reached);
    if (distance >= nearest) continue;
    nearest = distance;
    segment = i;
  }
  return {line.begin() + static_cast<std::ptrdiff_t>(segment) + 1, line.end()};
}

double deviation_of(std::span<const PathStop> stops, const PlannedCut& plan) {
  std::vector<Eigen::Vector3d> realised;
  for (const int vertex : plan.vertices) realised.push_back(plan.patch.positions[vertex]);
  const std::vector<Eigen::Vector3d> wanted = corners_of(stops);
  const std::size_t later = corners_ahead(stops, plan).size();
  double largest = 0;
  for (const Eigen::Vector3d& vertex : realised) largest = std::max(largest, distance_to(wanted, vertex));
  for (std::size_t i = 0; i + later < wanted.size(); ++i) largest = std::max(largest, distance_to(realised, wanted[i]));
  return largest;
}

PlannedCut plan_cut(const PatchPath& before, const PatchPath& refined) {
  const CutPatch& patch = refined.patch;
  const std::vector<PathStop>& stops = refined.stops;
  PlannedCut nothing{.patch = patch, .vertices = {}, .triangles = {}};
  if (stops.size() < 2) return nothing;
  PlannedCut plan = plan_with_nodes(before.patch, patch, stops, false);
  if (plan.vertices.empty()) {
    if (may_wait(patch, stops)) return nothing;
    plan = plan_with_nodes(before.patch, patch, stops, true);
  }
  if (!plan.vertices.empty()) {
    const double bound = kSnappingBound * longest_edge_at(plan.patch, plan.vertices);
    if (deviation_of(stops, plan) <= bound) return plan;
  }
  PlannedCut along = plan_along_edges(patch, stops);
  along.triangles = overlaps(before.patch, along.patch);
  if (!worse_than_before(before.patch, along.patch, along.triangles).empty()) {
    along = plan_along_edges(before.patch, before.stops);
  }
  if (along.vertices.empty()) return plan;
  const bool closer = plan.vertices.empty() || deviation_of(stops, along) < deviation_of(stops, plan);
  return closer ? along : plan;
}

}  // namespace thinwall
