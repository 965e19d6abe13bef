// Weight of wall and fluid, hydrostatic pressure, and the inertia of the fluid.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "engine/fluid/FluidWeight.hpp"
#include "engine/mesh/Shapes.hpp"
#include "engine/simulation/SimulationFailure.hpp"
#include "tests/engine/simulation/OpenBodies.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

constexpr double kG = 9.81;

SimulationOptions heavy(SimulationOptions options) {
  options.gravity = {0, 0, -kG};
  return options;
}

double mass_of(const Body& body) {
  return body.model().mass.sum() / 3 + body.model().definition.fluid.density * body.state().fluid_volume.sum();
}

TEST(Gravity, SupportsCarryWallAndFluid) {
  // What the wall pulls at its border and the pressure, hydrostatic part included, pushes on the base make the weight.
  Body body(pressurised_hemisphere(256, 300), {}, heavy(quasi_static()));
  body.settle();
  Eigen::Vector3d support = support_force(body);
  const BodyModel& model = body.model();
  for (std::size_t t = 0; t < model.surface.size(); ++t) {
    const auto corners =
        relative_to(model.chambers[0].level, corners_of(model.surface[t], body.state().equilibrium.position));
    const auto moment = fluid_moment_of(corners, model.definition.fluid.density * Eigen::Vector3d(0, 0, -kG));
    for (int k = 0; k < 3; ++k) {
      if (model.fixed[3 * model.surface[t][k]]) support -= moment.gradient.segment<3>(3 * k);
    }
  }
  double held = 0;  // weight of the wall at the border itself, which no equation has
  for (int v = 0; v < model.vertices(); ++v) held += model.fixed[3 * v] ? model.mass[3 * v] * kG : 0;
  const double weight = mass_of(body) * kG;
  EXPECT_NEAR(support.z() + held, weight, 1e-7 * weight);
  EXPECT_LT(std::hypot(support.x(), support.y()), 1e-7 * weight);
}

TEST(Gravity, BodyFallsAsOneThing) {
  // In free fall the pressure is even again, whatever the fluid weighs: nothing deforms, and books show the fall.
  BodyDefinition definition = make_body(make_sphere(20e-3, 320), 1e-3, neo_hookean(20e3));
  definition.fluid.initial_pressure = 300;
  SimulationOptions options = dynamic();
  Body body(definition, {}, options);
  body.settle();
  const Eigen::VectorXd shape = body.state().equilibrium.position;
  Body falling(definition, {}, heavy(dynamic()));
  falling.settle();
  for (int step = 0; step < 20; ++step) falling.advance({}, {}, 2e-3);
  const Eigen::Vector3d rate = momentum_rate(falling);
  EXPECT_LT((rate - mass_of(falling) * Eigen::Vector3d(0, 0, -kG)).norm(), 1e-8 * mass_of(falling) * kG);
  EXPECT_NEAR(falling.state().books.imbalance(), 0, 1e-9 * std::abs(falling.state().books.kinetic));
}

TEST(Gravity, SwingOfAFluidOnASpringHasItsWholeMass) {
  // A strip holds a heavy ball of fluid: too stiff to deform, wall and fluid swing as one mass on the wall's ends. The
  // fluid's kinetic energy is half its mass times the square of its mean velocity.
  Body body(pressurised_hemisphere(256, 800), {sphere_tool(8e-3)}, dynamic());
  body.settle();
  move(body, pose_at({0, 0, 30e-3}), {0, 0, 17e-3}, 13, 2e-3);
  const BodyState& state = body.state();
  const Eigen::Vector3d mean = state.fluid_motion[0].velocity / state.fluid_volume[0];
  const double whole = 0.5 * body.model().definition.fluid.density * state.fluid_volume[0] * mean.squaredNorm();
  const double wall = 0.5 * body.model().mass.dot(state.velocity.cwiseAbs2());
  EXPECT_GT(whole, 0);
  EXPECT_NEAR(state.books.kinetic, whole + wall, 1e-12 * state.books.kinetic);
}

TEST(Gravity, PressureIsToldAtTheCentroidOfTheStressFreeShape) {
  // Shifted by metres, as a scan's coordinates may be, nothing changes.
  std::vector<double> volumes;
  for (const double shift : {0.0, -1.2}) {
    BodyDefinition definition = pressurised_hemisphere(256, 300);
    for (Eigen::Vector3d& vertex : definition.mesh.vertices) vertex.z() += shift;
    Body body(definition, {}, heavy(quasi_static()));
    body.settle();
    EXPECT_NEAR(body.state().equilibrium.pressure[0], 300, 1e-9);
    volumes.push_back(body.state().volume[0]);
  }
  EXPECT_NEAR(volumes[0], volumes[1], 1e-9 * volumes[0]);
}

TEST(Gravity, BooksOfACompressibleFluidAskNotHowHighABodyStands) {
  // The space that it is compressed by had its weight too, so that the integrator seemed to give what lifts that.
  for (const bool is_open : {false, true}) {
    std::vector<double> numerical;
    for (const double shift : {0.0, -1.2}) {
      BodyDefinition definition = is_open ? open_ball(320, 400) : pressurised_hemisphere(256, 300);
      for (Eigen::Vector3d& vertex : definition.mesh.vertices) vertex.z() += shift;
      definition.fluid.kind = FluidKind::kCompressible;
      definition.fluid.bulk_modulus = 30e3;
      Body body(definition, {sphere_tool(5e-3)}, heavy(quasi_static()));
      body.settle();
      if (is_open) {
        move(body, pose_at({0.1, 0, 0}), {0.1, 0, 0}, 20, 10e-3);
        EXPECT_LT(body.state().equilibrium.pressure[0], 200);
      } else {
        move(body, pose_at({0, 0, shift + 21e-3}), {0, 0, shift + 15e-3}, 20, 10e-3);
        EXPECT_GT(body.state().equilibrium.pressure[0], 350);
      }
      const EnergyBooks& books = body.state().books;
      EXPECT_LT(std::abs(books.imbalance()), 1e-9 * books.largest());
      numerical.push_back(books.numerical);
    }
    // Seen: within 1e-15 J; told by the space they differ by 8e-4 J and more.
    EXPECT_NEAR(numerical[0], numerical[1], 1e-12) << is_open;
  }
}

TEST(Gravity, BallOfFluidOnItsFixedBottomSags) {
  BodyDefinition definition = make_body(make_sphere(20e-3, 1280), 1e-3, neo_hookean(20e3));
  definition.fluid.initial_pressure = 600;
  definition.fixed = {{.region = BelowRegion{.axis = 2, .at = -18e-3}}};
  Body light(definition, {}, quasi_static()), body(definition, {}, heavy(quasi_static()));
  light.settle();
  body.settle();
  const auto highest = [](const Body& one) {
    double top = 0;
    for (Eigen::Index k = 2; k < one.state().equilibrium.position.size(); k += 3) {
      top = std::max(top, one.state().equilibrium.position[k]);
    }
    return top;
  };
  EXPECT_LT(highest(body), highest(light) - 1e-3);
  EXPECT_LT(body.state().books.gravity, light.state().books.elastic);
}

/// A strip of 20 mm x 40 mm in the plane z = 0, whose short side at y = -20 mm is a hinge.
BodyDefinition hinged_strip(double youngs_modulus, int triangles = 200) {
  BodyDefinition definition =
      make_body(make_sheet(20e-3, 40e-3, triangles), 1e-3, st_venant_kirchhoff(youngs_modulus, 0));
  definition.fluid.kind = FluidKind::kNone;
  definition.fixed = {{.region = BelowRegion{.axis = 1, .at = -19.99e-3}}};
  return definition;
}

Eigen::Vector3d farthest_from_hinge(const Body& body) {
  Eigen::Index best = 0;
  for (Eigen::Index v = 0; v < body.model().vertices(); ++v) {
    if (body.model().rest_position[3 * v + 1] > body.model().rest_position[3 * best + 1]) best = v;
  }
  return body.state().equilibrium.position.segment<3>(3 * best);
}

TEST(Gravity, StripHeldAlongAnEdgeHangsDownFromIt) {
  for (const SimulationOptions& options : {heavy(quasi_static()), heavy(dynamic())}) {
    Body body(hinged_strip(1e6), {}, options);
    body.settle();
    const Eigen::Vector3d tip = farthest_from_hinge(body);
    EXPECT_NEAR(tip.y(), -20e-3, 1e-6);
    EXPECT_NEAR(tip.z(), -40e-3, 20e-6);
    for (int step = 0; step < 3; ++step) body.advance({}, {}, 10e-3);
    EXPECT_NEAR((farthest_from_hinge(body) - tip).norm(), 0, 1e-8);
  }
}

TEST(Gravity, WrinklingSheetThatFoldsWhileItIsHeldUnfoldsAsItHangs) {
  // Held against turning it folds in its middle, and what is above the fold has to come all the way down.
  BodyDefinition definition = hinged_strip(1e6, 120);
  definition.materials = {neo_hookean(1e6)};
  definition.tension_field = true;
  Body body(definition, {}, heavy(quasi_static()));
  body.settle();
  const Eigen::Vector3d tip = farthest_from_hinge(body);
  EXPECT_NEAR(tip.y(), -20e-3, 1e-6);
  EXPECT_NEAR(tip.z(), -40e-3, 5e-6);
  body.advance({}, {}, 10e-3);
  EXPECT_FALSE(body.report().held);
}

TEST(Gravity, WrinklingSheetStaysWhereItIsOnTheAxisAlongWhichNothingHoldsIt) {
  BodyDefinition flag = make_body(make_sheet(40e-3, 60e-3, 400), 0.5e-3, neo_hookean(100e3));
  flag.fluid.kind = FluidKind::kNone;
  flag.tension_field = true;
  flag.fixed = {{.region = PlaneRegion{.axis = 1, .at = -30e-3}, .axes = {true, false, true}}};
  Body body(flag, {}, heavy(quasi_static()));
  body.settle();
  const Eigen::Vector3d mean =
      mass_sum(body.model(), body.state().equilibrium.position) / (body.model().mass.sum() / 3);
  EXPECT_NEAR(mean.y(), 0, 1e-9);  // seen: 2e-11
  EXPECT_NEAR(mean.z(), -30e-3, 1e-4);
}

TEST(Gravity, MembraneThatIsNotSolvedInTheAttitudeItTurnsToStaysInItsOwn) {
  // There four rigid motions are free, and other ones than in its own.
  BodyDefinition sheet = make_body(make_sheet(40e-3, 40e-3, 200), 1e-3, neo_hookean(100e3));
  sheet.fluid.kind = FluidKind::kNone;
  sheet.fixed = {{.region = PlaneRegion{.axis = 1, .at = -20e-3}, .axes = {false, false, true}}};
  Body body(sheet, {}, heavy(quasi_static()));
  body.settle();
  body.advance({}, {}, 10e-3);
  EXPECT_TRUE(body.state().equilibrium.position.allFinite());
}

TEST(Gravity, BodyThatComesToNoRestIsNotTurnedAgainInEachStep) {
  // A law that bears 0.33 of its factor at most, less than the weight that hangs on the hinge.
  BodyDefinition definition = hinged_strip(1e6, 16);
  definition.materials = {Material{find_wall_law("ogden"), {1e3, 0.5}}};
  Body body(definition, {}, heavy(quasi_static()));
  body.settle();
  body.advance({}, {}, 10e-3);
  EXPECT_TRUE(body.report().held);
  EXPECT_LT(body.report().newton_iterations, 50);
}

TEST(Gravity, LoadThatGrowsAcrossTheWeightLiftsAHangingStripByAngles) {
  BodyDefinition definition = hinged_strip(1e7);
  definition.model = WallModel::kShell;
  const double weight = definition.density * kG;  // newton / metre^3
  definition.loads = {
      {.kind = LoadKind::kDeadBodyForce, .region = AboveRegion{.axis = 2, .at = -1}, .vector = {0, 2 * weight, 0}}};
  Body body(definition, {}, heavy(quasi_static()));
  body.settle({0});
  for (const double part : {0.1, 0.5, 1.0}) {
    body.advance({}, {}, 10e-3, {.load_factors = {part}, .fluids = {}});
    const Eigen::Vector3d tip = farthest_from_hinge(body) + Eigen::Vector3d(0, 20e-3, 0);
    EXPECT_NEAR(std::atan2(tip.y(), -tip.z()), std::atan(2 * part), 2e-6) << part;
  }
}

TEST(Gravity, BallTooHeavyForItsWallIsSaidToBurstWithWhatHelps) {
  BodyDefinition definition = make_body(make_sphere(20e-3, 200), 1e-3, neo_hookean(5e3));
  definition.fluid.initial_pressure = 400;
  definition.fixed = {{.region = BelowRegion{.axis = 2, .at = -15e-3}}};
  Body body(definition, {}, heavy(quasi_static()));
  try {
    body.settle();
    FAIL() << "it bears " << body.state().volume[0] << " m^3";
  } catch (const SimulationFailure& failure) {
    const std::string what = failure.what();
    EXPECT_NE(what.find("under 400 Pa and its weight: it bursts"), std::string::npos) << what;
    EXPECT_NE(what.find("lighter contents (`density`)"), std::string::npos) << what;
  }
}

}  // namespace
}  // namespace thinwall
