#include "engine/equilibrium/Newton.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/mesh/Shapes.hpp"
#include "tests/engine/simulation/OpenBodies.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

/// Orders of convergence log(r2 / r1) / log(r1 / r0) near the solution: of iterations that start below `near` of the
/// first residual and end above round-off.
std::vector<double> orders(const std::vector<double>& history, double near, double round_off) {
  std::vector<double> result;
  for (std::size_t k = 2; k < history.size(); ++k) {
    if (history[k - 1] < near && history[k] > round_off && history[k - 1] < history[k - 2]) {
      result.push_back(std::log(history[k] / history[k - 1]) / std::log(history[k - 1] / history[k - 2]));
    }
  }
  return result;
}

void print(const char* name, const NewtonResult& result) {
  std::printf("%s:", name);
  for (const double residual : result.residual_history) std::printf(" %.1e", residual);
  std::printf(" N, %d shifted\n", result.shifted_iterations);
}

struct Case {
  const char* name;
  Material material;
  FluidMode fluid;
  double stretch;  // of volume^(1/3), where Newton starts
  double jump;     // factor of the stretch to go
};

TEST(Newton, ConvergesQuadraticallyNearTheSolutionBelowAndBeyondTheLimitPoint) {
  const std::vector<Case> cases = {
      {"neo-Hookean, below the limit point", neo_hookean(20e3), FluidMode::kIncompressible, 1.1, 1.1},
      {"neo-Hookean, at the limit point", neo_hookean(20e3), FluidMode::kIncompressible, 1.35, 1.05},
      {"neo-Hookean, beyond the limit point", neo_hookean(20e3), FluidMode::kIncompressible, 1.8, 1.1},
      {"Mooney-Rivlin", mooney_rivlin(8e3, 2e3), FluidMode::kIncompressible, 1.3, 1.1},
      {"St. Venant-Kirchhoff", st_venant_kirchhoff(60e3, 0.3), FluidMode::kIncompressible, 1.1, 1.1},
      {"neo-Hookean, compressible fluid", neo_hookean(20e3), FluidMode::kCompressible, 1.1, 1.1},
      {"neo-Hookean, compressible fluid beyond the limit point", neo_hookean(20e3), FluidMode::kCompressible, 1.8, 1.1},
      {"neo-Hookean, given pressure", neo_hookean(20e3), FluidMode::kGivenPressure, 1.05, 1.03},
  };
  for (const Case& one : cases) {
    SCOPED_TRACE(one.name);
    const BodyModel model = make_body_model(make_body(make_sphere(20e-3, 320), 1e-3, one.material));
    Newton newton(model);
    EquilibriumProblem problem;
    problem.fluids = {{}};
    problem.hold_rigid_motions = true;
    EquilibriumState state{.position = model.rest_position, .pressure = {}, .rigid_reaction = {}};
    for (double stretch = 1.05; stretch < one.stretch + 1e-9; stretch += 0.05) {
      problem.fluids[0].fluid_volume = model.rest_volume * std::pow(stretch, 3);
      ASSERT_TRUE(newton.solve(problem, state, {}).converged);
    }
    const double pressure = state.pressure[0];
    problem.fluids[0].mode = one.fluid;
    problem.fluids[0].fluid_volume = model.rest_volume * std::pow(one.stretch * one.jump, 3);
    problem.fluids[0].bulk_modulus = 200e3;
    problem.fluids[0].pressure = one.fluid == FluidMode::kGivenPressure ? pressure * one.jump : 0;
    const NewtonResult result = newton.solve(problem, state, {.tolerance = 1e-13, .maximum_iterations = 40});
    print(one.name, result);
    const double scale = newton.terms().largest_force;
    EXPECT_EQ(result.shifted_iterations, 0);
    // Residuals below 1e-13 of a single force are round-off.
    const std::vector<double> seen = orders(result.residual_history, 0.1 * scale, 1e-12 * scale);
    ASSERT_FALSE(seen.empty());
    for (const double order : seen) EXPECT_GT(order, 1.8);
    EXPECT_LT(result.residual, 1e-9 * scale);
  }
}

/// A ball of 2 880 triangles that stands still under pressure.
struct RestingBall {
  BodyModel model = make_body_model(make_body(make_sphere(20e-3, 2880), 1e-3, neo_hookean(20e3)));
  Newton newton{model};
  EquilibriumProblem problem;
  EquilibriumState state{.position = model.rest_position, .pressure = {}, .rigid_reaction = {}};

  RestingBall() {
    problem.fluids = {{}};
    problem.fluids[0].fluid_volume = 1.1 * model.rest_volume;
    problem.hold_rigid_motions = true;
    EXPECT_TRUE(newton.solve(problem, state, {}).converged);
    problem.hold_rigid_motions = false;
    problem.inertia_target = state.position;
  }
};

TEST(Newton, ConvergesWithFactorsInSinglePrecisionAsWithThoseInDoubleWhereThereIsInertia) {
  // Of steps of 5 ms and of 160 ms. The residual falls by its square; without refinement the light ball takes 3.
  for (const auto& [inertia, iterations] : {std::pair(4e4, 4), std::pair(40.0, 2)}) {
    RestingBall ball;
    ball.problem.inertia = inertia;
    for (Eigen::Index k = 2; k < ball.state.position.size(); k += 3) ball.problem.inertia_target[k] *= 0.8;
    const NewtonResult result = ball.newton.solve(ball.problem, ball.state, {.tolerance = 1e-13});
    print("flattened ball", result);
    EXPECT_EQ(result.iterations, iterations);
    EXPECT_EQ(result.in_single_precision, result.factorisations);
    EXPECT_EQ(result.factorisations, result.iterations);
    EXPECT_EQ(result.shifted_iterations, 0);
  }
}

TEST(Newton, GoesOnInDoublePrecisionWhereSingleWillNotDo) {
  // Inertia that is 1e-9 of the wall's stiffness, and nothing else, holds the ball in space.
  RestingBall ball;
  ball.problem.inertia = 1e-2;
  const Eigen::VectorXd before = ball.state.position;
  for (Eigen::Index k = 0; k < before.size(); k += 3) ball.problem.inertia_target[k] += 1e-3;
  const NewtonResult result = ball.newton.solve(ball.problem, ball.state, {.tolerance = 1e-13});
  print("ball that nothing holds", result);
  EXPECT_EQ(result.shifted_iterations, 0);
  EXPECT_EQ(result.in_single_precision, 1);
  EXPECT_EQ(result.factorisations, result.iterations + 1);
  const double missed = (ball.state.position - ball.problem.inertia_target).cwiseAbs().maxCoeff();
  EXPECT_LT(missed, 1e-9);  // seen: 9e-11, the round-off of the wall's forces over springs that are so soft
}

TEST(Newton, FollowsABentWayInWholeSteps) {
  // A strip without bending stiffness, held at one end, that soft springs draw to where it is turned about that end: on
  // the way there, an arc, the residual hardly falls, and the energy as the curvature foresees.
  BodyDefinition strip = make_body(make_sheet(20e-3, 4e-3, 60), 1e-3, neo_hookean(20e3));
  strip.fluid.kind = FluidKind::kNone;
  strip.fixed = {{.region = PlaneRegion{.axis = 0, .at = -10e-3}}};
  const BodyModel model = make_body_model(strip);
  const Eigen::Vector3d held(-10e-3, 0, 0);
  int iterations = 0;
  for (const double angle : {0.5, 1.0, 1.5, 2.0}) {
    const Eigen::AngleAxisd turn(-angle, Eigen::Vector3d::UnitY());
    EquilibriumProblem problem;
    problem.inertia = 1e3;
    problem.inertia_target = model.rest_position;
    for (int v = 0; v < model.vertices(); ++v) {
      problem.inertia_target.segment<3>(3 * v) = held + turn * (model.rest_position.segment<3>(3 * v) - held);
    }
    EquilibriumState state{.position = model.rest_position, .pressure = {}, .rigid_reaction = {}};
    const NewtonResult result = Newton(model).solve(problem, state, {.maximum_iterations = 400});
    EXPECT_TRUE(result.converged);
    // There neither wall nor springs have any energy. Seen: 5e-14, round-off of forces over springs that are so soft.
    EXPECT_LT((state.position - problem.inertia_target).cwiseAbs().maxCoeff(), 1e-10);
    iterations += result.iterations;
  }
  std::printf("%d iterations\n", iterations);
  EXPECT_LT(iterations, 475);  // 417; 533 where steps are halved after the fifteenth
}

TEST(Newton, DentsASlackFlatMembraneInAsManyStepsOnFineTrianglesAsOnCoarseOnes) {
  for (const int triangles : {500, 2000, 8000}) {
    BodyDefinition drum = make_body(make_disc(30e-3, triangles), 0.1e-3, st_venant_kirchhoff(1e6, 1.0 / 3));
    drum.fluid.kind = FluidKind::kNone;
    drum.fixed = {{.region = BoundaryRegion{}}};
    const BodyModel model = make_body_model(drum);
    int near = 0;
    const auto distance = [&](int t) { return corners_of(model.surface[t], model.rest_position)[0].norm(); };
    for (int t = 0; t < model.triangles(); ++t) {
      if (distance(t) < distance(near)) near = t;
    }
    Attachment attachment{.tool = 0, .vertices = model.surface[near], .weights = {1, 0, 0}};
    attachment.target = material_point(attachment, model.rest_position) - Eigen::Vector3d(0, 0, 0.5e-3);
    EquilibriumProblem problem;
    problem.attachments = {attachment};
    EquilibriumState state{.position = model.rest_position, .pressure = {}, .rigid_reaction = {}};
    const NewtonResult result = Newton(model).solve(problem, state, {});
    print("dented drum", result);
    EXPECT_TRUE(result.converged) << result.reason;
    EXPECT_LE(result.iterations, 12);  // 7, 8 and 9; with springs in place of the tension 12, 25 and none within 60
  }
}

TEST(Newton, ConvergesQuadraticallyWithAnAttachedPoint) {
  BodyDefinition definition = pressurised_hemisphere(256, 0);
  const BodyModel model = make_body_model(definition);
  Newton newton(model);
  EquilibriumProblem problem;
  problem.fluids = {{}};
  problem.fluids[0].fluid_volume = 1.1 * model.rest_volume;
  EquilibriumState state{.position = model.rest_position, .pressure = {}, .rigid_reaction = {}};
  ASSERT_TRUE(newton.solve(problem, state, {}).converged);
  int near = 0;
  for (int t = 0; t < model.triangles(); ++t) {
    const auto height = [&](int triangle) { return corners_of(model.surface[triangle], state.position)[0].z(); };
    if (height(t) > height(near)) near = t;
  }
  Attachment attachment{.tool = 0, .vertices = model.surface[near], .weights = {0.5, 0.3, 0.2}};
  attachment.target = material_point(attachment, state.position) + Eigen::Vector3d(0.2e-3, 0, -1e-3);
  problem.attachments = {attachment};
  const NewtonResult result = newton.solve(problem, state, {.tolerance = 1e-13, .maximum_iterations = 40});
  print("attached point", result);
  // The multiplier of the point is found to about 1e-11 of itself, which ends the squaring a little earlier.
  const double scale = newton.terms().largest_force;
  const std::vector<double> seen = orders(result.residual_history, 0.1 * scale, 1e-10 * scale);
  ASSERT_FALSE(seen.empty());
  for (const double order : seen) EXPECT_GT(order, 1.8);
  EXPECT_LT((material_point(problem.attachments[0], state.position) - attachment.target).norm(), 1e-12);
}

TEST(Newton, AttachedPointReachesItsTargetAndTheFluidItsVolume) {
  const BodyModel model = make_body_model(pressurised_hemisphere(64, 0));
  Newton newton(model);
  EquilibriumProblem problem;
  problem.fluids = {{}};
  problem.fluids[0].fluid_volume = 1.02 * model.rest_volume;
  Attachment attachment{.tool = 0, .vertices = model.surface[0], .weights = {0.2, 0.3, 0.5}};
  attachment.target = material_point(attachment, model.rest_position) + Eigen::Vector3d(0, 0, -2e-3);
  problem.attachments = {attachment};
  EquilibriumState state{.position = model.rest_position, .pressure = {}, .rigid_reaction = {}};
  const NewtonResult result = newton.solve(problem, state, {});
  ASSERT_TRUE(result.converged) << result.reason;
  EXPECT_LT((material_point(problem.attachments[0], state.position) - attachment.target).norm(), 1e-12);
  EXPECT_NEAR(enclosed_volumes(model, state.position)[0], problem.fluids[0].fluid_volume, 1e-11 * model.rest_volume);
  for (Eigen::Index k = 0; k < state.position.size(); ++k) {
    if (model.fixed[k]) {
      EXPECT_EQ(state.position[k], model.rest_position[k]);
    }
  }
}

TEST(Newton, TakesNoTriangleOfAShellThroughItsNeighbour) {
  BodyDefinition definition = make_body(make_sheet(20e-3, 20e-3, 2), 1e-3, neo_hookean(20e3));
  definition.fluid.kind = FluidKind::kNone;
  definition.model = WallModel::kShell;
  const BodyModel model = make_body_model(definition);
  Newton newton(model);
  // The corners beyond the diagonal edge, folded about it by some angle.
  const auto folded = [&](double angle) {
    Eigen::VectorXd position = model.rest_position;
    const Eigen::AngleAxisd turn(angle, Eigen::Vector3d(1, 1, 0).normalized());
    for (int v = 0; v < model.vertices(); ++v) {
      const Eigen::Vector3d corner = position.segment<3>(3 * v);
      if (corner.x() > corner.y() + 1e-3) position.segment<3>(3 * v) = turn * corner;
    }
    return position;
  };
  const Eigen::VectorXd open = folded(2.9), through = folded(3.3), closed = folded(3.1);
  EXPECT_EQ(newton.safe_fraction(open, closed - open), 1);
  const double fraction = newton.safe_fraction(open, through - open);
  EXPECT_GT(fraction, 0.3);
  // The way goes straight on: half of it comes to where the triangles lie upon each other, give or take its sagitta.
  EXPECT_LT(fraction, 0.65);
}

TEST(Newton, SaysWhyItStoppedAndLeavesTheBestStateReached) {
  const BodyModel model = make_body_model(pressurised_hemisphere(64, 0));
  Newton newton(model);
  EquilibriumProblem problem;
  problem.fluids = {{}};
  problem.fluids[0].fluid_volume = 1.3 * model.rest_volume;
  EquilibriumState state{.position = model.rest_position, .pressure = {}, .rigid_reaction = {}};
  const NewtonResult result = newton.solve(problem, state, {.tolerance = 1e-9, .maximum_iterations = 1});
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.reason, "no convergence within 1 iterations");
  EXPECT_TRUE(state.position.allFinite());
}

TEST(Newton, MissesLessTheNearerAStateIsToEquilibriumAndWithoutBoundBeyondTheLaw) {
  constexpr double kLimit = 30;  // of the first invariant less 3
  BodyDefinition body = pressurised_hemisphere(64, 0);
  body.materials = {{find_wall_law("gent"), {20e3, kLimit}}};
  const BodyModel model = make_body_model(body);
  Newton newton(model);
  EquilibriumProblem problem;
  problem.fluids = {{}};
  problem.fluids[0].fluid_volume = 1.3 * model.rest_volume;
  const EquilibriumState start{.position = model.rest_position, .pressure = {}, .rigid_reaction = {}};
  EquilibriumState solution = start;
  ASSERT_TRUE(newton.solve(problem, solution, {.tolerance = 1e-12, .maximum_iterations = 40}).converged);
  const double scale = newton.terms().largest_force;
  double before = std::numeric_limits<double>::infinity();
  for (const double part : {0.25, 0.5, 0.75}) {
    EquilibriumState state = solution;
    state.position = start.position + part * (solution.position - start.position);
    const double missed = newton.missed(problem, state);
    EXPECT_LT(missed, before);
    before = missed;
  }
  EXPECT_GT(before, 0.01 * scale);
  EXPECT_LT(newton.missed(problem, solution), 1e-10 * scale);
  EquilibriumState torn = solution;
  torn.position *= 2 * std::sqrt(kLimit);
  EXPECT_EQ(newton.missed(problem, torn), std::numeric_limits<double>::infinity());
}

TEST(Equilibrium, TermsAreTheSameWithoutTheHessian) {
  // A shell that is heavy and moves, one chamber full and one open.
  BodyDefinition filled = make_body(make_sphere(20e-3, 320), 1e-3, neo_hookean(20e3));
  filled.model = WallModel::kShell;
  for (const BodyDefinition& definition : {filled, open_ball(320, 200)}) {
    const BodyModel model = make_body_model(definition);
    EquilibriumProblem problem;
    problem.fluids = {{}};
    problem.gravity = {1, 2, -9};
    problem.fluid_inertia = {{.factor = 1e6, .target = Eigen::Vector3d(1e-9, 2e-9, 0)}};
    const Eigen::VectorXd position = 1.1 * model.rest_position, pressure = Eigen::VectorXd::Constant(1, 250);
    EquilibriumTerms whole, forces;
    evaluate(model, problem, position, pressure, true, whole);
    evaluate(model, problem, position, pressure, false, forces);
    EXPECT_TRUE(whole.has_hessian());
    EXPECT_FALSE(forces.has_hessian());
    EXPECT_EQ(forces.gradient, whole.gradient);
    EXPECT_EQ(forces.elastic + forces.bending + forces.gravity, whole.elastic + whole.bending + whole.gravity);
    EXPECT_EQ(forces.volume_gradient, whole.volume_gradient);
    EXPECT_EQ(forces.moment_gradient, whole.moment_gradient);
    EXPECT_EQ(forces.load_of_pressure(), whole.load_of_pressure());
    EXPECT_EQ(forces.largest_force, whole.largest_force);
  }
}

TEST(Newton, EndsTheStepsOfABodyThatLeaksWithTheFactorsThatItHas) {
  // Each step ends with one that no new factor is made for, or two.
  Body body(open_ball(320, 400), {}, dynamic());
  body.settle();
  int iterations = 0, factorisations = 0;
  for (int step = 0; step < 20; ++step) {
    body.advance({}, {}, 5e-3);
    iterations += body.report().newton_iterations;
    factorisations += body.report().factorisations;
    EXPECT_LE(body.report().residual_share, 1e-9);
  }
  std::printf("%d iterations, %d factorisations\n", iterations, factorisations);
  EXPECT_LE(factorisations, iterations - 20);
}

}  // namespace
}  // namespace thinwall
