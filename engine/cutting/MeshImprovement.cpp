#include "engine/cutting/MeshImprovement.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/cutting/CutQuality.hpp"

namespace thinwall {
namespace {

constexpr double kGain = 1e-6;  // of a cosine: less is no improvement, so that no two states alternate

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
  for (double step = 0.2 * size; step > 0.01 * size; step *= 0.5) {
    for (int tries = 0; tries < 3; ++tries) {
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

bool relax_triangle(CutPatch& patch, int t) {
  bool better = false;
  for (int k = 0; k < 3; ++k) better |= flip_if_wider(patch, t, k);
  for (int k = 0; k < 3; ++k) better |= move_if_wider(patch, patch.triangles[t][k]);
  return better;
}

/// Flips and moves at changed triangles that are sharper than `enough`.
void relax(CutPatch& patch, double enough) {
  for (int pass = 0; pass < 8; ++pass) {
    bool better = false;
    for (int t = 0; t < patch.triangle_count(); ++t) {
      if (patch.changed[t] && sharpness(patch, t) > enough) better |= relax_triangle(patch, t);
    }
    if (!better) return;
  }
}

double sharpest_change(const CutPatch& patch, int facet) {
  double worst = -1;
  for (int t = 0; t < patch.triangle_count(); ++t) {
    if (patch.changed[t] && patch.facet[t] == facet) worst = std::max(worst, sharpness(patch, t));
  }
  return worst;
}

/// Puts a vertex into a triangle or one of its sides where that, and what it makes possible, helps.
bool split_if_wider(CutPatch& patch, int t, double enough) {
  const int facet = patch.facet[t];
  const double before = sharpest_change(patch, facet);
  CutPatch best;
  double best_value = before - 1e-3;
  for (int k = -1; k < 3; ++k) {
    if (k >= 0 && patch.is_held(t, k)) continue;
    CutPatch trial = patch;
    const Eigen::Vector3i& corners = patch.triangles[t];
    const auto& p = patch.positions;
    if (k < 0) {
      trial.split_triangle(t, (p[corners[0]] + p[corners[1]] + p[corners[2]]) / 3);
    } else {
      trial.split_side(t, k, 0.5 * (p[corners[k]] + p[corners[(k + 1) % 3]]));
    }
    relax(trial, enough);
    const double value = sharpest_change(trial, facet);
    if (value >= best_value) continue;
    best_value = value;
    best = std::move(trial);
  }
  if (best.triangles.empty()) return false;
  patch = std::move(best);
  return true;
}

}  // namespace

void improve(CutPatch& patch, double least, double enough) {
  relax(patch, std::cos(enough));
  constexpr int kMostSplits = 6;
  for (int splits = 0; splits < kMostSplits; ++splits) {
    int sharpest = -1;
    double worst = std::cos(least);
    for (int t = 0; t < patch.triangle_count(); ++t) {
      if (!patch.changed[t] || patch.frozen[t] || sharpness(patch, t) <= worst) continue;
      worst = sharpness(patch, t);
      sharpest = t;
    }
    if (sharpest < 0 || !split_if_wider(patch, sharpest, std::cos(enough))) return;
  }
}

}  // namespace thinwall
