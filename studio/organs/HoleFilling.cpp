#include "studio/organs/HoleFilling.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "engine/mesh/MeshMeasures.hpp"
#include "engine/mesh/MeshTopology.hpp"

namespace thinwall {
namespace {

/// How bad a way to fill is.
struct Cost {
  double bend = std::numeric_limits<double>::infinity();  // 1 - cosine of the sharpest bend
  double squares = 0;                                     // sum of the squared edges of all triangles

  bool operator<(const Cost& other) const { return bend != other.bend ? bend < other.bend : squares < other.squares; }
};

/// Bends that differ by rounding only are equal.
double rounded(double bend) {
  return std::round(1e6 * bend) / 1e6;
}

/// Fills one loop by dynamic programming over its stretches from vertex i to vertex j.
class LoopFilling {
 public:
  LoopFilling(const RawSurface& surface, const MeshTopology& topology, const std::vector<int>& loop)
      : surface_(surface), topology_(topology), loop_(loop), count_(static_cast<int>(loop.size())) {
    best_.resize(static_cast<std::size_t>(count_) * count_);
  }

  /// The triangles, or nothing when each way would put an edge twice.
  std::vector<Eigen::Vector3i> run() {
    for (int i = 0; i + 1 < count_; ++i) at(i, i + 1) = {{0, 0}, -1, rim_normal(i)};
    const Eigen::Vector3d closing = rim_normal(count_ - 1);
    for (int span = 2; span < count_; ++span) {
      for (int i = 0; i + span < count_; ++i) {
        const bool closes = span == count_ - 1;
        if (!closes && edge_exists(i, i + span)) continue;
        choose(i, i + span, closes ? &closing : nullptr);
      }
    }
    std::vector<Eigen::Vector3i> triangles;
    if (at(0, count_ - 1).middle >= 0) collect(0, count_ - 1, triangles);
    return triangles;
  }

 private:
  struct Stretch {
    Cost cost;
    int middle = -1;  // third corner of the triangle over the stretch
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  };

  Stretch& at(int i, int j) { return best_[static_cast<std::size_t>(i) * count_ + j]; }

  const Eigen::Vector3d& position(int i) const { return surface_.vertices[loop_[i]]; }

  Eigen::Vector3d normal_of(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) const {
    const Eigen::Vector3d normal = (b - a).cross(c - a);
    const double length = normal.norm();
    return length > 0 ? Eigen::Vector3d(normal / length) : Eigen::Vector3d::Zero();
  }

  int edge_between(int i, int j) const {
    const std::array<int, 2> edge = {std::min(loop_[i], loop_[j]), std::max(loop_[i], loop_[j])};
    const auto found = std::lower_bound(topology_.edges.begin(), topology_.edges.end(), edge);
    if (found == topology_.edges.end() || *found != edge) return -1;
    return static_cast<int>(found - topology_.edges.begin());
  }
  bool edge_exists(int i, int j) const { return edge_between(i, j) >= 0; }

  /// Normal of the triangle at the rim's edge from vertex i to the next.
  Eigen::Vector3d rim_normal(int i) const {
    const int edge = edge_between(i, (i + 1) % count_);
    const Eigen::Vector3i& t = surface_.triangles[triangles_at(topology_, edge)[0]];
    return normal_of(surface_.vertices[t[0]], surface_.vertices[t[1]], surface_.vertices[t[2]]);
  }

  void choose(int i, int j, const Eigen::Vector3d* closing) {
    Stretch& best = at(i, j);
    for (int k = i + 1; k < j; ++k) {
      const Stretch& left = at(i, k);
      const Stretch& right = at(k, j);
      if (!std::isfinite(left.cost.bend) || !std::isfinite(right.cost.bend)) continue;
      // The triangle runs against the rim.
      const Eigen::Vector3d normal = normal_of(position(j), position(k), position(i));
      double bend = std::max(1 - normal.dot(left.normal), 1 - normal.dot(right.normal));
      if (closing != nullptr) bend = std::max(bend, 1 - normal.dot(*closing));
      const double squares = (position(i) - position(j)).squaredNorm() + (position(j) - position(k)).squaredNorm() +
                             (position(k) - position(i)).squaredNorm();
      const Cost cost{std::max({rounded(bend), left.cost.bend, right.cost.bend}),
                      left.cost.squares + right.cost.squares + squares};
      if (cost < best.cost) best = {cost, k, normal};
    }
  }

  void collect(int i, int j, std::vector<Eigen::Vector3i>& triangles) {
    const int k = at(i, j).middle;
    if (k < 0) return;
    triangles.emplace_back(loop_[j], loop_[k], loop_[i]);
    collect(i, k, triangles);
    collect(k, j, triangles);
  }

  const RawSurface& surface_;
  const MeshTopology& topology_;
  const std::vector<int>& loop_;
  int count_;
  std::vector<Stretch> best_;
};

FoundHole describe(const RawSurface& surface, const std::vector<int>& loop) {
  FoundHole hole{.edges = static_cast<int>(loop.size())};
  for (const int v : loop) hole.middle += surface.vertices[v] / static_cast<double>(loop.size());
  if (hole.edges > kMostHoleEdges) {
    // All pairs of a long loop would take long; how wide it is about its middle is enough to tell.
    for (const int v : loop) hole.width = std::max(hole.width, 2 * (surface.vertices[v] - hole.middle).norm());
    return hole;
  }
  for (const int v : loop) {
    for (const int w : loop) hole.width = std::max(hole.width, (surface.vertices[v] - surface.vertices[w]).norm());
  }
  return hole;
}

double area_of(const RawSurface& surface, const std::vector<Eigen::Vector3i>& triangles) {
  double sum = 0;
  for (const double area : triangle_areas(surface.vertices, triangles)) sum += area;
  return sum;
}

/// The part with most triangles along a loop.
int part_along(const RawSurface& surface, const MeshTopology& topology, const std::vector<int>& loop) {
  std::map<int, int> votes;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const int a = loop[i];
    const int b = loop[(i + 1) % loop.size()];
    const std::array<int, 2> key = {std::min(a, b), std::max(a, b)};
    const auto edge = std::lower_bound(topology.edges.begin(), topology.edges.end(), key) - topology.edges.begin();
    ++votes[surface.parts[triangles_at(topology, static_cast<int>(edge))[0]]];
  }
  return std::max_element(votes.begin(), votes.end(),
                          [](const auto& one, const auto& other) { return one.second < other.second; })
      ->first;
}

}  // namespace

std::vector<FoundHole> fill_small_holes(RawSurface& surface, double crack_height) {
  std::vector<FoundHole> holes;
  const double widest = kWidestHole * extent_of(surface);
  // One at a time, because a filled hole's edges are in the way of the next.
  std::size_t next = 0;
  for (;;) {
    const MeshTopology topology = topology_of(static_cast<int>(surface.vertices.size()), surface.triangles);
    bool filled = false;
    while (!filled && next < topology.boundary_loops.size()) {
      const std::vector<int>& loop = topology.boundary_loops[next];
      FoundHole hole = describe(surface, loop);
      if (hole.edges >= 3 && hole.edges <= kMostHoleEdges) {
        const std::vector<Eigen::Vector3i> triangles = LoopFilling(surface, topology, loop).run();
        hole.filled =
            !triangles.empty() && (hole.width <= widest || area_of(surface, triangles) <= crack_height * hole.width);
        if (hole.filled) {
          surface.triangles.insert(surface.triangles.end(), triangles.begin(), triangles.end());
          surface.parts.resize(surface.triangles.size(), part_along(surface, topology, loop));
        }
        filled = hole.filled;
      }
      holes.push_back(hole);
      if (!filled) ++next;
    }
    if (!filled) return holes;
  }
}

}  // namespace thinwall
