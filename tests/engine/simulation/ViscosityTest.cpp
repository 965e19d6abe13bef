// Quasi-linear viscoelasticity and damping against what the Prony series and the damping law say in closed form. A ball
// whose incompressible fluid is given a volume is strained evenly and by a known amount, so that its pressure is the
// stress.

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstdio>
#include <numbers>

#include "engine/mesh/Shapes.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

const std::vector<PronyTerm> kSeries = {{.fraction = 0.3, .time = 0.2}, {.fraction = 0.25, .time = 2}};

Body ball(const std::vector<PronyTerm>& viscosity, const RayleighDamping& damping = {}) {
  BodyDefinition definition = make_body(make_sphere(20e-3, 80), 1e-3, neo_hookean(20e3));
  definition.viscosity = viscosity;
  definition.damping = damping;
  Body body(definition, {}, quasi_static());
  body.settle();
  return body;
}

double pressure_of(const Body& body) {
  return body.state().equilibrium.pressure[0];
}

void fill(Body& body, double stretch, double duration) {
  body.advance({}, {}, duration, filling(body, body.model().rest_volume * std::pow(stretch, 3)));
}

TEST(Viscosity, HeldStretchRelaxesByThePronySeries) {
  Body elastic = ball({});
  fill(elastic, 1.3, 1);
  const double at_once = pressure_of(elastic);
  Body body = ball(kSeries);
  const double ramp = 1e-3, hold = 0.05;
  fill(body, 1.3, ramp);
  for (int step = 0; step <= 100; ++step) {
    // A stress that grows evenly for the time `ramp` and is held relaxes by the mean of the exponential over the ramp.
    double part = 1;
    for (const PronyTerm& term : kSeries) {
      const double mean = -std::expm1(-ramp / term.time) / (ramp / term.time);
      part -= term.fraction * (1 - mean * std::exp(-hold * step / term.time));
    }
    EXPECT_NEAR(pressure_of(body), part * at_once, 1e-9 * at_once) << step;
    fill(body, 1.3, hold);
  }
  EXPECT_NEAR(body.state().books.imbalance(), 0, 1e-9 * body.state().books.script_work);
}

TEST(Viscosity, CyclesShowStorageAndLossModulus) {
  // Small cycles about the stress-free shape at five frequencies; 200 steps a cycle leave an error of 1e-4.
  const double amplitude = 1e-4;
  Body elastic = ball({});
  fill(elastic, 1 + amplitude, 1);
  const double at_once = pressure_of(elastic);
  for (const double frequency : {0.05, 0.2, 0.8, 3.0, 12.0}) {
    const double omega = 2 * std::numbers::pi * frequency;
    std::complex<double> exact = lasting_part({.viscosity = kSeries});
    for (const PronyTerm& term : kSeries) {
      const std::complex<double> x(0, omega * term.time);
      exact += term.fraction * x / (1.0 + x);
    }
    Body body = ball(kSeries);
    const int steps = 200, cycles = 2 + static_cast<int>(15 * 2.0 * frequency);
    std::complex<double> seen = 0;
    for (int step = 1; step <= steps * cycles; ++step) {
      const double phase = 2 * std::numbers::pi * step / steps;
      fill(body, 1 + amplitude * std::sin(phase), 1 / (frequency * steps));
      if (step <= steps * (cycles - 1)) continue;
      seen += pressure_of(body) / at_once * std::polar(1.0, -phase) * std::complex<double>(0, 2.0 / steps);
    }
    std::printf("%5.2f Hz: storage %.5f (exact %.5f), loss %.5f (%.5f)\n", frequency, seen.real(), exact.real(),
                seen.imag(), exact.imag());
    EXPECT_LT(std::abs(seen - exact), 1e-3 * std::abs(exact)) << frequency;
  }
}

TEST(Viscosity, LongAtRestMeansRelaxed) {
  // The pressure before time zero is borne by what lasts, so nothing creeps afterwards.
  BodyDefinition definition = make_body(make_sphere(20e-3, 80), 1e-3, neo_hookean(20e3));
  definition.viscosity = kSeries;
  definition.fluid.initial_pressure = 300;
  Body body(definition, {}, quasi_static());
  body.settle();
  const Eigen::VectorXd start = body.state().equilibrium.position;
  for (int step = 0; step < 5; ++step) body.advance({}, {}, 0.5);
  EXPECT_LT((body.state().equilibrium.position - start).cwiseAbs().maxCoeff(), 1e-10);
  EXPECT_NEAR(pressure_of(body), 300, 1e-5);
}

TEST(Viscosity, StiffnessDampingAddsItsTimeTimesTheRateOfStrain) {
  const double time = 0.1, rate = 1e-3;
  Body elastic = ball({}), body = ball({}, {.stiffness_time = time});
  double after = 0;
  for (int step = 1; step <= 20; ++step) {
    after = 0.01 * step;
    fill(elastic, 1 + rate * after, 0.01);
    fill(body, 1 + rate * after, 0.01);
  }
  // E = rate t to first order: the damped pressure is that of E + time dE/dt; squares of strains of 2e-4 are left out.
  EXPECT_NEAR(pressure_of(body) / pressure_of(elastic), (after + time) / after, 1e-3 * (after + time) / after);
  EXPECT_GT(body.state().books.viscous, 0);
  EXPECT_NEAR(body.state().books.imbalance(), 0, 1e-9 * body.state().books.script_work);
}

TEST(Viscosity, MassDampingGivesAFallingSheetItsTerminalVelocity) {
  BodyDefinition definition = make_body(make_sheet(10e-3, 10e-3, 32), 1e-3, neo_hookean(20e3));
  definition.fluid.kind = FluidKind::kNone;
  definition.damping.mass_rate = 5;
  SimulationOptions options = dynamic();
  options.gravity = {0, 0, -9.81};
  double error[2];
  for (int level = 0; level < 2; ++level) {
    Body body(definition, {}, options);
    body.settle();
    const int steps = 50 << level;
    for (int step = 0; step < steps; ++step) body.advance({}, {}, 0.5 / steps);
    const double exact = -9.81 / 5 * (0.5 - (1 - std::exp(-5 * 0.5)) / 5);
    error[level] = body.state().equilibrium.position[2] - exact;
    EXPECT_NEAR(body.state().books.imbalance(), 0, 1e-9 * std::abs(body.state().books.gravity));
  }
  std::printf("errors %.2e %.2e m\n", error[0], error[1]);
  EXPECT_LT(std::abs(error[0]), 2e-3);
  // The first step is a backward Euler one, whose error of h^2 / 2 falls with the square as well.
  EXPECT_NEAR(error[0] / error[1], 4, 0.5);
}

}  // namespace
}  // namespace thinwall
