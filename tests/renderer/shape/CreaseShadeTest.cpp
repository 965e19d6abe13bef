#include "renderer/shape/CreaseShade.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace thinwall {
namespace {

constexpr CreaseDefinition kCrease{.reach = 0.004, .curvature = 200};
constexpr float kStep = 0.002F;  // metres

/// 21 by 21 vertices around the origin, level or upright across x.
std::vector<SurfaceVertex> wall(bool is_upright, float x = 0) {
  std::vector<SurfaceVertex> vertices;
  for (int i = -10; i <= 10; ++i) {
    for (int j = -10; j <= 10; ++j) {
      const float a = static_cast<float>(i) * kStep, b = static_cast<float>(j) * kStep;
      SurfaceVertex& vertex = vertices.emplace_back();
      vertex.position = is_upright ? Float3{x, a, b} : Float3{a, b, 0};
      vertex.normal = is_upright ? Float3{1, 0, 0} : Float3{0, 0, 1};
    }
  }
  return vertices;
}

void shade(std::vector<SurfaceVertex>& one, std::vector<SurfaceVertex>& other) {
  const std::vector<std::span<SurfaceVertex>> walls = {one, other};
  shade_creases(walls, kCrease);
}

TEST(CreaseShade, WallsThatMeetAreTheDarkerTheNearerTheyAreToEachOther) {
  std::vector<SurfaceVertex> level = wall(false), upright = wall(true);
  shade(level, upright);
  const auto expected = [](float apart) { return std::max(0.0, 200 * (1 - std::abs(apart) / 0.004)); };
  // The nearest vertex of the other wall lies at the same y.
  for (const SurfaceVertex& vertex : level) EXPECT_NEAR(vertex.curvature, expected(vertex.position[0]), 1e-3);
  for (const SurfaceVertex& vertex : upright) EXPECT_NEAR(vertex.curvature, expected(vertex.position[2]), 1e-3);
}

TEST(CreaseShade, IsNoneFarFromOthersAndMakesNoDentShallower) {
  std::vector<SurfaceVertex> level = wall(false), far = wall(true, 0.06F);
  level.front().curvature = -30;
  shade(level, far);
  EXPECT_EQ(level.front().curvature, -30);
  EXPECT_TRUE(std::ranges::all_of(far, [](const SurfaceVertex& vertex) { return vertex.curvature == 0; }));
  std::vector<SurfaceVertex> upright = wall(true);
  for (SurfaceVertex& vertex : level) vertex.curvature = 300;
  shade(level, upright);
  EXPECT_TRUE(std::ranges::all_of(level, [](const SurfaceVertex& vertex) { return vertex.curvature == 300; }));
}

}  // namespace
}  // namespace thinwall
