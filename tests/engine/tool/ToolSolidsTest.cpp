#include "engine/tool/ToolSolids.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace thinwall {
namespace {

/// In space: x' is x, y' is y, z' is z, and the tip lies at the origin.
ToolPose upright(double opening = 0) {
  return {.direction = Eigen::Vector3d::UnitZ(), .axis = Eigen::Vector3d::UnitY(), .opening = opening};
}

double distance(const ToolSolid& solid, double x, double y, double z) {
  return signed_distance(solid, {x, y, z}).value;
}

/// Where three faces of a box would meet that are rounded by `radius`, metres: the diagonal of a cube less that.
double beside_corner(double radius) {
  return (std::sqrt(3) - 1) * radius;
}

TEST(ToolSolids, AreNoneOfPointAndLine) {
  EXPECT_TRUE(tool_solids({.name = "tool", .kind = ToolKind::kPoint}, upright()).empty());
  EXPECT_TRUE(tool_solids({.name = "tool", .kind = ToolKind::kLine, .length = 0.01}, upright()).empty());
}

TEST(ToolSolids, OfAPlateLieBehindItsFaceWithEdgesRoundedByATenthOfAMillimetreOrAQuarterOfItsThickness) {
  for (const auto& [thickness, rounding] : {std::pair(2e-3, 1e-4), std::pair(2e-4, 5e-5)}) {
    const ToolDefinition plate{
        .name = "plate", .kind = ToolKind::kPlate, .length = 0.02, .width = 0.01, .thickness = thickness};
    const std::vector<ToolSolid> solids = tool_solids(plate, upright());
    ASSERT_EQ(solids.size(), 1u);
    EXPECT_NEAR(distance(solids[0], 0, 0, 1e-3), 1e-3, 1e-15);
    EXPECT_NEAR(distance(solids[0], 0, 0, -thickness - 1e-3), 1e-3, 1e-15);
    EXPECT_NEAR(distance(solids[0], 5e-3, 10e-3, 0), beside_corner(rounding), 1e-15) << thickness;
  }
}

TEST(ToolSolids, OfForcepsAreTwoJawsTheirOpeningApartWithEdgesRoundedByAQuarterOfTheirThickness) {
  const ToolDefinition forceps{
      .name = "forceps", .kind = ToolKind::kForceps, .length = 0.03, .width = 4e-3, .thickness = 2e-3};
  const std::vector<ToolSolid> jaws = tool_solids(forceps, upright(6e-3));
  ASSERT_EQ(jaws.size(), 2u);
  for (int k = 0; k < 2; ++k) {
    const double side = k == 0 ? 1 : -1;
    EXPECT_NEAR(distance(jaws[k], side * 2e-3, 0, -0.01), 1e-3, 1e-15) << "from its inner face";
    EXPECT_NEAR(distance(jaws[k], side * 6e-3, 0, -0.01), 1e-3, 1e-15) << "from its outer face";
    EXPECT_NEAR(distance(jaws[k], side * 3e-3, 2e-3, 0), beside_corner(5e-4), 1e-15);
    EXPECT_NEAR(distance(jaws[k], side * 4e-3, 0, -0.032), 2e-3, 1e-15) << "behind it";
  }
}

TEST(ToolSolids, OfAScalpelHaveAnEdgeRoundedByHalfItsThickness) {
  const ToolDefinition scalpel{
      .name = "scalpel", .kind = ToolKind::kScalpel, .length = 0.02, .width = 6e-3, .thickness = 4e-4};
  const std::vector<ToolSolid> solids = tool_solids(scalpel, upright());
  ASSERT_EQ(solids.size(), 1u);
  EXPECT_NEAR(distance(solids[0], 0, 0, 1e-3), 1e-3, 1e-15);
  EXPECT_NEAR(distance(solids[0], 2e-4, 3e-3, 0), beside_corner(2e-4), 1e-15);
  EXPECT_NEAR(distance(solids[0], 1.2e-3, 0, -0.01), 1e-3, 1e-15);
}

TEST(ToolSolids, OfANeedleAreAShaftAndAConeOfFourRadiiThatEndsRoundByTwoFifthsOfTheRadius) {
  const double radius = 5e-4;
  const ToolDefinition needle{.name = "needle", .kind = ToolKind::kNeedle, .length = 0.04, .radius = radius};
  const std::vector<ToolSolid> solids = tool_solids(needle, upright());
  ASSERT_EQ(solids.size(), 1u);
  EXPECT_NEAR(distance(solids[0], 0, 0, 1e-3), 1e-3, 1e-15);
  EXPECT_NEAR(distance(solids[0], 0, 0, -0.041), 1e-3, 1e-15);
  // The ball at the tip is met wherever the way out of its middle does not lie on the cone.
  const double along = 0.8, across = 0.6;
  EXPECT_NEAR(distance(solids[0], across * 1e-3, 0, along * 1e-3 - 0.4 * radius), 1e-3 - 0.4 * radius, 1e-15);
  EXPECT_EQ(needle_cone(needle), 4 * radius);
  // From the middle of the ball at the tip to that of the ball at the shoulder, behind which the shaft is round.
  EXPECT_NEAR(distance(solids[0], 1e-3, 0, -(0.4 + 4.01) * radius), 1e-3 - radius, 1e-15);
  EXPECT_LT(1e-3 - radius, distance(solids[0], 1e-3, 0, -(0.4 + 3.5) * radius));
}

TEST(ToolSolids, AConeLeavesAShortNeedleTheBallsAtItsEnds) {
  EXPECT_NEAR(needle_cone({.name = "needle", .kind = ToolKind::kNeedle, .length = 3e-3, .radius = 1e-3}), 1.6e-3,
              1e-15);
}

}  // namespace
}  // namespace thinwall
