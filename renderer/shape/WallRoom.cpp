#include "renderer/shape/WallRoom.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>

#include "renderer/shape/ScreenArea.hpp"
#include "renderer/snapshot/Vector.hpp"

namespace thinwall {
namespace {

/// Of the way to the outside of a wall that lies against another's inner side, what that takes at most: some of it
/// stays, for between vertices walls are drawn round.
constexpr double kTaken = 0.7;

/// Cosine of the angle between the outsides of walls that lie against each other, at most.
constexpr double kTurnedAway = -0.5;

/// Mean length of a wall's edges, metres: vertices stand about as far apart.
double mean_edge(const SnapshotSurface& surface) {
  double sum = 0;
  for (const Triangle& triangle : surface.topology->triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      sum += length(vector3(surface.positions[triangle[(k + 1) % 3]]) - vector3(surface.positions[triangle[k]]));
    }
  }
  return sum / static_cast<double>(std::max<std::size_t>(1, 3 * surface.topology->triangles.size()));
}

/// The vertices of a wall by cells of space.
class VertexGrid {
 public:
  VertexGrid(std::span<const SurfaceVertex> wall, double cell) : bounds_(bounds_of(wall)) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double extent = static_cast<double>(bounds_.most[axis]) - bounds_.least[axis];
      cell_[axis] = std::max({cell, extent / kMostCells, kSmallest});
      count_[axis] = static_cast<int>(extent / cell_[axis]) + 1;
    }
    std::vector<std::size_t> cells;
    starts_.assign(static_cast<std::size_t>(count_[0] * count_[1] * count_[2]) + 1, 0);
    for (const SurfaceVertex& vertex : wall) {
      const auto at = [&](std::size_t axis) { return place(vertex.position[axis], axis); };
      cells.push_back(cell_at(at(0), at(1), at(2)));
      ++starts_[cells.back() + 1];
    }
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    std::vector<std::size_t> next = starts_;
    sorted_.resize(wall.size());
    for (std::uint32_t v = 0; v < wall.size(); ++v) sorted_[next[cells[v]]++] = v;
  }

  /// All vertices in the box around both points that is larger by `margin`, and some beside it.
  template <typename Visit>
  void visit(Vector3 start, Vector3 end, double margin, Visit&& visit) const {
    const std::array least{std::min(start.x, end.x), std::min(start.y, end.y), std::min(start.z, end.z)};
    const std::array most{std::max(start.x, end.x), std::max(start.y, end.y), std::max(start.z, end.z)};
    const auto from = [&](std::size_t axis) { return place(least[axis] - margin, axis); };
    const auto to = [&](std::size_t axis) { return place(most[axis] + margin, axis); };
    for (int z = from(2); z <= to(2); ++z) {
      for (int y = from(1); y <= to(1); ++y) {
        const std::size_t behind = starts_[cell_at(to(0), y, z) + 1];
        for (std::size_t i = starts_[cell_at(from(0), y, z)]; i < behind; ++i) visit(sorted_[i]);
      }
    }
  }

 private:
  static constexpr double kMostCells = 64, kSmallest = 1e-9;

  int place(double at, std::size_t axis) const {
    return static_cast<int>(std::clamp((at - bounds_.least[axis]) / cell_[axis], 0.0, count_[axis] - 1.0));
  }
  std::size_t cell_at(int x, int y, int z) const {
    return static_cast<std::size_t>((z * count_[1] + y) * count_[0] + x);
  }

  Bounds bounds_;
  std::array<double, 3> cell_{};
  std::array<int, 3> count_{};
  std::vector<std::size_t> starts_;    // (cells + 1), into `sorted_`
  std::vector<std::uint32_t> sorted_;  // vertices
};

}  // namespace

void thin_to_room(const SnapshotSurface& surface, std::span<const SurfaceVertex> wall, std::vector<double>& thickness) {
  if (wall.empty()) return;
  const double spacing = mean_edge(surface);
  const VertexGrid grid(wall, spacing);
  const std::vector<Float3>& rest = surface.topology->rest_positions;
  for (std::size_t v = 0; v < wall.size(); ++v) {
    const Vector3 at = vector3(wall[v].position), normal = vector3(wall[v].normal);
    const Vector3 rest_at = vector3(rest[v]);
    double room = thickness[v] / kTaken;
    grid.visit(at, at - room * normal, spacing, [&](std::uint32_t other) {
      const Vector3 other_normal = vector3(wall[other].normal);
      if (dot(normal, other_normal) > kTurnedAway) return;
      const Vector3 apart = at - vector3(wall[other].position);
      const double inward = dot(apart, normal), from_plane = -dot(apart, other_normal);
      if (!(inward > 0) || !(from_plane > 0)) return;
      const Vector3 aside = apart - inward * normal;
      if (dot(aside, aside) > spacing * spacing || length(rest_at - vector3(rest[other])) < thickness[v]) return;
      room = std::min(room, std::min(inward, from_plane));
    });
    thickness[v] = std::min(thickness[v], kTaken * room);
  }
}

}  // namespace thinwall
