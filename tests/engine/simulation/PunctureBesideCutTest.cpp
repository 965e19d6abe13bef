// Needles that meet a wall where a cut leaves no room for a slit of their width.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/cutting/SurfacePath.hpp"
#include "engine/cutting/SurfaceTrace.hpp"
#include "engine/mesh/Shapes.hpp"
#include "tests/engine/simulation/DrivenNeedle.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

/// `toughness`: joule / metre^2.
BodyDefinition tough_sheet(int triangles, double toughness) {
  BodyDefinition definition = make_body(make_sheet(40e-3, 40e-3, triangles), 1e-3, neo_hookean(20e3));
  definition.fluid.kind = FluidKind::kNone;
  definition.fixed = {{.region = BoundaryRegion{}}};
  definition.toughness = {toughness};
  return definition;
}

void cut_between(Body& body, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const SurfaceView surface = body.surface();
  const auto begin = project(surface, from, {}, 1e-3).point, end = project(surface, to, {}, 1e-3).point;
  const SurfaceTrace way = trace(surface, *begin, *end);
  body.cut({.from = {}, .points = way.pieces.front().points}, std::vector{pose_at({0, 0, 5e-3})});
  body.leave_cut();
}

Body cut_sheet(int triangles = 400, double toughness = 50) {
  Body body(tough_sheet(triangles, toughness), {test_needle(0.2)}, quasi_static());
  body.settle();
  cut_between(body, {-3e-3, -3e-3, 0}, {3e-3, 3e-3, 0});
  for (int k = 0; k < 4; ++k) {
    body.advance(std::vector{pose_at({0, 0, 5e-3})}, std::vector{pose_at({0, 0, 5e-3})}, 5e-3);
  }
  return body;
}

TEST(ANeedleBesideACut, MakesItsWayWhereTheCutLeavesRoom) {
  // At the end of a cut that is askew to the needle's axes, where no slit fits in.
  const Eigen::Vector3d place(3.3e-3, 2.7e-3, 0);
  Body body = cut_sheet();
  DrivenNeedle needle{.at = place};
  ASSERT_TRUE(needle.move_to_rupture(body, 1, 15e-3));
  EXPECT_NEAR(needle.ruptures[0].cut.length, 2 * 0.5e-3, 0.02e-3);
  const std::vector<ShaftPoint>& lips = body.state().punctures.front().points;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const ShaftPoint& point : lips) {
    middle += body.model().rest_position.segment<3>(3 * point.vertex) / static_cast<double>(lips.size());
  }
  const double beside = (middle - place).head<2>().norm();
  EXPECT_GT(beside, 0.5 * 0.5e-3);
  EXPECT_LT(beside, 2.1 * 0.5e-3);
  EXPECT_LT(std::abs(body.state().books.imbalance()), 1e-9 * body.state().books.largest());
}

TEST(ANeedleBesideACut, GoesIntoTheOpenCutAndOutAgainWithoutANewHole) {
  Body body = cut_sheet();
  DrivenNeedle needle{.at = {2.5e-3, 2.5e-3, 0}};
  EXPECT_FALSE(needle.move_to_rupture(body, 1, 12e-3));
  needle.move(body, -1e-3);
  EXPECT_TRUE(needle.ruptures.empty());
}

TEST(ANeedleBesideACut, IsSoonThroughASheetThatIsLeftSlack) {
  Body body = cut_sheet(800, 100);
  DrivenNeedle needle{.at = {5e-3, -5e-3, 0}};
  int most = 0, all = 0;
  const auto note = [&] {
    most = std::max(most, body.report().newton_iterations);
    all += body.report().newton_iterations;
  };
  ASSERT_TRUE(needle.move_to_rupture(body, 1, 15e-3, note));
  EXPECT_NEAR(needle.ruptured_at[0], 6.8e-3, 0.1e-3);
  // 678 and 1914 iterations; 1250 in the step where it is through when all of the wall must come to rest in it, 2821 in
  // all when a slit that does not pay is spread on the shaft all the same.
  EXPECT_LT(most, 900);
  EXPECT_LT(all, 2300);
}

}  // namespace
}  // namespace thinwall
