#include "studio/scenario/CameraPass.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>
#include <variant>

namespace thinwall {
namespace {

using Eigen::Quaterniond;
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

/// Over that shoulder from which more is seen, the tool's right one where it is the same. `turn`: to where it is asked.
Vector3d over_the_better_shoulder(const Vector3d& direction, const Quaterniond& turn, const CameraQuestions& ask) {
  constexpr double kAside = 50 * std::numbers::pi / 180;
  const std::array<Vector3d, 2> shoulders = {turn * over_the_shoulder(direction, kAside),
                                             turn * over_the_shoulder(direction, -kAside)};
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

std::vector<CheckedValue*> all_cameras(CheckedValue& root) {
  std::vector<CheckedValue*> all;
  if (CheckedValue* camera = root.find("camera")) all.push_back(camera);
  if (CheckedValue* cameras = root.find("cameras")) {
    for (CheckedMember& member : cameras->members) all.push_back(&member.value);
  }
  return all;
}

/// Whether something says where a camera stands or whereto it looks.
bool is_placed(const CheckedValue* camera) {
  const auto has = [camera](const char* key) { return camera->find(key) != nullptr; };
  return has("position") || has("facing") || has("elevation");
}

CheckedMember direction_member(const std::string& key, const Vector3d& direction, const SourceLocation& location) {
  CheckedValue list{.kind = CheckedKind::kList, .location = location, .given = false};
  for (const double part : direction) list.items.push_back(number_value(part, location));
  return {.key = key, .location = location, .value = list};
}

/// Against gravity; +z where there is none.
Vector3d upwards(const Vector3d& gravity) {
  return gravity.isZero() ? Vector3d::UnitZ().eval() : Vector3d(-gravity.normalized());
}

}  // namespace

void camera_pass(CheckedValue& root, const std::vector<Clip>& timeline, const Vector3d& gravity,
                 const CameraQuestions& ask) {
  std::vector<CheckedValue*> cameras = all_cameras(root);
  const Vector3d up = upwards(gravity);
  for (CheckedValue* camera : cameras) {
    if (up.isApprox(Vector3d::UnitZ()) || camera->find("up") != nullptr) continue;
    camera->members.push_back(direction_member("up", up, camera->location));
  }
  std::erase_if(cameras, is_placed);
  if (cameras.empty()) return;
  const auto [direction, cuts] = approach_of(timeline, ask);
  // All below is for up being +z.
  const Quaterniond turn = Quaterniond::FromTwoVectors(Vector3d::UnitZ(), up);
  const Vector3d level = turn.conjugate() * direction;
  const bool is_down = level.z() < -0.7;
  // The standard view shows what presses downwards.
  if (direction.isZero() || (is_down && !cuts)) return;
  const Vector3d facing = is_down ? direction
                          : cuts  ? Vector3d(turn * into_the_wound(level))
                                  : over_the_better_shoulder(level, turn, ask);
  for (CheckedValue* camera : cameras) {
    const SourceLocation& location = camera->location;
    if (is_down) {
      camera->members.push_back(
          {.key = "elevation", .location = location, .value = number_value(kElevationAboveWounds, location)});
    } else {
      camera->members.push_back(direction_member("facing", facing, location));
    }
  }
}

}  // namespace thinwall
