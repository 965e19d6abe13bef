// Bodies whose wall is open and whose contents do not run out.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "tests/engine/simulation/OpenBodies.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

constexpr double kPressure = 400;  // pascal

TEST(Gel, KeepsItsVolumeAndDrawsInItsWallRatherThanAir) {
  BodyDefinition definition = open_ball(320, kPressure);
  definition.fluid.leaks = false;
  Body body(definition, {}, quasi_static());
  body.settle();
  const double volume = body.state().volume[0];
  for (int step = 0; step < 3; ++step) body.advance({}, {}, 0.1);
  EXPECT_NEAR(body.state().volume[0], volume, 1e-10 * volume);
  EXPECT_EQ(body.state().leaked[0], 0);
  EXPECT_EQ(body.state().books.leak, 0);
  // Drained beyond what it holds at rest it draws its wall in; no air comes.
  for (int step = 0; step < 5; ++step) body.advance({}, {}, 0.1, filling(body, volume * (1 - 0.03 * (step + 1))));
  EXPECT_LT(body.state().equilibrium.pressure[0], 0);
  EXPECT_EQ(body.state().air[0], 0);
}

TEST(Gel, InAnOpenBodyPushesItNowhereAndGivesNoEnergyFromNothing) {
  BodyDefinition definition = open_ball(320, kPressure, 2);
  definition.fixed.clear();
  definition.fluid.leaks = false;
  Body body(definition, {}, dynamic());
  body.settle();
  const double whole = body.state().books.stored();
  const double thrust = kPressure * body.state().open_area[0];
  for (int step = 0; step < 100; ++step) body.advance({}, {}, 1e-3);
  const EnergyBooks& books = body.state().books;
  std::printf("momentum %.1e N s where a jet would give %.1e, stored %.2e J of %.2e, numerical %.1e J\n",
              momentum(body).norm(), 0.1 * thrust, books.stored(), whole, books.numerical);
  EXPECT_LT(momentum(body).norm(), 1e-6 * 0.1 * thrust);
  EXPECT_NEAR(books.stored(), whole, 1e-6 * whole);
  EXPECT_EQ(books.leak, 0);
}

TEST(Gel, ThatIsSwayedLosesTheLessEnergyTheShorterTheSteps) {
  // A gel that is swayed: pushed to a side and back, evenly enough for the integrator to be of second order.
  BodyDefinition definition = open_ball(320, 50, 2);
  definition.fixed = {{.region = BelowRegion{.axis = 2, .at = -15e-3}}};
  definition.fluid.leaks = false;
  definition.loads.push_back(
      {.kind = LoadKind::kDeadForce, .region = AboveRegion{.axis = 2, .at = 5e-3}, .vector = {0.02, 0, 0}});
  double numerical[3];
  for (int k = 0; k < 3; ++k) {
    Body body(definition, {}, dynamic());
    body.settle({0});
    const int steps = 40 << k;
    for (int step = 1; step <= steps; ++step) {
      const double push = std::sin(std::numbers::pi * step / steps);
      body.advance({}, {}, 0.2 / steps, {.load_factors = {push * push}, .fluids = {}});
    }
    const EnergyBooks& books = body.state().books;
    EXPECT_LT(std::abs(books.imbalance()), 1e-9 * books.largest());
    numerical[k] = std::abs(books.numerical) / books.largest();
  }
  std::printf("numerical / largest %.1e, %.1e, %.1e\n", numerical[0], numerical[1], numerical[2]);
  EXPECT_LT(numerical[1], numerical[0] / 3.5);  // second order: it falls to nothing
  EXPECT_LT(numerical[2], numerical[1] / 3.5);
}

}  // namespace
}  // namespace thinwall
