#include "renderer/shape/MeetingLines.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>

#include "renderer/snapshot/Float3.hpp"

namespace thinwall {
namespace {

/// A triangle and the box around it.
struct BoxedTriangle {
  std::array<Float3, 3> corners{};
  Bounds box;
};

bool meet(const Bounds& a, const Bounds& b) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (a.least[axis] > b.most[axis] || b.least[axis] > a.most[axis]) return false;
  }
  return true;
}

Bounds box_of(const std::array<Float3, 3>& corners) {
  Bounds box{corners[0], corners[0]};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.least[axis] = std::min({corners[0][axis], corners[1][axis], corners[2][axis]});
    box.most[axis] = std::max({corners[0][axis], corners[1][axis], corners[2][axis]});
  }
  return box;
}

bool faces(const std::array<Float3, 3>& corners, Vector3 eye) {
  const Vector3 a = vector3(corners[0]);
  return dot(cross(vector3(corners[1]) - a, vector3(corners[2]) - a), eye - a) > 0;
}

/// Those that face `eye` and whose boxes meet `bounds`.
std::vector<BoxedTriangle> triangles_within(std::span<const SurfaceVertex> vertices,
                                            std::span<const std::uint32_t> corners, const Bounds& bounds, Vector3 eye) {
  std::vector<BoxedTriangle> triangles;
  triangles.reserve(corners.size() / 6);  // a half of the wall faces anyone
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    BoxedTriangle triangle;
    for (std::size_t k = 0; k < 3; ++k) triangle.corners[k] = vertices[corners[i + k]].position;
    if (!faces(triangle.corners, eye)) continue;
    triangle.box = box_of(triangle.corners);
    if (meet(triangle.box, bounds)) triangles.push_back(triangle);
  }
  return triangles;
}

/// Triangles by the places of their boxes' least corners, in cells that none of them is larger than.
class TriangleGrid {
 public:
  explicit TriangleGrid(std::span<const BoxedTriangle> triangles) {
    Bounds all = triangles.front().box;
    float largest = 0;
    for (const BoxedTriangle& triangle : triangles) {
      all = around(all, triangle.box);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        largest = std::max(largest, triangle.box.most[axis] - triangle.box.least[axis]);
      }
    }
    least_ = all.least;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      cell_[axis] = std::max({largest, (all.most[axis] - all.least[axis]) / kMostCells, kSmallest});
      count_[axis] = static_cast<int>((all.most[axis] - all.least[axis]) / cell_[axis]) + 1;
    }
    std::vector<std::size_t> cells;
    starts_.assign(static_cast<std::size_t>(count_[0] * count_[1] * count_[2]) + 1, 0);
    for (const BoxedTriangle& triangle : triangles) {
      cells.push_back(
          cell_at(place(triangle.box.least[0], 0), place(triangle.box.least[1], 1), place(triangle.box.least[2], 2)));
      ++starts_[cells.back() + 1];
    }
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    std::vector<std::size_t> next = starts_;
    sorted_.resize(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) sorted_[next[cells[i]]++] = triangles[i];
  }

  /// All whose boxes meet that of `one`, in an order that the triangles alone decide.
  template <typename Visit>
  void visit(const BoxedTriangle& one, Visit&& visit) const {
    const auto from = [&](std::size_t axis) { return place(one.box.least[axis] - cell_[axis], axis); };
    const auto to = [&](std::size_t axis) { return place(one.box.most[axis], axis); };
    for (int z = from(2); z <= to(2); ++z) {
      for (int y = from(1); y <= to(1); ++y) {
        const std::size_t end = starts_[cell_at(to(0), y, z) + 1];
        for (std::size_t i = starts_[cell_at(from(0), y, z)]; i < end; ++i) {
          if (meet(one.box, sorted_[i].box)) visit(sorted_[i]);
        }
      }
    }
  }

 private:
  static constexpr float kMostCells = 64, kSmallest = 1e-9F;

  int place(float at, std::size_t axis) const {
    return std::clamp(static_cast<int>((at - least_[axis]) / cell_[axis]), 0, count_[axis] - 1);
  }
  std::size_t cell_at(int x, int y, int z) const {
    return static_cast<std::size_t>((z * count_[1] + y) * count_[0] + x);
  }

  Float3 least_{}, cell_{};
  std::array<int, 3> count_{};
  std::vector<std::size_t> starts_;  // (cells + 1), into `sorted_`
  std::vector<BoxedTriangle> sorted_;
};

/// Where a side of a triangle goes through another one.
std::optional<Vector3> side_through(Vector3 start, Vector3 end, const std::array<Vector3, 3>& triangle) {
  const auto& [a, b, c] = triangle;
  const Vector3 normal = cross(b - a, c - a);
  const double before = dot(start - a, normal), behind = dot(end - a, normal);
  if ((before > 0) == (behind > 0) || before == behind) return std::nullopt;
  const Vector3 at = start + before / (before - behind) * (end - start);
  for (std::size_t k = 0; k < 3; ++k) {
    if (dot(cross(triangle[(k + 1) % 3] - triangle[k], at - triangle[k]), normal) < 0) return std::nullopt;
  }
  return at;
}

/// Whether all of `one` lies on one side of the plane of `other`.
bool lies_beside(const std::array<Vector3, 3>& one, const std::array<Vector3, 3>& other) {
  const Vector3 normal = cross(other[1] - other[0], other[2] - other[0]);
  const auto is_before = [&](const Vector3& corner) { return dot(corner - other[0], normal) > 0; };
  return is_before(one[0]) == is_before(one[1]) && is_before(one[1]) == is_before(one[2]);
}

void append_line_of(const BoxedTriangle& first, const BoxedTriangle& second, std::vector<OutlineSegment>& lines) {
  const auto corners_of = [](const BoxedTriangle& triangle) {
    return std::array{vector3(triangle.corners[0]), vector3(triangle.corners[1]), vector3(triangle.corners[2])};
  };
  const std::array<std::array<Vector3, 3>, 2> both{corners_of(first), corners_of(second)};
  if (lies_beside(both[0], both[1]) || lies_beside(both[1], both[0])) return;
  std::array<Vector3, 6> ends;
  std::size_t count = 0;
  for (std::size_t which = 0; which < 2; ++which) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto at = side_through(both[which][k], both[which][(k + 1) % 3], both[1 - which]);
      if (at) ends[count++] = *at;
    }
  }
  if (count < 2) return;
  // Through a corner or a side, more than two may be found: the others lie between.
  std::size_t last = 1;
  for (std::size_t k = 2; k < count; ++k) {
    if (length(ends[k] - ends[0]) > length(ends[last] - ends[0])) last = k;
  }
  lines.push_back({float3(ends[0]), float3(ends[last])});
}

}  // namespace

void append_meeting_lines(std::span<const SurfaceVertex> vertices, const MeetingWall& first, const MeetingWall& second,
                          Vector3 eye, std::vector<OutlineSegment>& lines) {
  if (!meet(first.bounds, second.bounds)) return;
  const std::vector<BoxedTriangle> ones = triangles_within(vertices, first.corners, second.bounds, eye);
  const std::vector<BoxedTriangle> others = triangles_within(vertices, second.corners, first.bounds, eye);
  if (ones.empty() || others.empty()) return;
  const TriangleGrid grid(others);
  for (const BoxedTriangle& one : ones) {
    grid.visit(one, [&](const BoxedTriangle& other) { append_line_of(one, other, lines); });
  }
}

}  // namespace thinwall
