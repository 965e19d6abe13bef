#include "tests/engine/cutting/CutInvariants.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <sstream>

#include "engine/mesh/MeshMeasures.hpp"
#include "engine/mesh/MeshTopology.hpp"
#include "tests/engine/cutting/SurfaceWalk.hpp"

namespace thinwall {
namespace {

/// Sums of about 1e3 terms, each rounded to 1e-16.
constexpr double kExact = 1e-12;
/// Pieces count as flat to 1e-6 of an edge length; the meshes here have edges of at most a tenth of their size.
constexpr double kFlat = 1e-7;

class Judge {
 public:
  Judge(const SurfaceMesh& before, const CutSurface& after, const Cut& cut)
      : before_(before), after_(after.mesh()), surface_(after), cut_(cut) {
    for (const Eigen::Vector3d& vertex : before.vertices) {
      size_ = std::max(size_, (vertex - before.vertices.front()).norm());
    }
  }

  std::vector<std::string> judge() {
    check_topology();
    check_closed_surface();
    check_conservation();
    check_vertices();
    check_triangles();
    check_quality();
    check_lips();
    check_deviation();
    check_groups();
    return std::move(broken_);
  }

 private:
  const SurfaceMesh &before_, &after_;
  const CutSurface& surface_;
  const Cut& cut_;
  double size_ = 0;
  std::vector<std::string> broken_;

  template <typename... Parts>
  void expect(bool kept, const Parts&... parts) {
    if (kept) return;
    std::ostringstream text;
    text.precision(17);
    (text << ... << parts);
    broken_.push_back(text.str());
  }

  /// Splits are exact. Flips and moves within flat pieces are as exact as these are flat.
  bool only_splits() const { return cut_.counts.flips == 0 && cut_.counts.moved_vertices == 0; }

  void check_topology() {
    const MeshTopology was = topology_of(static_cast<int>(before_.vertices.size()), before_.triangles);
    const MeshTopology is = topology_of(static_cast<int>(after_.vertices.size()), after_.triangles);
    expect(is.crowded_edges.empty(), is.crowded_edges.size(), " edges have more than two triangles");
    expect(is.contrary_edges.empty(), is.contrary_edges.size(), " edges turn over");
    expect(is.non_manifold_vertices.empty(), is.non_manifold_vertices.size(), " vertices are bow-ties");
    const int change = is.euler_characteristic - was.euler_characteristic;
    expect(change == cut_.euler_change, "Euler characteristic changed by ", change, ", counted ", cut_.euler_change);
    expect(change == cut_.predicted_euler_change, "Euler characteristic changed by ", change, ", predicted ",
           cut_.predicted_euler_change);
    expect(is.component_count == surface_.component_count(), is.component_count, " components, counted ",
           surface_.component_count());
    expect(is.component_count - was.component_count == static_cast<int>(cut_.separated.size()),
           "new components: ", is.component_count - was.component_count, ", told ", cut_.separated.size());
    std::map<int, int> names;
    for (std::size_t t = 0; t < after_.triangles.size(); ++t) {
      const int name = names.emplace(is.triangle_component[t], surface_.components()[t]).first->second;
      expect(name == surface_.components()[t], "triangle ", t, " is in the wrong component");
      for (int k = 0; k < 3; ++k) {
        int neighbour = -1;
        for (const int other : triangles_at(is, is.triangle_edges[t][k])) {
          if (other != static_cast<int>(t)) neighbour = other;
        }
        expect(neighbour == std::max(-1, surface_.neighbours()[t][k]), "neighbour across side ", k, " of triangle ", t);
      }
    }
  }

  void check_closed_surface() {
    const auto surface = closed_surface(after_);
    const MeshTopology is = topology_of(static_cast<int>(after_.vertices.size()), surface);
    expect(is_oriented_manifold(is), "wall and caps are no oriented manifold: ", is.crowded_edges.size(), " ",
           is.contrary_edges.size(), " ", is.non_manifold_vertices.size());
    std::set<std::set<int>> borders;
    for (const auto& loop : is.boundary_loops) borders.emplace(loop.begin(), loop.end());
    for (const auto& loop : cut_.wound_loops) {
      expect(borders.count({loop.begin(), loop.end()}) == 1, "a wound loop of ", loop.size(),
             " vertices is no border of wall and caps");
    }
  }

  void check_conservation() {
    const double tolerance = only_splits() ? kExact : 1e3 * kExact;  // within flat pieces in the second order
    const double area = wall_area(before_), area_change = wall_area(after_) - area;
    expect(std::abs(area_change) <= kExact * area, "area changed by ", area_change / area);
    const double volume = enclosed_volume(before_.vertices, closed_surface(before_));
    const double change = enclosed_volume(after_.vertices, closed_surface(after_)) - volume;
    expect(std::abs(change) <= tolerance * area * size_, "volume changed by ", change / (area * size_));
    // What is booked is that of the changed triangles alone.
    expect(std::abs(cut_.counts.area_change - area_change) <= kExact * area, "area changed by ", area_change,
           ", booked ", cut_.counts.area_change);
    expect(std::abs(cut_.counts.volume_change - change) <= kExact * area * size_, "volume changed by ", change,
           ", booked ", cut_.counts.volume_change);
  }

  void check_vertices() {
    const std::size_t old = before_.vertices.size();
    std::vector<char> told(after_.vertices.size(), 0);
    for (const VertexSource& source : cut_.vertices) {
      told[source.vertex] = 1;
      expect(source.before.weights.minCoeff() >= 0 && std::abs(source.before.weights.sum() - 1) < 1e-14,
             "weights of vertex ", source.vertex);
      const double off = (position_of(before_, source.before) - after_.vertices[source.vertex]).norm();
      expect(off <= (only_splits() ? kExact * size_ : kFlat * size_), "vertex ", source.vertex,
             " does not lie where it is said to, by ", off / size_);
      if (source.original) {
        expect(after_.vertices[*source.original] == after_.vertices[source.vertex], "doubled vertex ", source.vertex);
      }
    }
    for (std::size_t v = 0; v < old; ++v) {
      expect(told[v] || before_.vertices[v] == after_.vertices[v], "vertex ", v, " moved without a word");
    }
    for (std::size_t v = old; v < after_.vertices.size(); ++v) expect(told[v], "vertex ", v, " has no source");
    check_sides();
  }

  /// Both lips of an earlier cut have the same places, and may be far from each other: what lies on one comes from
  /// there.
  void check_sides() {
    std::vector<std::set<int>> around(after_.vertices.size()), sources(after_.triangles.size());
    for (const TriangleSource& source : cut_.triangles) {
      for (const TriangleShare& share : source.before) sources[source.triangle].insert(share.triangle);
    }
    for (std::size_t t = 0; t < after_.triangles.size(); ++t) {
      if (sources[t].empty()) sources[t].insert(static_cast<int>(t));
      for (const int v : after_.triangles[t]) around[v].insert(sources[t].begin(), sources[t].end());
    }
    for (const VertexSource& source : cut_.vertices) {
      expect(around[source.vertex].count(source.before.triangle) == 1, "vertex ", source.vertex,
             " is said to come from a triangle that nothing around it comes from");
    }
  }

  void check_triangles() {
    const auto areas_before = triangle_areas(before_.vertices, before_.triangles);
    const auto areas = triangle_areas(after_.vertices, after_.triangles);
    std::vector<char> told(after_.triangles.size(), 0);
    std::map<int, double> received;
    for (const TriangleSource& source : cut_.triangles) {
      told[source.triangle] = 1;
      double sum = 0;
      for (const TriangleShare& share : source.before) {
        sum += share.share;
        received[share.triangle] += share.share * areas[source.triangle];
      }
      expect(std::abs(sum - 1) < 1e-14, "shares of triangle ", source.triangle, " sum to ", sum);
    }
    for (const auto& [triangle, area] : received) {
      const double off = std::abs(area / areas_before[triangle] - 1);
      expect(off < 1e-11, "triangle ", triangle, " is given on ", area / areas_before[triangle], " times");
    }
    for (std::size_t t = 0; t < after_.triangles.size(); ++t) {
      if (!told[t]) expect(t < before_.triangles.size() && before_.triangles[t] == after_.triangles[t], "triangle ", t);
    }
  }

  /// Each changed triangle against those that lay there and two rings around them.
  void check_quality() {
    const double good = std::min(20 * std::numbers::pi / 180, 0.5 * cut_.least_meeting_angle);
    const auto angles = smallest_angles(after_.vertices, after_.triangles);
    auto least_around = smallest_angles(before_.vertices, before_.triangles);
    for (int ring = 0; ring < 2; ++ring) {
      std::vector<double> at_vertex(before_.vertices.size(), good);
      for (std::size_t t = 0; t < least_around.size(); ++t) {
        for (const int v : before_.triangles[t]) at_vertex[v] = std::min(at_vertex[v], least_around[t]);
      }
      for (std::size_t t = 0; t < least_around.size(); ++t) {
        for (const int v : before_.triangles[t]) least_around[t] = std::min(least_around[t], at_vertex[v]);
      }
    }
    for (const TriangleSource& source : cut_.triangles) {
      double rule = good;
      for (const TriangleShare& share : source.before) rule = std::min(rule, least_around[share.triangle]);
      const double angle = angles[source.triangle];
      expect(angle >= rule - 1e-9, "triangle ", source.triangle, " has an angle of ", angle * 180 / std::numbers::pi,
             " degrees where ", rule * 180 / std::numbers::pi, " are due");
      expect(angle >= cut_.least_angle - 1e-9, "triangle ", source.triangle, " is sharper than told");
    }
  }

  void check_lips() {
    double length = 0;
    std::set<std::pair<int, int>> sides;
    for (std::size_t t = 0; t < after_.triangles.size(); ++t) {
      for (int k = 0; k < 3; ++k) {
        if (surface_.neighbours()[t][k] < 0) sides.emplace(after_.triangles[t][k], after_.triangles[t][(k + 1) % 3]);
      }
    }
    for (const Lips& lips : cut_.lips) {
      expect(lips.left.size() == lips.right.size() && lips.left.size() >= 2, "lips of unequal length");
      for (std::size_t i = 0; i < lips.left.size(); ++i) {
        expect(after_.vertices[lips.left[i]] == after_.vertices[lips.right[i]], "lips do not lie on each other");
        if (i == 0) continue;
        length += (after_.vertices[lips.left[i]] - after_.vertices[lips.left[i - 1]]).norm();
        expect(sides.count({lips.left[i - 1], lips.left[i]}) == 1, "left lip is no border");
        expect(sides.count({lips.right[i], lips.right[i - 1]}) == 1, "right lip is no border");
      }
    }
    expect(std::abs(length - cut_.length) <= 1e-12 * size_, "lips of length ", length, ", told ", cut_.length);
    if (cut_.tip && !cut_.lips.empty()) {
      const bool at_end = std::ranges::any_of(cut_.lips, [&](const Lips& lips) {
        return (lips.left.back() == *cut_.tip && lips.right.back() == *cut_.tip) ||
               (lips.left.front() == *cut_.tip && lips.right.front() == *cut_.tip);
      });
      expect(at_end, "the tip is not where the lips meet");
    }
  }

  /// Against the longest edge of the triangles that touch what was changed.
  void check_deviation() {
    std::set<int> near;
    for (const TriangleSource& source : cut_.triangles) {
      for (const TriangleShare& share : source.before) {
        const Eigen::Vector3i& t = before_.triangles[share.triangle];
        near.insert(t.begin(), t.end());
      }
    }
    double longest = 0;
    for (const Eigen::Vector3i& t : before_.triangles) {
      if (!near.count(t[0]) && !near.count(t[1]) && !near.count(t[2])) continue;
      for (int k = 0; k < 3; ++k) {
        longest = std::max(longest, (before_.vertices[t[(k + 1) % 3]] - before_.vertices[t[k]]).norm());
      }
    }
    expect(cut_.deviation <= longest, "the cut is off its path by ", cut_.deviation / longest, " edges");
  }

  void check_groups() {
    for (const auto& [name, members] : after_.groups) {
      expect(std::ranges::is_sorted(members), "group ", name, " is not ascending");
      expect(members.empty() || members.back() < static_cast<int>(after_.vertices.size()), "group ", name);
    }
  }
};

}  // namespace

std::vector<std::string> broken_rules(const SurfaceMesh& before, const CutSurface& after, const Cut& cut) {
  return Judge(before, after, cut).judge();
}

}  // namespace thinwall
