#include "engine/tool/PoseBetween.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace thinwall {
namespace {

ToolPose turned_by(const ToolPose& pose, double angle, const Eigen::Vector3d& about) {
  const Eigen::AngleAxisd turn(angle, about.normalized());
  ToolPose turned = pose;
  turned.direction = turn * pose.direction;
  turned.axis = turn * pose.axis;
  return turned;
}

TEST(PoseBetween, IsOnTheOneTurnFromBeginToEndAtAnEvenRate) {
  const Eigen::Vector3d about(0.3, -1, 0.4);
  ToolPose begin;
  for (const double angle : {1e-7, 0.02, 1.0, 3.1}) {
    const ToolPose end = turned_by(begin, angle, about);
    for (const double part : {0.0, 0.1, 0.5, 0.9, 1.0}) {
      const ToolPose pose = between(begin, end, part), exact = turned_by(begin, part * angle, about);
      EXPECT_LT((pose.direction - exact.direction).norm(), 1e-14) << angle;
      EXPECT_LT((pose.axis - exact.axis).norm(), 1e-14) << angle;
      EXPECT_LT(std::abs(pose.axis.dot(pose.direction)), 1e-15);
    }
  }
}

TEST(PoseBetween, LeavesAFrameThatDoesNotTurnToTheLastBitAndEndsAtTheLast) {
  ToolPose begin, end;
  begin.direction = end.direction = Eigen::Vector3d(0.1, 0, -1).normalized();
  end.tip = {0, 0, 0.01};
  EXPECT_EQ(between(begin, end, 0.3).direction, begin.direction);
  EXPECT_EQ(between(begin, end, 0.3).axis, begin.axis);
  end = turned_by(end, 0.7, {1, 2, 3});
  EXPECT_EQ(between(begin, end, 1).direction, end.direction);
  EXPECT_EQ(between(begin, end, 1).axis, end.axis);
}

TEST(PoseBetween, HalfATurnGoesThePositiveWayWhateverRoundingSays) {
  const ToolPose begin;
  for (const Eigen::Vector3d& about : {Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 0, -1)}) {
    for (const double rounding : {-1e-15, 0.0, 1e-15}) {
      // x' of the beginning is -x, z' is -z: the positive sense is about these.
      const Eigen::Vector3d positive = about.x() != 0 ? Eigen::Vector3d(-about) : about;
      const ToolPose end = turned_by(begin, std::numbers::pi + rounding, about);
      const ToolPose half = between(begin, end, 0.5), exact = turned_by(begin, std::numbers::pi / 2, positive);
      EXPECT_LT((half.direction - exact.direction).norm(), 1e-14);
      EXPECT_LT((half.axis - exact.axis).norm(), 1e-14);
    }
  }
}

TEST(TurnedTo, DoesNotTwistAboutTheDirection) {
  ToolPose pose;
  pose.axis = Eigen::Vector3d(1, 1, 0).normalized();
  const Eigen::Vector3d direction = Eigen::Vector3d(0.4, -0.7, -0.2).normalized();
  const ToolPose turned = turned_to(pose, direction);
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(frame_of(turned) * frame_of(pose).transpose()));
  EXPECT_EQ(turned.direction, direction);
  EXPECT_NEAR(turn.axis().dot(pose.direction), 0, 1e-15);
  EXPECT_NEAR(turn.axis().dot(direction), 0, 1e-15);
  EXPECT_LT((turned_to(pose, -pose.direction).axis - pose.axis).norm(), 1e-15) << "half a turn about y'";
}

}  // namespace
}  // namespace thinwall
