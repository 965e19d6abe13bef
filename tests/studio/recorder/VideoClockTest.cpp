#include "studio/recorder/VideoClock.hpp"

#include <gtest/gtest.h>

namespace thinwall {
namespace {

/// One second, frozen for two, then half a second at a quarter of the speed, then on.
VideoClock lesson() {
  return VideoClock({{.at = 1, .duration = 2}}, {{.begin = 1, .end = 1.5, .speed = 0.25}});
}

TEST(VideoClock, WithoutAnythingTheTimesAreTheSameToTheLastBit) {
  const VideoClock clock;
  for (int frame = 0; frame < 1000; ++frame) {
    const double time = frame / 30.0;
    EXPECT_EQ(clock.at(time).simulation, time);
    EXPECT_EQ(clock.first_shown(time), time);
    EXPECT_EQ(clock.last_shown(time), time);
  }
}

TEST(VideoClock, AFreezeHoldsTheTime) {
  for (const double time : {1.0, 1.7, 2.999}) {
    const VideoMoment moment = lesson().at(time);
    EXPECT_EQ(moment.simulation, 1);
    EXPECT_EQ(moment.speed, 0);
    EXPECT_NEAR(moment.held, time - 1, 1e-15);
  }
}

TEST(VideoClock, SlowMotionTakesLongerByItsSpeed) {
  EXPECT_NEAR(lesson().at(4).simulation, 1.25, 1e-15);
  EXPECT_EQ(lesson().at(4).speed, 0.25);
  EXPECT_NEAR(lesson().at(5).simulation, 1.5, 1e-15);
  EXPECT_NEAR(lesson().at(5.5).simulation, 2, 1e-15);
  EXPECT_EQ(lesson().at(5.5).speed, 1);
}

TEST(VideoClock, TimesOfTheSimulationAreFoundAgain) {
  const VideoClock clock = lesson();
  for (double time = 0; time < 4; time += 0.0625) {
    EXPECT_NEAR(clock.at(clock.first_shown(time)).simulation, time, 1e-12);
    EXPECT_NEAR(clock.at(clock.last_shown(time)).simulation, time, 1e-12);
  }
  EXPECT_EQ(clock.first_shown(1), 1);
  EXPECT_EQ(clock.last_shown(1), 3);
}

TEST(VideoClock, NeverGoesBack) {
  const VideoClock clock({{0, 1}, {0.3, 0.2}, {0.3, 0.3}, {1.1, 0.7}}, {{0.1, 0.3, 0.1}, {0.3, 0.9, 0.5}, {1.1, 2, 3}});
  double before = 0;
  for (int frame = 0; frame < 600; ++frame) {
    const double now = clock.at(frame / 60.0).simulation;
    EXPECT_GE(now, before);
    before = now;
  }
  EXPECT_EQ(clock.at(0.99).simulation, 0) << "a title card is a freeze at the beginning";
  EXPECT_NEAR(clock.last_shown(0.3) - clock.first_shown(0.3), 0.5, 1e-12) << "freezes at the same time add up";
}

}  // namespace
}  // namespace thinwall
