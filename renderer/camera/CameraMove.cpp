#include "renderer/camera/CameraMove.hpp"

#include <algorithm>
#include <cmath>

namespace thinwall {
namespace {

double eased(CameraEase ease, double part) {
  return ease == CameraEase::kSmooth ? part * part * (3 - 2 * part) : part;
}

Vector3 between(Vector3 a, Vector3 b, double part) {
  return (1 - part) * a + part * b;
}

/// From one direction to another on the shorter great circle, at constant angular speed; both of length one. Opposite
/// ones are joined by way of `aside`.
Vector3 direction_between(Vector3 a, Vector3 b, double part, Vector3 aside) {
  const double cosine = std::clamp(dot(a, b), -1.0, 1.0);
  const Vector3 across = b - cosine * a;
  if (length(across) < 1e-9 && cosine > 0) return a;
  const Vector3 toward = normalized(length(across) < 1e-9 ? cross(aside, a) : across, perpendicular(a));
  const double angle = part * std::acos(cosine);
  return std::cos(angle) * a + std::sin(angle) * toward;
}

CameraPose keyframe_pose(const CameraKeyframe& key, const CameraPose& own) {
  return {.position = key.position ? vector3(*key.position) : own.position,
          .target = key.target ? vector3(*key.target) : own.target,
          .up = key.up ? vector3(*key.up) : own.up,
          .field_of_view = key.field_of_view.value_or(own.field_of_view)};
}

CameraPose pose_between(const CameraPose& a, const CameraPose& b, double part) {
  if (part <= 0) return a;
  if (part >= 1) return b;
  const Vector3 offset_a = a.position - a.target;
  const Vector3 offset_b = b.position - b.target;
  const double distance = std::exp((1 - part) * std::log(length(offset_a)) + part * std::log(length(offset_b)));
  const Vector3 up = normalized(between(normalized(a.up), normalized(b.up), part), a.up);
  const Vector3 direction = direction_between(normalized(offset_a), normalized(offset_b), part, up);
  const Vector3 target = between(a.target, b.target, part);
  return {.position = target + distance * direction,
          .target = target,
          .up = up,
          .field_of_view = (1 - part) * a.field_of_view + part * b.field_of_view};
}

CameraPose keyed_pose(const std::vector<CameraKeyframe>& keys, const CameraPose& own, double time) {
  const auto next = std::ranges::find_if(keys, [&](const CameraKeyframe& key) { return key.time >= time; });
  if (next == keys.end()) return keyframe_pose(keys.back(), own);
  if (next == keys.begin() || next->time == time) return keyframe_pose(*next, own);
  const CameraKeyframe& before = *(next - 1);
  const double part = (time - before.time) / (next->time - before.time);
  return pose_between(keyframe_pose(before, own), keyframe_pose(*next, own), eased(next->ease, part));
}

double nearness(const CameraPushIn& push, double time) {
  const double part = std::clamp((time - push.begin) / (push.end - push.begin), 0.0, 1.0);
  return std::pow(push.factor, eased(push.ease, part));
}

}  // namespace

double orbit_angle(const CameraDefinition& camera, double time) {
  const bool ends = camera.orbit_end && *camera.orbit_end > 0;
  const double ease = ends ? std::min(kOrbitEase, 0.5 * *camera.orbit_end) : kOrbitEase;
  // Seconds at full speed that one has gone which set out so long ago: the integral of 3 u^2 - 2 u^3.
  const auto since_start = [ease](double elapsed) {
    const double part = std::clamp(elapsed / ease, 0.0, 1.0);
    return std::max(0.0, elapsed - ease) + ease * part * part * part * (1 - 0.5 * part);
  };
  double gone = since_start(time);
  if (ends && time > 0.5 * *camera.orbit_end) gone = *camera.orbit_end - ease - since_start(*camera.orbit_end - time);
  return camera.orbit_speed * gone;
}

CameraPose moved_pose(const CameraDefinition& camera, const CameraPose& own, double time) {
  CameraPose pose = camera.keyframes.empty() ? own : keyed_pose(camera.keyframes, own, time);
  if (camera.follow && camera.followed_point) {
    const Vector3 subject = vector3(*camera.followed_point);
    if (camera.follow->travels) pose.position = pose.position + (subject - pose.target);
    pose.target = subject;
  }
  for (const CameraPushIn& push : camera.push_ins) {
    pose.position = pose.target + nearness(push, time) * (pose.position - pose.target);
  }
  return pose;
}

}  // namespace thinwall
