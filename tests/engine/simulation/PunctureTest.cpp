// A needle through the wall of a body: dent, rupture, sliding, withdrawal, and what it all costs.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "engine/mesh/Shapes.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

ToolDefinition needle(double friction) {
  return {.name = "needle", .kind = ToolKind::kNeedle, .length = 40e-3, .radius = 0.5e-3, .friction = friction};
}

BodyDefinition tough_hemisphere(int triangles, double toughness) {
  BodyDefinition definition = pressurised_hemisphere(triangles, 600);
  definition.toughness = {toughness};
  return definition;
}

/// What a needle on its way felt.
struct Passage {
  std::vector<double> forces;     // newton, against its way in, after each step
  std::vector<double> residuals;  // newton, of each step
  std::vector<Rupture> ruptures;
};

/// Moves the needle up or down in steps of 5 ms and lets it pierce where `pierces`.
void move_needle(Body& body, double& height, double to, double step, Passage& passage, bool pierces = true,
                 const std::function<void()>& after = {}) {
  const int steps = static_cast<int>(std::lround(std::abs(to - height) / step));
  const double begin = height;
  for (int k = 1; k <= steps; ++k) {
    const std::vector<ToolPose> from = {pose_at({0.3e-3, 0.4e-3, height})};
    height = begin + (to - begin) * k / steps;
    const std::vector<ToolPose> next = {pose_at({0.3e-3, 0.4e-3, height})};
    body.advance(from, next, 5e-3);
    passage.forces.push_back(body.state().contacts[0].force.z());
    if (pierces) {
      if (auto rupture = body.pierce(0, next)) passage.ruptures.push_back(std::move(*rupture));
    }
    passage.residuals.push_back(body.report().residual);
    if (after) after();
  }
}

/// A slit of the needle's width; the step of 0.2 mm overshoots by the work of its last part. `force`: newton, at last.
void expect_slit_paid_in_full(const EnergyBooks& books, const Rupture& rupture, double force) {
  EXPECT_NEAR(rupture.cut.length, 1e-3, 0.02e-3);
  EXPECT_NEAR(rupture.cost, 200 * 1e-3 * rupture.cut.length, 1e-12);
  EXPECT_EQ(books.fracture, rupture.cost);
  EXPECT_GE(rupture.released, rupture.cost);
  EXPECT_LT(rupture.released, rupture.cost + force * 0.2e-3);
}

TEST(ANeedleThatPierces, DentsRupturesSlidesAndLeavesAHoleUnderBooksThatClose) {
  for (const Analysis analysis : {Analysis::kQuasiStatic, Analysis::kDynamic}) {
    SimulationOptions options;
    options.analysis = analysis;
    Body body(tough_hemisphere(400, 200), {needle(0.2)}, options);
    body.settle();
    const double fluid = body.state().fluid_volume[0];
    Passage passage;
    const auto after = [&] {
      const BodyState& state = body.state();
      EXPECT_LT(std::abs(state.books.imbalance()), 1e-9 * state.books.elastic);
      EXPECT_LT(std::abs(state.books.numerical), 0.005 * state.books.elastic);
      EXPECT_NEAR(state.fluid_volume[0] + state.leaked[0], fluid, 1e-12 * fluid);
    };
    double height = 22e-3;
    while (passage.ruptures.empty() && height > 10e-3) {
      move_needle(body, height, height - 0.2e-3, 0.2e-3, passage, true, after);
    }
    ASSERT_EQ(passage.ruptures.size(), 1u);
    const Rupture& rupture = passage.ruptures[0];
    const double at_rupture = body.state().books.tool_work, ruptured_at = height;
    const EnergyBooks books = body.state().books;
    expect_slit_paid_in_full(books, rupture, passage.forces.back());
    const double peak = passage.forces.back();
    move_needle(body, height, ruptured_at - 3e-3, 0.2e-3, passage, true, after);
    const double plateau = passage.forces.back();
    EXPECT_LT(plateau, 0.1 * peak);
    EXPECT_GT(plateau, 0);
    EXPECT_EQ(body.state().leaked[0], 0);
    EXPECT_EQ(body.state().open_area[0], 0);
    // Along the plateau all that the needle does goes into friction.
    const double worked = body.state().books.tool_work, rubbed = body.state().books.friction;
    move_needle(body, height, ruptured_at - 4e-3, 0.2e-3, passage, true, after);
    EXPECT_NEAR(body.state().books.tool_work - worked, plateau * 1e-3, 0.03 * plateau * 1e-3);
    EXPECT_NEAR(body.state().books.friction - rubbed, plateau * 1e-3, 0.03 * plateau * 1e-3);
    if (analysis == Analysis::kDynamic) continue;
    move_needle(body, height, 24e-3, 0.2e-3, passage, true, after);
    EXPECT_EQ(passage.forces.back(), 0);
    EXPECT_GT(body.state().leaked[0], 0);
    EXPECT_GT(body.state().open_area[0], 0);
    EXPECT_EQ(passage.ruptures.size(), 1u);
    std::printf(
        "peak %.4f N at %.1f mm, plateau %.4f N, released %.3e of %.3e J, tool %.3e J at rupture, numerical %.1e J, "
        "open %.2e m^2\n",
        peak, 1e3 * ruptured_at, plateau, rupture.released, rupture.cost, at_rupture, body.state().books.numerical,
        body.state().open_area[0]);
  }
}

/// A needle that goes through a damped wall: nothing that was spent comes back.
void expect_spent_for_good(const RayleighDamping& damping, Analysis analysis) {
  SimulationOptions options;
  options.analysis = analysis;
  BodyDefinition definition = tough_hemisphere(400, 200);
  definition.damping = damping;
  Body body(definition, {needle(0.2)}, options);
  body.settle();
  Passage passage;
  EnergyBooks last;
  const auto after = [&] {
    const EnergyBooks& books = body.state().books;
    EXPECT_GE(books.viscous, last.viscous);
    EXPECT_GE(books.friction, last.friction);
    EXPECT_GE(books.jump, last.jump);
    EXPECT_TRUE(books.leak == 0 || body.state().leaked[0] > 0) << books.leak;
    EXPECT_LT(std::abs(books.imbalance()), 1e-9 * books.elastic);
    EXPECT_LT(std::abs(books.numerical), 0.005 * books.elastic);
    last = books;
  };
  double height = 22e-3;
  while (passage.ruptures.empty() && height > 10e-3) {
    move_needle(body, height, height - 0.2e-3, 0.2e-3, passage, true, after);
  }
  ASSERT_EQ(passage.ruptures.size(), 1u);
  std::printf("viscous %.3e, jump %.3e J at the rupture\n", last.viscous, last.jump);
  move_needle(body, height, height - 3e-3, 0.2e-3, passage, true, after);
}

TEST(ANeedleThatPierces, GivesBackNothingThatADampedWallHasSpent) {
  expect_spent_for_good({.stiffness_time = 20e-3}, Analysis::kQuasiStatic);
  expect_spent_for_good({.stiffness_time = 20e-3}, Analysis::kDynamic);
  expect_spent_for_good({.mass_rate = 500}, Analysis::kDynamic);
}

TEST(ANeedleThatPierces, FeelsWhatItFeelsOnAnUncutWallUntilItRuptures) {
  Body pierced(tough_hemisphere(400, 200), {needle(0)}, quasi_static());
  Body dented(tough_hemisphere(400, 200), {needle(0)}, quasi_static());
  pierced.settle();
  dented.settle();
  Passage with, without;
  double height = 22e-3, other = 22e-3;
  while (with.ruptures.empty() && height > 10e-3) move_needle(pierced, height, height - 0.2e-3, 0.2e-3, with);
  move_needle(dented, other, height, 0.2e-3, without, false);
  ASSERT_EQ(with.ruptures.size(), 1u);
  ASSERT_EQ(with.forces.size(), without.forces.size());
  for (std::size_t k = 0; k < with.forces.size(); ++k) EXPECT_EQ(with.forces[k], without.forces[k]);
  // Whether a slit pays is tried after the step, and leaves no trace in what is told of it until one does.
  for (std::size_t k = 0; k + 1 < with.residuals.size(); ++k) EXPECT_EQ(with.residuals[k], without.residuals[k]);
  // Without friction nothing holds the wall on the shaft.
  move_needle(pierced, height, height - 3e-3, 0.2e-3, with);
  EXPECT_LT(std::abs(with.forces.back()), 1e-6 * without.forces.back());
}

/// Newton, that a needle feels after it has been in a coarse ball, so high off its middle, and out again. `wall`:
/// metres, where its tip is along y when it touches.
double felt_after(double height, double wall) {
  BodyDefinition ball = make_body(make_sphere(20e-3, 800), 2e-3, neo_hookean(20e3));
  ball.fluid.initial_pressure = 600;
  ball.fixed = {{.region = BelowRegion{2, -10e-3}, .axes = {true, true, true}}};
  ball.toughness = {200};
  Body body(ball, {{.name = "needle", .kind = ToolKind::kNeedle, .length = 50e-3, .radius = 0.8e-3}}, dynamic());
  body.settle();
  // At 60 mm/s from 5 mm before the wall, 12 mm in and back.
  const auto pose = [&](int step) {
    const double way = 60e-3 * 16e-3 * step, turn = 17e-3;
    const double along = std::max(0.0, turn - std::abs(way - turn)) - 5e-3;
    return std::vector<ToolPose>{pose_at({0, wall + along, height}, Eigen::Vector3d::UnitY())};
  };
  int ruptures = 0;
  for (int step = 0; step < 38; ++step) {
    body.advance(pose(step), pose(step + 1), 16e-3);
    if (body.pierce(0, pose(step + 1))) ++ruptures;
  }
  EXPECT_EQ(ruptures, 1);
  return body.state().contacts[0].force.norm();
}

TEST(ANeedleThatPierces, LeavesAWallThatSnapsBackAsideWhenItsLipsAreLetGo) {
  // The shaft holds the lips aside, and the tip is within a triangle beside them when it has left them.
  EXPECT_EQ(felt_after(8e-3, -18.926343e-3), 0) << "the wall hangs on the tip";
}

TEST(ANeedleThatPierces, LeavesLipsThatAreDrawnOverItsTip) {
  // With a cone that ends at the tip they find no equilibrium there.
  EXPECT_EQ(felt_after(4e-3, -20.067434e-3), 0);
}

}  // namespace
}  // namespace thinwall
