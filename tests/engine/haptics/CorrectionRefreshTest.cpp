#include "engine/haptics/CorrectionRefresh.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "engine/haptics/HapticLoop.hpp"
#include "engine/haptics/Trajectory.hpp"

namespace thinwall {
namespace {

constexpr double kCoarse = 150, kFine = 200;  // newton / metre

/// A wall at z = 0 that pushes as a spring.
Eigen::Vector3d push(const ToolPose& pose, double stiffness) {
  return {0, 0, pose.tip.z() < 0 ? -stiffness * pose.tip.z() : 0};
}

FullAnswer coarse_answer(double, const ToolPose& pose) {
  FullAnswer answer;
  answer.response.pose = pose;
  answer.response.force = push(pose, kCoarse);
  if (pose.tip.z() >= 0) {
    answer.response.ahead = {.gap = pose.tip.z(), .normal = -Eigen::Vector3d::UnitZ(), .stiffness = kCoarse};
    return answer;
  }
  SiteResponse& site = answer.response.sites.emplace_back();
  site.force = answer.response.force.z();
  site.normal = -Eigen::Vector3d::UnitZ();
  site.force_by_motion[2] = -kCoarse;
  return answer;
}

ToolPose at_height(double z) {
  ToolPose pose;
  pose.tip.z() = z;
  return pose;
}

/// Presses 3 mm deep, holds, and goes away. Nothing brakes: the fine body gives back more than the coarse one took.
HapticRecord play(const PairSolver& solver) {
  Trajectory hand({{.time = 0, .pose = at_height(1e-3)},
                   {.time = 0.1, .pose = at_height(-3e-3)},
                   {.time = 0.4, .pose = at_height(-3e-3)},
                   {.time = 0.5, .pose = at_height(5e-3)}});
  const HandState begin{.time = 0, .pose = at_height(1e-3)};
  ModelRefresh models(coarse_answer, begin, {.reach = 5e-3, .shortest_way = 1e-4, .most_way = 5e-3});
  CorrectionRefresh corrections(solver, begin, 1);
  LocalForce coarse(models, 4e-3);
  CorrectedForce source(coarse, corrections, 20e-3);
  const HapticRecord record =
      run_haptic_loop(hand, source, {.duration = 1, .passivity = {.most_damping = 0}, .real_time = false});
  models.finish();
  corrections.finish();
  return record;
}

ForcePair both(double, const ToolPose& pose) {
  return {.fine = push(pose, kFine), .coarse = push(pose, kCoarse)};
}

TEST(ForceCorrection, FadesWithTheCoarseForceAndLeavesNothingToAToolThatHasLeft) {
  const ForceCorrection correction{.difference = {0, 0.1, 0.2}, .coarse = 2};
  EXPECT_EQ(correction.of({0, 0, 2}), Eigen::Vector3d(0, 0.1, 0.2));
  EXPECT_EQ(correction.of({0, 0, 1}), Eigen::Vector3d(0, 0.05, 0.1));
  EXPECT_EQ(correction.of({0, 0, 5}), Eigen::Vector3d(0, 0.1, 0.2));
  EXPECT_TRUE(correction.of(Eigen::Vector3d::Zero()).isZero());
  EXPECT_TRUE(ForceCorrection{}.of({0, 0, 1}).isZero());
}

TEST(CorrectedForce, AHandAtRestFeelsTheFineBodyAndOneThatHasLeftNothing) {
  const HapticRecord record = play(both);
  ASSERT_GT(record.ticks.size(), 20U);
  int held = 0;
  for (const HapticTick& tick : record.ticks) {
    // Away for longer than forces take over from one another.
    if (tick.time > 0.45 && tick.pose.tip.z() >= 2.5e-3) {
      EXPECT_LT(tick.force.norm(), 1e-4) << tick.time;
    }
    // A quarter of a second is long enough for both solvers.
    if (tick.time < 0.35 || tick.time > 0.4) continue;
    EXPECT_NEAR(tick.force.z(), kFine * 3e-3, 1e-9) << tick.time;
    ++held;
  }
  EXPECT_GT(held, 0);
}

TEST(CorrectedForce, ACorrectionThatComesIsFeltWithoutAJump) {
  int call = 0;
  const HapticRecord record = play([&](double time, const ToolPose& pose) {
    ForcePair pair = both(time, pose);
    if (++call % 2 == 0) pair.fine *= 0.5;
    return pair;
  });
  for (std::size_t k = 1; k < record.ticks.size(); ++k) {
    const double ticks = (record.ticks[k].time - record.ticks[k - 1].time) / 1e-3;
    // Corrections differ by 0.3 N at most, and blend by 3/2 of that in 20 ticks at most; the hand goes by 80
    // micrometres.
    EXPECT_LE((record.ticks[k].force - record.ticks[k - 1].force).norm(), ticks * (0.3 * 1.5 / 20 + 0.02));
  }
}

TEST(CorrectedForce, ASolverOfBothThatFailsEndsTheLoopAndIsHeardOf) {
  int call = 0;
  EXPECT_THROW(play([&](double time, const ToolPose& pose) {
                 if (++call > 3) throw std::runtime_error("no equilibrium");
                 return both(time, pose);
               }),
               std::runtime_error);
}

}  // namespace
}  // namespace thinwall
