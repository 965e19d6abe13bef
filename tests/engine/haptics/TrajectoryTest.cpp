#include "engine/haptics/Trajectory.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace thinwall {
namespace {

TEST(TrajectoryTest, GoesStraightFromMomentToMomentAndEnds) {
  ToolPose begin, end;
  end.tip = {0.01, 0, -0.02};
  end.opening = 4e-3;
  Trajectory trajectory({{.time = 0, .pose = begin}, {.time = 2, .pose = end}});
  const auto half = trajectory.pose_at(1);
  ASSERT_TRUE(half.has_value());
  EXPECT_TRUE(half->tip.isApprox(Eigen::Vector3d(0.005, 0, -0.01)));
  EXPECT_DOUBLE_EQ(half->opening, 2e-3);
  EXPECT_EQ(trajectory.pose_at(2)->tip, end.tip);
  EXPECT_FALSE(trajectory.pose_at(2.001).has_value());
}

TEST(TrajectoryTest, FramesTurnTheShortestWayAndStayFrames) {
  ToolPose begin, end;
  end.direction = Eigen::Vector3d(std::sin(1.0), 0, -std::cos(1.0));
  Trajectory trajectory({{.time = 0, .pose = begin}, {.time = 2, .pose = end}});
  const auto half = trajectory.pose_at(1);
  EXPECT_TRUE(half->direction.isApprox(Eigen::Vector3d(std::sin(0.5), 0, -std::cos(0.5))));
  EXPECT_TRUE(half->axis.isApprox(Eigen::Vector3d::UnitY()));
}

}  // namespace
}  // namespace thinwall
