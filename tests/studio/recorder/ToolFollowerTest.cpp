#include "studio/recorder/ToolFollower.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "studio/recorder/ShotFollower.hpp"

namespace thinwall {
namespace {

Snapshot with_tip(double time, double x) {
  Snapshot snapshot;
  snapshot.time = time;
  SnapshotTool& tool = snapshot.tools.emplace_back();
  tool.name = "probe";
  tool.tip = {x, 2, 3};
  return snapshot;
}

TEST(ToolFollower, LagsBehindASteadyTipByTheSmoothingTime) {
  constexpr double kSpeed = 0.01;
  ToolFollower follower("probe", 0.4);
  for (int i = 0; i <= 500; ++i) follower.add(with_tip(0.01 * i, kSpeed * 0.01 * i));
  // After twelve smoothing times, 25 constants of the filters, e^-25 of the start is left.
  EXPECT_NEAR(follower.at(with_tip(5, kSpeed * 5))[0], kSpeed * (5 - 0.4), 1e-10);
}

TEST(ToolFollower, AnswersAJumpAsTwoLowPassesInARow) {
  ToolFollower follower("probe", 0.4);
  follower.add(with_tip(0, 0));
  follower.add(with_tip(1e-9, 1));
  follower.add(with_tip(1, 1));
  for (const double time : {0.1, 0.3, 0.9}) {
    const double units = time / 0.2;
    EXPECT_NEAR(follower.at(with_tip(time, 1))[0], 1 - (1 + units) * std::exp(-units), 1e-8);
  }
}

TEST(ToolFollower, DoesNotDependOnHowFinelyAStraightPathIsCut) {
  ToolFollower coarse("probe", 0.3), fine("probe", 0.3);
  coarse.add(with_tip(0, 0));
  coarse.add(with_tip(1, 0.05));
  for (int i = 0; i <= 64; ++i) fine.add(with_tip(i / 64.0, 0.05 * i / 64.0));
  EXPECT_NEAR(coarse.at(with_tip(1, 0.05))[0], fine.at(with_tip(1, 0.05))[0], 1e-15);
}

TEST(ToolFollower, WithoutSmoothingIsTheTip) {
  ToolFollower follower("probe", 0);
  follower.add(with_tip(0, 0));
  follower.add(with_tip(1, 4));
  EXPECT_EQ(follower.at(with_tip(0.5, 2)), (Double3{2, 2, 3}));
}

TEST(ToolFollower, NamesAToolThatIsNotThere) {
  EXPECT_THROW(ToolFollower("knife", 1).add(with_tip(0, 0)), std::invalid_argument);
}

TEST(ShotFollower, TellsEachCameraWhereItsToolIs) {
  ViewDefinition view;
  view.camera.follow = CameraFollow{.tool = "probe", .smoothing = 0};
  view.cameras["still"].exposure = 2;
  view.cuts = {{.time = 0.5, .camera = "still", .inset = "main"}};
  ShotFollower shots(view);
  shots.add(with_tip(0, 0));
  shots.add(with_tip(1, 4));
  EXPECT_EQ(shots.shot(with_tip(0.25, 1), 1).camera.followed_point, (Double3{1, 2, 3}));
  const Shot later = shots.shot(with_tip(0.75, 3), 1);
  EXPECT_FALSE(later.camera.followed_point);
  EXPECT_EQ(later.inset->followed_point, (Double3{3, 2, 3}));
}

}  // namespace
}  // namespace thinwall
