#include "engine/cutting/CutSurface.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <unordered_map>

#include "engine/cutting/CutBooks.hpp"
#include "engine/cutting/CutPlanning.hpp"
#include "engine/cutting/CutQuality.hpp"
#include "engine/cutting/LipOpening.hpp"
#include "engine/cutting/PatchNumbers.hpp"
#include "engine/cutting/PathRefinement.hpp"
#include "engine/cutting/WantedPath.hpp"
#include "engine/mesh/MeshTopology.hpp"

namespace thinwall {
namespace {

/// The numbers on a patch of those that lie on it. `local`: (numbers), -1 beside it.
std::vector<int> locals_of(const std::vector<int>& numbers, const std::vector<int>& local) {
  std::vector<int> found;
  for (const int number : numbers) {
    if (number >= 0 && number < static_cast<int>(local.size()) && local[number] >= 0) found.push_back(local[number]);
  }
  return found;
}

constexpr double kFlat = 1e-6;  // sine of an angle: triangles that deviate less lie in one plane

Eigen::Vector3d normal_of(const SurfaceMesh& mesh, int triangle) {
  const Eigen::Vector3i& t = mesh.triangles[triangle];
  const auto& p = mesh.vertices;
  return (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).normalized();
}

double mean_edge(const SurfaceMesh& mesh, const Eigen::Vector3i& t) {
  double sum = 0;
  for (int k = 0; k < 3; ++k) sum += (mesh.vertices[t[(k + 1) % 3]] - mesh.vertices[t[k]]).norm();
  return sum / 3;
}

}  // namespace

CutSurface::CutSurface(SurfaceMesh mesh) : mesh_(std::move(mesh)), rim_(mesh_.cap_triangles) {
  const int vertices = static_cast<int>(mesh_.vertices.size()), triangles = static_cast<int>(mesh_.triangles.size());
  const MeshTopology topology = topology_of(vertices, mesh_.triangles);
  if (!is_oriented_manifold(topology)) {
    throw std::invalid_argument(
        "a wall to be cut must be an oriented manifold: its edges have at most two triangles "
        "of equal sense, and the triangles of a vertex form one fan");
  }
  neighbours_.assign(triangles, Eigen::Vector3i::Constant(CutPatch::kBorder));
  vertex_triangle_.assign(vertices, -1);
  for (int t = 0; t < triangles; ++t) {
    for (int k = 0; k < 3; ++k) {
      vertex_triangle_[mesh_.triangles[t][k]] = t;
      for (const int other : triangles_at(topology, topology.triangle_edges[t][k])) {
        if (other != t) neighbours_[t][k] = other;
      }
    }
    scale_.push_back(mean_edge(mesh_, mesh_.triangles[t]));
  }
  component_ = topology.triangle_component;
  component_count_ = topology.component_count;
  find_facets();
  for (const auto& [name, members] : mesh_.groups) {
    std::vector<char> is_member(vertices, 0);
    for (const int member : members) is_member[member] = 1;
    is_member_.emplace_back(name, std::move(is_member));
  }
}

/// Flat pieces: a triangle belongs to that of its neighbour when it lies in the plane of the piece's first triangle.
void CutSurface::find_facets() {
  facet_.assign(mesh_.triangles.size(), -1);
  std::vector<int> waiting;
  for (int seed = 0; seed < static_cast<int>(facet_.size()); ++seed) {
    if (facet_[seed] >= 0) continue;
    const int facet = static_cast<int>(facet_normals_.size());
    const Eigen::Vector3d normal = normal_of(mesh_, seed), origin = mesh_.vertices[mesh_.triangles[seed][0]];
    facet_normals_.push_back(normal);
    facet_[seed] = facet;
    waiting.push_back(seed);
    while (!waiting.empty()) {
      const int t = waiting.back();
      waiting.pop_back();
      for (const int next : neighbours_[t]) {
        if (next < 0 || facet_[next] >= 0 || normal_of(mesh_, next).dot(normal) < 0.5) continue;
        const bool in_plane = std::ranges::all_of(mesh_.triangles[next], [&](int vertex) {
          return std::abs(normal.dot(mesh_.vertices[vertex] - origin)) < kFlat * scale_[next];
        });
        if (!in_plane || normal_of(mesh_, next).cross(normal).norm() > kFlat) continue;
        facet_[next] = facet;
        waiting.push_back(next);
      }
    }
  }
}

std::vector<int> CutSurface::fan_of(int vertex) const {
  std::vector<int> fan;
  const auto corner_of = [&](int t) {
    return static_cast<int>(std::ranges::find(mesh_.triangles[t], vertex) - mesh_.triangles[t].begin());
  };
  const int start = vertex_triangle_[vertex];
  int t = start;
  do {
    fan.push_back(t);
    t = neighbours_[t][(corner_of(t) + 2) % 3];
  } while (t >= 0 && t != start);
  if (t == start) return fan;
  for (t = neighbours_[start][corner_of(start)]; t >= 0; t = neighbours_[t][corner_of(t)]) fan.push_back(t);
  return fan;
}

void CutSurface::check_path(const CutPath& path) const {
  if (path.from &&
      (*path.from < 0 || *path.from >= static_cast<int>(vertex_triangle_.size()) || vertex_triangle_[*path.from] < 0)) {
    throw std::invalid_argument("a cut goes on from vertex " + std::to_string(*path.from) +
                                ", which is none of the wall");
  }
  for (const SurfacePoint& point : path.points) {
    const bool known = point.triangle >= 0 && point.triangle < static_cast<int>(mesh_.triangles.size());
    if (!known || !point.weights.allFinite() || point.weights.minCoeff() < -1e-6 ||
        std::abs(point.weights.sum() - 1) > 1e-6) {
      throw std::invalid_argument("a point of a cut path is none of the wall: triangle " +
                                  std::to_string(point.triangle) + " of " + std::to_string(mesh_.triangles.size()));
    }
  }
}

namespace {
// Rings of triangles around the path; the outermost one stays as it is.
constexpr int kRings = 3;
// As many more for a refinement, which spreads where triangles cannot be divided well: as few as will do.
constexpr std::array kRingsOfRefinement = {2, 6, 18};
}  // namespace

Eigen::Vector3d CutSurface::position_of(const SurfacePoint& point) const {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k) position += point.weights[k] * mesh_.vertices[mesh_.triangles[point.triangle][k]];
  return position;
}

std::vector<int> CutSurface::triangles_near(const CutPath& path, int rings) const {
  std::vector<char> has_triangle(mesh_.triangles.size(), 0), has_vertex(mesh_.vertices.size(), 0);
  std::vector<int> near;
  const auto add = [&](int t) {
    if (!has_triangle[t]) near.push_back(t);
    has_triangle[t] = 1;
  };
  if (path.from) add(vertex_triangle_[*path.from]);
  for (const SurfacePoint& point : path.points) add(point.triangle);
  std::vector<std::array<Eigen::Vector3d, 2>> segments;
  for (std::size_t i = 0; i + 1 < path.points.size(); ++i) {
    segments.push_back({position_of(path.points[i]), position_of(path.points[i + 1])});
  }
  if (path.from) segments.push_back({mesh_.vertices[*path.from], position_of(path.points.front())});
  // Within a flat piece points may lie far apart; the triangles between them are met on the way.
  for (const auto& segment : segments) {
    const double length = (segment[1] - segment[0]).norm();
    for (std::size_t i = 0; i < near.size() && length > scale_[near[0]]; ++i) {
      for (const int next : neighbours_[near[i]]) {
        if (next < 0 || has_triangle[next]) continue;
        const Eigen::Vector3i& t = mesh_.triangles[next];
        const Eigen::Vector3d middle = (mesh_.vertices[t[0]] + mesh_.vertices[t[1]] + mesh_.vertices[t[2]]) / 3;
        if (distance_to(segment, middle) < scale_[next]) add(next);
      }
    }
  }
  std::size_t begin = 0;
  for (int ring = 0; ring < rings; ++ring) {
    const std::size_t end = near.size();
    for (; begin < end; ++begin) {
      for (const int vertex : mesh_.triangles[near[begin]]) {
        if (has_vertex[vertex]) continue;
        has_vertex[vertex] = 1;
        for (const int t : fan_of(vertex)) add(t);
      }
    }
  }
  return near;
}

CutPatch CutSurface::extract(const CutPath& path, const CutOptions& options, int rings, PatchNumbers& numbers) const {
  CutPatch patch;
  numbers.triangles = triangles_near(path, rings);
  std::vector<int>&local_triangle = numbers.local_triangle, local_vertex(mesh_.vertices.size(), -1);
  local_triangle.assign(mesh_.triangles.size(), -1);
  std::unordered_map<int, int> local_facet;
  for (int i = 0; i < static_cast<int>(numbers.triangles.size()); ++i) local_triangle[numbers.triangles[i]] = i;
  for (int i = 0; i < static_cast<int>(numbers.triangles.size()); ++i) {
    const int t = numbers.triangles[i];
    Eigen::Vector3i corners, around;
    bool outermost = false;
    for (int k = 0; k < 3; ++k) {
      const int vertex = mesh_.triangles[t][k];
      if (local_vertex[vertex] < 0) {
        local_vertex[vertex] = static_cast<int>(numbers.vertices.size());
        numbers.vertices.push_back(vertex);
        patch.positions.push_back(mesh_.vertices[vertex]);
        if (!options.placement.empty()) patch.placement.push_back(options.placement[vertex]);
        patch.vertex_triangle.push_back(i);
      }
      corners[k] = local_vertex[vertex];
      const int next = neighbours_[t][k];
      around[k] = next < 0 ? next : local_triangle[next] >= 0 ? local_triangle[next] : CutPatch::kFrame;
    }
    for (const int vertex : mesh_.triangles[t]) {
      outermost =
          outermost || std::ranges::any_of(fan_of(vertex), [&](int other) { return local_triangle[other] < 0; });
    }
    const auto [facet, is_new] = local_facet.emplace(facet_[t], static_cast<int>(patch.facet_normals.size()));
    if (is_new) {
      patch.facet_normals.push_back(facet_normals_[facet_[t]]);
      numbers.facets.push_back(facet_[t]);
    }
    patch.triangles.push_back(corners);
    patch.neighbours.push_back(around);
    patch.facet.push_back(facet->second);
    patch.scale.push_back(scale_[t]);
    patch.frozen.push_back(outermost);
  }
  patch.changed.assign(patch.triangles.size(), 0);
  patch.on_path.assign(patch.triangles.size(), {0, 0, 0});
  patch.line.assign(patch.positions.size(), Eigen::Vector3d::Zero());
  patch.freedom.resize(patch.positions.size());
  patch.find_freedom(0);
  allow_angles_as_now(patch);
  for (const int local : locals_of(options.kept_triangles, local_triangle)) patch.frozen[local] = 1;
  for (const int local : locals_of(options.kept_vertices, local_vertex)) patch.freedom[local] = VertexFreedom::kFixed;
  return patch;
}

/// A cut that has been planned on a patch, and not written back.
struct CutSurface::Plan {
  PatchNumbers numbers;
  PatchPath start, refined;
  PlannedCut cut;

  double deviation() const { return deviation_of(refined.stops, cut); }
};

CutSurface::Plan CutSurface::start_of(const CutPath& path, const CutOptions& options, int rings) const {
  Plan plan;
  plan.start.patch = extract(path, options, rings, plan.numbers);
  plan.start.patch.path_goes_on = path.goes_on;
  std::vector<SurfacePoint> points = path.points;
  for (SurfacePoint& point : points) point.triangle = plan.numbers.local_triangle[point.triangle];
  const std::vector<int>& vertices = plan.numbers.vertices;
  std::optional<int> from;
  if (path.from) from = static_cast<int>(std::ranges::find(vertices, *path.from) - vertices.begin());
  plan.start.stops = read_path(plan.start.patch, from, points);
  plan.refined = plan.start;
  return plan;
}

CutSurface::Plan CutSurface::plan(const CutPath& path, const CutOptions& options) const {
  Plan plan;
  if (options.edge_length > 0) {
    for (const int rings : kRingsOfRefinement) {
      plan = start_of(path, options, kRings + rings);
      if (refine_along(plan.refined.patch, plan.refined.stops, options.edge_length)) break;
    }
  } else {
    plan = start_of(path, options, kRings);
  }
  plan.cut = plan_cut(plan.start, plan.refined);
  return plan;
}

double CutSurface::edge_length_at(const CutPath& path) const {
  double largest = 0;
  for (const SurfacePoint& point : path.points) largest = std::max(largest, scale_[point.triangle]);
  return largest;
}

CutSurface::Plan CutSurface::plan_close(const CutPath& path, const CutOptions& options) const {
  constexpr int kMostHalvings = 3;
  Plan best = plan(path, options);
  if (options.deviation <= 0 || best.cut.vertices.empty()) return best;
  CutOptions finer = options;
  if (finer.edge_length <= 0) finer.edge_length = edge_length_at(path);
  for (int halvings = 0; halvings < kMostHalvings && best.deviation() > options.deviation; ++halvings) {
    finer.edge_length /= 2;
    Plan next = plan(path, finer);
    if (!next.cut.vertices.empty() && next.deviation() < best.deviation()) best = std::move(next);
  }
  return best;
}

Cut CutSurface::cut(const CutPath& path, const CutOptions& options) {
  check_path(path);
  Cut result;
  result.tip = path.from;
  result.least_meeting_angle = std::numbers::pi;
  if (path.points.empty()) return result;
  Plan planned = plan_close(path, options);
  PatchNumbers& numbers = planned.numbers;
  PlannedCut& plan = planned.cut;
  const CutPatch& before = planned.start.patch;
  const std::vector<PathStop>& stops = planned.refined.stops;
  result.least_angle = least_angle(before);
  if (plan.vertices.empty()) {
    if (stops.size() > 1) result.rest = path.points;
    return result;
  }
  result.least_angle = least_angle(plan.patch);
  result.least_meeting_angle = least_meeting_angle(plan.patch);
  result.counts = {.splits = plan.patch.splits, .flips = plan.patch.flips, .edge_paths = plan.along_edges};
  result.triangles = std::move(plan.triangles);
  result.deviation = deviation_of(stops, plan);
  const std::vector<std::vector<int>> chains = split_borders(before, plan.patch);
  const std::optional<int> tip = tip_of(plan);
  OpenedLips opened = open_lips(plan.patch, plan.vertices);
  result.length = opened.length;
  result.predicted_euler_change = opened.euler_change;
  result.lips = std::move(opened.lips);
  result.rest = rest_of(stops, plan);
  count_changes(before, plan.patch, result);
  const int first_new = static_cast<int>(mesh_.vertices.size());
  add_vertices(before, plan.patch, opened.originals, numbers, result);
  add_to_groups(first_new, numbers, result);
  change_rim(chains, opened.rims, numbers);
  for (VertexSource& source : result.vertices) source.before.triangle = numbers.triangles[source.before.triangle];
  write_back(before, plan.patch, numbers, result);
  result.tip.reset();
  if (tip) result.tip = numbers.vertices[*tip];
  if (opened.may_separate) separate(result);
  result.wound_loops = wound_loops(result.lips);
  return result;
}

}  // namespace thinwall
