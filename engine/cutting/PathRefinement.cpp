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

/// The sharpness of the worst piece of a triangle whose sides but one are split, with the better one of the diagonals
/// between them.
double sharpness_of_thirds(const CutPatch& patch, int triangle, int whole_side) {
  const Eigen::Vector3i& t = patch.triangles[triangle];
  const Eigen::Vector3d &a = patch.positions[t[whole_side]], &b = patch.positions[t[(whole_side + 1) % 3]],
                        &c = patch.positions[t[(whole_side + 2) % 3]];
  const Eigen::Vector3d at_a = 0.5 * (c + a), at_b = 0.5 * (b + c);
  const auto piece = [&](const Eigen::Vector3d& one, const Eigen::Vector3d& two, const Eigen::Vector3d& three) {
    return sharpness(one, two, three, patch.facet_normals[patch.facet[triangle]]);
  };
  const double from_a = std::max(piece(a, b, at_b), piece(a, at_b, at_a));
  const double from_b = std::max(piece(a, b, at_a), piece(b, at_b, at_a));
  return std::max(piece(at_b, c, at_a), std::min(from_a, from_b));
}

struct Marks {
  std::vector<char> refined;  // (triangles), into four
  std::set<Edge> split;
};

/// Chooses what to refine: triangles along the path, and others until of each of the rest at most two edges are split
/// and divide it well. Where a triangle can bear neither, because it is fine already or frozen, its edges stay whole,
/// and so do the triangles that would have split them.
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

  bool is_fine() const { return seeds_.empty(); }

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

  /// Whether a triangle is divided well by new vertices on some of its sides, the triangle itself not refined.
  bool divides_well(int t, const std::vector<int>& split) const {
    if (patch_.frozen[t] || split.size() > 2) return false;
    const double worst = split.size() == 1 ? sharpness_of_halves(patch_, t, split[0])
                                           : sharpness_of_thirds(patch_, t, 3 - split[0] - split[1]);
    return worst <= allowed_sharpness(patch_, t);
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
        if (split.empty() || divides_well(t, split)) continue;
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

/// The vertex across a side, in the triangle beside it.
int vertex_across(const CutPatch& patch, int triangle, int side) {
  const int next = patch.neighbours[triangle][side];
  return patch.triangles[next][(patch.corner_of(next, patch.triangles[triangle][(side + 1) % 3]) + 2) % 3];
}

/// Whether the two triangles at a side were less sharp with the other diagonal.
bool is_better_flipped(const CutPatch& patch, int triangle, int side) {
  const Eigen::Vector3i& t = patch.triangles[triangle];
  const Eigen::Vector3d& normal = patch.facet_normals[patch.facet[triangle]];
  const auto &a = patch.positions[t[side]], &b = patch.positions[t[(side + 1) % 3]],
             &c = patch.positions[t[(side + 2) % 3]], &d = patch.positions[vertex_across(patch, triangle, side)];
  const double now = std::max(sharpness(a, b, c, normal), sharpness(b, a, d, normal));
  return std::max(sharpness(a, d, c, normal), sharpness(d, b, c, normal)) < now;
}

/// Splits the edges. Between the three new vertices of a refined triangle one edge still runs to an old vertex, and so
/// does that between the two of one that is not refined, which may be the worse diagonal.
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
      const int new_corners = (patch.triangles[t][(k + 2) % 3] >= old) + (vertex_across(patch, t, k) >= old);
      if (new_corners == 2 || (new_corners == 1 && is_better_flipped(patch, t, k))) patch.flip(t, k);
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

bool refine_along(CutPatch& patch, std::vector<PathStop>& stops, double edge_length) {
  const std::vector<Eigen::Vector3d> line = corners_of(stops);
  for (;;) {
    Marking marking(patch, line, edge_length);
    const Marks marks = marking.find();
    if (marks.split.empty()) return marking.is_fine();
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
