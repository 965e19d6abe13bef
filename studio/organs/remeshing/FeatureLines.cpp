#include "studio/organs/remeshing/FeatureLines.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "engine/mesh/MeshMeasures.hpp"
#include "engine/mesh/MeshTopology.hpp"

namespace thinwall {
namespace {

/// The normal of a narrower triangle says something about the surface only where a neighbour bears it out.
constexpr double kSliverAngle = 10 * std::numbers::pi / 180;   // radians
constexpr double kBorneOutAngle = 3 * std::numbers::pi / 180;  // radians

constexpr int kNoLine = -1;

Eigen::Vector3d normal_of(const TriangleSurface& surface, int t) {
  const Eigen::Vector3i& c = surface.triangles[t];
  const Eigen::Vector3d& a = surface.vertices[c[0]];
  return (surface.vertices[c[1]] - a).cross(surface.vertices[c[2]] - a).normalized();
}

/// Whether the triangle's normal can be relied on at one of its edges.
bool has_sure_normal(const TriangleSurface& surface, const MeshTopology& topology, double angle, int t, int edge) {
  if (angle > kSliverAngle) return true;
  for (const int other : topology.triangle_edges[t]) {
    if (other == edge) continue;
    for (const int beside : triangles_at(topology, other)) {
      if (beside == t) continue;
      if (normal_of(surface, beside).dot(normal_of(surface, t)) > std::cos(kBorneOutAngle)) return true;
    }
  }
  return false;
}

}  // namespace

FeatureLines::FeatureLines(const TriangleSurface& surface, double crease_angle, double least_length)
    : neighbours_(surface.vertices.size()),
      line_of_(surface.vertices.size()),
      corners_(surface.vertices.size(), false) {
  const MeshTopology topology = topology_of(static_cast<int>(surface.vertices.size()), surface.triangles);
  const std::vector<double> angles = smallest_angles(surface.vertices, surface.triangles);
  std::vector<std::array<int, 2>> creases;
  for (int e = 0; e < static_cast<int>(topology.edges.size()); ++e) {
    const std::span<const int> pair = triangles_at(topology, e);
    const auto [a, b] = topology.edges[e];
    if (pair.size() == 1) {
      join(a, b, kNoLine);
    } else if (has_sure_normal(surface, topology, angles[pair[0]], pair[0], e) &&
               has_sure_normal(surface, topology, angles[pair[1]], pair[1], e) &&
               normal_of(surface, pair[0]).dot(normal_of(surface, pair[1])) < std::cos(crease_angle)) {
      creases.push_back({a, b});
    }
  }
  drop_short_creases(surface, least_length, creases);
  for (const auto& [a, b] : creases) join(a, b, kNoLine);
  mark_corners(surface, crease_angle);
  // What has no corner closes.
  for (const bool from_corners : {true, false}) {
    for (int v = 0; v < count(); ++v) {
      if (corners_[v] != from_corners) continue;
      const std::vector<int> beside = neighbours_[v];
      for (const int other : beside) follow(surface, v, other);
    }
  }
}

void FeatureLines::follow(const TriangleSurface& surface, int from, int to) {
  if (line_of(from, to) != kNoLine) return;
  const int line = static_cast<int>(lines_.size());
  lines_.emplace_back();
  while (line_of(from, to) == kNoLine) {
    lines_.back().push_back({surface.vertices[from], surface.vertices[to]});
    part(from, to);
    join(from, to, line);
    if (corners_[to]) return;
    const std::vector<int>& beside = neighbours_[to];
    from = std::exchange(to, beside.front() == from ? beside.back() : beside.front());
  }
}

void FeatureLines::drop_short_creases(const TriangleSurface& surface, double least_length,
                                      std::vector<std::array<int, 2>>& creases) const {
  std::map<int, std::vector<int>> at;  // vertex -> creases
  for (int i = 0; i < static_cast<int>(creases.size()); ++i) {
    for (const int v : creases[i]) at[v].push_back(i);
  }
  std::vector<bool> reached(creases.size(), false);
  std::vector<std::array<int, 2>> kept;
  for (int seed = 0; seed < static_cast<int>(creases.size()); ++seed) {
    if (reached[seed]) continue;
    reached[seed] = true;
    std::vector<int> together = {seed};
    double length = 0;
    for (std::size_t i = 0; i < together.size(); ++i) {
      const std::array<int, 2> edge = creases[together[i]];
      length += (surface.vertices[edge[0]] - surface.vertices[edge[1]]).norm();
      for (const int v : edge) {
        for (const int next : at[v]) {
          if (reached[next]) continue;
          reached[next] = true;
          together.push_back(next);
        }
      }
    }
    if (length < least_length) continue;
    for (const int i : together) kept.push_back(creases[i]);
  }
  creases = std::move(kept);
}

void FeatureLines::mark_corners(const TriangleSurface& surface, double crease_angle) {
  for (int v = 0; v < count(); ++v) {
    const std::vector<int>& beside = neighbours_[v];
    if (beside.empty()) continue;
    if (beside.size() != 2) {
      corners_[v] = true;
      continue;
    }
    const Eigen::Vector3d in = (surface.vertices[v] - surface.vertices[beside[0]]).normalized();
    const Eigen::Vector3d out = (surface.vertices[beside[1]] - surface.vertices[v]).normalized();
    corners_[v] = in.dot(out) < std::cos(crease_angle);
  }
}

void FeatureLines::keep(const TriangleSurface& surface, int a, int b) {
  keep(a);
  keep(b);
  join(a, b, kNoLine);
  follow(surface, a, b);
}

std::size_t FeatureLines::edge_count() const {
  std::size_t sum = 0;
  for (const std::vector<Segment>& line : lines_) sum += line.size();
  return sum;
}

bool FeatureLines::has_edge(int a, int b) const {
  return a < count() && std::binary_search(neighbours_[a].begin(), neighbours_[a].end(), b);
}

std::ptrdiff_t FeatureLines::place_of(int a, int b) const {
  const std::vector<int>& beside = neighbours_[a];
  const auto place = std::lower_bound(beside.begin(), beside.end(), b);
  assert(place != beside.end() && *place == b);
  return place - beside.begin();
}

int FeatureLines::line_of(int a, int b) const {
  return line_of_[a][place_of(a, b)];
}

void FeatureLines::join(int a, int b, int line) {
  for (const auto& [from, to] : {std::array<int, 2>{a, b}, std::array<int, 2>{b, a}}) {
    std::vector<int>& beside = neighbours_[from];
    const auto place = std::lower_bound(beside.begin(), beside.end(), to);
    if (place != beside.end() && *place == to) continue;
    line_of_[from].insert(line_of_[from].begin() + (place - beside.begin()), line);
    beside.insert(place, to);
  }
}

void FeatureLines::part(int a, int b) {
  for (const auto& [from, to] : {std::array<int, 2>{a, b}, std::array<int, 2>{b, a}}) {
    const std::ptrdiff_t place = place_of(from, to);
    line_of_[from].erase(line_of_[from].begin() + place);
    neighbours_[from].erase(neighbours_[from].begin() + place);
  }
}

void FeatureLines::split(int a, int b, int middle) {
  if (!has_edge(a, b)) return;
  neighbours_.resize(std::max<std::size_t>(neighbours_.size(), middle + 1));
  line_of_.resize(neighbours_.size());
  corners_.resize(neighbours_.size(), false);
  const int line = line_of(a, b);
  part(a, b);
  join(a, middle, line);
  join(middle, b, line);
}

void FeatureLines::collapse(int a, int b) {
  if (!is_on_line(b)) return;
  part(a, b);
  const std::vector<int> beside = neighbours_[b];
  for (const int v : beside) {
    const int line = line_of(b, v);
    part(b, v);
    join(a, v, line);
  }
}

Eigen::Vector3d FeatureLines::project(const Eigen::Vector3d& point, const Eigen::Vector3d& direction, int line) const {
  Eigen::Vector3d best = point;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [start, end] : lines_[line]) {
    const Eigen::Vector3d along = end - start;
    // Within 60 degrees, either way.
    if (std::abs(along.dot(direction)) < 0.5 * along.norm() * direction.norm()) continue;
    const double share = std::clamp((point - start).dot(along) / along.squaredNorm(), 0.0, 1.0);
    const Eigen::Vector3d closest = start + share * along;
    const double distance = (closest - point).squaredNorm();
    if (distance < least) {
      least = distance;
      best = closest;
    }
  }
  return best;
}

}  // namespace thinwall
