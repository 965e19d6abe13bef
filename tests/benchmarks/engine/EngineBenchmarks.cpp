// What a step of the engine costs, part by part, on spheres of 1280, 5120 and 20480 triangles.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

#include "engine/mesh/Shapes.hpp"
#include "engine/tool/ToolSolids.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Arg(1280)->Arg(5120)->Arg(20480)->Unit(benchmark::kMillisecond);
}

/// A ball under 300 Pa whose lower third is held.
BodyDefinition ball(int triangles) {
  BodyDefinition body = make_body(make_sphere(20e-3, triangles), 1e-3, neo_hookean(20e3));
  body.fluid.initial_pressure = 300;
  body.fixed = {{.region = BelowRegion{.axis = 2, .at = -10e-3}}};
  return body;
}

EquilibriumProblem filled(const BodyModel& model) {
  EquilibriumProblem problem;
  problem.fluids = {{.fluid_volume = 1.1 * model.rest_volume}};
  return problem;
}

void Evaluate(benchmark::State& state) {
  const BodyModel model = make_body_model(ball(static_cast<int>(state.range(0))));
  const EquilibriumProblem problem = filled(model);
  EquilibriumTerms terms;
  for (auto _ : state) {
    evaluate(model, problem, model.rest_position, Eigen::VectorXd::Constant(1, 300), true, terms);
    benchmark::DoNotOptimize(terms.elastic);
  }
  // Each value is read and written, what belongs to a triangle is read: all of it once.
  const double per_triangle = sizeof(MembraneRest) + sizeof(TriangleAddresses) + sizeof(Eigen::Vector3i);
  state.counters["bytes"] = 2.0 * sizeof(double) * model.pattern.nonzeros() + per_triangle * model.triangles();
}
BENCHMARK(Evaluate)->Apply(sizes);

/// The same with jaws that have closed over the crown, which rims and corners keep out of: forty solids.
void EvaluateBetweenJaws(benchmark::State& state) {
  const BodyModel model = make_body_model(ball(static_cast<int>(state.range(0))));
  const ToolDefinition forceps{
      .name = "grip", .kind = ToolKind::kForceps, .length = 0.03, .width = 6e-3, .thickness = 2e-3, .opening = 0.01};
  ToolPose pose = pose_at({0, 0, 0.016});
  pose.opening = 4e-3;
  EquilibriumProblem problem = filled(model);
  for (const ToolSolid& solid : contact_solids(forceps, pose)) {
    problem.solids.push_back({.solid = solid,
                              .range = 1e-4,
                              .dip = 1e-4,
                              .hugging_pressure = 1e3,
                              .forces = std::vector<double>(model.sites.size(), 0)});
  }
  EquilibriumTerms terms;
  for (auto _ : state) {
    evaluate(model, problem, model.rest_position, Eigen::VectorXd::Constant(1, 300), true, terms);
    benchmark::DoNotOptimize(terms.elastic);
  }
}
BENCHMARK(EvaluateBetweenJaws)->Apply(sizes)->UseRealTime();

/// The matrix of a wall stretched by a tenth.
std::vector<double> stretched_matrix(const BodyModel& model) {
  EquilibriumTerms terms;
  evaluate(model, filled(model), 1.1 * model.rest_position, Eigen::VectorXd::Zero(1), true, terms);
  std::vector<double> values = terms.values;
  for (const int entry : model.diagonal_entries) values[entry] += 1e-3 * model.wall_stiffness;
  return values;
}

void Analyse(benchmark::State& state) {
  const BodyModel model = make_body_model(ball(static_cast<int>(state.range(0))));
  for (auto _ : state) SparseFactor factor(model.pattern);
}
BENCHMARK(Analyse)->Apply(sizes);

void Factorize(benchmark::State& state) {
  const BodyModel model = make_body_model(ball(static_cast<int>(state.range(0))));
  const std::vector<double> values = stretched_matrix(model);
  SparseFactor factor(model.pattern);
  for (auto _ : state) {
    if (!factor.factorize(values)) state.SkipWithError("the matrix is not positive definite");
  }
  state.counters["operations"] = factor.operations();
}
BENCHMARK(Factorize)->Apply(sizes);

void FactorizeIndefinite(benchmark::State& state) {
  const BodyModel model = make_body_model(ball(static_cast<int>(state.range(0))));
  const std::vector<double> values = stretched_matrix(model);
  SparseFactor factor(model.pattern);
  for (auto _ : state) benchmark::DoNotOptimize(factor.factorize(values, true));
  state.counters["operations"] = factor.operations();
}
BENCHMARK(FactorizeIndefinite)->Apply(sizes);

void Solve(benchmark::State& state) {
  const BodyModel model = make_body_model(ball(static_cast<int>(state.range(0))));
  SparseFactor factor(model.pattern);
  if (!factor.factorize(stretched_matrix(model))) state.SkipWithError("the matrix is not positive definite");
  const Eigen::VectorXd right = model.rest_position;
  Eigen::VectorXd solved;
  for (auto _ : state) {
    solved = right;
    factor.solve(solved);
  }
}
BENCHMARK(Solve)->Apply(sizes);

/// Steps of 16.7 ms of a ball of 4 mm that is pressed 5 mm deep at 15 mm/s and drawn back, over and over.
void PalpationStep(benchmark::State& state) {
  SimulationOptions options;
  Body body(ball(static_cast<int>(state.range(0))), {sphere_tool(4e-3)}, options);
  body.settle();
  constexpr double kStep = 1.0 / 60, kSpeed = 15e-3, kDepth = 5e-3;
  double crown = 0;
  for (int v = 0; v < body.model().vertices(); ++v) {
    crown = std::max(crown, body.state().equilibrium.position[3 * v + 2]);
  }
  std::vector<ToolPose> from = {pose_at({1e-3, 0.5e-3, crown})}, to = from;
  double way = 0, iterations = 0;
  for (auto _ : state) {
    way += kSpeed * kStep;
    to[0].tip.z() = crown - std::abs(std::remainder(way, 2 * kDepth));
    body.advance(from, to, kStep);
    from = to;
    iterations += body.report().newton_iterations;
  }
  state.counters["iterations"] = benchmark::Counter(iterations, benchmark::Counter::kAvgIterations);
}
BENCHMARK(PalpationStep)->Apply(sizes);

/// What contact of the wall with itself costs where nothing is near: the look at every vertex that each evaluation
/// takes, and the listing of near pairs once the wall has moved by a tenth of an edge.
void SelfContactScan(benchmark::State& state) {
  const BodyModel model = make_body_model(ball(static_cast<int>(state.range(0))));
  SelfContact contact(self_contact_of(model));
  SelfContactTerms terms;
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(model.rest_position.size());
  for (auto _ : state) {
    contact.evaluate(model.rest_position, terms, gradient);
    benchmark::DoNotOptimize(terms.energy);
  }
}
BENCHMARK(SelfContactScan)->Apply(sizes);

void SelfContactListing(benchmark::State& state) {
  const BodyModel model = make_body_model(ball(static_cast<int>(state.range(0))));
  SelfContact contact(self_contact_of(model));
  SelfContactTerms terms;
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(model.rest_position.size());
  double stretch = 1;
  for (auto _ : state) {
    stretch = stretch == 1 ? 1.1 : 1;
    contact.evaluate(stretch * model.rest_position, terms, gradient);
    benchmark::DoNotOptimize(terms.energy);
  }
}
BENCHMARK(SelfContactListing)->Apply(sizes);

/// The longest motion without contact, of a body blown up by half: every pair of boxes on the way is looked at.
void SelfContactLongMotion(benchmark::State& state) {
  const BodyModel model = make_body_model(ball(static_cast<int>(state.range(0))));
  SelfContact contact(self_contact_of(model));
  const Eigen::VectorXd motion = 0.5 * model.rest_position;
  for (auto _ : state) benchmark::DoNotOptimize(contact.safe_fraction(model.rest_position, motion));
}
BENCHMARK(SelfContactLongMotion)->Apply(sizes);

/// Pressed flat onto itself: evaluation with contacts everywhere.
void SelfContactFlattened(benchmark::State& state) {
  const BodyModel model = make_body_model(ball(static_cast<int>(state.range(0))));
  SelfContact contact(self_contact_of(model));
  SelfContactTerms terms;
  Eigen::VectorXd position = model.rest_position, gradient = Eigen::VectorXd::Zero(position.size());
  for (Eigen::Index k = 2; k < position.size(); k += 3) position[k] *= 0.01;
  for (auto _ : state) {
    contact.evaluate(position, terms, gradient);
    benchmark::DoNotOptimize(terms.energy);
  }
  state.counters["pairs"] = static_cast<double>(terms.folds.size());
}
BENCHMARK(SelfContactFlattened)->Apply(sizes);

}  // namespace
}  // namespace thinwall
