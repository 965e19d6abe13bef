// A needle that pierces where the wall is held fast, and next to there.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/mesh/Shapes.hpp"
#include "engine/simulation/SimulationFailure.hpp"
#include "engine/tool/ToolSolids.hpp"
#include "tests/engine/simulation/DrivenNeedle.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

constexpr double kRadius = 20e-3, kToughness = 400, kThickness = 1.5e-3;  // metres, joule / metre^2, metres

/// A ball full of fluid, its crown held as far as `held` metres from the middle.
BodyDefinition held_ball(int triangles, double held) {
  BodyDefinition definition = make_body(make_sphere(kRadius, triangles), kThickness, neo_hookean(40e3));
  definition.toughness = {kToughness};
  definition.fixed = {{.region = SphereRegion{.center = {0, 0, kRadius}, .radius = held}}};
  return definition;
}

/// What a needle felt on its way.
struct Way {
  double largest = 0;  // newton
  double last = 0;     // newton
  int ruptures = 0;
  double at_rupture = 0;  // joule, of its work
};

/// Moves the needle from one height to another, straight down or up at a place of the x, y plane, metres.
Way move_needle(Body& body, const Eigen::Vector2d& at, double from, double to, double step) {
  Way way;
  const int steps = static_cast<int>(std::lround(std::abs(to - from) / step));
  for (int k = 0; k < steps; ++k) {
    const std::vector<ToolPose> begin = {pose_at({at.x(), at.y(), from + (to - from) * k / steps})};
    const std::vector<ToolPose> end = {pose_at({at.x(), at.y(), from + (to - from) * (k + 1) / steps})};
    const double work = body.state().books.tool_work;
    body.advance(begin, end, 5e-3, {.load_factors = {}, .fluids = {}, .needles = {0}});
    const auto within = static_cast<int>(body.report().ruptures.size());
    way.ruptures += within + (body.pierce(0, end) ? 1 : 0);
    if (within > 0) way.at_rupture = body.state().books.tool_work - work;
    way.last = body.state().contacts[0].force.norm();
    way.largest = std::max(way.largest, way.last);
    const EnergyBooks& books = body.state().books;
    EXPECT_LT(std::abs(books.imbalance()), 1e-9 * std::max(books.largest(), 1e-6));
  }
  return way;
}

TEST(ANeedleThatPiercesAHeldWall, PaysForItsSlitEvenlyOverItsConeWhateverTheStep) {
  const double cone = needle_cone(test_needle(0));
  for (const Analysis analysis : {Analysis::kQuasiStatic, Analysis::kDynamic}) {
    for (const double step : {0.02e-3, 0.2e-3, 1e-3}) {
      SimulationOptions options;
      options.analysis = analysis;
      Body body(held_ball(320, 8e-3), {test_needle(0.3)}, options);
      body.settle();
      const Way way = move_needle(body, {1e-3, 0.3e-3}, kRadius + 1e-3, kRadius - 4e-3, step);
      const EnergyBooks& books = body.state().books;
      ASSERT_EQ(way.ruptures, 1);
      const double cost = kToughness * kThickness * body.state().cut.length;
      EXPECT_NEAR(body.state().cut.length, 1e-3, 0.02e-3);
      EXPECT_NEAR(books.fracture, cost, 1e-9 * cost);
      EXPECT_NEAR(books.tool_work, cost, 1e-6 * cost);
      EXPECT_LT(std::abs(books.jump), 1e-6 * cost);
      EXPECT_LT(way.largest, 1.0001 * cost / (0.9 * cone));
      EXPECT_GT(way.largest, 0.5 * cost / (0.9 * cone));
      // What cannot move squeezes no shaft.
      EXPECT_EQ(way.last, 0);
    }
  }
}

TEST(ANeedleThatPiercesAHeldWall, PaysAsFarAsItsConeHasCome) {
  Body body(held_ball(320, 8e-3), {test_needle(0)}, {});
  body.settle();
  const SurfaceEntry wall = *first_entry(body.surface(), {1e-3, 0.3e-3, 2 * kRadius}, -Eigen::Vector3d::UnitZ());
  const double surface = 2 * kRadius - wall.travel, cone = needle_cone(test_needle(0));
  move_needle(body, {1e-3, 0.3e-3}, surface + 1e-3, surface - 0.55 * cone, 0.1e-3);
  const double cost = kToughness * kThickness * body.state().cut.length;
  EXPECT_NEAR(body.state().books.fracture, 0.5 * cost, 0.01 * cost);
  const Way back = move_needle(body, {1e-3, 0.3e-3}, surface - 0.55 * cone, surface + 2e-3, 0.1e-3);
  EXPECT_NEAR(body.state().books.fracture, 0.5 * cost, 0.01 * cost);
  EXPECT_EQ(back.largest, 0);
  EXPECT_FALSE(body.state().punctures.front().tool);
}

TEST(ANeedleThatPiercesAHeldWall, GoesThroughTheFarWallTooWhereThatIsHeld) {
  Body body(held_ball(320, 60e-3), {test_needle(0)}, {});
  body.settle();
  const Way way = move_needle(body, {1e-3, 0.3e-3}, kRadius + 1e-3, -kRadius - 4e-3, 0.4e-3);
  EXPECT_EQ(way.ruptures, 2);
  const double cost = kToughness * kThickness * body.state().cut.length;
  EXPECT_NEAR(body.state().cut.length, 2e-3, 0.04e-3);
  EXPECT_NEAR(body.state().books.fracture, cost, 1e-9 * cost);
}

TEST(ANeedleThatHasPiercedAHeldWall, FeelsWhatIsHeldAgainOnceItIsOut) {
  for (const bool comes_out : {false, true}) {
    Body body(held_ball(320, 8e-3), {test_needle(0)}, quasi_static());
    body.settle();
    move_needle(body, {1e-3, 0.3e-3}, kRadius + 1e-3, kRadius - 3e-3, 0.2e-3);
    // What is no piercing any more moves the needle on, back, and against the wall where that is whole.
    const auto go = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
      const std::vector<ToolPose> begin = {pose_at(from)}, end = {pose_at(to)};
      body.advance(begin, end, 5e-3);
      body.pierce(0, end);
      return body.state().contacts[0].force.norm();
    };
    const Eigen::Vector3d in(1e-3, 0.3e-3, kRadius - 3e-3), out(1e-3, 0.3e-3, kRadius + 2e-3);
    EXPECT_EQ(go(in, in - Eigen::Vector3d(0, 0, 0.2e-3)), 0);
    EXPECT_EQ(go(in, comes_out ? out : in), 0);
    EXPECT_EQ(body.state().punctures.front().tool.has_value(), !comes_out);
    body.advance(std::vector<ToolPose>{pose_at(comes_out ? out : in)},
                 std::vector<ToolPose>{pose_at(comes_out ? out : in)}, 5e-3);
    EXPECT_EQ(body.state().piercing.empty(), comes_out);
    if (!comes_out) continue;
    const SurfaceEntry wall = *first_entry(body.surface(), {-3e-3, 0.3e-3, 2 * kRadius}, -Eigen::Vector3d::UnitZ());
    const Eigen::Vector3d above(-3e-3, 0.3e-3, 2 * kRadius - wall.travel + 0.05e-3);
    EXPECT_THROW(go(above, above - Eigen::Vector3d(0, 0, 0.06e-3)), SimulationFailure);
  }
}

TEST(ANeedleThatPiercesNextToAHeldWall, FeelsForcesOfTheSizeOfItsSlitsCost) {
  // From triangles that are held all over one held vertex to such as are free.
  const double cost = kToughness * kThickness * 1e-3;
  for (const double x : {3.4e-3, 3.7e-3}) {
    Body body(held_ball(720, 6e-3), {test_needle(0)}, {});
    body.settle();
    const Way way = move_needle(body, {x, 0.3e-3}, kRadius, kRadius - 3e-3, 0.2e-3);
    std::printf("at %.1f mm: %.3f N, %d ruptures, jump %.3f of the cost\n", 1e3 * x, way.largest, way.ruptures,
                body.state().books.jump / cost);
    EXPECT_LT(way.largest, 2);
    EXPECT_LT(body.state().books.jump, cost);
    EXPECT_LT(body.state().books.tool_work, 3 * cost);
  }
}

TEST(ANeedleWhoseStepsAreLong, HasThemDividedBeforeItWorksFarMoreThanASlitCosts) {
  BodyDefinition definition = held_ball(320, 0);
  definition.toughness = {2};
  definition.fixed = {{.region = BelowRegion{.axis = 2, .at = -15e-3}}};
  Body body(definition, {test_needle(0)}, quasi_static());
  body.settle();
  const double cost = 2 * kThickness * 1e-3;
  const Way way = move_needle(body, {0.5e-3, 0.3e-3}, kRadius + 0.5e-3, kRadius - 3.5e-3, 2e-3);
  std::printf("%.4f N, %d ruptures, work %.3f, jump %.3f of the cost\n", way.largest, way.ruptures,
              way.at_rupture / cost, body.state().books.jump / cost);
  ASSERT_EQ(way.ruptures, 1);
  EXPECT_GT(way.at_rupture, cost);
  EXPECT_LT(way.at_rupture, 2 * cost);
  EXPECT_LT(body.state().books.jump, cost);
  // What it felt when the wall gave way is told of the step.
  EXPECT_GT(way.largest, 0);
}

TEST(ANeedleThatPiercesAHeldWall, GoesInOnABorderAsTheFirstThatCutsTheBody) {
  const double half = 20e-3;
  BodyDefinition definition = make_body(make_sheet(2 * half, 2 * half, 400), 0.5e-3, neo_hookean(100e3));
  definition.fluid.kind = FluidKind::kNone;
  definition.toughness = {100};
  definition.fixed = {{.region = BoundaryRegion{}}};
  Body body(std::move(definition), {test_needle(0.2)}, {});
  body.settle();
  EXPECT_EQ(move_needle(body, {half, 0}, 1e-3, -4e-3, 0.5e-3).ruptures, 1);
  EXPECT_GT(body.state().cut.length, 0);
}

}  // namespace
}  // namespace thinwall
