#include "renderer/shape/SeenLining.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "tests/renderer/shape/RightAngle.hpp"

namespace thinwall {
namespace {

/// Triangles with a side of 0.2 and their right angle at `places`.
std::vector<SurfaceVertex> triangles_at(const std::vector<Float3>& places) {
  std::vector<SurfaceVertex> vertices;
  for (const Float3& place : places) {
    for (const auto& [x, y] : {std::pair{0.0F, 0.0F}, {0.2F, 0.0F}, {0.0F, 0.2F}}) {
      vertices.push_back({.position = {place[0] + x, place[1] + y, place[2]}});
    }
  }
  return vertices;
}

TEST(SeenLining, IsWhatLiesBehindTheOpeningOnTheScreen) {
  // Seen through the opening, at twice its distance: 0 to 0.4 on both axes.
  const Bounds opening{{0, 0, -1}, {0.2F, 0.2F, -1}};
  const std::vector<SurfaceVertex> vertices = triangles_at({{0.3F, 0.1F, -2}, {0.5F, 0.1F, -2}, {-0.1F, -0.1F, -2}});
  const std::vector<std::uint32_t> corners = {0, 1, 2, 3, 4, 5, 6, 7, 8};
  EXPECT_EQ(seen_lining(vertices, corners, opening, right_angle()), (std::vector<std::uint32_t>{0, 1, 2, 6, 7, 8}));
}

TEST(SeenLining, IsAllOfItWhereTheOpeningReachesBehindTheEye) {
  const Bounds opening{{0, 0, -1}, {0.2F, 0.2F, 1}};
  const std::vector<SurfaceVertex> vertices = triangles_at({{5, 5, -2}});
  const std::vector<std::uint32_t> corners = {0, 1, 2};
  EXPECT_EQ(seen_lining(vertices, corners, opening, right_angle()), corners);
}

TEST(SeenLining, ATriangleThatReachesBehindTheEyeIsKept) {
  const Bounds opening{{0, 0, -1}, {0.2F, 0.2F, -1}};
  std::vector<SurfaceVertex> vertices = triangles_at({{5, 5, -2}});
  vertices[1].position[2] = 1;
  const std::vector<std::uint32_t> corners = {0, 1, 2};
  EXPECT_EQ(seen_lining(vertices, corners, opening, right_angle()), corners);
}

}  // namespace
}  // namespace thinwall
