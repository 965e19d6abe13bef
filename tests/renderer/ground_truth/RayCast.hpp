#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "renderer/camera/Camera.hpp"
#include "renderer/shape/ToolShape.hpp"
#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall::test {

struct CastHit {
  double depth = std::numeric_limits<double>::infinity();  // metres along the line of sight
  std::size_t owner = 0;                                   // surface, or surfaces + tool
  std::size_t triangle = 0;
  std::array<double, 3> weights{};
};

/// Tries a triangle in the way of Möller and Trumbore (1997).
inline void cast(Vector3 origin, Vector3 direction, const std::array<Vector3, 3>& corners, std::size_t owner,
                 std::size_t triangle, CastHit& hit) {
  const Vector3 u = corners[1] - corners[0], v = corners[2] - corners[0];
  const Vector3 p = cross(direction, v);
  const double determinant = dot(u, p);
  if (determinant == 0) return;
  const Vector3 t = origin - corners[0];
  const double second = dot(t, p) / determinant;
  const Vector3 q = cross(t, u);
  const double third = dot(direction, q) / determinant;
  const double depth = dot(v, q) / determinant;
  if (second < 0 || third < 0 || second + third > 1 || depth <= 0 || depth >= hit.depth) return;
  hit = {.depth = depth, .owner = owner, .triangle = triangle, .weights = {1 - second - third, second, third}};
}

/// The ray through a place of the picture in pixels from its upper left corner; one metre deep along the line of sight.
inline Vector3 ray_direction(const Camera& camera, ImageSize size, double x, double y) {
  return camera.forward + (2 * x / size.width - 1) * camera.tangent_x * camera.right -
         (2 * y / size.height - 1) * camera.tangent_y * camera.up;
}

/// What the middle of a pixel shows of walls and tools, by trying every triangle.
inline std::optional<CastHit> cast(const Snapshot& snapshot, const Camera& camera, ImageSize size, double scene_size,
                                   int column, int row) {
  const Vector3 direction = ray_direction(camera, size, column + 0.5, row + 0.5);
  CastHit hit;
  std::size_t owner = 0;
  for (const SnapshotSurface& surface : snapshot.surfaces) {
    for (std::size_t t = 0; t < surface.topology->triangles.size(); ++t) {
      std::array<Vector3, 3> corners;
      for (std::size_t k = 0; k < 3; ++k) {
        corners[k] = vector3(surface.positions[surface.topology->triangles[t][k]]);
      }
      cast(camera.position, direction, corners, owner, t, hit);
    }
    ++owner;
  }
  for (const SnapshotTool& tool : snapshot.tools) {
    const ToolShape shape = tool_shape(tool, scene_size);
    for (std::size_t t = 0; t < shape.indices.size() / 3; ++t) {
      std::array<Vector3, 3> corners;
      for (std::size_t k = 0; k < 3; ++k) corners[k] = vector3(shape.vertices[shape.indices[3 * t + k]].position);
      cast(camera.position, direction, corners, owner, t, hit);
    }
    ++owner;
  }
  if (!std::isfinite(hit.depth)) return std::nullopt;
  return hit;
}

}  // namespace thinwall::test
