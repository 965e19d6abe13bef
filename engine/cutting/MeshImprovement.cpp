#include "engine/cutting/MeshImprovement.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <span>
#include <vector>

#include "engine/cutting/CutQuality.hpp"

namespace thinwall {
namespace {

// Of a cosine: less is no improvement, so that no two states alternate and little time goes into little.
constexpr double kGain = 5e-4;

double longest_side(const CutPatch& patch, int triangle) {
  double longest = 0;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3i& t = patch.triangles[triangle];
    longest = std::max(longest, (patch.positions[t[(k + 1) % 3]] - patch.positions[t[k]]).norm());
  }
  return longest;
}

bool flip_if_wider(CutPatch& patch, int t, int k) {
  if (!patch.can_flip(t, k)) return false;
  const int n = patch.neighbours[t][k];
  const int a = patch.triangles[t][k], b = patch.triangles[t][(k + 1) % 3], c = patch.triangles[t][(k + 2) % 3];
  const int d = patch.triangles[n][(patch.corner_of(n, b) + 2) % 3];
  const Eigen::Vector3d& normal = patch.facet_normals[patch.facet[t]];
  const auto& p = patch.positions;
  const double now = std::max(sharpness(patch, t), sharpness(patch, n));
  const double then = std::max(sharpness(p[a], p[d], p[c], normal), sharpness(p[d], p[b], p[c], normal));
  if (then > now - kGain) return false;
  patch.flip(t, k);
  return true;
}

/// Moves that are tried: in the plane of the vertex or along its line.
std::vector<Eigen::Vector3d> directions_of(const CutPatch& patch, int vertex) {
  if (patch.freedom[vertex] == VertexFreedom::kLine) return {patch.line[vertex], -patch.line[vertex]};
  const int t = patch.vertex_triangle[vertex];
  const Eigen::Vector3i& corners = patch.triangles[t];
  const Eigen::Vector3d x = (patch.positions[corners[1]] - patch.positions[corners[0]]).normalized();
  const Eigen::Vector3d y = patch.facet_normals[patch.facet[t]].cross(x);
  std::vector<Eigen::Vector3d> directions;
  constexpr int kDirections = 8;
  for (int i = 0; i < kDirections; ++i) {
    const double angle = i * 2 * std::numbers::pi / kDirections;
    directions.push_back(std::cos(angle) * x + std::sin(angle) * y);
  }
  return directions;
}

/// Pattern search for the place of a vertex at which the sharpest triangle around it is least sharp.
bool move_if_wider(CutPatch& patch, int vertex) {
  if (patch.freedom[vertex] == VertexFreedom::kFixed) return false;
  const PatchFan fan = patch.fan_of(vertex);
  if (fan.cut_off) return false;
  double size = 0;
  for (const PatchCorner& corner : fan.corners) {
    if (patch.frozen[corner.triangle]) return false;
    size = std::max(size, longest_side(patch, corner.triangle));
  }
  const auto worst = [&] {
    double value = -1;
    for (const PatchCorner& corner : fan.corners) value = std::max(value, sharpness(patch, corner.triangle));
    return value;
  };
  const std::vector<Eigen::Vector3d> directions = directions_of(patch, vertex);
  double best = worst();
  bool moved = false;
  for (double step = 0.2 * size; step > 0.02 * size; step *= 0.4) {
    for (int tries = 0; tries < 2; ++tries) {
      const Eigen::Vector3d here = patch.positions[vertex];
      Eigen::Vector3d place = here;
      for (const Eigen::Vector3d& direction : directions) {
        patch.positions[vertex] = here + step * direction;
        const double value = worst();
        if (value > best - kGain) continue;
        best = value;
        place = patch.positions[vertex];
      }
      patch.positions[vertex] = place;
      if (place == here) break;
      moved = true;
    }
  }
  if (moved) {
    for (const PatchCorner& corner : fan.corners) patch.changed[corner.triangle] = 1;
  }
  return moved;
}

/// Triangles that wait to be made wider, each once at a time.
class WorkList {
 public:
  void add(int triangle) {
    if (triangle >= static_cast<int>(waits_.size())) waits_.resize(triangle + 1, 0);
    if (waits_[triangle]) return;
    waits_[triangle] = 1;
    triangles_.push_back(triangle);
  }
  void add_around(const CutPatch& patch, int triangle) {
    for (const int vertex : patch.triangles[triangle]) {
      for (const PatchCorner& corner : patch.fan_of(vertex).corners) add(corner.triangle);
    }
  }
  bool take(int& triangle) {
    if (next_ == triangles_.size()) return false;
    triangle = triangles_[next_++];
    waits_[triangle] = 0;
    return true;
  }
  std::span<const int> met() const { return triangles_; }

 private:
  std::vector<int> triangles_;
  std::vector<char> waits_;
  std::size_t next_ = 0;
};

/// The sharpness from which on a triangle is left alone: a little better than it must be.
double good_enough(const CutPatch& patch, int triangle) {
  constexpr double kMargin = 1.3;
  return std::cos(kMargin * patch.allowed_at(triangle));
}

/// Flips and moves at changed triangles that are not good enough, and on from there where that helped.
void relax(CutPatch& patch, WorkList& work) {
  int budget = 10 * static_cast<int>(work.met().size()) + 40;  // visits: what has not helped by then will not
  for (int t = 0; work.take(t) && budget > 0; --budget) {
    if (!patch.changed[t] || patch.frozen[t] || sharpness(patch, t) <= good_enough(patch, t)) continue;
    bool better = false;
    for (int k = 0; k < 3; ++k) {
      const int across = patch.neighbours[t][k];
      if (!flip_if_wider(patch, t, k)) continue;
      better = true;
      work.add_around(patch, across);
    }
    for (int k = 0; k < 3; ++k) better |= move_if_wider(patch, patch.triangles[t][k]);
    if (better) work.add_around(patch, t);
  }
}

/// Puts a vertex into a triangle or one of its sides where that, and what it makes possible, helps.
bool split_if_wider(CutPatch& patch, int t) {
  CutPatch best;
  double best_value = sharpness(patch, t) - 1e-3;
  for (int k = -1; k < 3; ++k) {
    if (k >= 0 && patch.is_held(t, k)) continue;
    CutPatch trial = patch;
    const Eigen::Vector3i& corners = patch.triangles[t];
    const auto& p = patch.positions;
    const int vertex = k < 0 ? trial.split_triangle(t, (p[corners[0]] + p[corners[1]] + p[corners[2]]) / 3)
                             : trial.split_side(t, k, 0.5 * (p[corners[k]] + p[corners[(k + 1) % 3]]));
    WorkList work;
    for (const PatchCorner& corner : trial.fan_of(vertex).corners) work.add(corner.triangle);
    relax(trial, work);
    double value = -1;
    for (const int met : work.met()) {
      if (trial.changed[met]) value = std::max(value, sharpness(trial, met));
    }
    if (value >= best_value) continue;
    best_value = value;
    best = std::move(trial);
  }
  if (best.triangles.empty()) return false;
  patch = std::move(best);
  return true;
}

}  // namespace

void improve(CutPatch& patch) {
  WorkList work;
  for (int t = 0; t < patch.triangle_count(); ++t) work.add(t);
  relax(patch, work);
  std::set<int> hopeless;
  constexpr int kMostSplits = 12;
  constexpr std::size_t kMostHopeless = 3;  // triangles: the path has to be snapped differently anyway
  for (int splits = 0; splits < kMostSplits && hopeless.size() < kMostHopeless; ++splits) {
    int sharpest = -1;
    double worst = 0;
    for (int t = 0; t < patch.triangle_count(); ++t) {
      if (!patch.changed[t] || patch.frozen[t] || hopeless.count(t)) continue;
      const double excess = sharpness(patch, t) - allowed_sharpness(patch, t);
      if (excess <= worst) continue;
      worst = excess;
      sharpest = t;
    }
    if (sharpest < 0) return;
    if (!split_if_wider(patch, sharpest)) hopeless.insert(sharpest);
  }
}

}  // namespace thinwall
