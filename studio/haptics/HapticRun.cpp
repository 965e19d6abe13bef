#include "studio/haptics/HapticRun.hpp"

#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>

#include "engine/haptics/RealTimeThread.hpp"
#include "engine/simulation/SimulationFailure.hpp"
#include "studio/director/ScenarioRun.hpp"
#include "studio/haptics/CoarseScenario.hpp"
#include "studio/haptics/PeerDevice.hpp"
#include "studio/haptics/TrajectoryFile.hpp"
#include "studio/recorder/Messages.hpp"
#include "studio/scenario/InputError.hpp"

namespace thinwall {
namespace {

constexpr double kPeriod = 1e-3;  // seconds, of a tick

/// Seconds for which the empty loop runs, at most.
constexpr double kEmptyLoop = 2;

/// Wall triangles up to which a body is solved fully in each tick unless the user says otherwise.
constexpr int kFullTriangles = 150;

/// Residual of the solver behind the loop, over the largest force: below what a hand feels by orders of magnitude.
constexpr double kTolerance = 1e-4;

/// The same where solutions make local models: it leaves less of the force than models do, and looser ones let some
/// solutions go astray.
constexpr double kLocalTolerance = 1e-3;

/// Triangles of a coarse wall, which is solved some two hundred times a second: of fewer the force is uneven where the
/// tool is dragged, more are late where it turns.
constexpr int kCoarseTriangles = 2100;

/// Seconds within which a coarse wall at rest has to answer. Under a hand it answers later by up to ten times, and the
/// farther the hand has gone by then, the longer the next answer takes: a wall that is too large for its processor
/// never catches up.
constexpr double kQuickAnswer = 2.8e-3;
constexpr int kTimedAnswers = 7;  // of which the median counts

/// Metres from which a tool is answered when that is timed, wherever it begins.
constexpr double kAnyReach = 1;

/// Seconds in which a newer correction of a coarse body's force takes over.
constexpr double kCorrectionBlending = 20e-3;

/// Seconds for which a driver is waited for.
constexpr double kPatience = 60;

/// Seconds that a session may last without `duration`.
constexpr double kLongestSession = 600;

/// Least way for which a local model is good, metres, and the parts of it that a secant needs, that the hand's
/// motion may be foreseen, and that the tool goes in one solution.
constexpr double kLeastReach = 2e-3;
constexpr double kShortestWay = 0.04;
constexpr double kForeseenWay = 0.5;
constexpr double kMostWay = 0.25;
constexpr double kForesight = 0.06;  // seconds

/// Part of the reach at which models of tools that go through the wall end: where they do, the solution is late.
constexpr double kReachIntoWall = 0.25;

/// Part of the reach that the tool goes in a solution of a fine body.
constexpr double kMostFineWay = 0.25;

ToolPose pose_of(const SnapshotTool& tool) {
  return {.tip = Eigen::Vector3d(tool.tip[0], tool.tip[1], tool.tip[2]),
          .direction = Eigen::Vector3d(tool.direction[0], tool.direction[1], tool.direction[2]),
          .axis = Eigen::Vector3d(tool.axis[0], tool.axis[1], tool.axis[2]),
          .opening = tool.opening};
}

/// A motion with the forces of the full solution along it.
struct FullSolution {
  std::vector<TimedPose> poses;
  std::vector<TimedForce> forces;

  void note(const ScenarioRun& run, int tool) {
    poses.push_back({.time = run.time(), .pose = pose_of(run.snapshot().tools[tool])});
    forces.push_back({.time = run.time(), .force = run.record().tools[tool].force});
  }
};

FullSolution play(const Scenario& scenario, int tool, double duration) {
  FullSolution solution;
  ScenarioRun run(scenario);
  solution.note(run, tool);
  while (run.time() < duration && run.step()) solution.note(run, tool);
  return solution;
}

FullSolution play_driven(const Scenario& scenario, int tool, Trajectory motion) {
  FullSolution solution;
  ScenarioRun run(scenario);
  solution.note(run, tool);
  while (const auto pose = motion.pose_at(run.time() + scenario.simulation.time_step)) {
    run.step_driven(1, {.index = tool, .pose = *pose});
    solution.note(run, tool);
  }
  return solution;
}

int tool_index(const HapticPlan& plan) {
  const std::vector<ToolDefinition>& tools = plan.scenario.tools;
  if (tools.empty()) {
    throw InputErrors({{SourceLocation{.file = plan.scenario.file}, "tools: a hand needs a tool, and none is there"}});
  }
  if (plan.tool.empty()) return 0;
  for (std::size_t k = 0; k < tools.size(); ++k) {
    if (tools[k].name == plan.tool) return static_cast<int>(k);
  }
  std::string names;
  for (const ToolDefinition& tool : tools) names += (names.empty() ? "" : ", ") + tool.name;
  throw InputErrors({{SourceLocation{.file = plan.scenario.file},
                      fmt::format("--tool {}: no tool has that name; the scenario has {}", plan.tool, names)}});
}

/// The scenario as the solver behind the loop steps it: by ticks.
Scenario in_ticks(Scenario scenario, double tolerance) {
  scenario.simulation.time_step = kPeriod;
  scenario.simulation.tolerance = std::max(scenario.simulation.tolerance, tolerance);
  scenario.simulation.extrapolates = true;
  return scenario;
}

double reach_of(const ToolDefinition& tool) {
  return std::max({kLeastReach, tool.radius, 0.5 * tool.thickness});
}

bool goes_through_wall(const ToolDefinition& tool) {
  return tool.kind == ToolKind::kNeedle || tool.kind == ToolKind::kScalpel;
}

/// Whether it may go through the wall or take hold of it.
bool changes_wall(const ToolDefinition& tool) {
  return goes_through_wall(tool) || tool.kind == ToolKind::kForceps;
}

RefreshOptions refresh_options(const ToolDefinition& tool) {
  const double reach = reach_of(tool);
  RefreshOptions options{.reach = reach, .shortest_way = kShortestWay * reach, .most_way = kMostWay * reach};
  // Where a tool goes through the wall no pose may be tried that the hand does not reach.
  if (goes_through_wall(tool)) options.reach *= kReachIntoWall;
  if (changes_wall(tool)) return options;
  options.foresight = kForesight;
  options.foreseen_way = kForeseenWay * reach;
  return options;
}

/// The body behind the loop, as the loop sees it.
class LoopedRun {
 public:
  LoopedRun(const Scenario& scenario, int tool, double tolerance)
      : run_(in_ticks(scenario, tolerance)), tool_(tool), reach_(reach_of(scenario.tools[tool])) {}

  /// A tick to where the hand begins, before time counts: the first step of a thread takes its memory, which takes ten
  /// times as long as the step.
  void warm_up(const ToolPose& pose) {
    run_.step_driven(1, {.index = tool_, .pose = pose});
    ticks_ = 1;
  }

  FullAnswer solve(double time, const ToolPose& pose, bool responds) {
    const long until = std::lround(time / kPeriod);
    const int count = static_cast<int>(until == 0 ? 0 : std::max(until - ticks_, 1L));
    const long cuts = run_.cuts();
    if (count > 0) run_.step_driven(count, {.index = tool_, .pose = pose});
    ticks_ += count;
    FullAnswer answer;
    if (responds) {
      answer.response = run_.respond(tool_, std::max(count, 1) * kPeriod, 2 * reach_);
    } else {
      answer.response.force = run_.record().tools[tool_].force;
    }
    answer.event = run_.cuts() != cuts;
    return answer;
  }

  /// Seconds that a tick and its answer take while the tool rests.
  double answer_duration() {
    const double begin = loop_clock();
    run_.step_driven(1, {.index = tool_, .pose = first_pose()});
    run_.respond(tool_, kPeriod, kAnyReach);
    return loop_clock() - begin;
  }

  int triangles() const {
    int sum = 0;
    for (const SnapshotSurface& surface : run_.snapshot().surfaces) sum += triangles_of(surface);
    return sum;
  }
  ToolPose first_pose() const { return pose_of(run_.snapshot().tools[tool_]); }

 private:
  static int triangles_of(const SnapshotSurface& surface) {
    return static_cast<int>(surface.topology->triangles.size());
  }

  ScenarioRun run_;
  int tool_;
  double reach_;
  long ticks_ = 0;
};

/// What moves the tool.
struct Hand {
  std::unique_ptr<HapticDevice> device;
  const PeerDevice* driver = nullptr;  // the device, where it is one
  ToolPose begin;
  double duration = 0;  // seconds
  FullSolution known;   // of the timeline's own motion
};

Hand make_hand(const HapticPlan& plan, int tool, const ToolPose& first) {
  Hand hand;
  if (plan.peer) {
    auto peer = std::make_unique<PeerDevice>(*plan.peer);
    print_message(stderr, "waiting for a driver at {}\n", plan.peer->string());
    hand.begin = peer->wait_for_first_pose(kPatience, plan.throw_if_interrupted);
    hand.duration = plan.duration.value_or(kLongestSession);
    hand.driver = peer.get();
    hand.device = std::move(peer);
    return hand;
  }
  std::vector<TimedPose> moments;
  if (plan.trajectory) {
    moments = read_trajectory(*plan.trajectory, first);
  } else {
    hand.known = play(plan.scenario, tool, plan.duration.value_or(kLongestSession));
    moments = hand.known.poses;
  }
  hand.begin = moments.front().pose;
  hand.duration = std::min(moments.back().time, plan.duration.value_or(kLongestSession));
  if (!plan.duration && moments.back().time > kLongestSession) {
    print_message(stderr, "the motion lasts {:g} s, of which the first {:g} s are felt; --for asks for more\n",
                  moments.back().time, kLongestSession);
  }
  hand.device = std::make_unique<Trajectory>(std::move(moments));
  return hand;
}

std::vector<TimedPose> motion_of(const std::vector<HapticTick>& ticks) {
  std::vector<TimedPose> moments;
  for (const HapticTick& tick : ticks) moments.push_back({.time = tick.time, .pose = tick.pose});
  return moments;
}

/// The scenario with coarse walls that this machine solves in time, where the tool leaves walls whole; nothing where
/// none is far coarser.
std::optional<Scenario> leading_scenario(const Scenario& scenario, int tool) {
  if (changes_wall(scenario.tools[tool])) return {};
  std::optional<Scenario> coarse = coarse_scenario(scenario, kCoarseTriangles);
  if (!coarse) return {};
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  LoopedRun timed(*coarse, tool, kLocalTolerance);
  timed.warm_up(timed.first_pose());
  std::array<double, kTimedAnswers> durations;
  for (double& duration : durations) duration = timed.answer_duration();
  std::ranges::nth_element(durations, durations.begin() + kTimedAnswers / 2);
  const int triangles = affordable_triangles(kCoarseTriangles, durations[kTimedAnswers / 2], kQuickAnswer);
  return triangles < kCoarseTriangles ? coarse_scenario(scenario, triangles) : coarse;
}

/// The force of a coarse body at each tick, and what the body itself gives beyond it as often as it can be solved.
void run_corrected(const HapticPlan& plan, const Scenario& coarse, LoopedRun& looped, int tool, Hand& hand,
                   const HapticLoopOptions& options, HapticReport& report) {
  // Both solvers have a processor of their own: neither may take the other's for a part of its sums.
  const tbb::global_control one_each(tbb::global_control::max_allowed_parallelism, 1);
  const ToolDefinition& definition = plan.scenario.tools[tool];
  LoopedRun leading(coarse, tool, kLocalTolerance), beside(coarse, tool, kTolerance);
  report.coarse_triangles = leading.triangles();
  const HandState begin{.time = 0, .pose = hand.begin};
  CorrectionRefresh corrections(
      [&](double time, const ToolPose& pose) {
        return ForcePair{.fine = looped.solve(time, pose, false).response.force,
                         .coarse = beside.solve(time, pose, false).response.force};
      },
      begin, kMostFineWay * reach_of(definition));
  ModelRefresh refresh([&](double time, const ToolPose& pose) { return leading.solve(time, pose, true); }, begin,
                       refresh_options(definition));
  LocalForce source(refresh, options.blending);
  CorrectedForce corrected(source, corrections, kCorrectionBlending);
  report.record = run_haptic_loop(*hand.device, corrected, options);
  refresh.finish();
  corrections.finish();
  report.refresh = refresh.figures();
  report.corrections = corrections.figures();
}

void run_loop(const HapticPlan& plan, const Scenario* coarse, LoopedRun& looped, int tool, Hand& hand,
              HapticReport& report) {
  HapticLoopOptions options{.period = kPeriod, .duration = hand.duration, .real_time = plan.real_time};
  options.passivity.way_before = reach_of(plan.scenario.tools[tool]);
  options.is_interrupted = [&] {
    try {
      plan.throw_if_interrupted();
    } catch (...) {
      return true;
    }
    return false;
  };
  try {
    if (report.forces == "local" && coarse != nullptr) {
      run_corrected(plan, *coarse, looped, tool, hand, options, report);
    } else if (report.forces == "full") {
      FullForce source([&](double time, const ToolPose& pose) { return looped.solve(time, pose, false); },
                       reach_of(plan.scenario.tools[tool]), [&] { looped.warm_up(hand.begin); });
      report.record = run_haptic_loop(*hand.device, source, options);
    } else {
      ModelRefresh refresh([&](double time, const ToolPose& pose) { return looped.solve(time, pose, true); },
                           {.time = 0, .pose = hand.begin}, refresh_options(plan.scenario.tools[tool]));
      LocalForce source(refresh, options.blending);
      report.record = run_haptic_loop(*hand.device, source, options);
      refresh.finish();
      report.refresh = refresh.figures();
    }
  } catch (const SimulationFailure& failure) {
    report.failure = failure.what();
  }
}

/// Ticks without any work.
HapticRecord run_empty_loop(const HapticPlan& plan, const ToolPose& pose) {
  NoForce nothing;
  Trajectory still({{.time = 0, .pose = pose}, {.time = kEmptyLoop, .pose = pose}});
  const double duration = std::min(kEmptyLoop, plan.duration.value_or(kEmptyLoop));
  return run_haptic_loop(still, nothing, {.period = kPeriod, .duration = duration, .real_time = plan.real_time});
}

}  // namespace

HapticReport run_haptics(const HapticPlan& plan) {
  const int tool = tool_index(plan);
  std::optional<LoopedRun> looped(std::in_place, plan.scenario, tool, kTolerance);
  // Before a driver comes, which would not be listened to meanwhile.
  const HapticRecord empty = run_empty_loop(plan, looped->first_pose());
  const std::optional<Scenario> coarse =
      plan.forces == HapticForces::kFull ? std::nullopt : leading_scenario(plan.scenario, tool);
  Hand hand = make_hand(plan, tool, looped->first_pose());
  HapticReport report{.scenario = plan.scenario.name, .tool = plan.scenario.tools[tool].name};
  report.asked_for_real_time = plan.real_time;
  report.empty = empty;
  report.triangles = looped->triangles();
  const bool small = report.triangles <= kFullTriangles;
  report.forces =
      plan.forces == HapticForces::kFull || (plan.forces == HapticForces::kAuto && small) ? "full" : "local";
  if (report.forces == "local" && !coarse) looped.emplace(plan.scenario, tool, kLocalTolerance);
  run_loop(plan, coarse ? &*coarse : nullptr, *looped, tool, hand, report);
  if (hand.driver != nullptr) report.driver = hand.driver->figures();
  plan.throw_if_interrupted();
  if (report.record.ticks.empty()) return report;
  report.duration = report.record.ticks.back().time;
  if (hand.known.forces.empty()) {
    hand.known = play_driven(plan.scenario, tool, Trajectory(motion_of(report.record.ticks)));
  }
  report.error = force_error(report.record.ticks, hand.known.forces);
  report.full_change = largest_change(hand.known.forces, kPeriod);
  return report;
}

}  // namespace thinwall
