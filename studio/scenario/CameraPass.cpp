#include "studio/scenario/CameraPass.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace thinwall {
namespace {

/// Mean direction in which the clips press, unit or zero.
Eigen::Vector3d pressing_direction(const CheckedValue& timeline) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const CheckedValue& clip : timeline.items) {
    const CheckedValue* approach = clip.find("palpate");
    if (approach == nullptr) approach = clip.find("grasp");
    const CheckedValue* direction = approach != nullptr ? approach->find("direction") : nullptr;
    if (direction == nullptr || direction->items.size() != 3) continue;
    sum += Eigen::Vector3d(direction->items[0].number, direction->items[1].number, direction->items[2].number);
  }
  return sum.norm() > 1e-9 ? Eigen::Vector3d(sum.normalized()) : Eigen::Vector3d::Zero();
}

/// Over the tool's shoulder: turned aside far enough that the tool does not hide what it touches.
Eigen::Vector3d over_the_shoulder(const Eigen::Vector3d& direction) {
  const double aside = 50 * std::numbers::pi / 180;
  const double azimuth = std::atan2(direction.y(), direction.x()) + aside;
  const double slope = direction.z() > 0.5 ? 0.35 : -0.45;
  return Eigen::Vector3d(std::cos(azimuth), std::sin(azimuth), slope).normalized();
}

void face(CheckedValue& camera, const Eigen::Vector3d& facing) {
  if (camera.find("position") != nullptr || camera.find("facing") != nullptr) return;
  CheckedValue value{.kind = CheckedKind::kList, .location = camera.location, .given = false};
  for (const double part : facing) {
    value.items.push_back({.kind = CheckedKind::kNumber, .location = camera.location, .given = false, .number = part});
  }
  camera.members.push_back({.key = "facing", .location = camera.location, .value = value});
}

}  // namespace

void camera_pass(CheckedValue& root) {
  const CheckedValue* timeline = root.find("timeline");
  if (timeline == nullptr) return;
  const Eigen::Vector3d direction = pressing_direction(*timeline);
  // Mostly downwards, or nothing pressed: the standard view shows it.
  if (direction.isZero() || direction.z() < -0.7) return;
  const Eigen::Vector3d facing = over_the_shoulder(direction);
  if (CheckedValue* camera = root.find("camera")) face(*camera, facing);
  if (CheckedValue* cameras = root.find("cameras")) {
    for (CheckedMember& member : cameras->members) face(member.value, facing);
  }
}

}  // namespace thinwall
