#include "studio/organs/ManifoldRepair.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <compare>
#include <map>
#include <set>
#include <utility>

#include "engine/mesh/MeshMeasures.hpp"
#include "engine/mesh/MeshTopology.hpp"
#include "engine/mesh/UnionFind.hpp"

namespace thinwall {
namespace {

Eigen::Vector3d middle_of(const RawSurface& surface, const std::array<int, 2>& edge) {
  return (surface.vertices[edge[0]] + surface.vertices[edge[1]]) / 2;
}

struct Patch {
  double area = 0;
  bool is_open = false;     // has edges of one triangle
  bool is_crowded = false;  // has edges of more than two
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
};

/// The triangles of a surface whose patches hang together across edges of two triangles: by triangle, the first of its
/// patch.
std::vector<int> patches_of(const MeshTopology& topology) {
  UnionFind sets(topology.triangle_edges.size());
  for (int e = 0; e < static_cast<int>(topology.edges.size()); ++e) {
    const std::span<const int> pair = triangles_at(topology, e);
    if (pair.size() == 2) sets.join(pair[0], pair[1]);
  }
  std::vector<int> patch;
  for (int t = 0; t < static_cast<int>(topology.triangle_edges.size()); ++t) patch.push_back(sets.find(t));
  return patch;
}

/// Joins corners of triangles to the vertices of a split surface. Corner k of triangle t is number 3 t + k.
class CornerJoiner {
 public:
  explicit CornerJoiner(const RawSurface& surface)
      : surface_(surface), topology_(topology_of_surface(surface)), sets_(3 * surface.triangles.size()) {
    for (int e = 0; e < static_cast<int>(topology_.edges.size()); ++e) {
      const std::span<const int> pair = triangles_at(topology_, e);
      if (pair.size() == 2) join(e, pair[0], pair[1]);
    }
  }

  /// The surface with a vertex for each set of corners, in the order of the vertices that they come from.
  /// `source` gets the vertex that each comes from.
  RawSurface separated(std::vector<int>& source) {
    std::map<std::pair<int, int>, int> place;  // (vertex, set) -> new vertex
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
      for (int k = 0; k < 3; ++k) place.try_emplace({surface_.triangles[t][k], set_of(t, k)}, 0);
    }
    RawSurface result;
    source.clear();
    for (auto& [key, index] : place) {
      index = static_cast<int>(source.size());
      source.push_back(key.first);
      result.vertices.push_back(surface_.vertices[key.first]);
    }
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
      Eigen::Vector3i corners;
      for (int k = 0; k < 3; ++k) corners[k] = place.at({surface_.triangles[t][k], set_of(t, k)});
      result.triangles.push_back(corners);
    }
    result.parts = surface_.parts;
    return result;
  }

  /// Joins the triangles of a crowded edge in pairs. False when the wall branches there: then all are joined.
  bool join_wedges(int edge) {
    std::vector<Sector> sectors = sectors_around(edge);
    const std::size_t count = sectors.size();
    bool alternates = count % 2 == 0;
    for (std::size_t i = 0; i < count; ++i) {
      alternates = alternates && sectors[i].runs_down != sectors[(i + 1) % count].runs_down;
    }
    if (!alternates) {
      for (std::size_t i = 1; i < count; ++i) join(edge, sectors[0].triangle, sectors[i].triangle);
      return false;
    }
    // A triangle that runs down the edge has the solid on the side of growing angles.
    for (std::size_t i = 0; i < count; ++i) {
      if (sectors[i].runs_down) join(edge, sectors[i].triangle, sectors[(i + 1) % count].triangle);
    }
    return true;
  }

  const MeshTopology& topology() const { return topology_; }

 private:
  struct Sector {
    long angle = 0;          // around the edge, counter-clockwise seen against its sense, in microradians
    bool runs_down = false;  // along the edge from its upper vertex to its lower
    int triangle = 0;

    /// Of two triangles that lie on each other the one that runs up comes first: two solids touch there.
    auto operator<=>(const Sector&) const = default;
  };

  int set_of(std::size_t t, int k) { return sets_.find(static_cast<int>(3 * t) + k); }

  void join(int edge, int t, int u) {
    for (const int v : topology_.edges[edge]) sets_.join(corner(t, v), corner(u, v));
  }

  int corner(int t, int vertex) const {
    int k = 0;
    while (surface_.triangles[t][k] != vertex) ++k;
    return 3 * t + k;
  }

  static constexpr long kHalfTurn = 3141593;  // microradians

  std::vector<Sector> sectors_around(int edge) const {
    const auto [a, b] = topology_.edges[edge];
    const Eigen::Vector3d axis = (surface_.vertices[b] - surface_.vertices[a]).normalized();
    const Eigen::Vector3d first = axis.unitOrthogonal();
    const Eigen::Vector3d second = axis.cross(first);
    std::vector<Sector> sectors;
    for (const int t : triangles_at(topology_, edge)) {
      const Eigen::Vector3i& corners = surface_.triangles[t];
      const Eigen::Vector3d reach = surface_.vertices[corners.sum() - a - b] - surface_.vertices[a];
      bool runs_down = false;
      for (int k = 0; k < 3; ++k) runs_down |= corners[k] == b && corners[(k + 1) % 3] == a;
      // From -pi up and to pi, which is the same, so that triangles on each other have one angle.
      const long angle = std::lround(1e6 * std::atan2(reach.dot(second), reach.dot(first)));
      sectors.push_back({angle == -kHalfTurn ? kHalfTurn : angle, runs_down, t});
    }
    std::sort(sectors.begin(), sectors.end());
    return sectors;
  }

  const RawSurface& surface_;
  MeshTopology topology_;
  UnionFind sets_;
};

/// Orients the surface cut along its crowded edges in a given way; false where that cannot be done.
bool orient_cut(RawSurface& surface, OrientationResult (*orient)(RawSurface&)) {
  std::vector<int> source;
  RawSurface cut = CornerJoiner(surface).separated(source);
  if (!orient(cut).orientable) return false;
  for (std::size_t t = 0; t < cut.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) surface.triangles[t][k] = source[cut.triangles[t][k]];
  }
  return true;
}

/// How many crowded edges have triangles that do not take turns in facing into and out of a wedge.
int count_branches(const RawSurface& surface) {
  CornerJoiner joiner(surface);
  int branches = 0;
  for (const int e : joiner.topology().crowded_edges) branches += joiner.join_wedges(e) ? 0 : 1;
  return branches;
}

/// Orients the surface so that as few edges as may be are branches; false where it is not orientable.
bool orient_for_wedges(RawSurface& surface) {
  // The senses that the file gives are right as a rule, and they alone tell a hollow from a body. Where they are not,
  // each patch by itself is turned outwards.
  RawSurface as_given = surface;
  if (!orient_cut(as_given, make_agree)) return false;
  RawSurface outwards = surface;
  orient_cut(outwards, orient_outwards);
  surface = count_branches(as_given) <= count_branches(outwards) ? std::move(as_given) : std::move(outwards);
  return true;
}

/// The middles of the crowded edges whose triangles can be joined in pairs.
std::vector<Eigen::Vector3d> wedge_edges(const RawSurface& surface) {
  CornerJoiner joiner(surface);
  std::vector<Eigen::Vector3d> middles;
  for (const int e : joiner.topology().crowded_edges) {
    if (joiner.join_wedges(e)) middles.push_back(middle_of(surface, joiner.topology().edges[e]));
  }
  return middles;
}

/// Puts a vertex in the middle of an edge of all its triangles.
void halve_edge(RawSurface& surface, const std::array<int, 2>& edge) {
  const int middle = static_cast<int>(surface.vertices.size());
  surface.vertices.push_back(middle_of(surface, edge));
  const std::size_t count = surface.triangles.size();
  for (std::size_t t = 0; t < count; ++t) {
    Eigen::Vector3i near = surface.triangles[t];
    Eigen::Vector3i far = near;
    if (!(near.array() == edge[0]).any() || !(near.array() == edge[1]).any()) continue;
    for (int k = 0; k < 3; ++k) {
      if (near[k] == edge[1]) near[k] = middle;
      if (far[k] == edge[0]) far[k] = middle;
    }
    surface.triangles[t] = near;
    surface.triangles.push_back(far);
    surface.parts.push_back(surface.parts[t]);
  }
}

/// Where the wedges at a crowded edge are joined around both of its ends, no copies of the ends tell them apart; a
/// vertex in its middle has a copy for each.
void halve_edges_joined_at_both_ends(RawSurface& surface) {
  CornerJoiner joiner(surface);
  std::vector<bool> branches;
  for (const int e : joiner.topology().crowded_edges) branches.push_back(!joiner.join_wedges(e));
  std::vector<int> source;
  const MeshTopology split = topology_of_surface(joiner.separated(source));
  std::set<std::array<int, 2>> joined;
  for (const int e : split.crowded_edges) {
    joined.insert({source[split.edges[e][0]], source[split.edges[e][1]]});
  }
  for (std::size_t i = 0; i < branches.size(); ++i) {
    if (branches[i]) joined.erase(joiner.topology().edges[joiner.topology().crowded_edges[i]]);
  }
  for (const std::array<int, 2>& edge : joined) halve_edge(surface, edge);
}

}  // namespace

RemovedFlaps remove_flaps(RawSurface& surface) {
  RemovedFlaps removed;
  for (;;) {
    const MeshTopology topology = topology_of_surface(surface);
    const std::vector<int> patch_of = patches_of(topology);
    const std::vector<double> areas = triangle_areas(surface.vertices, surface.triangles);
    std::map<int, Patch> patches;
    double whole = 0;
    for (std::size_t t = 0; t < areas.size(); ++t) {
      Patch& patch = patches[patch_of[t]];
      whole += areas[t];
      patch.area += areas[t];
      for (int k = 0; k < 3; ++k) {
        const std::size_t users = triangles_at(topology, topology.triangle_edges[t][k]).size();
        patch.is_open = patch.is_open || users == 1;
        patch.is_crowded = patch.is_crowded || users > 2;
        patch.middle += areas[t] / 3 * surface.vertices[surface.triangles[t][k]];
      }
    }
    std::vector<bool> keep;
    for (const auto& [first, patch] : patches) {
      if (patch.is_open && patch.is_crowded && patch.area < kFlapShare * whole) {
        removed.places.push_back(patch.middle / patch.area);
      }
    }
    for (const int first : patch_of) {
      const Patch& patch = patches.at(first);
      keep.push_back(!(patch.is_open && patch.is_crowded && patch.area < kFlapShare * whole));
    }
    const int count = keep_marked(surface, keep);
    removed.triangles += count;
    if (count == 0) return removed;
  }
}

SplitPlaces split_apart(RawSurface& surface) {
  SplitPlaces places;
  const std::vector<Eigen::Vector3i> before = surface.triangles;
  if (!orient_for_wedges(surface)) return places;
  for (std::size_t t = 0; t < before.size(); ++t) places.turned += surface.triangles[t] == before[t] ? 0 : 1;
  places.edges = wedge_edges(surface);
  // Once is enough, except where so many triangles lie on each other that no sense can be made of them.
  halve_edges_joined_at_both_ends(surface);
  CornerJoiner joiner(surface);
  std::vector<bool> at_split_edge(surface.vertices.size(), false);
  for (const int e : joiner.topology().crowded_edges) {
    if (!joiner.join_wedges(e)) continue;
    for (const int v : joiner.topology().edges[e]) at_split_edge[v] = true;
  }
  std::vector<int> source;
  RawSurface split = joiner.separated(source);
  for (std::size_t i = 0; i + 1 < source.size(); ++i) {
    const bool is_first_copy = source[i] == source[i + 1] && (i == 0 || source[i - 1] != source[i]);
    if (is_first_copy && !at_split_edge[source[i]]) places.vertices.push_back(surface.vertices[source[i]]);
  }
  surface = std::move(split);
  return places;
}

}  // namespace thinwall
