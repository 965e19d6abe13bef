#include "engine/fluid/PressedLanes.hpp"

#include <gtest/gtest.h>

#include "engine/solver/BlockPattern.hpp"

namespace thinwall {
namespace {

using Corners = std::array<Eigen::Vector3d, 3>;

/// Triangles of unlike shapes, seen from a point that belongs to none.
struct Some {
  std::array<Corners, kLanes> triangles;
  double corners[9][kLanes];

  Some() {
    for (int lane = 0; lane < kLanes; ++lane) {
      triangles[lane] = {Eigen::Vector3d(0.3, -0.1, 0.7), Eigen::Vector3d(1.2, 0.4, 0.2),
                         Eigen::Vector3d(-0.2, 0.9, 1.1)};
      triangles[lane][lane % 3] *= 1.0 / (lane + 3);
      for (int k = 0; k < 9; ++k) corners[k][lane] = triangles[lane][k / 3][k % 3];
    }
  }
};

/// Another field for each lane: of the four one lies wholly below its surface, one above, two across.
std::array<PressureField, kLanes> fields(bool suction) {
  std::array<PressureField, kLanes> all;
  const double levels[] = {9.7, -9.1, -0.23, 0.31};
  for (int lane = 0; lane < kLanes; ++lane) {
    all[lane] = {.at_origin = levels[lane % 4], .slope = {1.1 + 0.3 * lane, -2.3, 0.7}, .suction = suction};
  }
  return all;
}

class OfLanesTest : public testing::TestWithParam<bool> {};

TEST_P(OfLanesTest, PressuresOnTrianglesSideBySideDoWhatTheyDoToEachToTheBit) {
  const Some some;
  const auto all = fields(GetParam());
  PressureLanes field;
  for (int lane = 0; lane < kLanes; ++lane) field.set(lane, all[lane]);
  PressedLanes terms;
  pressed_lanes(some.corners, field, true, terms);
  for (int lane = 0; lane < kLanes; ++lane) {
    const PressedTriangle alone(some.triangles[lane], all[lane]);
    const auto load = alone.load(), unit_load = alone.unit_load();
    for (int k = 0; k < 9; ++k) {
      EXPECT_EQ(terms.load[k][lane], load[k]) << "load " << k << " of lane " << lane;
      EXPECT_EQ(terms.unit_load[k][lane], unit_load[k]) << "unit load " << k << " of lane " << lane;
    }
    const auto tangent = alone.symmetric_tangent();
    for (int block = 0; block < 6; ++block) {
      const auto [a, b] = kBlockCorners[block];
      for (int column = 0; column < 3; ++column) {
        for (int row = a == b ? column : 0; row < 3; ++row) {
          EXPECT_EQ(terms.stiffness[block][3 * column + row][lane], -tangent(3 * a + row, 3 * b + column))
              << "row " << row << ", column " << column << " of block " << block << " of lane " << lane;
        }
      }
    }
  }
}
INSTANTIATE_TEST_SUITE_P(PressedLanes, OfLanesTest, testing::Bool(),
                         [](const auto& which) { return which.param ? "WithSuction" : "BelowASurface"; });

TEST(PressedLanes, MomentLoadsOfTrianglesSideBySideAreThoseOfEachToTheBit) {
  const Some some;
  double loads[3][9][kLanes];
  moment_loads_of(some.corners, loads);
  for (int lane = 0; lane < kLanes; ++lane) {
    const auto alone = moment_loads_of(some.triangles[lane]);
    for (int axis = 0; axis < 3; ++axis) {
      for (int k = 0; k < 9; ++k) EXPECT_EQ(loads[axis][k][lane], alone(k, axis)) << axis << ", " << k << ", " << lane;
    }
  }
}

TEST(PressedLanes, FurtherPressuresOnTheSameTrianglesAdd) {
  const Some some;
  PressureLanes one, two, both;
  for (int lane = 0; lane < kLanes; ++lane) {
    const PressureField first{.at_origin = 2, .slope = {1, 0, 2}}, second{.at_origin = -3, .slope = {0, 4, 1}};
    one.set(lane, first);
    two.set(lane, second);
    both.set(lane, {.at_origin = -1, .slope = {1, 4, 3}});
  }
  PressedLanes sum, part, whole;
  pressed_lanes(some.corners, one, true, sum);
  pressed_lanes(some.corners, two, true, part);
  add_to(sum, part, true);
  pressed_lanes(some.corners, both, true, whole);
  for (int lane = 0; lane < kLanes; ++lane) {
    // Round-off of numbers of some ten.
    for (int k = 0; k < 9; ++k) EXPECT_NEAR(sum.load[k][lane], whole.load[k][lane], 1e-14);
    for (int k = 0; k < 9; ++k) EXPECT_NEAR(sum.stiffness[3][k][lane], whole.stiffness[3][k][lane], 1e-14);
  }
}

}  // namespace
}  // namespace thinwall
