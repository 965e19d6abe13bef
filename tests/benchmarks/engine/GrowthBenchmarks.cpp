// How time and memory grow with the mesh, and what fits a picture at 30 Hz: filled balls that a ball palpates or a
// blade cuts, at the residuals that the pictures need.

#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "tests/benchmarks/engine/FilledBall.hpp"

namespace thinwall {
namespace {

constexpr double kFrame = 1.0 / 30;  // seconds
constexpr double kSpeed = 15e-3;     // metres / second

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// A ball of 4 mm that goes 5 mm deep and back, over and over.
struct Palpation {
  Body body;
  std::vector<ToolPose> poses;
  double crown = 0, way = 0;  // metres

  Palpation(int triangles, double tolerance)
      : body(filled_ball(triangles), {sphere_tool(4e-3)}, {.analysis = Analysis::kDynamic, .tolerance = tolerance}) {
    body.settle();
    for (int v = 0; v < body.model().vertices(); ++v) {
      crown = std::max(crown, body.state().equilibrium.position[3 * v + 2]);
    }
    poses = {pose_at({1e-3, 0.5e-3, crown})};
  }

  void step(double duration) {
    constexpr double kDepth = 5e-3;
    const std::vector<ToolPose> from = poses;
    way += kSpeed * duration;
    poses[0].tip.z() = crown - std::abs(std::remainder(way, 2 * kDepth));
    body.advance(from, poses, duration);
  }
};

/// Steps of a picture each; of what all of the process has taken by then the peak memory.
void GrowingPalpation(benchmark::State& state) {
  Palpation palpation(static_cast<int>(state.range(0)), 1e-3);
  for (int k = 0; k < 3; ++k) palpation.step(kFrame);
  double iterations = 0;
  for (auto _ : state) {
    palpation.step(kFrame);
    iterations += palpation.body.report().newton_iterations;
  }
  state.counters["iterations"] = benchmark::Counter(iterations, benchmark::Counter::kAvgIterations);
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  state.counters["peak_MiB"] = static_cast<double>(usage.ru_maxrss) / 1024;
}
BENCHMARK(GrowingPalpation)->Arg(1280)->Arg(5120)->Arg(20480)->Arg(98000)->Iterations(8)->Unit(benchmark::kMillisecond);

/// A second of dynamic palpation in steps of a picture, and by which part of its largest motion the wall is then off
/// from where steps sixteen times as short bring it.
void PalpationSecond(benchmark::State& state) {
  constexpr int kFiner = 16;
  const double step = 1 / static_cast<double>(state.range(1));
  const int steps = static_cast<int>(state.range(1));
  for (auto _ : state) {
    Palpation coarse(static_cast<int>(state.range(0)), 1e-3);
    const Eigen::VectorXd start = coarse.body.state().equilibrium.position;
    std::vector<Eigen::VectorXd> reached;
    const auto begin = std::chrono::steady_clock::now();
    for (int k = 0; k < steps; ++k) {
      coarse.step(step);
      reached.push_back(coarse.body.state().equilibrium.position);
    }
    state.SetIterationTime(seconds_since(begin));
    // The finer run over the first quarter of the second only, into the wall: it costs sixteen times as much.
    Palpation fine(static_cast<int>(state.range(0)), 1e-3);
    double off = 0, largest = 0;
    for (int k = 0; k < steps / 4; ++k) {
      for (int part = 0; part < kFiner; ++part) fine.step(step / kFiner);
      const Eigen::VectorXd& right = fine.body.state().equilibrium.position;
      off = std::max(off, (reached[k] - right).lpNorm<Eigen::Infinity>());
      largest = std::max(largest, (right - start).lpNorm<Eigen::Infinity>());
    }
    state.counters["error_percent"] = 100 * off / largest;
  }
}
BENCHMARK(PalpationSecond)
    ->ArgNames({"triangles", "steps"})
    ->Args({5120, 30})
    ->Args({5120, 60})
    ->UseManualTime()
    ->Iterations(1)
    ->Unit(benchmark::kSecond);

struct CutFrames {
  double whole = 0, longest = 0;  // seconds
  int steps = 0, cuts = 0;
  double residual = 0;  // largest that was taken, over the largest force
};

/// A blade that goes on through the wall, `aside` metres beside the middle.
void cut_frames(int triangles, double aside, CutFrames& frames) {
  constexpr int kSteps = 16;
  Body body(filled_ball(triangles),
            {{.name = "blade", .kind = ToolKind::kScalpel, .length = 20e-3, .width = 4e-3, .thickness = 0.3e-3}},
            {.analysis = Analysis::kDynamic, .tolerance = 1e-3});
  body.settle();
  std::vector<ToolPose> poses = {pose_at({-8e-3, aside, 12e-3})};
  body.follow_blade(0, poses);
  for (int k = -2; k < kSteps; ++k) {
    const double travel = k < 0 ? 1e-3 : kSpeed * kFrame;
    const std::vector<ToolPose> from = poses;
    poses[0].tip.x() += travel;
    BodyInput input;
    input.blade = BladeInput{.tool = 0, .travel = travel, .direction = Eigen::Vector3d::UnitX()};
    const auto begin = std::chrono::steady_clock::now();
    body.advance(from, poses, kFrame, input);
    const bool has_cut = body.follow_blade(0, poses).has_value();
    const double taken = seconds_since(begin);
    if (k < 0) continue;
    ++frames.steps;
    frames.whole += taken;
    frames.longest = std::max(frames.longest, taken);
    frames.cuts += has_cut;
    frames.residual = std::max(frames.residual, body.report().residual_share);
  }
}

/// A blade that goes on through the wall by half a millimetre a picture, contact and one cut in each step, on eight
/// ways beside each other, as chance has a say in how slack lips lie: the mean of the steps, the longest, and the
/// largest residual that was taken.
void CutFrame(benchmark::State& state) {
  constexpr int kWays = 8;
  constexpr double kBetweenWays = 0.4e-3;  // metres
  for (auto _ : state) {
    CutFrames frames;
    for (int way = 0; way < kWays; ++way) {
      cut_frames(static_cast<int>(state.range(0)), kBetweenWays * (way - 1.25), frames);
    }
    state.SetIterationTime(frames.whole / frames.steps);
    state.counters["longest_ms"] = 1e3 * frames.longest;
    state.counters["cuts"] = static_cast<double>(frames.cuts) / frames.steps;
    state.counters["residual"] = frames.residual;
  }
}
BENCHMARK(CutFrame)->Arg(320)->Arg(720)->Arg(1280)->Arg(5120)->Arg(6480)->UseManualTime()->Iterations(1)->Unit(
    benchmark::kMillisecond);

}  // namespace
}  // namespace thinwall
