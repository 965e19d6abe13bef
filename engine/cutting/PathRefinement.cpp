#include "engine/cutting/PathRefinement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "engine/cutting/CutQuality.hpp"

namespace thinwall {
namespace {

constexpr double kLongest = 1.6;  // wanted edge lengths: triangles of longer edges are refined
constexpr double kReach = 0.9;    // edge lengths: triangles whose middle is nearer to the path are refined

using Edge = std::pair<int, int>;  // vertices, the lower first

Edge edge_of(const CutPatch& patch, int triangle, int side) {
  return std::minmax(int(patch.triangles[triangle][side]), int(patch.triangles[triangle][(side + 1) % 3]));
}

Eigen::Vector3d middle_of(const CutPatch& patch, int triangle) {
  const Eigen::Vector3i& t = patch.triangles[triangle];
  return (patch.positions[t[0]] + patch.positions[t[1]] + patch.positions[t[2]]) / 3;
}

/// The sharpness of the worse half of a triangle.
double sharpness_of_halves(const CutPatch& patch, int triangle, int side) {
  const Eigen::Vector3i& t = patch.triangles[triangle];
  const Eigen::Vector3d &a = patch.positions[t[side]], &b = patch.positions[t[(side + 1) % 3]],
                        &c = patch.positions[t[(side + 2) % 3]];
  const Eigen::Vector3d middle = 0.5 * (a + b), &normal = patch.facet_normals[patch.facet[triangle]];
  return std::max(sharpness(a, middle, c, normal), sharpness(middle, b, c, normal));
}

struct Marks {
  std::vector<char> refined;  // (triangles), into four
  std::set<Edge> split;
};

/// Chooses what to refine: triangles along the path, and others until of each of the rest at most one edge is split and
/// halves it well. Where a triangle can bear neither, because it is fine already or frozen, its edges stay whole, and
/// so do the triangles that would have split them.
class Marking {
 public:
  Marking(const CutPatch& patch, std::span<const Eigen::Vector3d> line, double edge_length)
      : patch_(patch), edge_length_(edge_length) {
    for (int t = 0; t < patch.triangle_count(); ++t) {
      const double scale = patch.scale[t];
      const bool near = distance_to(line, middle_of(patch, t)) < kReach * scale;
      if (near && scale > kLongest * edge_length) seeds_.push_back(t);
    }
  }

  Marks find() {
    do {
      marks_ = {.refined = std::vector<char>(patch_.triangles.size(), 0), .split = {}};
      for (const int t : seeds_) {
        if (may_refine(t)) refine(t);
      }
    } while (!close());
    return std::move(marks_);
  }

 private:
  const CutPatch& patch_;
  double edge_length_;
  std::vector<int> seeds_;
  std::set<Edge> whole_;  // edges that are not split
  Marks marks_;

  bool may_refine(int t) const {
    if (patch_.frozen[t] || patch_.scale[t] < edge_length_) return false;
    for (int k = 0; k < 3; ++k) {
      if (whole_.count(edge_of(patch_, t, k))) return false;
    }
    return true;
  }

  bool halves_well(int t, int side) const {
    return sharpness_of_halves(patch_, t, side) <= allowed_sharpness(patch_, t);
  }

  void refine(int t) {
    marks_.refined[t] = 1;
    for (int k = 0; k < 3; ++k) marks_.split.insert(edge_of(patch_, t, k));
  }

  /// Refines what the split edges ask for; false where some of them have to stay whole.
  bool close() {
    for (bool more = true; more;) {
      more = false;
      for (int t = 0; t < patch_.triangle_count(); ++t) {
        if (marks_.refined[t]) continue;
        std::vector<int> split;
        for (int k = 0; k < 3; ++k) {
          if (marks_.split.count(edge_of(patch_, t, k))) split.push_back(k);
        }
        const bool good = split.size() == 1 && !patch_.frozen[t] && halves_well(t, split[0]);
        if (split.empty() || good) continue;
        if (!may_refine(t)) {
          for (const int k : split) whole_.insert(edge_of(patch_, t, k));
          return false;
        }
        refine(t);
        more = true;
      }
    }
    return true;
  }
};

/// Splits the edges; between the three new vertices of a refined triangle one edge still runs to an old vertex.
std::map<Edge, int> split_edges(CutPatch& patch, const Marks& marks) {
  const int old = patch.vertex_count();
  std::map<Edge, int> middles;
  std::vector<Edge> parents;
  for (const Edge& edge : marks.split) {
    PatchCorner side = patch.side_between(edge.first, edge.second);
    if (side.triangle < 0) side = patch.side_between(edge.second, edge.first);
    middles[edge] = patch.split_side(side.triangle, side.corner,
                                     0.5 * (patch.positions[edge.first] + patch.positions[edge.second]));
    parents.push_back(edge);
  }
  for (int t = 0; t < patch.triangle_count(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] = edge_of(patch, t, k);
      if (low >= old || high < old || parents[high - old].first == low || parents[high - old].second == low) continue;
      if (!patch.can_flip(t, k)) continue;
      const int n = patch.neighbours[t][k];
      const int d = patch.triangles[n][(patch.corner_of(n, patch.triangles[t][(k + 1) % 3]) + 2) % 3];
      if (patch.triangles[t][(k + 2) % 3] >= old && d >= old) patch.flip(t, k);
    }
  }
  return middles;
}

void move_stops(std::vector<PathStop>& stops, const std::map<Edge, int>& middles) {
  constexpr double kAtMiddle = 1e-9;
  for (PathStop& stop : stops) {
    PatchPlace& place = stop.place;
    if (place.kind != PlaceKind::kSide) continue;
    const auto found = middles.find(std::minmax(place.from, place.to));
    if (found == middles.end()) continue;
    const int middle = found->second;
    if (std::abs(place.along - 0.5) < kAtMiddle) {
      place = {.kind = PlaceKind::kVertex, .vertex = middle, .position = place.position};
    } else if (place.along < 0.5) {
      place.to = middle;
      place.along *= 2;
    } else {
      place.from = middle;
      place.along = 2 * place.along - 1;
    }
  }
}

}  // namespace

void refine_along(CutPatch& patch, std::vector<PathStop>& stops, double edge_length) {
  const std::vector<Eigen::Vector3d> line = corners_of(stops);
  for (;;) {
    const Marks marks = Marking(patch, line, edge_length).find();
    if (marks.split.empty()) return;
    const int old_vertices = patch.vertex_count();
    std::vector<char> split_before(patch.changed.size(), 0);
    std::swap(split_before, patch.changed);
    patch.changed.assign(split_before.size(), 0);
    move_stops(stops, split_edges(patch, marks));
    patch.find_freedom(old_vertices);
    for (int t = 0; t < patch.triangle_count(); ++t) {
      if (patch.changed[t]) patch.scale[t] = patch.mean_edge(t);
      if (t < static_cast<int>(split_before.size()) && split_before[t]) patch.changed[t] = 1;
    }
  }
}

}  // namespace thinwall
