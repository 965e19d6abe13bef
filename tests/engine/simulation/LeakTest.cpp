// Bodies whose wall is open: the force of the contents, what runs out, and the books.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "engine/mesh/Shapes.hpp"
#include "tests/engine/simulation/LeakWatch.hpp"
#include "tests/engine/simulation/OpenBodies.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

constexpr double kPressure = 400;  // pascal

/// Flow through an opening, written out: metres^3 / second.
double bernoulli(double area, double pressure) {
  return 0.61 * area * std::sqrt(2 * pressure / 1010);
}

/// Pressure and volume of a body as its contents are drained to nothing, without leaks.
std::vector<std::pair<double, double>> compliance_of(BodyDefinition definition, int steps) {
  definition.fluid.leaks = false;
  Body body(definition, {}, quasi_static());
  body.settle();
  std::vector<std::pair<double, double>> curve;
  const double root = std::sqrt(kPressure);
  for (int step = 0; step < steps; ++step) {
    curve.emplace_back(body.state().equilibrium.pressure[0], body.state().fluid_volume[0]);
    const double next = root * (1 - (step + 1.0) / steps);
    body.advance({}, {}, 1, {.load_factors = {}, .fluids = {{.added = 0, .pressure = next * next}}});
  }
  return curve;
}

/// Time at which the fluid has fallen to a volume: integral of dV / Q(p(V)), by the middles of the root of p.
double time_to(const std::vector<std::pair<double, double>>& curve, double area, double volume) {
  double time = 0;
  for (std::size_t k = 1; k < curve.size(); ++k) {
    const double root = 0.5 * (std::sqrt(curve[k - 1].first) + std::sqrt(curve[k].first));
    const double part = std::min(1.0, (curve[k - 1].second - volume) / (curve[k - 1].second - curve[k].second));
    time += part * (curve[k - 1].second - curve[k].second) / bernoulli(area, root * root);
    if (part < 1) break;
  }
  return time;
}

TEST(Leak, LowersThePressureAsTheOrificeEquationAsks) {
  const BodyDefinition definition = open_ball(320, kPressure);
  const auto curve = compliance_of(definition, 200);
  double error[3];
  for (int k = 0; k < 3; ++k) {
    Body body(definition, {}, quasi_static());
    body.settle();
    const double end = time_to(curve, body.state().open_area[0], curve[100].second);
    const int steps = 20 << k;
    for (int step = 0; step < steps; ++step) body.advance({}, {}, end / steps);
    error[k] = body.state().equilibrium.pressure[0] / curve[100].first - 1;
    std::printf("%d steps: error of the pressure %.2e\n", steps, error[k]);
  }
  EXPECT_LT(std::abs(error[1]), 1e-3);
  EXPECT_GT(error[0] / error[1], 3);  // second order
  EXPECT_GT(error[1] / error[2], 3);
}

TEST(Leak, OfACompressibleFluidInARigidBodyFollowsItsEquation) {
  BodyDefinition definition = open_ball(80, kPressure);
  definition.fluid.kind = FluidKind::kCompressible;
  definition.fluid.bulk_modulus = 20e3;
  definition.fixed = {{.region = BelowRegion{.axis = 2, .at = 1}}};
  Body body(definition, {}, quasi_static());
  body.settle();
  const double volume = body.state().volume[0], modulus = definition.fluid.bulk_modulus;
  std::vector<std::pair<double, double>> curve;
  for (int k = 0; k < 1000; ++k) {
    const double root = std::sqrt(kPressure) * (1 - k / 1000.0);
    curve.emplace_back(root * root, volume / (1 - (root * root - kPressure) / modulus));
  }
  const double end = time_to(curve, body.state().open_area[0], curve[500].second);
  for (int step = 0; step < 50; ++step) body.advance({}, {}, end / 50);
  EXPECT_NEAR(body.state().equilibrium.pressure[0], curve[500].first, 1e-3 * curve[500].first);
}

void expect_supports_to_feel_the_jet(double gravity, bool lips_are_held) {
  BodyDefinition definition = open_ball(320, kPressure);
  definition.thickness.assign(definition.thickness.size(), 3e-3);
  if (!lips_are_held) definition.fixed = {{.region = BelowRegion{.axis = 2, .at = 0}}};
  SimulationOptions options = quasi_static();
  options.gravity = gravity * Eigen::Vector3d(0.6, 0, -0.8);
  Body body(definition, {}, options);
  body.settle();
  for (int step = 0; step < 4; ++step) {
    const BodyState& state = body.state();
    const Eigen::Matrix3Xd lips = body.model().openings[0].at(state.equilibrium.position);
    // The fluid's weight bears on the wall but for what the cap would bear.
    Eigen::Vector3d expected = -(body.model().mass.sum() / 3 + 1010 * state.volume[0]) * options.gravity;
    PressureField field{.at_origin = state.equilibrium.pressure[0], .slope = 1010 * options.gravity};
    field.at_origin -= field.slope.dot(body.model().chambers[0].level);
    expected += lip_load_of(lips, field).rowwise().sum();
    EXPECT_LT((force_of_supports(body, options.gravity) - expected).norm(), 1e-9 * largest_single_force(body) + 1e-9);
    if (gravity == 0) {
      EXPECT_NEAR(expected.z(), state.equilibrium.pressure[0] * lip_cap_of(lips).area.z(), 1e-12);
    }
    body.advance({}, {}, 0.01);
  }
}

TEST(Leak, SupportsFeelTheJet) {
  for (const bool lips_are_held : {true, false}) {
    expect_supports_to_feel_the_jet(0, lips_are_held);
    expect_supports_to_feel_the_jet(9.81, lips_are_held);
  }
}

void expect_quadratic_convergence(bool has_surface) {
  BodyDefinition definition = open_ball(320, 600, 2);
  definition.fixed = {{.region = BelowRegion{.axis = 2, .at = -15e-3}}};  // the lips move
  Body body(definition, {}, dynamic());
  body.settle();
  EquilibriumProblem problem;
  const double left = has_surface ? 0.8 : 0.97;
  problem.fluids = {
      {.fluid_volume = left * body.state().fluid_volume[0], .outflow_time = 0.003, .has_surface = has_surface}};
  problem.gravity = {1, 2, -5};
  const Eigen::Vector3d origin(0, 0, 0.015);
  const Eigen::Vector3d moment =
      body.state().fluid_motion[0].moment + body.state().volume[0] * (body.model().chambers[0].level - origin);
  problem.fluid_inertia = {{.factor = 1e12, .target = moment + Eigen::Vector3d(4e-9, -2e-9, 3e-9), .origin = origin}};
  EquilibriumState state = body.state().equilibrium;
  Newton newton(body.model());
  const NewtonResult result = newton.solve(problem, state, {});
  ASSERT_TRUE(result.converged) << result.reason;
  for (const double residual : result.residual_history) std::printf("%.2e N\n", residual);
  const std::vector<double>& history = result.residual_history;
  const std::size_t last = history.size() - 1;
  EXPECT_LT(history[last - 1], 3e-2 * history[last - 2]);
  EXPECT_LT(history[last], 1e-3 * history[last - 1]);
}

TEST(Leak, ConvergesQuadraticallyAlthoughNothingIsSymmetric) {
  expect_quadratic_convergence(false);
  expect_quadratic_convergence(true);
}

TEST(Leak, LeavesNoStepThatLeadsUpInTheEnergyOfTheLineSearch) {
  for (const FluidKind kind : {FluidKind::kIncompressible, FluidKind::kCompressible}) {
    BodyDefinition definition = open_ball(320, 600, 2);
    definition.fixed = {{.region = BelowRegion{.axis = 2, .at = -15e-3}}};
    definition.fluid.kind = kind;
    definition.fluid.bulk_modulus = 20e3;
    for (const Analysis analysis : {Analysis::kQuasiStatic, Analysis::kDynamic}) {
      SimulationOptions options;
      options.analysis = analysis;
      Body body(definition, {}, options);
      body.settle();
      int ascending = 0;
      for (int step = 0; step < 20; ++step) {
        body.advance({}, {}, 0.001);
        ascending += body.report().ascending_steps;
      }
      EXPECT_EQ(ascending, 0);
    }
  }
}

TEST(Leak, BooksCloseAndTheIntegratorHasLittleOfThem) {
  for (const FluidKind kind : {FluidKind::kIncompressible, FluidKind::kCompressible}) {
    for (const Analysis analysis : {Analysis::kQuasiStatic, Analysis::kDynamic}) {
      BodyDefinition definition = open_ball(320, kPressure);
      definition.fixed = {{.region = BelowRegion{.axis = 2, .at = -15e-3}}};
      definition.fluid.kind = kind;
      definition.fluid.bulk_modulus = 20e3;
      double numerical[2];
      for (int k = 0; k < 2; ++k) {
        SimulationOptions options;
        options.analysis = analysis;
        Body body(definition, {}, options);
        body.settle();
        LeakWatch watch(body);
        const int steps = k == 0 ? 20 : 80;
        for (int step = 0; step < steps; ++step) {
          body.advance({}, {}, 0.15 / steps);
          if (kind == FluidKind::kIncompressible) watch.note(body);
        }
        const EnergyBooks& books = body.state().books;
        EXPECT_LT(std::abs(books.imbalance()), 1e-9 * books.script_work);
        EXPECT_GT(books.leak, 0.5 * books.script_work);
        numerical[k] = std::abs(books.numerical) / books.script_work;
      }
      std::printf("numerical / work %.1e, with steps of a quarter %.1e\n", numerical[0], numerical[1]);
      // A leak that opens at once accelerates the masses at once, and shakes what is stiff: to no order.
      EXPECT_LT(numerical[0], analysis == Analysis::kDynamic ? 2e-3 : 3e-4);
      EXPECT_LT(numerical[1], numerical[0] / (analysis == Analysis::kDynamic ? 1.1 : 14));  // second order
    }
  }
}

TEST(Leak, DrainsARigidBodyToTheHeightOfItsLipsAsTorricelliSays) {
  // Air comes in at the top, fluid leaves at the side. Surface of a ball at height z: pi (R^2 - z^2).
  const double radius = 20e-3, gravity = 9.81;
  BodyDefinition definition = make_body(make_sphere(radius, 720), 1e-3, neo_hookean(20e3));
  open_at({0, 0, radius}, 1, definition);
  open_at({radius, 0, 0}, 1, definition);
  definition.fixed = {{.region = BelowRegion{.axis = 2, .at = 1}}};
  SimulationOptions options = quasi_static();
  options.gravity = {0, 0, -gravity};
  Body body(definition, {}, options);
  body.settle();
  const LipCap side = lip_cap_of(body.model().openings[1].at(body.state().equilibrium.position));
  const double area = side.area.norm(), low = side.center.z();
  const auto height = [&] {
    return body.model().chambers[0].level.z() + body.state().equilibrium.pressure[0] / (1010 * gravity);
  };
  for (int step = 0; step < 5; ++step) body.advance({}, {}, 2e-3);
  double expected = height(), time = 0;
  EXPECT_GT(body.state().air[0], 0);
  for (int step = 0; step < 160 && expected > low + 1e-3; ++step) {
    body.advance({}, {}, 5e-3);
    time += 5e-3;
    for (int part = 0; part < 50; ++part) {
      const double surface = std::numbers::pi * (radius * radius - expected * expected);
      expected -= 1e-4 * 0.61 * area * std::sqrt(2 * gravity * std::max(0.0, expected - low)) / surface;
    }
    // The ball of triangles has 1 to 2 % less surface than the sphere.
    EXPECT_NEAR(height(), expected, 0.02 * radius);
  }
  std::printf("%.3f s, height %.2f mm, expected %.2f mm\n", time, 1e3 * height(), 1e3 * expected);
  EXPECT_GT(time, 0.1);
  for (int step = 0; step < 60; ++step) body.advance({}, {}, 0.1);
  EXPECT_NEAR(height(), low, 1e-5);
  const double leak = body.state().books.leak;
  EXPECT_GT(leak, 0);
  EXPECT_LT(std::abs(body.state().books.numerical), 0.02 * leak);
  EXPECT_NEAR(body.state().fluid_volume[0] + body.state().air[0], body.state().volume[0], 1e-15);
}

TEST(Leak, FluidAndLeakedKeepTheirSumOverAThousandSteps) {
  BodyDefinition definition = open_ball(80, kPressure);
  definition.fixed = {{.region = BelowRegion{.axis = 2, .at = -15e-3}}};
  definition.fluid.discharge = 0.05;
  Body body(definition, {}, dynamic());
  body.settle();
  LeakWatch watch(body);
  for (int step = 0; step < 1000; ++step) {
    body.advance({}, {}, 0.002);
    watch.note(body);
  }
  EXPECT_LT(watch.worst_identity, 1e-12);
  EXPECT_GT(body.state().leaked[0], 1e-6);
  EXPECT_LT(body.state().equilibrium.pressure[0], 0.5 * kPressure);
}

TEST(Leak, DoesNotRingWhereThePressureFollowsStiffly) {
  // A steady inflow into a stiff body: the pressure goes to where as much leaves, from one side, with any step.
  BodyDefinition definition = open_ball(80, kPressure);
  definition.fluid.kind = FluidKind::kCompressible;
  definition.fluid.bulk_modulus = 2e6;
  definition.fixed = {{.region = BelowRegion{.axis = 2, .at = 1}}};
  Body body(definition, {}, quasi_static());
  body.settle();
  const double inflow = bernoulli(body.state().open_area[0], 100);
  for (int step = 0; step < 20; ++step) {
    const double before = body.state().equilibrium.pressure[0];
    body.advance({}, {}, 0.1, {.load_factors = {}, .fluids = {{.added = 0.1 * inflow, .pressure = {}}}});
    const double now = body.state().equilibrium.pressure[0];
    EXPECT_LE(std::abs(now - 100), 0.5 * std::abs(before - 100) + 1e-3);
    EXPECT_NEAR(body.state().books.imbalance(), 0, 1e-9 * body.state().books.script_work);
  }
  EXPECT_NEAR(body.state().equilibrium.pressure[0], 100, 1e-2);  // the root is laminar near zero
}

TEST(Leak, OfOneChamberLeavesTheOther) {
  BodyDefinition definition = make_body(make_sphere(20e-3, 80), 1e-3, neo_hookean(20e3));
  const SurfaceMesh other = definition.mesh;
  const int count = static_cast<int>(other.vertices.size());
  for (const Eigen::Vector3d& vertex : other.vertices)
    definition.mesh.vertices.push_back(vertex + Eigen::Vector3d(0.1, 0, 0));
  for (const Eigen::Vector3i& triangle : other.triangles) definition.mesh.triangles.push_back(triangle.array() + count);
  definition.thickness.assign(definition.mesh.triangles.size(), 1e-3);
  definition.fluid.initial_pressure = kPressure;
  definition.fixed = {{.region = BelowRegion{.axis = 2, .at = -15e-3}}};
  open_at({0.1, 0, 20e-3}, 1, definition);
  for (const Analysis analysis : {Analysis::kQuasiStatic, Analysis::kDynamic}) {
    SimulationOptions options;
    options.analysis = analysis;
    Body body(definition, {}, options);
    body.settle();
    ASSERT_EQ(body.model().openings[0].chamber, 1);
    const double volume = body.state().fluid_volume[0];
    for (int step = 0; step < 10; ++step) body.advance({}, {}, 0.01);
    EXPECT_EQ(body.state().fluid_volume[0], volume);
    EXPECT_NEAR(body.state().equilibrium.pressure[0], kPressure, 1e-6 * kPressure);
    EXPECT_LT(body.state().equilibrium.pressure[1], 0.8 * kPressure);
    EXPECT_GT(body.state().leaked[1], 1e-6);
    EXPECT_EQ(body.state().leaked[0], 0);
  }
}

/// A slack bag whose mouth is pulled down over what it holds.
void expect_a_jet_of_lips_that_draw_back(int rings, double force) {
  BodyDefinition definition = open_ball(320, 0, rings);
  definition.fixed = {{.region = BelowRegion{.axis = 2, .at = -15e-3}}};
  definition.thickness.assign(definition.thickness.size(), 0.2e-3);
  definition.materials = {neo_hookean(2e3)};
  definition.loads = {{.kind = LoadKind::kDeadForce, .region = GroupRegion{"lips"}, .vector = {0, 0, -force}}};
  Body body(definition, {}, dynamic());
  body.settle({0});
  LeakWatch watch(body);
  double leak = 0, fallen = 0;
  for (int step = 0; step < 200; ++step) {
    body.advance({}, {}, 0.002, {.load_factors = {std::min(1.0, step / 50.0)}, .fluids = {}});
    watch.note(body);
    fallen = std::max(fallen, leak - body.state().books.leak);
    leak = body.state().books.leak;
  }
  std::printf("%.1f of %.1f ml leaked, energy of the jet %.2e J, in a step at most %.1e J less\n",
              1e6 * body.state().leaked[0], 1e6 * watch.whole, leak, fallen);
  watch.expect_sound();
  EXPECT_GT(body.state().leaked[0], 0.1 * watch.whole);
  EXPECT_LT(fallen, 1e-2 * leak);
}

TEST(Leak, OfLipsThatDrawBackTakesNoEnergyFromNothing) {
  expect_a_jet_of_lips_that_draw_back(2, 5e-3);
  expect_a_jet_of_lips_that_draw_back(3, 5e-3);
  expect_a_jet_of_lips_that_draw_back(4, 1e-3);
}

/// A bag that is turned inside out through its mouth.
void expect_to_empty(BodyDefinition definition, const Eigen::Vector3d& gravity) {
  definition.fixed = {{.region = BelowRegion{.axis = 2, .at = -15e-3}}};
  SimulationOptions options = dynamic();
  options.gravity = gravity;
  Body body(definition, {}, options);
  body.settle({0});
  LeakWatch watch(body);
  double least = watch.whole, least_motion = 0;
  for (int step = 0; step < 200; ++step) {
    body.advance({}, {}, 0.002, {.load_factors = {std::min(1.0, step / 50.0)}, .fluids = {}});
    watch.note_sums(body);
    least = std::min(least, body.state().fluid_volume[0]);
    least_motion = std::min(least_motion, body.state().books.kinetic);
  }
  std::printf("%.1f of %.1f ml leaked, %.1f ml enclosed, numerical %.1e J of %.1e J\n", 1e6 * body.state().leaked[0],
              1e6 * watch.whole, 1e6 * body.state().volume[0], body.state().books.numerical,
              body.state().books.largest());
  EXPECT_EQ(least, 0);
  EXPECT_EQ(least_motion, 0);
  EXPECT_LT(body.state().volume[0], 0);
  EXPECT_LT(watch.worst_identity, 1e-12);
  EXPECT_LT(watch.worst_imbalance, 2e-8 * watch.largest);
}

TEST(Leak, LeavesNoLessThanNothing) {
  for (const int rings : {3, 4}) {
    BodyDefinition soft = open_ball(320, 0, rings);
    soft.thickness.assign(soft.thickness.size(), 0.2e-3);
    soft.materials = {neo_hookean(2e3)};
    // Twice as strong a pull crumples the mouth before all has run out.
    soft.loads = {{.kind = LoadKind::kDeadForce, .region = GroupRegion{"lips"}, .vector = {0, 0, -0.01}}};
    expect_to_empty(soft, Eigen::Vector3d::Zero());
    BodyDefinition stiff = open_ball(320, 0, rings);
    stiff.loads = {{.kind = LoadKind::kDeadForce, .region = GroupRegion{"lips"}, .vector = {0, 0, -1}}};
    expect_to_empty(stiff, {0, 0, -9.81});
    stiff.fluid.kind = FluidKind::kCompressible;
    stiff.fluid.bulk_modulus = 20e3;
    expect_to_empty(stiff, {0, 0, -9.81});
  }
}

TEST(Leak, AFreeBodyRecoilsFromItsJet) {
  BodyDefinition definition = open_ball(320, kPressure);
  definition.fixed.clear();
  Body body(definition, {}, dynamic());
  body.settle();
  double impulse = 0, carried = 0;  // newton second, along z: of the jet, and with the fluid that left
  const auto jet = [&] {
    return body.state().equilibrium.pressure[0] *
           lip_cap_of(body.model().openings[0].at(body.state().equilibrium.position)).area.z();
  };
  for (int step = 0; step < 100; ++step) {
    const double before = jet();
    body.advance({}, {}, 0.0005);
    impulse -= 0.0005 * 0.5 * (before + jet());
    const double speed = body.state().fluid_motion[0].velocity.z() / body.state().volume[0];
    carried += 1010 * body.state().outflow.volumes[0] * speed;
  }
  const double moved = momentum(body).z() + carried;
  std::printf("momentum %.4e, impulse %.4e, carried away %.1e N s\n", moved, impulse, carried);
  EXPECT_LT(impulse, -1e-3);
  EXPECT_NEAR(moved, impulse, 1e-2 * std::abs(impulse));
}

}  // namespace
}  // namespace thinwall
