#include "studio/scenario/CameraPass.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>

namespace thinwall {
namespace {

using Eigen::Vector3d;

Vector3d vector(const CheckedValue& list) {
  return {list.items[0].number, list.items[1].number, list.items[2].number};
}

const CheckedValue* find_list(const CheckedValue& mapping, std::string_view key) {
  const CheckedValue* list = mapping.find(key);
  return list != nullptr && list->items.size() == 3 ? list : nullptr;
}

/// The shape of the body that a clip works on; empty where it is a mesh.
std::string shape_of(const CheckedValue& root, const CheckedValue& clip) {
  const CheckedValue *name = clip.find("body"), *bodies = root.find("bodies");
  if (bodies == nullptr || bodies->members.empty()) return {};
  const CheckedValue* body = name != nullptr ? bodies->find(name->text) : &bodies->members.front().value;
  const CheckedValue* surface = body != nullptr ? body->find("surface") : nullptr;
  if (surface == nullptr || surface->find("mesh") != nullptr) return {};
  const CheckedValue* shape = surface->find("shape");
  return shape != nullptr ? shape->text : std::string();
}

/// Into a round shape, which stands around the origin, where a path of a cut lies; downwards into a flat one; zero for
/// others.
Vector3d inward_at(const CheckedValue& path, const std::string& shape) {
  if (shape == "sheet" || shape == "disc" || shape == "annulus" || shape == "strip") return -Vector3d::UnitZ();
  Vector3d sum = Vector3d::Zero();
  for (const CheckedValue& point : path.items) {
    if (point.items.size() == 3) sum += vector(point);
  }
  if (shape == "semicylinder" || shape == "cylinder") sum.y() = 0;  // their axis
  const bool is_round = shape == "sphere" || shape == "hemisphere" || shape == "semicylinder" || shape == "cylinder";
  return is_round && sum.norm() > 1e-9 ? Vector3d(-sum.normalized()) : Vector3d::Zero();
}

/// How the clips of a timeline go into bodies.
struct Approach {
  Vector3d direction = Vector3d::Zero();  // the mean, unit or zero
  bool cuts = false;
};

Approach approach_of(const CheckedValue& root, const CheckedValue& timeline) {
  Approach approach;
  for (const CheckedValue& clip : timeline.items) {
    for (const char* verb : {"palpate", "grasp", "pierce", "incise"}) {
      const CheckedValue* presses = clip.find(verb);
      if (presses == nullptr) continue;
      const CheckedValue *direction = find_list(*presses, "direction"), *path = presses->find("path");
      approach.cuts = approach.cuts || path != nullptr;
      if (direction != nullptr) {
        approach.direction += vector(*direction).normalized();
      } else if (path != nullptr) {
        approach.direction += inward_at(*path, shape_of(root, *presses));
      }
    }
  }
  const double size = approach.direction.norm();
  approach.direction = size > 1e-9 ? Vector3d(approach.direction / size) : Vector3d::Zero();
  return approach;
}

/// Over the tool's shoulder: turned aside far enough that the tool does not hide what it touches.
Vector3d over_the_shoulder(const Vector3d& direction) {
  const double aside = 50 * std::numbers::pi / 180;
  const double azimuth = std::atan2(direction.y(), direction.x()) + aside;
  const double slope = direction.z() > 0.5 ? 0.35 : -0.45;
  return Vector3d(std::cos(azimuth), std::sin(azimuth), slope).normalized();
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

/// Towards `facing`, or down onto a wound.
void turn(CheckedValue& camera, const std::optional<Vector3d>& facing) {
  for (const char* key : {"position", "facing", "elevation"}) {
    if (camera.find(key) != nullptr) return;
  }
  if (!facing) {
    camera.members.push_back({.key = "elevation",
                              .location = camera.location,
                              .value = number_value(kElevationAboveWounds, camera.location)});
    return;
  }
  CheckedValue list{.kind = CheckedKind::kList, .location = camera.location, .given = false};
  for (const double part : *facing) list.items.push_back(number_value(part, camera.location));
  camera.members.push_back({.key = "facing", .location = camera.location, .value = list});
}

}  // namespace

void camera_pass(CheckedValue& root) {
  const CheckedValue* timeline = root.find("timeline");
  if (timeline == nullptr) return;
  const auto [direction, cuts] = approach_of(root, *timeline);
  const bool is_down = direction.z() < -0.7;
  // The standard view shows what presses downwards.
  if (direction.isZero() || (is_down && !cuts)) return;
  std::optional<Vector3d> facing;
  if (!is_down) facing = cuts ? into_the_wound(direction) : over_the_shoulder(direction);
  if (CheckedValue* camera = root.find("camera")) turn(*camera, facing);
  if (CheckedValue* cameras = root.find("cameras")) {
    for (CheckedMember& member : cameras->members) turn(member.value, facing);
  }
}

}  // namespace thinwall
