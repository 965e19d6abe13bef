#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/picture/FrameUniforms.hpp"

namespace thinwall {
namespace {

/// A sheet of 60 mm by 20 mm, at rest.
SceneExtent sheet() {
  SceneExtent extent;
  for (const double x : {-0.03, 0.0, 0.03}) {
    for (const double y : {-0.01, 0.0, 0.01}) extent.rest_points.push_back({x, y, 0});
  }
  extent.size = 2 * std::hypot(0.03, 0.01);
  extent.reach = 0.5 * extent.size;
  return extent;
}

/// Most of |x| and of |y| of all rest points in the map.
std::array<double, 2> most_in_map(const SceneExtent& extent, const Studio& studio) {
  const Matrix4 matrix = key_light_matrix(extent, studio);
  std::array<double, 2> most{};
  for (const Vector3& point : extent.rest_points) {
    std::array<double, 4> clip{};
    for (int row = 0; row < 4; ++row) {
      clip[static_cast<std::size_t>(row)] =
          matrix(row, 0) * point.x + matrix(row, 1) * point.y + matrix(row, 2) * point.z + matrix(row, 3);
    }
    for (std::size_t axis = 0; axis < 2; ++axis) most[axis] = std::max(most[axis], std::abs(clip[axis] / clip[3]));
  }
  return most;
}

Studio lamp_at(Vector3 place) {
  return {.key_direction = normalized(place),
          .fill_direction = normalized(place),
          .front = {0, -1, 0},
          .lamp_place = place};
}

const Studio kFarLamp = {.key_direction = {0.6, 0, 0.8}, .fill_direction = {0, 0, 1}, .front = {0, -1, 0}};

/// The margin around it is 15 %; beyond nine tenths shadows fade.
TEST(KeyLight, FillsItsMapWithTheTissueAtRest) {
  for (const Studio& studio : {kFarLamp, lamp_at({0.01, -0.03, 0.06})}) {
    for (const double most : most_in_map(sheet(), studio)) EXPECT_NEAR(most, 1 / 1.15, 1e-6);
  }
}

TEST(KeyLight, LeavesRoomForTissueThatHasGrown) {
  SceneExtent extent = sheet();
  extent.reach *= 1.25;
  for (const double most : most_in_map(extent, kFarLamp)) EXPECT_NEAR(most, 1 / (1.15 * 1.25), 1e-6);
}

TEST(KeyLight, AmongTheTissueKeepsItsWholeView) {
  for (const double most : most_in_map(sheet(), lamp_at({0, 0, 1e-4}))) EXPECT_TRUE(std::isfinite(most));
}

}  // namespace
}  // namespace thinwall
