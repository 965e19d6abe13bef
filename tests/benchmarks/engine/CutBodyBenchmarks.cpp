// What a whole step of an incision costs, and its parts, on pressurised balls of 5120 and 20480 triangles.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "engine/cutting/SurfacePath.hpp"
#include "engine/cutting/SurfaceTrace.hpp"
#include "engine/simulation/CutTransfer.hpp"
#include "tests/benchmarks/engine/FilledBall.hpp"

namespace thinwall {
namespace {

void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Arg(5120)->Arg(20480)->Unit(benchmark::kMillisecond);
}

constexpr int kSteps = 16;  // after those that begin the cut
constexpr double kStep = 1.0 / 60;

/// What a blade goes on by in a step, metres: at 60 mm/s, and at the 20 mm/s of a scalpel that is drawn.
constexpr double kFast = 1e-3, kDrawn = 1e-3 / 3;

/// A blade that has begun to cut a ball and goes on over its crown.
struct Incision {
  double travel;  // metres, in a step
  Body body;
  std::vector<ToolPose> poses = {pose_at({-8e-3, 0.7e-3, 12e-3})};

  Incision(int triangles, Analysis analysis, WallModel model = WallModel::kMembrane, double of_step = kFast)
      : travel(of_step),
        body(filled_ball(triangles, model),
             {{.name = "blade", .kind = ToolKind::kScalpel, .length = 20e-3, .width = 4e-3, .thickness = 0.3e-3}},
             SimulationOptions{.analysis = analysis}) {
    body.settle();
    body.follow_blade(0, poses);
    for (double way = 0; way < 1.5 * kFast; way += travel) {
      move();
      cut();
    }
  }

  void move() {
    const std::vector<ToolPose> from = poses;
    poses[0].tip.x() += travel;
    BodyInput input;
    input.blade = BladeInput{.tool = 0, .travel = travel, .direction = Eigen::Vector3d::UnitX()};
    body.advance(from, poses, kStep, input);
  }

  bool cut() { return body.follow_blade(0, poses).has_value(); }
};

void IncisionStep(benchmark::State& state, Analysis analysis, double travel) {
  double iterations = 0, cuts = 0;
  std::unique_ptr<Incision> incision;
  int left = 0;
  for (auto _ : state) {
    if (left-- == 0) {
      state.PauseTiming();
      incision = std::make_unique<Incision>(static_cast<int>(state.range(0)), analysis, WallModel::kMembrane, travel);
      left = kSteps - 1;
      state.ResumeTiming();
    }
    incision->move();
    cuts += incision->cut();
    iterations += incision->body.report().newton_iterations;
  }
  state.counters["iterations"] = benchmark::Counter(iterations, benchmark::Counter::kAvgIterations);
  state.counters["cuts"] = benchmark::Counter(cuts, benchmark::Counter::kAvgIterations);
}
BENCHMARK_CAPTURE(IncisionStep, dynamic, Analysis::kDynamic, kFast)->Apply(sizes)->Iterations(kSteps);
BENCHMARK_CAPTURE(IncisionStep, dynamic_drawn, Analysis::kDynamic, kDrawn)->Apply(sizes)->Iterations(kSteps);
BENCHMARK_CAPTURE(IncisionStep, quasi_static, Analysis::kQuasiStatic, kFast)->Apply(sizes)->Iterations(kSteps);
BENCHMARK_CAPTURE(IncisionStep, quasi_static_drawn, Analysis::kQuasiStatic, kDrawn)->Apply(sizes)->Iterations(kSteps);

/// The cut of such a step alone: trace, cut, state and solver carried over.
void CutOfStep(benchmark::State& state, WallModel model) {
  Incision incision(static_cast<int>(state.range(0)), Analysis::kDynamic, model);
  double cuts = 0;
  for (auto _ : state) {
    state.PauseTiming();
    incision.move();
    state.ResumeTiming();
    cuts += incision.cut();
  }
  state.counters["cuts"] = benchmark::Counter(cuts, benchmark::Counter::kAvgIterations);
}
BENCHMARK_CAPTURE(CutOfStep, membrane, WallModel::kMembrane)->Apply(sizes)->Iterations(kSteps);
BENCHMARK_CAPTURE(CutOfStep, shell, WallModel::kShell)->Arg(5120)->Unit(benchmark::kMillisecond)->Iterations(kSteps);

/// What of it depends on the topology, done again by itself: the way traced, the wall cut, and the model, the solver's
/// order and the pairs of parts brought up to it. Without the forces in the new wall.
void TopologyOfCut(benchmark::State& state) {
  const BodyModel model = make_body_model(filled_ball(static_cast<int>(state.range(0))));
  const Eigen::VectorXd& position = model.rest_position;
  CutSurface surface(model.definition.mesh);
  const Newton newton(model);
  const SurfaceView wall{.triangles = model.definition.mesh.triangles, .position = position};
  const auto place = [&](double x) {
    return *project(wall, Eigen::Vector3d(x, 0.7e-3, 1), Eigen::Vector3d(0, 0, -1), 2).point;
  };
  // From a tip within the wall, as each step but the first goes on.
  CutOptions options;
  for (int v = 0; v < model.vertices(); ++v) options.placement.push_back(position.segment<3>(3 * v));
  const Cut before = surface.cut({.points = trace(wall, place(-8e-3), place(0)).pieces.front().points}, options);
  const BodyModel begun = make_body_model(cut_definition(model, surface, before));
  const Newton begun_newton(begun, newton, begun.rest_position);
  const SurfaceView begun_wall{.triangles = begun.definition.mesh.triangles, .position = begun.rest_position};
  options.placement.clear();
  for (int v = 0; v < begun.vertices(); ++v) options.placement.push_back(begun.rest_position.segment<3>(3 * v));
  const SurfacePoint tip = point_at(begun_wall.triangles, *before.tip);
  const SurfacePoint next = *project(begun_wall, Eigen::Vector3d(kFast, 0.7e-3, 1), Eigen::Vector3d(0, 0, -1), 2).point;
  for (auto _ : state) {
    state.PauseTiming();
    auto to_cut = std::make_unique<CutSurface>(surface);
    state.ResumeTiming();
    const SurfaceTrace way = trace(begun_wall, tip, next);
    const Cut cut = to_cut->cut({.from = before.tip, .points = way.pieces.front().points}, options);
    const BodyModel after = make_body_model(cut_definition(begun, *to_cut, cut));
    const Newton carried(after, begun_newton, after.rest_position);
    benchmark::DoNotOptimize(&carried);
  }
}
BENCHMARK(TopologyOfCut)->Apply(sizes)->UseRealTime();

void BuildModel(benchmark::State& state) {
  const BodyDefinition definition = filled_ball(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(make_body_model(definition).rest_area);
}
BENCHMARK(BuildModel)->Apply(sizes);

void BuildNewton(benchmark::State& state, WallModel wall) {
  const BodyModel model = make_body_model(filled_ball(static_cast<int>(state.range(0)), wall));
  for (auto _ : state) Newton newton(model);
}
BENCHMARK_CAPTURE(BuildNewton, membrane, WallModel::kMembrane)->Apply(sizes);
BENCHMARK_CAPTURE(BuildNewton, shell, WallModel::kShell)->Apply(sizes);

}  // namespace
}  // namespace thinwall
