#include "engine/tool/PoseBetween.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace thinwall {
namespace {

/// Cosine of half a turn's half angle, and length of the sum of two opposite unit vectors, below which rounding alone
/// would say which way round a half turn goes.
constexpr double kHalfTurn = 1e-9;

/// The turn from one frame to another, in the axes of the first, by at most pi.
Eigen::AngleAxisd shortest_turn(const Eigen::Matrix3d& from, const Eigen::Matrix3d& to) {
  Eigen::Quaterniond turn(Eigen::Matrix3d(from.transpose() * to));
  Eigen::Index nearest = 0;
  turn.vec().cwiseAbs().maxCoeff(&nearest);
  const bool is_half = std::abs(turn.w()) < kHalfTurn;
  if (is_half ? turn.vec()[nearest] < 0 : turn.w() < 0) turn.coeffs() = -turn.coeffs();
  return {2 * std::atan2(turn.vec().norm(), turn.w()), turn.vec().normalized()};
}

}  // namespace

Eigen::Matrix3d frame_of(const ToolPose& pose) {
  Eigen::Matrix3d frame;
  frame << pose.axis.cross(pose.direction), pose.axis, pose.direction;
  return frame;
}

ToolPose between(const ToolPose& begin, const ToolPose& end, double part) {
  ToolPose pose = part < 1 ? begin : end;
  pose.tip = begin.tip + part * (end.tip - begin.tip);
  pose.opening = begin.opening + part * (end.opening - begin.opening);
  if (part >= 1 || (begin.direction == end.direction && begin.axis == end.axis)) return pose;
  const Eigen::Matrix3d from = frame_of(begin);
  const Eigen::AngleAxisd turn = shortest_turn(from, frame_of(end));
  const Eigen::Matrix3d frame = from * Eigen::AngleAxisd(part * turn.angle(), turn.axis());
  pose.direction = frame.col(2).normalized();
  pose.axis = (frame.col(1) - pose.direction * pose.direction.dot(frame.col(1))).normalized();
  return pose;
}

ToolPose turned_to(const ToolPose& pose, const Eigen::Vector3d& direction) {
  ToolPose turned = pose;
  turned.direction = direction;
  if (direction == pose.direction) return turned;
  Eigen::Vector3d axis = pose.axis;
  if ((pose.direction + direction).norm() > kHalfTurn) {
    axis = Eigen::Quaterniond::FromTwoVectors(pose.direction, direction) * pose.axis;
  }
  turned.axis = (axis - direction * direction.dot(axis)).normalized();
  return turned;
}

}  // namespace thinwall
