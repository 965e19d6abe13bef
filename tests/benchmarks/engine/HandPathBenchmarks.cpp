// Full solutions along the path of a hand, a tick of 1 ms each, on hemispheres of growing size: a ball of 6 mm that is
// pressed 5 mm deep at 50 mm/s, held, dragged 20 mm along and drawn back. The time is the 99th percentile of a tick's.

#include <benchmark/benchmark.h>
#include <time.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <vector>

#include "engine/haptics/CorrectionRefresh.hpp"
#include "engine/haptics/ForceBlend.hpp"
#include "engine/haptics/LocalModel.hpp"
#include "engine/mesh/Shapes.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

constexpr double kTick = 1e-3;            // seconds
constexpr double kSpeed = 50e-3;          // metres / second
constexpr double kTolerance = 1e-4;       // residual over the largest force, at every tick
constexpr double kModelTolerance = 1e-3;  // the same of solutions that make local models
constexpr int kCoarseTriangles = 2100;
constexpr double kDepth = 5e-3;        // metres
constexpr double kDrag = 20e-3;        // metres
constexpr double kWithdrawal = 15e-3;  // metres
constexpr int kHold = 200;             // ticks

/// A filled hemisphere of 25 mm on its held base.
BodyDefinition hemisphere(int triangles) {
  BodyDefinition body = make_body(make_hemisphere(25e-3, triangles), 1.5e-3, neo_hookean(30e3));
  body.fluid.initial_pressure = 400;
  body.fixed = {fixed_group("base")};
  return body;
}

/// What the calling thread has computed for, seconds: where others share the machine, the wall clock tells of them.
double processor_time() {
  timespec now = {};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// A body under the hand, and what its ticks took.
struct HandPath {
  Body body;
  std::vector<ToolPose> poses = {pose_at({-8e-3, 1e-3, 30e-3})};
  std::vector<double> seconds = {};          // (ticks)
  std::vector<double> processor = {};        // (ticks), seconds
  std::vector<double> iterations = {};       // (ticks)
  std::vector<ToolPose> reached = {};        // (ticks)
  std::vector<Eigen::Vector3d> forces = {};  // (ticks), newton
  double factorisations = 0, halvings = 0;
  ToolPose start = {};  // where it touches first

  explicit HandPath(int triangles, double tolerance = kTolerance)
      : body(hemisphere(triangles), {sphere_tool(6e-3)},
             {.analysis = Analysis::kQuasiStatic, .tolerance = tolerance, .extrapolates = true}) {
    body.settle();
  }

  void tick(const Eigen::Vector3d& motion) {
    const std::vector<ToolPose> from = poses;
    poses[0].tip += motion;
    const auto begin = std::chrono::steady_clock::now();
    const double before = processor_time();
    body.advance(from, poses, kTick);
    processor.push_back(processor_time() - before);
    seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    iterations.push_back(body.report().newton_iterations);
    reached.push_back(poses[0]);
    forces.push_back(body.state().contacts[0].force);
    factorisations += body.report().factorisations;
    halvings += body.report().halvings;
  }

  /// In one step; seconds that the processor took.
  double go_to(const ToolPose& pose) {
    const std::vector<ToolPose> from = poses;
    poses[0] = pose;
    const double before = processor_time();
    body.advance(from, poses, kTick);
    return processor_time() - before;
  }

  void move(const Eigen::Vector3d& way) {
    const int ticks = static_cast<int>(way.norm() / (kSpeed * kTick) + 0.5);
    for (int k = 0; k < ticks; ++k) tick(way / ticks);
  }

  void play() {
    while (!body.state().contacts[0].touching) tick({0, 0, -kSpeed * kTick});
    start = poses[0];
    seconds.clear();
    processor.clear();
    iterations.clear();
    reached.clear();
    forces.clear();
    factorisations = halvings = 0;
    move({0, 0, -kDepth});
    for (int k = 0; k < kHold; ++k) tick(Eigen::Vector3d::Zero());
    move({kDrag, 0, 0});
    move({0, 0, kWithdrawal});
  }
};

/// What a hand is given that moves through ticks, from models that a solver beside it makes.
struct ModelledForces {
  double largest_error = 0, mean_error = 0, largest_force = 0;  // newton
  double seconds = 0;                                           // mean of a model
  int models = 0, worst_tick = 0;
};

/// Where the hand will be `time` seconds after tick k, if it goes on as it moves, at most `way` metres away.
ToolPose foreseen(const std::vector<ToolPose>& poses, std::size_t k, double time, double way) {
  const Eigen::Vector3d velocity =
      k > 0 ? Eigen::Vector3d((poses[k].tip - poses[k - 1].tip) / kTick) : Eigen::Vector3d(0, 0, -kSpeed);
  if (time * velocity.norm() > way) time = way / velocity.norm();
  ToolPose pose = poses[k];
  pose.tip += time * velocity;
  return pose;
}

/// A fine body, and a coarse one at the same poses, that correct the force of another coarse one.
struct Correction {
  static constexpr double kBlending = 20e-3;  // seconds
  static constexpr double kMostWay = 1.5e-3;  // metres

  HandPath fine, coarse;
  ForceBlend blend{kBlending};
  ForceCorrection in_use = {}, next = {};
  double ready = 0;  // seconds
  int solutions = 0;

  Correction(int triangles, int coarse_triangles, const ToolPose& start) : fine(triangles), coarse(coarse_triangles) {
    fine.poses = coarse.poses = {start};
  }

  Eigen::Vector3d corrected(double time, const ToolPose& hand, const Eigen::Vector3d& force) {
    if (solutions > 0 && ready <= time) {
      const Eigen::Vector3d given = blend.force(time, in_use.of(force));
      in_use = next;
      blend.take_over(time, given, in_use.of(force));
    }
    if (ready <= time) solve(time, hand);
    return force + blend.force(time, in_use.of(force));
  }

  void solve(double time, ToolPose hand) {
    const Eigen::Vector3d way = hand.tip - fine.poses[0].tip;
    if (way.norm() > kMostWay) hand.tip = fine.poses[0].tip + kMostWay / way.norm() * way;
    ready = time + fine.go_to(hand) + coarse.go_to(hand);
    const Eigen::Vector3d forces[] = {fine.body.state().contacts[0].force, coarse.body.state().contacts[0].force};
    next = {.difference = forces[0] - forces[1], .coarse = forces[1].norm()};
    ++solutions;
  }
};

/// The solver beside the loop takes as long as its processor time: what else the machine does is left out.
ModelledForces follow_with_models(HandPath& path, const std::vector<ToolPose>& poses,
                                  const std::vector<Eigen::Vector3d>& forces, Correction* correction) {
  constexpr double kReach = 6e-3, kShortestWay = 0.04 * kReach, kForesight = 0.06, kForeseenWay = 0.5 * kReach;
  constexpr double kMostWay = 0.25 * kReach;
  ModelledForces result;
  LocalModelMaker maker(kReach, kShortestWay);
  LocalModel model, next;
  ForceBlend blend(4e-3);
  ToolPose at = path.poses[0];
  double ready = 0, duration = 0;
  bool under_way = false;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const double time = static_cast<double>(k) * kTick;
    if (under_way && ready <= time) {
      const Eigen::Vector3d given = blend.force(time, model.force_at(poses[k]));
      model = next;
      blend.take_over(time, given, model.force_at(poses[k]));
      under_way = false;
    }
    if (!under_way) {
      ToolPose pose = foreseen(poses, k, std::min(duration, kForesight), kForeseenWay);
      const double before = processor_time();
      const double way = (pose.tip - at.tip).norm();
      if (result.models > 0 && way > kMostWay) pose.tip = at.tip + kMostWay / way * (pose.tip - at.tip);
      path.body.advance(std::vector{at}, std::vector{pose}, kTick);
      at = pose;
      maker.make(path.body.respond(0, std::vector{at}, kTick, 2 * kReach), time, false, next);
      duration = processor_time() - before;
      result.seconds += duration;
      ++result.models;
      ready = time + duration;
      under_way = true;
      if (k == 0) {
        model = next;
        under_way = false;
      }
    }
    Eigen::Vector3d given = blend.force(time, model.force_at(poses[k]));
    if (correction != nullptr) given = correction->corrected(time, poses[k], given);
    const double error = (given - forces[k]).norm();
    if (error > result.largest_error) result.worst_tick = static_cast<int>(k);
    result.largest_error = std::max(result.largest_error, error);
    result.mean_error += error * error / static_cast<double>(poses.size());
    result.largest_force = std::max(result.largest_force, forces[k].norm());
  }
  result.mean_error = std::sqrt(result.mean_error);
  result.seconds /= result.models;
  return result;
}

double percentile(std::vector<double> values, double part) {
  const auto rank = static_cast<std::size_t>(part * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[rank];
}

double sum(const std::vector<double>& values) {
  double whole = 0;
  for (const double value : values) whole += value;
  return whole;
}

void HandPathTick(benchmark::State& state) {
  for (auto _ : state) {
    HandPath path(static_cast<int>(state.range(0)));
    path.play();
    state.SetIterationTime(percentile(path.seconds, 0.99));
    const auto ticks = static_cast<double>(path.seconds.size());
    state.counters["p50_ms"] = 1e3 * percentile(path.seconds, 0.5);
    state.counters["processor_p99_ms"] = 1e3 * percentile(path.processor, 0.99);
    state.counters["processor_p50_ms"] = 1e3 * percentile(path.processor, 0.5);
    state.counters["mean_ms"] = 1e3 * sum(path.seconds) / ticks;
    state.counters["largest_ms"] = 1e3 * percentile(path.seconds, 1);
    state.counters["iterations"] = sum(path.iterations) / ticks;
    state.counters["most_iterations"] = percentile(path.iterations, 1);
    state.counters["factorisations"] = path.factorisations / ticks;
    state.counters["halvings"] = path.halvings;
  }
}
BENCHMARK(HandPathTick)
    ->Arg(64)
    ->Arg(256)
    ->Arg(576)
    ->Arg(1024)
    ->Arg(2500)
    ->UseManualTime()
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

void HandPathModel(benchmark::State& state) {
  for (auto _ : state) {
    const int triangles = static_cast<int>(state.range(0));
    const bool is_led = triangles > 1.4 * kCoarseTriangles;
    HandPath full(triangles), modelled(is_led ? kCoarseTriangles : triangles, kModelTolerance);
    full.play();
    modelled.poses = {full.start};
    std::optional<Correction> correction;
    if (is_led) correction.emplace(triangles, kCoarseTriangles, full.start);
    const ModelledForces result =
        follow_with_models(modelled, full.reached, full.forces, correction ? &*correction : nullptr);
    if (correction) state.counters["corrections"] = correction->solutions;
    state.SetIterationTime(result.seconds);
    state.counters["error_percent"] = 100 * result.largest_error / result.largest_force;
    state.counters["rms_percent"] = 100 * result.mean_error / result.largest_force;
    state.counters["largest_force_N"] = result.largest_force;
    state.counters["worst_tick"] = result.worst_tick;
    state.counters["models"] = result.models;
  }
}
BENCHMARK(HandPathModel)
    ->Arg(1024)
    ->Arg(2500)
    ->Arg(10000)
    ->UseManualTime()
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace thinwall
