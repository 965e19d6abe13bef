#include "engine/haptics/HapticLoop.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <optional>
#include <stdexcept>
#include <thread>
#include <vector>

#include "engine/haptics/Trajectory.hpp"

namespace thinwall {
namespace {

std::vector<TimedPose> straight_in(double seconds, double depth) {
  ToolPose end;
  end.tip.z() = -depth;
  return {{.time = 0, .pose = {}}, {.time = seconds, .pose = end}};
}

/// A wall at z = 0 that pushes as a spring, newton / metre.
ToolResponse spring(const ToolPose& pose, double stiffness) {
  ToolResponse response;
  response.pose = pose;
  if (pose.tip.z() >= 0) {
    response.ahead = {.gap = pose.tip.z(), .normal = -Eigen::Vector3d::UnitZ(), .stiffness = stiffness};
    return response;
  }
  SiteResponse& site = response.sites.emplace_back();
  site.force = -stiffness * pose.tip.z();
  site.normal = -Eigen::Vector3d::UnitZ();
  site.force_by_motion[2] = -stiffness;
  response.force = -site.force * site.normal;
  return response;
}

TEST(HapticLoopTest, ASpringIsFeltAsASpringThroughItsLocalModels) {
  Trajectory hand(straight_in(0.3, 3e-3));
  ModelRefresh refresh([](double, const ToolPose& pose) { return FullAnswer{.response = spring(pose, 200)}; },
                       {.time = 0, .pose = {}}, {.reach = 5e-3, .shortest_way = 1e-4, .most_way = 5e-3});
  LocalForce source(refresh, 4e-3);
  const HapticRecord record = run_haptic_loop(hand, source, {.duration = 1, .real_time = false});
  refresh.finish();
  ASSERT_GT(record.ticks.size(), 10U);
  for (const HapticTick& tick : record.ticks) {
    EXPECT_NEAR(tick.force.z(), -200 * tick.pose.tip.z(), 1e-9) << tick.time;
  }
  EXPECT_GT(refresh.figures().solutions, 1);
}

TEST(HapticLoopTest, ModelsThatDisagreeAreFeltWithoutAJump) {
  Trajectory hand(straight_in(0.3, 3e-3));
  int call = 0;
  ModelRefresh refresh(
      [&](double, const ToolPose& pose) { return FullAnswer{.response = spring(pose, ++call % 2 == 0 ? 100 : 300)}; },
      {.time = 0, .pose = {}}, {.reach = 5e-3, .shortest_way = 1, .most_way = 5e-3});
  LocalForce source(refresh, 4e-3);
  const HapticRecord record = run_haptic_loop(hand, source, {.duration = 1, .real_time = false});
  refresh.finish();
  for (std::size_t k = 1; k < record.ticks.size(); ++k) {
    const double ticks = (record.ticks[k].time - record.ticks[k - 1].time) / 1e-3;
    // The springs differ by 0.6 N at most; a blend goes by 3/2 of that in 4 ticks at most, the springs by 3 mN a tick.
    EXPECT_LE((record.ticks[k].force - record.ticks[k - 1].force).norm(), ticks * (0.6 * 1.5 / 4 + 0.004));
  }
}

TEST(HapticLoopTest, ASolverThatFailsEndsTheLoopAndIsHeardOf) {
  Trajectory hand(straight_in(5, 3e-3));
  int call = 0;
  ModelRefresh refresh(
      [&](double, const ToolPose& pose) {
        if (++call > 3) throw std::runtime_error("no equilibrium");
        return FullAnswer{.response = spring(pose, 100)};
      },
      {.time = 0, .pose = {}}, {.reach = 5e-3, .shortest_way = 1, .most_way = 5e-3});
  LocalForce source(refresh, 4e-3);
  const HapticRecord record = run_haptic_loop(hand, source, {.duration = 5, .real_time = false});
  EXPECT_TRUE(record.solver_failed);
  EXPECT_LT(record.ticks.size(), 4000U);
  EXPECT_THROW(refresh.finish(), std::runtime_error);
}

TEST(HapticLoopTest, FullForcesAreSolvedInEachTick) {
  Trajectory hand(straight_in(0.1, 1e-3));
  FullForce source([](double, const ToolPose& pose) { return FullAnswer{.response = spring(pose, 50)}; }, 1e-3);
  const HapticRecord record = run_haptic_loop(hand, source, {.duration = 1, .real_time = false});
  for (const HapticTick& tick : record.ticks) EXPECT_DOUBLE_EQ(tick.force.z(), -50 * tick.pose.tip.z());
}

TEST(HapticLoopTest, AFullSolverWarmsUpOnceInTheThreadOfTheLoopBeforeTheFirstTick) {
  Trajectory hand(straight_in(5e-3, 1e-4));
  std::vector<std::thread::id> threads;
  int warmed_up = 0, solved_cold = 0;
  FullForce source(
      [&](double, const ToolPose& pose) {
        solved_cold += warmed_up == 0;
        threads.push_back(std::this_thread::get_id());
        return FullAnswer{.response = spring(pose, 50)};
      },
      1e-3,
      [&] {
        ++warmed_up;
        threads.push_back(std::this_thread::get_id());
      });
  run_haptic_loop(hand, source, {.duration = 1, .real_time = false});
  EXPECT_EQ(warmed_up, 1);
  EXPECT_EQ(solved_cold, 0);
  ASSERT_GT(threads.size(), 2U);
  for (const std::thread::id thread : threads) EXPECT_EQ(thread, threads.front());
}

TEST(HapticLoopTest, AHandThatIsSetElsewhereIsFollowedByNoMoreThanItsWayInEachTick) {
  std::vector<TimedPose> moments = straight_in(0.1, 5);
  moments.insert(moments.begin() + 1, {.time = 50e-3, .pose = {}});
  moments[2].time = 51e-3;
  moments.push_back({.time = 0.1, .pose = moments[2].pose});
  Trajectory hand(moments);
  std::vector<double> depths;
  FullForce source(
      [&](double, const ToolPose& pose) {
        depths.push_back(-pose.tip.z());
        return FullAnswer{.response = spring(pose, 50)};
      },
      1e-3);
  run_haptic_loop(hand, source, {.duration = 1, .real_time = false});
  ASSERT_GT(depths.size(), 10U);
  for (std::size_t k = 1; k < depths.size(); ++k) EXPECT_LE(depths[k] - depths[k - 1], 1e-3 * (1 + 1e-9));
  EXPECT_GT(depths.back(), 5e-3);
}

/// Takes far longer than a period in one tick, and keeps the velocities that it was told.
class SlowOnce final : public ForceSource {
 public:
  Eigen::Vector3d force(HapticTick& tick, const Eigen::Vector3d& velocity) override {
    speeds.push_back(velocity.norm());
    if (tick.time > 20e-3 && !was_slow_) {
      std::this_thread::sleep_for(std::chrono::milliseconds(30));
      was_slow_ = true;
    }
    return Eigen::Vector3d::Zero();
  }
  std::vector<double> speeds;  // metres / second

 private:
  bool was_slow_ = false;
};

TEST(HapticLoopTest, AHandIsNoFasterWhereTicksWereLeftOut) {
  Trajectory hand(straight_in(0.1, 5e-3));
  SlowOnce source;
  const HapticRecord record = run_haptic_loop(hand, source, {.duration = 1, .real_time = false});
  EXPECT_GE(record.skipped, 25);
  ASSERT_GT(source.speeds.size(), 10U);
  for (std::size_t k = 1; k < source.speeds.size(); ++k) EXPECT_NEAR(source.speeds[k], 0.05, 1e-9) << k;
}

/// Counts how often it is let go.
class LetGoCount final : public HapticDevice {
 public:
  std::optional<ToolPose> pose_at(double time) override {
    return time > 5e-3 ? std::nullopt : std::optional(ToolPose{});
  }
  void feel(double, const Eigen::Vector3d&) override {}
  void let_go() override { ++count; }
  int count = 0;
};

TEST(HapticLoopTest, TheHandIsLetGoOnceHoweverTheLoopEnds) {
  LetGoCount hand;
  NoForce nothing;
  run_haptic_loop(hand, nothing, {.duration = 1, .real_time = false});
  EXPECT_EQ(hand.count, 1);
  FullForce failing([](double, const ToolPose&) -> FullAnswer { throw std::runtime_error("no equilibrium"); }, 1e-3);
  EXPECT_THROW(run_haptic_loop(hand, failing, {.duration = 1, .real_time = false}), std::runtime_error);
  EXPECT_EQ(hand.count, 2);
}

}  // namespace
}  // namespace thinwall
