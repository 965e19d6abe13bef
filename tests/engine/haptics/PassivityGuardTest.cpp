#include "engine/haptics/PassivityGuard.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace thinwall {
namespace {

constexpr double kTick = 1e-3;  // seconds

/// Work that the tissue does on the hand, joule, while it is moved to and fro against a spring that answers `late`
/// ticks late, for ten seconds.
double work_on_hand(int late, bool guarded, PassivityGuard& guard) {
  const double stiffness = 500, amplitude = 5e-3;
  const auto place = [&](int tick) { return amplitude * std::sin(2 * std::numbers::pi * 2 * tick * kTick); };
  double work = 0;
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  for (int tick = 1; tick <= 10'000; ++tick) {
    const Eigen::Vector3d motion(place(tick) - place(tick - 1), 0, 0);
    work += force.dot(motion);
    const Eigen::Vector3d wanted(-stiffness * place(tick - late), 0, 0);
    force = guarded ? guard.guard(wanted, motion, kTick) : wanted;
  }
  return work;
}

TEST(PassivityGuardTest, ASpringThatAnswersLateDrivesTheHandWithoutIt) {
  PassivityGuard unused({});
  EXPECT_GT(work_on_hand(10, false, unused), 50e-3);
}

TEST(PassivityGuardTest, TakesBackWhatALateSpringGives) {
  PassivityGuard guard({.allowance = 2e-4, .most_damping = 20, .onset = 0.005});
  // What the allowance lets through, and what is given out in the ticks before the damping has risen: some thousandths
  // of the spring's own 6 mJ in each of twenty swings.
  EXPECT_LT(work_on_hand(10, true, guard), 2e-3);
  EXPECT_GT(guard.dissipated(), 50e-3);
  EXPECT_GT(guard.braked(), 0);
}

TEST(PassivityGuardTest, LetsAPassiveElementBe) {
  PassivityGuard guard({});
  for (int tick = 0; tick < 1000; ++tick) {
    const Eigen::Vector3d motion(1e-5 * std::cos(0.01 * tick), 0, 0), damper = -3.0 * motion / kTick;
    EXPECT_EQ(guard.guard(damper, motion, kTick), damper);
  }
  EXPECT_EQ(guard.braked(), 0);
}

TEST(PassivityGuardTest, TheDampingRisesEvenly) {
  const PassivityOptions options{.allowance = 0, .most_damping = 10, .onset = 0.02};
  PassivityGuard guard(options);
  const Eigen::Vector3d motion(1e-4, 0, 0), push(1, 0, 0);  // drives the hand along
  double before = 0;
  for (int tick = 0; tick < 50; ++tick) {
    const double braking = (push - guard.guard(push, motion, kTick)).norm();
    EXPECT_LE(std::abs(braking - before), options.most_damping * kTick / options.onset * 0.1 + 1e-12);
    before = braking;
  }
  EXPECT_GT(before, 0);
}

}  // namespace
}  // namespace thinwall
