#include "engine/equilibrium/WallPatch.hpp"

#include <algorithm>

namespace thinwall {
namespace {

/// Part of the largest force above which a vertex is one of those that a patch lies around, and how many there may be.
constexpr double kSeedForce = 0.05;
constexpr std::ptrdiff_t kMostSeeds = 24;

/// Rings of triangles around them.
constexpr int kRings = 2;

/// Vertices in a patch: as many as a dense matrix takes less time for than a sparse one for the wall, and a part of the
/// wall that has little to say about the rest.
constexpr std::ptrdiff_t kMostVertices = 90;
constexpr std::ptrdiff_t kLeastShare = 40;

bool has_corner(const std::vector<char>& marked, const Eigen::Vector3i& triangle) {
  return marked[triangle[0]] || marked[triangle[1]] || marked[triangle[2]];
}

void add_ring(const BodyModel& model, std::vector<char>& marked) {
  const std::vector<char> before = marked;
  for (int t = 0; t < model.triangles(); ++t) {
    if (!has_corner(before, model.surface[t])) continue;
    for (const int vertex : model.surface[t]) marked[vertex] = 1;
  }
}

}  // namespace

std::optional<WallPatch> patch_around(const BodyModel& model, const Eigen::VectorXd& force,
                                      std::span<const char> held) {
  const int vertices = model.vertices();
  const double largest = force.lpNorm<Eigen::Infinity>();
  WallPatch patch;
  patch.has.resize(vertices);
  for (int v = 0; v < vertices; ++v) {
    patch.has[v] = force.segment<3>(3 * v).lpNorm<Eigen::Infinity>() > kSeedForce * largest;
  }
  if (std::ranges::count(patch.has, 1) > kMostSeeds) return {};
  for (int ring = 0; ring < kRings; ++ring) add_ring(model, patch.has);
  for (int v = 0; v < vertices; ++v) {
    if (held[v]) patch.has[v] = 0;
  }
  const std::ptrdiff_t count = std::ranges::count(patch.has, 1);
  if (count == 0 || count > kMostVertices || kLeastShare * count > vertices) return {};
  patch.number.assign(model.unknowns(), -1);
  for (int k = 0; k < 3 * vertices; ++k) {
    if (!patch.has[k / 3] || model.fixed[k]) continue;
    patch.number[k] = static_cast<int>(patch.unknowns.size());
    patch.unknowns.push_back(k);
  }
  for (int t = 0; t < model.triangles(); ++t) {
    if (has_corner(patch.has, model.surface[t])) patch.triangles.push_back(t);
  }
  return patch;
}

}  // namespace thinwall
