#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "renderer/snapshot/Snapshot.hpp"
#include "renderer/snapshot/Vector.hpp"

namespace thinwall {

/// An edge of a triangle mesh with the corners that its one or two triangles have off it.
struct MeshEdge {
  static constexpr std::uint32_t kNone = 0xffffffffu;
  std::uint32_t start = 0;
  std::uint32_t end = 0;
  std::uint32_t left = kNone;   // third corner of the triangle that runs from start to end
  std::uint32_t right = kNone;  // third corner of the other triangle, kNone at a border
};

/// Each edge once, in the order of its vertices; `corners` is (3 x triangles).
std::vector<MeshEdge> mesh_edges(std::span<const std::uint32_t> corners);

/// A straight piece of what divides a body from what is seen behind it.
struct OutlineSegment {
  Float3 start{};  // metres
  Float3 end{};    // metres
};

/// The edges of `edges` between a triangle that faces `eye` and one that faces away, and those at a border.
/// `position(i)` gives vertex i as a Vector3.
template <typename Position>
void append_outline(const std::vector<MeshEdge>& edges, Position&& position, Vector3 eye,
                    std::vector<OutlineSegment>& outline) {
  for (const MeshEdge& edge : edges) {
    const Vector3 start = position(edge.start), end = position(edge.end);
    const Vector3 toward_eye = eye - start;
    const Vector3 plane = cross(end - start, toward_eye);  // through the edge and the eye
    const bool border = edge.right == MeshEdge::kNone;
    // Seen from the eye, the triangles of an outline edge lie on the same side of it.
    if (!border && !(dot(plane, position(edge.left) - start) * dot(plane, position(edge.right) - start) > 0)) continue;
    const auto single = [](Vector3 a) {
      return Float3{static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(a.z)};
    };
    outline.push_back({single(start), single(end)});
  }
}

}  // namespace thinwall
