// Walls that no longer bear a load in the shape that they have.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/mesh/Shapes.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

constexpr double kWidth = 20e-3, kLength = 100e-3, kThickness = 1e-3, kModulus = 1e6;

/// Euler's load of a strip between hinges, newton.
const double kCritical = std::pow(std::numbers::pi / kLength, 2) * kModulus * kWidth * std::pow(kThickness, 3) / 12;

/// A straight strip between hinges that is pressed along itself by `load` times the critical one.
BodyDefinition pressed_strip(double load) {
  BodyDefinition body = make_body(make_sheet(kWidth, kLength, 250), kThickness, st_venant_kirchhoff(kModulus, 0));
  body.model = WallModel::kShell;
  body.fluid.kind = FluidKind::kNone;
  const Region end = PlaneRegion{.axis = 1, .at = kLength / 2};
  body.fixed = {{.region = PlaneRegion{.axis = 1, .at = -kLength / 2}}, {.region = end, .axes = {true, false, true}}};
  body.loads = {{.kind = LoadKind::kDeadForce, .region = end, .vector = {0, -load * kCritical, 0}}};
  return body;
}

/// Rise of the middle over the length of the elastica, at a load over the critical one: k / K(k) where
/// K(k) = pi / 2 sqrt(load) (Love, A Treatise on the Mathematical Theory of Elasticity, 1927, 262-263).
double elastica_rise(double load) {
  double low = 0, high = 1 - 1e-9;
  for (int turn = 0; turn < 60; ++turn) {
    const double middle = 0.5 * (low + high);
    (std::comp_ellint_1(middle) < 0.5 * std::numbers::pi * std::sqrt(load) ? low : high) = middle;
  }
  return low / std::comp_ellint_1(low);
}

double largest_rise(const Body& body) {
  double rise = 0;
  for (Eigen::Index k = 2; k < body.state().equilibrium.position.size(); k += 3) {
    rise = std::max(rise, std::abs(body.state().equilibrium.position[k]));
  }
  return rise;
}

TEST(Buckling, AStraightStripStaysSoBelowEulersLoadAndFollowsTheElasticaAbove) {
  Body body(pressed_strip(1.2), {}, quasi_static());
  body.settle({0});
  body.advance({}, {}, 1, {.load_factors = {0.95 / 1.2}, .fluids = {}});
  EXPECT_LT(largest_rise(body), 1e-9);
  for (const double factor : {1.05 / 1.2, 1.0}) {
    body.advance({}, {}, 1, {.load_factors = {factor}, .fluids = {}});
    EXPECT_FALSE(body.report().unstable);
    EXPECT_LT(std::abs(body.state().books.imbalance()), 1e-9);
  }
  EXPECT_NEAR(largest_rise(body) / kLength, elastica_rise(1.2), 0.01 * elastica_rise(1.2));
}

TEST(Buckling, AShapeThatIsNotStableIsToldWhereItIsNotLeft) {
  // What a tool with friction drags along is not found anew on the way.
  ToolDefinition ball = sphere_tool(1e-3);
  ball.friction = 0.3;
  const std::vector<ToolPose> away = {pose_at({0, 0, 1})};
  Body body(pressed_strip(1.2), {ball}, quasi_static());
  body.settle({0});
  body.advance(away, away, 1, {.load_factors = {0.95 / 1.2}, .fluids = {}});
  EXPECT_FALSE(body.report().unstable);
  body.advance(away, away, 1, {.load_factors = {1}, .fluids = {}});
  EXPECT_TRUE(body.report().unstable);
  EXPECT_LT(largest_rise(body), 1e-9);
}

TEST(Buckling, AStripThatIsPressedBeforeTimeZeroBeginsBuckled) {
  for (const SimulationOptions& options : {quasi_static(), SimulationOptions{}}) {
    Body body(pressed_strip(1.2), {}, options);
    body.settle({1});
    EXPECT_FALSE(body.report().unstable);
    EXPECT_NEAR(largest_rise(body) / kLength, elastica_rise(1.2), 0.01 * elastica_rise(1.2));
  }
}

TEST(Buckling, AStripThatIsTooLongForItsHingesBeginsBuckled) {
  // Flat it rests as it is given, though not stably. A half sine as long as the strip: (pi rise / (2 length))^2 is what
  // it is too long by, less what it is pressed to by Euler's load.
  constexpr double kExcess = 0.01;
  BodyDefinition strip = pressed_strip(0);
  strip.loads.clear();
  strip.fixed[1].axes = {true, true, true};
  strip.prestretch = {{.along = Eigen::Vector3d::UnitY(), .first = 1 / (1 + kExcess), .second = 1}};
  Body body(strip, {}, quasi_static());
  body.settle();
  EXPECT_FALSE(body.report().unstable);
  const double pressed = kCritical / (kModulus * kWidth * kThickness);
  const double rise = 2 / std::numbers::pi * std::sqrt(kExcess - pressed);
  EXPECT_NEAR(largest_rise(body) / kLength, rise, 0.01 * rise);
}

TEST(Buckling, ATubeThatIsDrainedFlattensByItself) {
  // A ring of a long tube. Round it loses (h / R)^2 / 2 of its area up to Levy's pressure, 3 D / R^3. An inextensible
  // one of 0.8895 of the circle's area bears 3.2 D / R^3 (Flaherty, Keller and Rubinow 1972).
  constexpr double kRadius = 10e-3, kWall = 0.2e-3, kArea = 0.8895, kPressure = 3.2;
  constexpr double kCriticalLoss = 0.5 * kWall * kWall / (kRadius * kRadius);
  BodyDefinition tube = make_body(make_cylinder(kRadius, 2e-3, 400), kWall, st_venant_kirchhoff(kModulus, 0));
  tube.model = WallModel::kShell;
  tube.fluid.leaks = false;
  tube.fixed = {{.region = WholeRegion{}, .axes = {false, true, false}, .clamped = true}};
  Body body(tube, {}, quasi_static());
  body.settle();
  const double whole = body.state().volume[0], unit = kModulus * std::pow(kWall / kRadius, 3) / 12;
  for (const double lost : {0.9 * kCriticalLoss, 1.1 * kCriticalLoss, 0.5 * (1 - kArea), 1 - kArea}) {
    body.advance({}, {}, 1, filling(body, whole * (1 - lost)));
    EXPECT_FALSE(body.report().unstable);
  }
  EXPECT_NEAR(-body.state().equilibrium.pressure[0] / unit, kPressure, 0.02 * kPressure);
}

TEST(Buckling, AMembraneThatIsPressedBeforeTimeZeroIsToldToBeUnstableThenAndAfterwards) {
  // Without bending stiffness it has no shape to buckle to.
  BodyDefinition strip = pressed_strip(1.2);
  strip.model = WallModel::kMembrane;
  Body body(strip, {}, quasi_static());
  body.settle({1});
  EXPECT_TRUE(body.report().unstable);
  body.advance({}, {}, 1, {.load_factors = {1}, .fluids = {}});
  EXPECT_EQ(body.report().newton_iterations, 0);
  EXPECT_TRUE(body.report().unstable);
}

TEST(Buckling, AHandDoesNotWaitForIt) {
  Body body(pressed_strip(1.2), {}, {.analysis = Analysis::kQuasiStatic, .extrapolates = true});
  body.settle({0});
  body.advance({}, {}, 1, {.load_factors = {1}, .fluids = {}});
  EXPECT_LT(body.report().newton_iterations, 10);
  EXPECT_LT(largest_rise(body), 1e-9);
}

TEST(Buckling, AFlatMembraneThatNothingHoldsAcrossItselfIsNeutral) {
  BodyDefinition sheet = make_body(make_sheet(kWidth, kLength, 250), kThickness, neo_hookean(kModulus));
  sheet.fluid.kind = FluidKind::kNone;
  const Region end = PlaneRegion{.axis = 1, .at = kLength / 2};
  sheet.fixed = {{.region = PlaneRegion{.axis = 1, .at = -kLength / 2}}, {.region = end, .axes = {false, false, true}}};
  sheet.loads = {{.kind = LoadKind::kDeadForce, .region = end, .vector = {0, 1e-3, 0}}};
  Body body(sheet, {}, quasi_static());
  body.settle({0});
  for (const double factor : {0.0, 1.0}) {
    body.advance({}, {}, 1, {.load_factors = {factor}, .fluids = {}});
    EXPECT_FALSE(body.report().unstable);
  }
}

}  // namespace
}  // namespace thinwall
