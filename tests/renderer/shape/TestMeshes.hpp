#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include "renderer/snapshot/Snapshot.hpp"
#include "renderer/snapshot/Vector.hpp"

namespace thinwall::test {

/// A surface at rest.
inline SnapshotSurface surface_of(const std::string& body, std::vector<Float3> positions,
                                  std::vector<Triangle> triangles) {
  auto topology = std::make_shared<SnapshotTopology>();
  topology->rest_positions = positions;
  topology->triangles = std::move(triangles);
  return {.body = body, .topology = topology, .positions = std::move(positions), .fields = {}};
}

/// Four corners, counter-clockwise seen from the side that the surface faces.
inline SnapshotSurface quad(const std::string& body, const std::array<Float3, 4>& corners) {
  return surface_of(body, {corners.begin(), corners.end()}, {{0, 1, 2}, {0, 2, 3}});
}

/// An octahedron whose triangles are divided into four `divisions` times, blown up to a sphere.
inline SnapshotSurface sphere(const std::string& body, Vector3 center, double radius, int divisions) {
  std::vector<Vector3> points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  std::vector<Triangle> triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                     {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int division = 0; division < divisions; ++division) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [found, is_new] =
          middles.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<std::uint32_t>(points.size()));
      if (is_new) points.push_back(normalized(points[a] + points[b]));
      return found->second;
    };
    std::vector<Triangle> smaller;
    for (const auto& [a, b, c] : triangles) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      smaller.insert(smaller.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    triangles = std::move(smaller);
  }
  std::vector<Float3> positions;
  for (const Vector3& point : points) {
    const Vector3 place = center + radius * point;
    positions.push_back({static_cast<float>(place.x), static_cast<float>(place.y), static_cast<float>(place.z)});
  }
  return surface_of(body, std::move(positions), std::move(triangles));
}

/// The same of 8 * parts ^ 2 triangles: each edge of the octahedron is divided into `parts`.
inline SnapshotSurface divided_sphere(const std::string& body, Vector3 center, double radius, int parts) {
  std::map<std::array<int, 3>, std::uint32_t> numbers;
  std::vector<Float3> positions;
  const auto vertex = [&](const std::array<int, 3>& place) {
    const auto [found, is_new] = numbers.try_emplace(place, static_cast<std::uint32_t>(positions.size()));
    if (is_new) {
      const Vector3 point = center + radius * normalized(Vector3{1.0 * place[0], 1.0 * place[1], 1.0 * place[2]});
      positions.push_back({static_cast<float>(point.x), static_cast<float>(point.y), static_cast<float>(point.z)});
    }
    return found->second;
  };
  std::vector<Triangle> triangles;
  for (int face = 0; face < 8; ++face) {
    const int x = face & 1 ? -1 : 1, y = face & 2 ? -1 : 1, z = face & 4 ? -1 : 1;
    const auto at = [&](int i, int j) { return vertex({x * i, y * j, z * (parts - i - j)}); };
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      triangles.push_back(x * y * z > 0 ? Triangle{a, b, c} : Triangle{a, c, b});
    };
    for (int i = 0; i < parts; ++i) {
      for (int j = 0; i + j < parts; ++j) {
        add(at(i, j), at(i + 1, j), at(i, j + 1));
        if (i + j + 1 < parts) add(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
      }
    }
  }
  return surface_of(body, std::move(positions), std::move(triangles));
}

}  // namespace thinwall::test
