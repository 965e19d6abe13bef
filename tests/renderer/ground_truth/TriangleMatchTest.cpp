#include "renderer/ground_truth/TriangleMatch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace thinwall {
namespace {

TEST(TriangleMatchTest, NearestPlacesAreNotFartherThanAnyOther) {
  std::mt19937 random(7);
  const auto draw = [&] { return static_cast<double>(random()) / static_cast<double>(std::mt19937::max()) - 0.5; };
  for (int trial = 0; trial < 300; ++trial) {
    const std::array<Vector3, 3> corners = {
        {{draw(), draw(), draw()}, {draw(), draw(), draw()}, {draw(), draw(), draw()}}};
    const Vector3 point{2 * draw(), 2 * draw(), 2 * draw()};
    const auto [weights, distance] = nearest_weights(point, corners);
    EXPECT_NEAR(weights[0] + weights[1] + weights[2], 1, 1e-12);
    EXPECT_GE(*std::ranges::min_element(weights), -1e-12);
    double best = 1e9;
    constexpr int kSteps = 40;
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; i + j <= kSteps; ++j) {
        const double a = i / double{kSteps}, b = j / double{kSteps};
        best = std::min(best, length(a * corners[0] + b * corners[1] + (1 - a - b) * corners[2] - point));
      }
    }
    EXPECT_LE(distance, best + 1e-12);
    // The grid's places are at most this far from any other.
    EXPECT_GE(distance, best - 1.5 / kSteps);
  }
}

TEST(TriangleMatchTest, FindsPlacesInTheTrianglesThatACutHasMadeOfAnother) {
  const std::vector<Float3> before = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  const std::vector<Triangle> whole = {{0, 1, 2}, {1, 3, 2}};
  std::vector<Float3> after = before;
  after.push_back({0.5F, 0, 0});
  after.push_back({0.5F, 0, 0});
  const std::vector<Triangle> parts = {{0, 4, 2}, {1, 3, 2}, {5, 1, 2}};
  const TriangleMatch match({before, whole}, {after, parts});
  const auto same = match.find({.triangle = 1, .weights = {0.2, 0.3, 0.5}});
  ASSERT_TRUE(same);
  EXPECT_EQ(same->triangle, 1U);
  const auto left = match.find({.triangle = 0, .weights = {0.7, 0.2, 0.1}});
  ASSERT_TRUE(left);
  EXPECT_EQ(left->triangle, 0U);
  EXPECT_NEAR(left->weights[1], 0.4, 1e-6);
  const auto right = match.find({.triangle = 0, .weights = {0.2, 0.7, 0.1}});
  ASSERT_TRUE(right);
  EXPECT_EQ(right->triangle, 2U);
}

TEST(TriangleMatchTest, FindsNothingWhereThereIsNoWall) {
  const std::vector<Float3> positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}};
  const std::vector<Triangle> first = {{0, 1, 2}}, second = {{3, 4, 5}};
  EXPECT_FALSE(TriangleMatch({positions, first}, {positions, second}).find({0, {0.2, 0.3, 0.5}}));
}

}  // namespace
}  // namespace thinwall
