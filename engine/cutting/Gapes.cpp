#include "engine/cutting/Gapes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>
#include <span>
#include <utility>

namespace thinwall {
namespace {

/// Area over the square of a loop's length that is rounding: the lips of a slit lie on each other at rest.
constexpr double kNoArea = 1e-9;

/// Lips that hang together: vertices in the sense of the wall's triangles, and whether the last leads to the first.
struct LipChain {
  std::vector<int> vertices;
  bool is_closed = false;
};

/// (vertices), the triangle whose side from the vertex on is a lip; -1 where none is.
std::vector<int> triangles_after(const CutSurface& surface) {
  const std::vector<Eigen::Vector3i>& triangles = surface.mesh().triangles;
  std::vector<int> after(surface.mesh().vertices.size(), -1);
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
    for (int k = 0; k < 3; ++k) {
      if (surface.is_lip(t, k)) after[triangles[t][k]] = t;
    }
  }
  return after;
}

int following(const Eigen::Vector3i& triangle, int vertex) {
  return triangle[(std::ranges::find(triangle, vertex) - triangle.begin() + 1) % 3];
}

std::vector<LipChain> chains_of(const SurfaceMesh& mesh, const std::vector<int>& triangle_after) {
  const int count = static_cast<int>(triangle_after.size());
  std::vector<int> next(count, -1);
  std::vector<char> has_previous(count, 0), met(count, 0);
  for (int v = 0; v < count; ++v) {
    if (triangle_after[v] < 0) continue;
    next[v] = following(mesh.triangles[triangle_after[v]], v);
    has_previous[next[v]] = 1;
  }
  std::vector<LipChain> chains;
  // First those that begin somewhere; what is left are loops.
  for (const bool begins : {true, false}) {
    for (int start = 0; start < count; ++start) {
      if (next[start] < 0 || met[start] || (begins && has_previous[start])) continue;
      LipChain chain{.vertices = {}, .is_closed = !begins};
      for (int v = start; v >= 0 && !met[v]; v = next[v]) {
        met[v] = 1;
        chain.vertices.push_back(v);
      }
      chains.push_back(std::move(chain));
    }
  }
  return chains;
}

/// Joins the lips that end at borders, which no cut made, across those.
std::vector<std::vector<int>> joined_across_mouths(const SurfaceMesh& mesh, std::span<const LipChain> chains) {
  std::vector<std::vector<int>> loops;
  std::vector<char> used(chains.size(), 0);
  const auto beginning_at = [&](int vertex) -> std::optional<std::size_t> {
    for (std::size_t k = 0; k < chains.size(); ++k) {
      if (used[k] || chains[k].is_closed) continue;
      if (mesh.vertices[chains[k].vertices.front()] == mesh.vertices[vertex]) return k;
    }
    return std::nullopt;
  };
  for (std::size_t first = 0; first < chains.size(); ++first) {
    if (used[first] || chains[first].is_closed) continue;
    std::vector<int> loop;
    for (std::optional<std::size_t> k = first; k; k = beginning_at(loop.back())) {
      used[*k] = 1;
      loop.insert(loop.end(), chains[*k].vertices.begin(), chains[*k].vertices.end());
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

/// Whether the wall lies within a loop at rest, and not around it.
bool is_outer_border(const SurfaceMesh& mesh, const std::vector<int>& triangle_after, const std::vector<int>& loop) {
  Eigen::Vector3d within = Eigen::Vector3d::Zero(), normal = Eigen::Vector3d::Zero();
  double length = 0;
  const Eigen::Vector3d& origin = mesh.vertices[loop.front()];
  for (const int vertex : loop) {
    const Eigen::Vector3i& t = mesh.triangles[triangle_after[vertex]];
    const Eigen::Vector3d &a = mesh.vertices[vertex], &b = mesh.vertices[following(t, vertex)];
    within += 0.5 * (a - origin).cross(b - origin);
    length += (b - a).norm();
    const Eigen::Vector3d across =
        (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]).normalized();
    normal += (b - a).norm() * across;
  }
  return within.dot(normal.stableNormalized()) > kNoArea * length * length;
}

}  // namespace

std::vector<std::vector<int>> gapes_of(const CutSurface& surface) {
  const SurfaceMesh& mesh = surface.mesh();
  const std::vector<int> triangle_after = triangles_after(surface);
  const std::vector<LipChain> chains = chains_of(mesh, triangle_after);
  std::vector<std::vector<int>> gapes = joined_across_mouths(mesh, chains);
  for (const LipChain& chain : chains) {
    if (chain.is_closed && !is_outer_border(mesh, triangle_after, chain.vertices)) gapes.push_back(chain.vertices);
  }
  return gapes;
}

}  // namespace thinwall
