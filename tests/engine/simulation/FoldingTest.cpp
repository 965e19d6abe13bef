// A wall that comes to lie on itself or on its floor keeps out of its own way: drained organs, and organs pressed so
// deep that front and back meet.

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include "engine/mesh/Shapes.hpp"
#include "engine/simulation/SimulationFailure.hpp"
#include "tests/engine/contact/SurfaceIntersections.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

bool meets_itself(const Body& body) {
  return !surface_intersections(body.model().definition.mesh.triangles, body.state().equilibrium.position).empty();
}

double lowest(const Body& body) {
  double height = std::numeric_limits<double>::infinity();
  for (int v = 0; v < body.model().vertices(); ++v) {
    if (!body.model().fixed[3 * v + 2]) height = std::min(height, body.state().equilibrium.position[3 * v + 2]);
  }
  return height;
}

/// What happened on the way.
struct Passage {
  double worst_imbalance = 0, largest_energy = 0;  // joule
  double lowest = std::numeric_limits<double>::infinity();
  std::size_t most_folds = 0;
  int intersections = 0;  // steps after which the wall passes through itself

  void note(const Body& body) {
    const EnergyBooks& books = body.state().books;
    worst_imbalance = std::max(worst_imbalance, std::abs(books.imbalance()));
    for (const double term : {books.elastic, books.kinetic, books.fluid, books.contact, books.script_work,
                              books.tool_work, books.numerical}) {
      largest_energy = std::max(largest_energy, std::abs(term));
    }
    lowest = std::min(lowest, thinwall::lowest(body));
    most_folds = std::max(most_folds, body.fold_count());
    intersections += meets_itself(body) ? 1 : 0;
  }
};

Passage drain(Body& body, double to, int steps, double duration) {
  const double rest = body.model().rest_volume;
  const double part = (to * rest - body.state().fluid_volume[0]) / steps;
  Passage passage;
  for (int step = 1; step <= steps; ++step) {
    body.advance({}, {}, duration, {.load_factors = {}, .fluids = {{.added = part, .pressure = {}}}});
    passage.note(body);
  }
  std::printf("%zu pairs in contact at most, lowest vertex at %.3f mm, imbalance / largest term %.1e\n",
              passage.most_folds, 1e3 * passage.lowest, passage.worst_imbalance / passage.largest_energy);
  return passage;
}

Body sphere(Analysis analysis) {
  Body body(make_body(make_sphere(20e-3, 320), 1e-3, neo_hookean(20e3)), {},
            analysis == Analysis::kDynamic ? dynamic() : quasi_static());
  body.settle();
  return body;
}

Body hemisphere(Analysis analysis) {
  BodyDefinition definition = make_body(make_hemisphere(20e-3, 256), 1e-3, neo_hookean(20e3));
  definition.fixed = {fixed_group("base")};
  Body body(definition, {}, analysis == Analysis::kDynamic ? dynamic() : quasi_static());
  body.settle();
  return body;
}

class Folding : public testing::TestWithParam<Analysis> {};

TEST_P(Folding, OfASphereDrainedToAFifthLeavesNoIntersection) {
  Body body = sphere(GetParam());
  const Passage passage = drain(body, 0.2, 50, 0.02);
  EXPECT_NEAR(body.state().volume[0] / body.model().rest_volume, 0.2, 1e-9);
  EXPECT_EQ(passage.intersections, 0);
  // It did fold; how, the last bits choose: 16 pairs and several hundred were seen.
  EXPECT_GT(passage.most_folds, 4U);
  // Seen 1e-9: what the volumes may miss in each step times the jumps of the pressure as the wall buckles.
  EXPECT_LT(passage.worst_imbalance, 1e-7 * passage.largest_energy);
}

TEST_P(Folding, OfAHemisphereComesToLieOnItsFloor) {
  Body body = hemisphere(GetParam());
  const Passage passage = drain(body, 0.1, 40, 0.02);
  EXPECT_EQ(passage.intersections, 0);
  EXPECT_GT(passage.lowest, 0);       // the floor
  EXPECT_LT(passage.lowest, 0.9e-3);  // was reached: it pushes from the wall's thickness on, 1 mm
  EXPECT_LT(passage.worst_imbalance, 1e-7 * passage.largest_energy);
}

INSTANTIATE_TEST_SUITE_P(Analyses, Folding, testing::Values(Analysis::kQuasiStatic, Analysis::kDynamic),
                         [](const auto& each) { return each.param == Analysis::kDynamic ? "Dynamic" : "QuasiStatic"; });

TEST(FoldingWall, RunsTheSameTwice) {
  Body one = sphere(Analysis::kDynamic), other = sphere(Analysis::kDynamic);
  drain(one, 0.2, 20, 0.02);
  drain(other, 0.2, 20, 0.02);
  EXPECT_GT(one.fold_count(), 0U);
  EXPECT_EQ(one.state().equilibrium.position, other.state().equilibrium.position);
}

TEST(FoldingWall, StaysAboveItsFloorUnderABallThatPressesNineTenthsOfItsHeight) {
  BodyDefinition definition = make_body(make_hemisphere(20e-3, 256), 1e-3, neo_hookean(20e3));
  definition.fixed = {fixed_group("base")};
  definition.fluid.kind = FluidKind::kCompressible;
  definition.fluid.bulk_modulus = 5e3;
  Body body(definition, {sphere_tool(5e-3)}, quasi_static());
  body.settle();
  Passage passage;
  // The tip ends 1.5 mm above the floor; then the ball is drawn back, and the wall with it.
  ToolPose pose = move(body, pose_at({0.1e-3, 0.2e-3, 20.1e-3}), {0.1e-3, 0.2e-3, 0.3e-3}, 40, 0.01,
                       [&](const ToolPose&) { passage.note(body); });
  const double deep = body.state().contacts[0].force.z();
  move(body, pose, {0.1e-3, 0.2e-3, 20.1e-3}, 20, 0.01, [&](const ToolPose&) { passage.note(body); });
  EXPECT_GT(deep, 0.5);  // newton
  EXPECT_EQ(passage.intersections, 0);
  EXPECT_GT(passage.lowest, 0);
  EXPECT_LT(passage.lowest, 0.4e-3);
  EXPECT_LT(passage.worst_imbalance, 1e-7 * passage.largest_energy);
}

TEST(FoldingWall, OfACylinderMeetsItsOtherSideUnderABall) {
  BodyDefinition definition = make_body(make_cylinder(10e-3, 40e-3, 320), 1e-3, neo_hookean(20e3));
  definition.fixed = {fixed_group("ends")};
  definition.fluid.kind = FluidKind::kNone;
  Body body(definition, {sphere_tool(5e-3)}, quasi_static());
  body.settle();
  Passage passage;
  move(body, pose_at({0.1e-3, 0.2e-3, 10.1e-3}), {0.1e-3, 0.2e-3, -8.5e-3}, 40, 0.01,
       [&](const ToolPose&) { passage.note(body); });
  EXPECT_EQ(passage.intersections, 0);
  EXPECT_GT(passage.most_folds, 20U);
  EXPECT_LT(passage.worst_imbalance, 1e-7 * passage.largest_energy);
}

/// A soft tube without contents in a bed up to half its height: its upper half comes to lie in the lower one.
Body tube_in_bed(int triangles) {
  BodyDefinition definition = make_body(make_cylinder(10e-3, 20e-3, triangles), 0.5e-3, neo_hookean(2e3));
  definition.fixed = {{.region = BelowRegion{.axis = 2, .at = 0.1e-3}}};
  definition.fluid.kind = FluidKind::kNone;
  SimulationOptions options = dynamic();
  options.gravity = {0, 0, -9.81};
  return Body(definition, {}, options);
}

TEST(FoldingWall, FallsOnItselfAlikeToTheBitWithAnyNumberOfThreads) {
  // So many triangles that threads share the search for what is near.
  std::vector<Eigen::VectorXd> positions;
  for (const int threads : {1, 2, 4}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    Body body = tube_in_bed(1020);
    for (int step = 0; step < 12; ++step) body.advance({}, {}, 5e-3);
    EXPECT_GT(body.fold_count(), 100U);
    positions.push_back(body.state().equilibrium.position);
  }
  EXPECT_GT(positions[0].size(), 3 * 500);
  EXPECT_EQ(positions[0], positions[1]);
  EXPECT_EQ(positions[0], positions[2]);
}

TEST(FoldingWall, OfAnOpenTubeSettlesOnItselfUnderItsWeight) {
  Body body = tube_in_bed(240);
  body.settle();
  EXPECT_GT(body.fold_count(), 100U);
  EXPECT_LT(body.state().equilibrium.position.reshaped(3, body.model().vertices()).row(2).maxCoeff(), 1e-3);
  Passage passage;
  for (int step = 0; step < 20; ++step) {
    body.advance({}, {}, 5e-3);
    passage.note(body);
  }
  EXPECT_EQ(passage.intersections, 0);
  // It lies still: what settling found is an equilibrium, in which contact bears the weight.
  EXPECT_LT(body.state().books.kinetic, 1e-12 * std::abs(body.state().books.gravity));
}

TEST(FoldingWall, StopsATipThatIsToGoThroughTheFloorAndSaysWhy) {
  BodyDefinition definition = make_body(make_hemisphere(20e-3, 64), 1e-3, neo_hookean(20e3));
  definition.fixed = {fixed_group("base")};
  definition.fluid.kind = FluidKind::kNone;
  Body body(definition, {point_tool()}, quasi_static());
  body.settle();
  std::string reason;
  try {
    move(body, pose_at({0, 0, 20.1e-3}), {0, 0, -1e-3}, 20, 0.01);
  } catch (const SimulationFailure& failure) {
    reason = failure.what();
  }
  EXPECT_NE(reason.find("against itself or its floor"), std::string::npos) << reason;
  EXPECT_GT(lowest(body), 0);
}

TEST(FoldingWall, IsNotFeltWhereNothingIsNear) {
  // Inflated and pressed, a body has no contact with itself: the results are those of the wall alone, to the bit.
  Body body(pressurised_hemisphere(256, 300), {sphere_tool(5e-3)}, quasi_static());
  body.settle();
  move(body, pose_at({0, 0, 22e-3}), {0, 0, 16e-3}, 10, 0.01,
       [&](const ToolPose&) { ASSERT_EQ(body.fold_count(), 0U); });
}

}  // namespace
}  // namespace thinwall
