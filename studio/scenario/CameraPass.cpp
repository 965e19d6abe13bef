#include "studio/scenario/CameraPass.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>
#include <variant>

namespace thinwall {
namespace {

using Eigen::Vector3d;

/// How the clips of a timeline go into bodies.
struct Approach {
  Vector3d direction = Vector3d::Zero();  // the mean, unit or zero
  bool cuts = false;
};

Approach approach_of(const std::vector<Clip>& timeline, const CameraQuestions& ask) {
  Approach approach;
  for (const Clip& clip : timeline) {
    if (const auto* incise = std::get_if<InciseClip>(&clip.action)) {
      approach.cuts = true;
      approach.direction += incise->direction ? *incise->direction : ask.inward_along(*incise);
    } else if (const auto* palpate = std::get_if<PalpateClip>(&clip.action)) {
      approach.direction += palpate->direction;
    } else if (const auto* pierce = std::get_if<PierceClip>(&clip.action)) {
      approach.direction += pierce->direction;
    } else if (const auto* grasp = std::get_if<GraspClip>(&clip.action)) {
      approach.direction += grasp->direction;
    }
  }
  const double size = approach.direction.norm();
  approach.direction = size > 1e-9 ? Vector3d(approach.direction / size) : Vector3d::Zero();
  return approach;
}

/// Over a shoulder of the tool: turned aside, radians, far enough that the tool does not hide what it touches.
Vector3d over_the_shoulder(const Vector3d& direction, double aside) {
  const double azimuth = std::atan2(direction.y(), direction.x()) + aside;
  const double slope = direction.z() > 0.5 ? 0.35 : -0.45;
  return Vector3d(std::cos(azimuth), std::sin(azimuth), slope).normalized();
}

/// Over that shoulder from which more is seen, the tool's right one where it is the same.
Vector3d over_the_better_shoulder(const Vector3d& direction, const CameraQuestions& ask) {
  constexpr double kAside = 50 * std::numbers::pi / 180;
  const std::array<Vector3d, 2> shoulders = {over_the_shoulder(direction, kAside),
                                             over_the_shoulder(direction, -kAside)};
  const std::vector<double> hidden = ask.hidden_parts(shoulders);
  return shoulders[hidden[1] < hidden[0] ? 1 : 0];
}

/// Into a wound, a little from aside and above: what a blade opens is hidden sooner than what a tool dents.
Vector3d into_the_wound(const Vector3d& direction) {
  const double off = 30 * std::numbers::pi / 180;
  const Vector3d across = Vector3d::UnitZ().cross(direction);
  const bool is_steep = across.norm() < 0.2;
  const Vector3d aside = is_steep ? Vector3d(-0.42, 0.91, 0) : Vector3d(across.normalized() - 0.8 * Vector3d::UnitZ());
  const Vector3d square = aside - aside.dot(direction) * direction;
  return std::cos(off) * direction + std::sin(off) * square.normalized();
}

/// Steeply down onto a wound, radians: from the standard height what opens on top of a round body lies at its horizon.
constexpr double kElevationAboveWounds = 55 * std::numbers::pi / 180;

CheckedValue number_value(double number, const SourceLocation& location) {
  return {.kind = CheckedKind::kNumber, .location = location, .given = false, .number = number};
}

/// The cameras of which nothing says where they stand or whereto they look.
std::vector<CheckedValue*> unplaced_cameras(CheckedValue& root) {
  std::vector<CheckedValue*> all;
  if (CheckedValue* camera = root.find("camera")) all.push_back(camera);
  if (CheckedValue* cameras = root.find("cameras")) {
    for (CheckedMember& member : cameras->members) all.push_back(&member.value);
  }
  std::erase_if(all, [](const CheckedValue* camera) {
    const auto has = [camera](const char* key) { return camera->find(key) != nullptr; };
    return has("position") || has("facing") || has("elevation");
  });
  return all;
}

CheckedMember facing_member(const Vector3d& facing, const SourceLocation& location) {
  CheckedValue list{.kind = CheckedKind::kList, .location = location, .given = false};
  for (const double part : facing) list.items.push_back(number_value(part, location));
  return {.key = "facing", .location = location, .value = list};
}

}  // namespace

void camera_pass(CheckedValue& root, const std::vector<Clip>& timeline, const CameraQuestions& ask) {
  const std::vector<CheckedValue*> cameras = unplaced_cameras(root);
  if (cameras.empty()) return;
  const auto [direction, cuts] = approach_of(timeline, ask);
  const bool is_down = direction.z() < -0.7;
  // The standard view shows what presses downwards.
  if (direction.isZero() || (is_down && !cuts)) return;
  const Vector3d facing = is_down ? direction
                          : cuts  ? into_the_wound(direction)
                                  : over_the_better_shoulder(direction, ask);
  for (CheckedValue* camera : cameras) {
    const SourceLocation& location = camera->location;
    if (is_down) {
      camera->members.push_back(
          {.key = "elevation", .location = location, .value = number_value(kElevationAboveWounds, location)});
    } else {
      camera->members.push_back(facing_member(facing, location));
    }
  }
}

}  // namespace thinwall
