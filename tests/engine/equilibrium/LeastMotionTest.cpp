#include "engine/equilibrium/LeastMotion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/mesh/Shapes.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

constexpr double kPart = 1e-3;

BodyModel slack_dome() {
  BodyDefinition definition = make_body(make_hemisphere(20e-3, 64), 1e-3, neo_hookean(20e3));
  definition.tension_field = true;
  return make_body_model(definition);
}

/// Moves every vertex its own way, by about a millimetre.
Eigen::VectorXd moved(const Eigen::VectorXd& from, double phase) {
  Eigen::VectorXd to = from;
  for (Eigen::Index k = 0; k < to.size(); ++k) to[k] += 1e-3 * std::sin(phase + 1.7 * static_cast<double>(k));
  return to;
}

TEST(LeastMotion, ForcesAndStiffnessAreTheDerivativesOfItsEnergy) {
  const BodyModel model = slack_dome();
  const LeastMotion motion{.part = kPart, .from = model.rest_position};
  const Eigen::VectorXd position = moved(model.rest_position, 0.3);
  constexpr double kStep = 1e-6;  // metres; the energy is of second order, so that differences have round-off alone
  for (const int triangle : {0, 17, 63}) {
    const LeastMotionTerms terms = least_motion_terms(model, motion, position, triangle);
    for (int k = 0; k < 9; ++k) {
      const int unknown = 3 * model.surface[triangle][k / 3] + k % 3;
      Eigen::VectorXd plus = position, minus = position;
      plus[unknown] += kStep;
      minus[unknown] -= kStep;
      const LeastMotionTerms above = least_motion_terms(model, motion, plus, triangle);
      const LeastMotionTerms below = least_motion_terms(model, motion, minus, triangle);
      const double largest_force = terms.gradient.cwiseAbs().maxCoeff();
      EXPECT_NEAR((above.energy - below.energy) / (2 * kStep), terms.gradient[k], 1e-9 * largest_force);
      const Eigen::Matrix<double, 9, 1> column = (above.gradient - below.gradient) / (2 * kStep);
      EXPECT_LT((column - terms.hessian.col(k)).norm(), 1e-9 * terms.hessian.norm());
    }
  }
}

/// Joule, that the least motion of the whole dome adds at a position.
double energy_added(const BodyModel& model, const Eigen::VectorXd& position) {
  EquilibriumProblem problem;
  problem.fluids = {{.mode = FluidMode::kGivenPressure}};
  const Eigen::VectorXd pressure = Eigen::VectorXd::Zero(1);
  EquilibriumTerms free, held;
  evaluate(model, problem, position, pressure, false, free);
  problem.least_motion = {.part = kPart, .from = model.rest_position};
  evaluate(model, problem, position, pressure, false, held);
  EXPECT_EQ(held.strain_energy, free.strain_energy);
  return held.elastic - free.elastic;
}

TEST(LeastMotion, CostsAMotionAsAWholeItsStiffnessTimesHalfTheSquareOfTheWay) {
  const BodyModel model = slack_dome();
  const Eigen::Vector3d way(3e-3, -1e-3, 2e-3);
  Eigen::VectorXd position = model.rest_position;
  for (int v = 0; v < model.vertices(); ++v) position.segment<3>(3 * v) += way;
  const double expected = 0.5 * kPart * model.wall_stiffness * way.squaredNorm();
  EXPECT_NEAR(energy_added(model, position), expected, 1e-12 * expected);
}

TEST(LeastMotion, CostsAStretchThatOfAnEvenTension) {
  // Twice as large all over: |grad (x - from)|^2 = 2, and at its corners x - from = from.
  const BodyModel model = slack_dome();
  double springs = 0;
  for (int t = 0; t < model.triangles(); ++t) {
    for (const int vertex : model.surface[t]) {
      springs += model.rest[t].area / 3 * model.rest_position.segment<3>(3 * vertex).squaredNorm();
    }
  }
  const double expected = kPart * model.wall_stiffness * (model.rest_area + 0.5 * springs / model.rest_area);
  EXPECT_NEAR(energy_added(model, 2 * model.rest_position), expected, 1e-9 * expected);
}

TEST(LeastMotion, IsLeftToInertiaWhereThereIsAny) {
  const BodyModel model = slack_dome();
  EquilibriumProblem problem;
  problem.fluids = {{.mode = FluidMode::kGivenPressure}};
  problem.inertia = 1e4;
  problem.inertia_target = model.rest_position;
  const Eigen::VectorXd position = moved(model.rest_position, 0.9), pressure = Eigen::VectorXd::Zero(1);
  EquilibriumTerms with, without;
  evaluate(model, problem, position, pressure, true, without);
  problem.least_motion = {.part = kPart, .from = model.rest_position};
  evaluate(model, problem, position, pressure, true, with);
  EXPECT_EQ(with.elastic, without.elastic);
  EXPECT_EQ(with.gradient, without.gradient);
  EXPECT_EQ(with.values, without.values);
}

}  // namespace
}  // namespace thinwall
