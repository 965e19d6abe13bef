#include "engine/haptics/PassivityGuard.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

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
  const PassivityOptions options{.allowance = 0, .most_damping = 10, .onset = 0.02, .most_excess = 1};
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

/// A hand, 0.1 kg on a spring of 200 N/m and with little damping, that leans on a wall of `stiffness` newton / metre
/// at z = 0 which answers `late` ticks late. Gives the most work that it was given in `seconds`, joule.
double work_on_leaning_hand(double stiffness, int late, double seconds, const PassivityOptions& options) {
  constexpr double kMass = 0.1, kSpring = 200, kDamping = 0.5, kGoal = -12e-3;
  constexpr int kParts = 10;
  PassivityGuard guard(options);
  std::vector<double> places;
  double place = 5e-3, speed = 0, before = place, work = 0, most = 0;
  for (int tick = 0; tick < static_cast<int>(seconds / kTick); ++tick) {
    places.push_back(place);
    const double felt = places[static_cast<std::size_t>(std::max(0, tick - late))];
    const Eigen::Vector3d wanted(0, 0, felt < 0 ? -stiffness * felt : 0), motion(0, 0, place - before);
    const double force = guard.guard(wanted, motion, kTick).z();
    before = place;
    for (int part = 0; part < kParts; ++part) {
      speed += (force - kSpring * (place - kGoal) - kDamping * speed) / kMass * kTick / kParts;
      place += speed * kTick / kParts;
    }
    work += force * (place - before);
    most = std::max(most, work);
  }
  return most;
}

TEST(PassivityGuardTest, AHandThatLeansOnAStiffWallWhichAnswersLateIsNotDriven) {
  const PassivityOptions braking_alone{.most_excess = 1e9};
  for (const int late : {10, 30, 100}) {
    EXPECT_GT(work_on_leaning_hand(1000, late, 8, braking_alone), 0.1) << late;
    // 1.2 mJ are let through, and what a wall of 10 N gives a hand of 1 m/s in some ticks until the force has yielded.
    EXPECT_LT(work_on_leaning_hand(1000, late, 8, {}), 0.015) << late;
  }
}

TEST(PassivityGuardTest, AForceThatHasYieldedComesBackWithoutAJump) {
  const PassivityOptions options{.most_damping = 0};
  PassivityGuard guard(options);
  const Eigen::Vector3d push(0, 0, 2), out(0, 0, 1e-3);
  for (int tick = 0; tick < 20; ++tick) guard.guard(push, out, kTick);
  double before = guard.guard(push, out, kTick).z();
  EXPECT_EQ(before, 0);
  // What it was given beyond the allowance is forgotten by `pardon` while it rests.
  for (int tick = 0; tick < 60'000; ++tick) {
    const double force = guard.guard(push, Eigen::Vector3d::Zero(), kTick).z();
    ASSERT_LE(std::abs(force - before), 2 * kTick / options.recovery + 1e-12);
    before = force;
  }
  EXPECT_EQ(before, 2);
}

TEST(PassivityGuardTest, AToolThatBeginsInTheWallIsGivenBackWhatThatHolds) {
  PassivityGuard guard({.way_before = 5e-3});
  for (double depth = 5e-3; depth > 0; depth -= 5e-5) {
    const Eigen::Vector3d wanted(0, 0, 2000 * depth);
    EXPECT_EQ(guard.guard(wanted, Eigen::Vector3d(0, 0, depth < 5e-3 ? 5e-5 : 0), kTick), wanted) << depth;
  }
  EXPECT_EQ(guard.braked() + guard.yielded(), 0);
}

}  // namespace
}  // namespace thinwall
