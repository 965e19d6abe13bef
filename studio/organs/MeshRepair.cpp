#include "studio/organs/MeshRepair.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <set>
#include <unordered_map>
#include <utility>

#include "engine/mesh/MeshMeasures.hpp"
#include "engine/mesh/MeshTopology.hpp"

namespace thinwall {
namespace {

using Cell = std::array<std::int64_t, 3>;

struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    std::uint64_t hash = 0;
    for (const std::int64_t index : cell) hash = (hash ^ static_cast<std::uint64_t>(index)) * 0x9e3779b97f4a7c15u;
    return hash ^ (hash >> 32);
  }
};

Cell cell_of(const Eigen::Vector3d& point, double size) {
  Cell cell{};
  for (int axis = 0; axis < 3; ++axis) cell[axis] = static_cast<std::int64_t>(std::floor(point[axis] / size));
  return cell;
}

/// Vertices kept so far, found by place. Only looked up, never walked through, so its order plays no part.
class KeptVertices {
 public:
  explicit KeptVertices(double tolerance) : tolerance_(tolerance), size_(8 * tolerance) {}

  /// The first kept vertex within the tolerance, or -1.
  int near(const Eigen::Vector3d& point, const std::vector<Eigen::Vector3d>& vertices) const {
    const Cell low = cell_of(point.array() - tolerance_, size_);
    const Cell high = cell_of(point.array() + tolerance_, size_);
    int first = -1;
    for (std::int64_t i = low[0]; i <= high[0]; ++i) {
      for (std::int64_t j = low[1]; j <= high[1]; ++j) {
        for (std::int64_t k = low[2]; k <= high[2]; ++k) {
          const auto found = cells_.find({i, j, k});
          if (found == cells_.end()) continue;
          for (const int v : found->second) {
            if ((vertices[v] - point).norm() <= tolerance_ && (first < 0 || v < first)) first = v;
          }
        }
      }
    }
    return first;
  }
  void add(int vertex, const Eigen::Vector3d& point) { cells_[cell_of(point, size_)].push_back(vertex); }

 private:
  double tolerance_;
  double size_;
  std::unordered_map<Cell, std::vector<int>, CellHash> cells_;
};

/// The corner at which the longest edge starts.
int longest_edge(const RawSurface& surface, const Eigen::Vector3i& t) {
  const auto length = [&](int k) { return (surface.vertices[t[(k + 1) % 3]] - surface.vertices[t[k]]).norm(); };
  int longest = 0;
  for (int k = 1; k < 3; ++k) {
    if (length(k) > length(longest)) longest = k;
  }
  return longest;
}

double lowest_height(const RawSurface& surface, const Eigen::Vector3i& t) {
  const int k = longest_edge(surface, t);
  const Eigen::Vector3d edge = surface.vertices[t[(k + 1) % 3]] - surface.vertices[t[k]];
  const Eigen::Vector3d side = surface.vertices[t[(k + 2) % 3]] - surface.vertices[t[k]];
  return edge.cross(side).norm() / edge.norm();
}

/// Turns the longest edge (a, b) of triangle (a, b, c) into the edge from c to the neighbour's far corner d. Gives
/// false when there is no single neighbour or that edge is there already.
bool turn_longest_edge(RawSurface& surface, const MeshTopology& topology, int t, std::vector<bool>& touched) {
  const Eigen::Vector3i triangle = surface.triangles[t];
  const int k = longest_edge(surface, triangle);
  const int a = triangle[k];
  const int b = triangle[(k + 1) % 3];
  const int c = triangle[(k + 2) % 3];
  const std::span<const int> pair = triangles_at(topology, topology.triangle_edges[t][k]);
  if (pair.size() != 2) return false;
  const int neighbour = pair[0] == t ? pair[1] : pair[0];
  const Eigen::Vector3i other = surface.triangles[neighbour];
  const int d = other.sum() - a - b;
  const std::array<int, 2> ends = {std::min(c, d), std::max(c, d)};
  if (c == d || std::binary_search(topology.edges.begin(), topology.edges.end(), ends)) return false;
  for (const int near : {t, neighbour}) {
    for (const int edge : topology.triangle_edges[near]) {
      for (const int reached : triangles_at(topology, edge)) {
        if (touched[reached]) return false;
      }
    }
  }
  touched[t] = touched[neighbour] = true;
  bool neighbour_runs_along = false;  // its sense along the edge; contrary to the triangle's when the two agree
  for (int i = 0; i < 3; ++i) neighbour_runs_along |= other[i] == a && other[(i + 1) % 3] == b;
  surface.triangles[t] = {a, d, c};
  surface.triangles[neighbour] = neighbour_runs_along ? Eigen::Vector3i(c, b, d) : Eigen::Vector3i(d, b, c);
  surface.parts[t] = surface.parts[neighbour];
  return true;
}

/// Gives each triangle the sense of the first of its component, across edges of two triangles.
std::vector<bool> senses_from_first(const RawSurface& surface, const MeshTopology& topology, bool& orientable) {
  const auto runs_up = [&](int t, int edge) {
    for (int k = 0; k < 3; ++k) {
      if (topology.triangle_edges[t][k] == edge) return surface.triangles[t][k] == topology.edges[edge][0];
    }
    return false;
  };
  const int count = static_cast<int>(surface.triangles.size());
  std::vector<bool> turned(count, false);
  std::vector<bool> reached(count, false);
  std::vector<int> waiting;
  for (int seed = 0; seed < count; ++seed) {
    if (reached[seed]) continue;
    reached[seed] = true;
    waiting.push_back(seed);
    while (!waiting.empty()) {
      const int t = waiting.back();
      waiting.pop_back();
      for (const int edge : topology.triangle_edges[t]) {
        const std::span<const int> pair = triangles_at(topology, edge);
        if (pair.size() != 2) continue;
        const int next = pair[0] == t ? pair[1] : pair[0];
        const bool agrees = runs_up(t, edge) != runs_up(next, edge);
        const bool wanted = agrees ? turned[t] : !turned[t];
        if (reached[next]) {
          orientable = orientable && turned[next] == wanted;
          continue;
        }
        reached[next] = true;
        turned[next] = wanted;
        waiting.push_back(next);
      }
    }
  }
  return turned;
}

struct VolumeAndArea {
  double volume = 0;
  double area = 0;
};

/// Area, and volume with open loops closed by fans to the middle of the corners: about that point the fans add nothing.
VolumeAndArea measure(const RawSurface& surface, const std::vector<int>& triangles) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const int t : triangles) {
    for (const int v : surface.triangles[t]) middle += surface.vertices[v];
  }
  middle /= 3.0 * static_cast<double>(triangles.size());
  VolumeAndArea result;
  for (const int t : triangles) {
    const Eigen::Vector3d a = surface.vertices[surface.triangles[t][0]] - middle;
    const Eigen::Vector3d b = surface.vertices[surface.triangles[t][1]] - middle;
    const Eigen::Vector3d c = surface.vertices[surface.triangles[t][2]] - middle;
    result.volume += a.dot(b.cross(c)) / 6;
    result.area += 0.5 * (b - a).cross(c - a).norm();
  }
  return result;
}

bool faces_inwards(const RawSurface& surface, const MeshTopology& topology, const std::vector<int>& members) {
  const bool is_open = std::any_of(members.begin(), members.end(), [&](int t) {
    const std::array<int, 3>& edges = topology.triangle_edges[t];
    return std::any_of(edges.begin(), edges.end(), [&](int e) { return triangles_at(topology, e).size() == 1; });
  });
  // A flat or slightly bent sheet has no inside: its volume is far below that of a body of its area.
  const VolumeAndArea size = measure(surface, members);
  return size.volume < (is_open ? -1e-3 * std::pow(size.area, 1.5) : 0);
}

std::vector<std::vector<int>> triangles_by_component(const MeshTopology& topology) {
  std::vector<std::vector<int>> members(topology.component_count);
  for (int t = 0; t < static_cast<int>(topology.triangle_component.size()); ++t) {
    members[topology.triangle_component[t]].push_back(t);
  }
  return members;
}

}  // namespace

MeshTopology topology_of_surface(const RawSurface& surface) {
  return topology_of(static_cast<int>(surface.vertices.size()), surface.triangles);
}

double extent_of(const RawSurface& surface) {
  if (surface.vertices.empty()) return 0;
  return bounding_box(surface.vertices).sizes().norm();
}

int keep_marked(RawSurface& surface, const std::vector<bool>& keep) {
  std::size_t kept = 0;
  for (std::size_t t = 0; t < keep.size(); ++t) {
    if (!keep[t]) continue;
    surface.triangles[kept] = surface.triangles[t];
    surface.parts[kept] = surface.parts[t];
    ++kept;
  }
  surface.triangles.resize(kept);
  surface.parts.resize(kept);
  return static_cast<int>(keep.size() - kept);
}

int weld_vertices(RawSurface& surface, double tolerance) {
  KeptVertices kept(tolerance);
  std::vector<int> target(surface.vertices.size());
  int merged = 0;
  for (int v = 0; v < static_cast<int>(surface.vertices.size()); ++v) {
    const int first = kept.near(surface.vertices[v], surface.vertices);
    target[v] = first < 0 ? v : first;
    if (first < 0) {
      kept.add(v, surface.vertices[v]);
    } else if (surface.vertices[v] != surface.vertices[first]) {
      ++merged;
    }
  }
  for (Eigen::Vector3i& t : surface.triangles) {
    for (int& v : t) v = target[v];
  }
  return merged;
}

int remove_collapsed_triangles(RawSurface& surface) {
  std::vector<bool> keep;
  for (const Eigen::Vector3i& t : surface.triangles) keep.push_back(t[0] != t[1] && t[1] != t[2] && t[2] != t[0]);
  return keep_marked(surface, keep);
}

int remove_repeated_triangles(RawSurface& surface) {
  std::set<std::array<int, 3>> seen;
  std::vector<bool> keep;
  for (const Eigen::Vector3i& t : surface.triangles) {
    std::array<int, 3> corners = {t[0], t[1], t[2]};
    std::sort(corners.begin(), corners.end());
    keep.push_back(seen.insert(corners).second);
  }
  return keep_marked(surface, keep);
}

int remove_flat_triangles(RawSurface& surface, double tolerance) {
  // Turning an edge may leave the neighbour flat in turn, so again until nothing turns. Flat triangles side by side
  // could turn in a circle for ever: after so many rounds they are removed like those that cannot turn.
  constexpr int kMostRounds = 100;
  int treated = 0;
  for (int round = 0;; ++round) {
    const MeshTopology topology = topology_of_surface(surface);
    std::vector<bool> touched(surface.triangles.size(), false);
    std::vector<bool> keep(surface.triangles.size(), true);
    int turned = 0;
    for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
      if (touched[t] || lowest_height(surface, surface.triangles[t]) > tolerance) continue;
      if (round < kMostRounds && turn_longest_edge(surface, topology, t, touched)) {
        ++turned;
      } else {
        keep[t] = false;
      }
    }
    treated += turned;
    if (turned == 0) return treated + keep_marked(surface, keep);
  }
}

int remove_unused_vertices(RawSurface& surface) {
  std::vector<int> place(surface.vertices.size(), -1);
  for (const Eigen::Vector3i& t : surface.triangles) {
    for (const int v : t) place[v] = 0;
  }
  int kept = 0;
  for (std::size_t v = 0; v < place.size(); ++v) {
    if (place[v] < 0) continue;
    surface.vertices[kept] = surface.vertices[v];
    place[v] = kept++;
  }
  surface.vertices.resize(kept);
  for (Eigen::Vector3i& t : surface.triangles) {
    for (int& v : t) v = place[v];
  }
  return static_cast<int>(place.size()) - kept;
}

OrientationResult make_agree(RawSurface& surface) {
  OrientationResult result;
  const MeshTopology topology = topology_of_surface(surface);
  std::vector<bool> turned = senses_from_first(surface, topology, result.orientable);
  if (!result.orientable) return result;
  const std::vector<double> areas = triangle_areas(surface.vertices, surface.triangles);
  for (const std::vector<int>& members : triangles_by_component(topology)) {
    double turned_area = 0;
    double area = 0;
    for (const int t : members) {
      area += areas[t];
      if (turned[t]) turned_area += areas[t];
    }
    const bool first_was_wrong = 2 * turned_area > area;
    for (const int t : members) {
      if (turned[t] == first_was_wrong) continue;
      std::swap(surface.triangles[t][1], surface.triangles[t][2]);
      ++result.turned;
    }
  }
  return result;
}

OrientationResult orient_outwards(RawSurface& surface) {
  OrientationResult result = make_agree(surface);
  if (!result.orientable) return result;
  const MeshTopology topology = topology_of_surface(surface);
  for (const std::vector<int>& members : triangles_by_component(topology)) {
    if (!faces_inwards(surface, topology, members)) continue;
    for (const int t : members) std::swap(surface.triangles[t][1], surface.triangles[t][2]);
    ++result.turned_inside;
  }
  return result;
}

std::vector<SurfaceComponent> components_of(const RawSurface& surface) {
  std::vector<SurfaceComponent> components;
  for (const std::vector<int>& members : triangles_by_component(topology_of_surface(surface))) {
    components.push_back({static_cast<int>(members.size()), measure(surface, members).area});
  }
  return components;
}

void keep_component(RawSurface& surface, int component) {
  const MeshTopology topology = topology_of_surface(surface);
  std::vector<bool> keep;
  for (const int c : topology.triangle_component) keep.push_back(c == component);
  keep_marked(surface, keep);
  remove_unused_vertices(surface);
}

}  // namespace thinwall
