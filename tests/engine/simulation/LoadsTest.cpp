// Loads that a script puts on a wall.

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "engine/mesh/Shapes.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

constexpr double kWidth = 20e-3, kLength = 40e-3, kThickness = 1e-3, kModulus = 20e3;

/// A sheet held at y = -length / 2 along y, free to narrow, held flat.
BodyDefinition sheet() {
  BodyDefinition body = make_body(make_sheet(kWidth, kLength, 128), kThickness, neo_hookean(kModulus));
  body.fluid.kind = FluidKind::kNone;
  body.fixed = {{.region = PlaneRegion{.axis = 1, .at = -kLength / 2}, .axes = {false, true, false}},
                {.region = PlaneRegion{.axis = 0, .at = -kWidth / 2}, .axes = {true, false, false}},
                {.region = PlaneRegion{.axis = 2, .at = 0}, .axes = {false, false, true}}};
  return body;
}

const Region kEnd = PlaneRegion{.axis = 1, .at = kLength / 2};

/// Stretch at which a strip of neo-Hookean rubber bears a nominal stress.
double uniaxial_stretch(double stress) {
  double stretch = 1;
  for (int k = 0; k < 60; ++k) {
    const double miss = kModulus * (stretch - 1 / (stretch * stretch)) - stress;
    stretch -= miss / (kModulus * (1 + 2 / (stretch * stretch * stretch)));
  }
  return stretch;
}

double largest(const Body& body, int axis) {
  double value = -1;
  for (Eigen::Index k = axis; k < body.state().equilibrium.position.size(); k += 3) {
    value = std::max(value, body.state().equilibrium.position[k]);
  }
  return value;
}

TEST(Loads, ForceAndLineForceOnAnEndStretchAStripEvenly) {
  const double stress = 9e3;
  const LoadDefinition loads[] = {
      {.kind = LoadKind::kDeadForce, .region = kEnd, .vector = {0, stress * kWidth * kThickness, 0}},
      {.kind = LoadKind::kDeadLineForce, .region = kEnd, .vector = {0, stress * kThickness, 0}},
  };
  for (const LoadDefinition& load : loads) {
    BodyDefinition definition = sheet();
    definition.loads = {load};
    Body body(definition, {}, quasi_static());
    body.settle({0});
    for (int step = 1; step <= 4; ++step) body.advance({}, {}, 1, {.load_factors = {0.25 * step}, .fluids = {}});
    // An even strain is in the element's space; what is left is Newton's tolerance.
    EXPECT_NEAR(largest(body, 1) + kLength / 2, uniaxial_stretch(stress) * kLength, 1e-9 * kLength);
    EXPECT_NEAR(body.state().books.imbalance(), 0, 1e-12);
    EXPECT_GT(body.state().books.script_work, 0);
  }
}

TEST(Loads, AreAnsweredHoweverLightTheyAre) {
  constexpr double kLoad = 1e-13;  // newton: less at each node than the round-off of a wall that is strained by 1e-4
  BodyDefinition definition = sheet();
  definition.loads = {{.kind = LoadKind::kDeadForce, .region = kEnd, .vector = {0, kLoad, 0}}};
  Body body(definition, {}, quasi_static());
  body.settle({0});
  const double longer = kLoad * kLength / (3 * kModulus * kWidth * kThickness);  // metres
  for (int step = 1; step <= 4; ++step) {
    body.advance({}, {}, 1, {.load_factors = {0.25 * step}, .fluids = {}});
    // The coordinates are rounded by a thousandth of it.
    EXPECT_NEAR(largest(body, 1) - kLength / 2, 0.25 * step * longer, 2e-2 * longer);
  }
}

TEST(Loads, WithoutFactorsAreThereBeforeTimeZero) {
  BodyDefinition definition = sheet();
  definition.loads = {{.kind = LoadKind::kDeadForce, .region = kEnd, .vector = {0, 9e3 * kWidth * kThickness, 0}}};
  Body body(definition, {}, quasi_static());
  body.settle();
  EXPECT_NEAR(largest(body, 1) + kLength / 2, uniaxial_stretch(9e3) * kLength, 1e-9 * kLength);
}

TEST(Loads, TractionAndBodyForceAddUpToAreaAndVolume) {
  BodyDefinition definition = sheet();
  const Region all = AboveRegion{.axis = 1, .at = -1};
  definition.loads = {{.kind = LoadKind::kDeadTraction, .region = all, .vector = {3, 0, 0}},
                      {.kind = LoadKind::kDeadBodyForce, .region = all, .vector = {0, 700, 0}}};
  const BodyModel model = make_body_model(definition);
  const auto sum = [&](int load) {
    Eigen::Vector3d total = Eigen::Vector3d::Zero();
    for (int v = 0; v < model.vertices(); ++v) total += model.loads[load].force.segment<3>(3 * v);
    return total;
  };
  EXPECT_LT((sum(0) - Eigen::Vector3d(3 * kWidth * kLength, 0, 0)).norm(), 1e-15);
  EXPECT_LT((sum(1) - Eigen::Vector3d(0, 700 * kWidth * kLength * kThickness, 0)).norm(), 1e-15);
}

TEST(Loads, PressureOnAHeldDiscActsAsAFluidUnderIt) {
  // The same hemisphere, blown up by its fluid or by a pressure on its wall.
  BodyDefinition filled = pressurised_hemisphere(256, 300);
  BodyDefinition loaded = filled;
  loaded.fluid = {.kind = FluidKind::kNone};
  loaded.loads = {{.kind = LoadKind::kFollowerPressure, .region = AboveRegion{.axis = 2, .at = -1}, .pressure = 300}};
  Body one(filled, {}, quasi_static()), other(loaded, {}, quasi_static());
  one.settle();
  other.settle();
  EXPECT_LT((one.state().equilibrium.position - other.state().equilibrium.position).cwiseAbs().maxCoeff(), 1e-10);
}

TEST(Loads, PressureFollowsAFreeWall) {
  // A sheet held along one edge and stretched along it stands in the wind: the force is pressure times area vector.
  BodyDefinition definition = make_body(make_sheet(kWidth, kLength, 128), kThickness, neo_hookean(kModulus));
  definition.fluid.kind = FluidKind::kNone;
  definition.loads = {{.kind = LoadKind::kFollowerPressure, .region = AboveRegion{.axis = 1, .at = -1}, .pressure = 5}};
  const BodyModel model = make_body_model(definition);
  EquilibriumProblem problem;
  Eigen::VectorXd position = model.rest_position;
  for (int v = 0; v < model.vertices(); ++v) position[3 * v + 2] = 3 * std::pow(position[3 * v + 1], 2) + 0.4;
  problem.start = position;
  EquilibriumTerms terms;
  evaluate(model, problem, position, {}, true, terms);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero(), exact = Eigen::Vector3d::Zero();
  for (int v = 0; v < model.vertices(); ++v) sum += terms.load_force.segment<3>(3 * v);
  for (const Eigen::Vector3i& triangle : model.surface) {
    const auto corners = corners_of(triangle, position);
    exact += 2.5 * (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  }
  EXPECT_LT((sum - exact).norm(), 1e-15);
}

TEST(Loads, MomentHasNoForceAndItsOwnTorque) {
  BodyDefinition definition = make_body(make_sheet(kWidth, kLength, 128), kThickness, neo_hookean(kModulus));
  definition.fluid.kind = FluidKind::kNone;
  const Eigen::Vector3d moment(2e-3, 0, 0);
  definition.loads = {{.kind = LoadKind::kDeadMoment, .region = kEnd, .vector = moment}};
  const BodyModel model = make_body_model(definition);
  EquilibriumProblem problem;
  problem.start = model.rest_position;
  EquilibriumTerms terms;
  evaluate(model, problem, model.rest_position, {}, true, terms);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero(), torque = Eigen::Vector3d::Zero();
  for (int v = 0; v < model.vertices(); ++v) {
    const Eigen::Vector3d force = terms.load_force.segment<3>(3 * v);
    sum += force;
    torque += Eigen::Vector3d(model.rest_position.segment<3>(3 * v)).cross(force);
  }
  EXPECT_LT(sum.norm(), 1e-15);
  EXPECT_LT((torque - moment).norm(), 1e-15);
}

TEST(Loads, HessianIsTheSlopeOfTheGradient) {
  BodyDefinition definition = pressurised_hemisphere(64, 300);
  const Region upper = AboveRegion{.axis = 2, .at = 5e-3};
  definition.loads = {{.kind = LoadKind::kFollowerPressure, .region = AboveRegion{.axis = 2, .at = -1}, .pressure = 40},
                      {.kind = LoadKind::kDeadMoment, .region = upper, .vector = {1e-3, 2e-3, 0}}};
  const BodyModel model = make_body_model(definition);
  EquilibriumProblem problem;
  problem.fluids = {{}};
  problem.gravity = {1, -2, -9};
  problem.start = model.rest_position;
  const Eigen::VectorXd pressure = Eigen::VectorXd::Constant(1, 300), position = 1.1 * model.rest_position;
  EquilibriumTerms terms, ahead, behind;
  evaluate(model, problem, position, pressure, true, terms);
  const Eigen::VectorXd way = Eigen::VectorXd::NullaryExpr(
      position.size(), [&](Eigen::Index k) { return model.fixed[k] ? 0 : std::sin(7.0 * static_cast<double>(k)); });
  const double h = 1e-8;
  evaluate(model, problem, position + h * way, pressure, true, ahead);
  evaluate(model, problem, position - h * way, pressure, true, behind);
  const auto force = [&](const EquilibriumTerms& one) {
    return (one.gradient - one.volume_gradient * pressure).eval();
  };
  const Eigen::VectorXd difference = (force(ahead) - force(behind)) / (2 * h);
  Eigen::VectorXd product;
  multiply(model.pattern, terms.values, way, product);
  double worst = 0;
  for (Eigen::Index k = 0; k < way.size(); ++k) {
    if (!model.fixed[k]) worst = std::max(worst, std::abs(product[k] - difference[k]));
  }
  EXPECT_LT(worst, 1e-6 * difference.cwiseAbs().maxCoeff());
}

TEST(Loads, OnNothingAreRefused) {
  BodyDefinition definition = sheet();
  definition.loads = {{.kind = LoadKind::kDeadLineForce, .region = SphereRegion{.center = {1, 1, 1}, .radius = 0.1}}};
  EXPECT_THROW(make_body_model(definition), std::invalid_argument);
}

TEST(Loads, StepsAreRefinedToKeepTheErrorThatIsAllowed) {
  BodyDefinition definition = sheet();
  definition.loads = {{.kind = LoadKind::kDeadForce, .region = kEnd, .vector = {0, 0.05, 0}}};
  double end[3];
  const double allowed[3] = {1e-5, 1e-6, 1e-8};
  for (int level = 0; level < 3; ++level) {
    SimulationOptions options = dynamic();
    options.step_error = allowed[level];
    Body body(definition, {}, options);
    body.settle({0});
    int refinements = 0;
    for (int step = 0; step < 10; ++step) {
      body.advance({}, {}, 5e-3, {.load_factors = {1}, .fluids = {}});
      refinements += body.report().refinements;
    }
    EXPECT_GT(refinements, 0);
    end[level] = largest(body, 1);
  }
  EXPECT_LT(std::abs(end[1] - end[2]), 0.5 * std::abs(end[0] - end[2]));
}

}  // namespace
}  // namespace thinwall
