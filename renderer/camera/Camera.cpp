#include "renderer/camera/Camera.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "renderer/camera/CameraMove.hpp"
#include "renderer/camera/Framing.hpp"
#include "renderer/image/PictureFailure.hpp"

namespace thinwall {
namespace {

/// At which the standard view looks down, radians.
constexpr double kElevation = 33 * std::numbers::pi / 180;

void orient(Camera& camera, Vector3 forward, Vector3 up) {
  camera.forward = normalized(forward);
  const Vector3 right = cross(camera.forward, up);
  camera.right = length(right) > 1e-9 * length(up) ? normalized(right) : perpendicular(camera.forward);
  camera.up = cross(camera.right, camera.forward);
}

/// A vector as it is where +z has been turned to `up`, unit, by the shortest way; upside down around x.
Vector3 turned_from_z(Vector3 up, Vector3 vector) {
  const Vector3 axis = cross({0, 0, 1}, up);
  const double sine = length(axis);
  const Vector3 around = sine > 1e-9 ? normalized(axis) : Vector3{1, 0, 0};
  return turned(vector, around, std::atan2(sine, up.z));
}

/// From the front, a little from the right and from above; elongated bodies lie across the picture. `up`: unit; where
/// it is not +z all is turned with it by the shortest way.
Vector3 oblique_direction(const SceneExtent& extent, double elevation, Vector3 up) {
  const Vector3 right = turned_from_z(up, {1, 0, 0}), back = turned_from_z(up, {0, 1, 0});
  const double xx = extent.spread.along(right, right), yy = extent.spread.along(back, back);
  // Long in x or round: seen from the front (-y). Long in y: seen from the right (+x).
  const bool long_in_y = yy > 1.2 * xx && yy - xx > std::abs(extent.spread.along(right, back));
  const double azimuth = (long_in_y ? -20.0 : -65.0) * std::numbers::pi / 180;
  return std::cos(elevation) * (std::cos(azimuth) * right + std::sin(azimuth) * back) + std::sin(elevation) * up;
}

void require_sound(const CameraDefinition& definition) {
  if (!(definition.field_of_view > 0 && definition.field_of_view < std::numbers::pi)) {
    throw PictureFailure("the camera's field of view must lie between 0 and 180 degrees");
  }
}

void set_field_of_view(Camera& camera, double angle, ImageSize size) {
  camera.tangent_y = std::tan(0.5 * angle);
  camera.tangent_x = camera.tangent_y * size.width / size.height;
}

/// Whether a camera is so near to what it looks at that a rounding would say in which sense it looks.
bool is_at(Vector3 position, Vector3 target, const SceneExtent& extent) {
  constexpr double kRounding = 1e-6;  // of the scene's size, whose places are in single precision
  return !(length(target - position) > kRounding * extent.size);
}

/// Where the camera stands before anything moves it. `angle`: by which it goes round then, radians.
void stand(Camera& camera, const CameraDefinition& definition, const SceneExtent& extent, Vector3 up, double angle) {
  const Vector3 target = definition.target ? vector3(*definition.target) : extent.center;
  if (definition.position) {
    camera.position = vector3(*definition.position);
    if (is_at(camera.position, target, extent)) {
      throw PictureFailure(definition.target ? "the camera stands at its target; move one"
                                             : "the camera stands in the middle of the bodies, where it looks without "
                                               "`target`; give it a `target`");
    }
    orient(camera, target - camera.position, up);
    return;
  }
  orient(camera,
         definition.facing ? vector3(*definition.facing)
                           : -oblique_direction(extent, definition.elevation.value_or(kElevation), up),
         up);
  if (!extent.rest_points.empty()) frame(camera, extent, {.center = target, .axis = up, .angle = angle});
  // A given target keeps the distance; without one the window decides, which leaves the centre out of the middle.
  const double distance = std::max(dot(extent.center - camera.position, camera.forward), extent.size);
  if (definition.target || extent.rest_points.empty()) camera.position = target - distance * camera.forward;
}

/// Moves a camera that stands.
CameraPose move(Camera& camera, const CameraDefinition& definition, const SceneExtent& extent, ImageSize size,
                double time) {
  // A framed camera looks past the centre, so that there is room for overlays: at the point level with it.
  const double depth = dot(extent.center - camera.position, camera.forward);
  const Vector3 aim = definition.target     ? vector3(*definition.target)
                      : definition.position ? extent.center
                                            : camera.position + depth * camera.forward;
  const CameraPose own{.position = camera.position,
                       .target = aim,
                       .up = definition.up ? vector3(*definition.up) : Vector3{0, 0, 1},
                       .field_of_view = definition.field_of_view};
  const CameraPose pose = moved_pose(definition, own, time);
  if (is_at(pose.position, pose.target, extent)) {
    throw PictureFailure("the camera moves into its target; keep off it");
  }
  camera.position = pose.position;
  orient(camera, pose.target - pose.position, pose.up);
  set_field_of_view(camera, pose.field_of_view, size);
  return pose;
}

}  // namespace

Camera resolve_camera(const CameraDefinition& definition, const SceneExtent& extent, ImageSize size, double time) {
  require_sound(definition);
  const SceneExtent& subject = extent.subject();
  Camera camera;
  camera.kind = definition.kind;
  camera.lens = Lens(definition.lens);
  set_field_of_view(camera, definition.field_of_view, size);
  Vector3 up = definition.up ? normalized(vector3(*definition.up)) : Vector3{0, 0, 1};
  const double angle = orbit_angle(definition, time);
  stand(camera, definition, subject, up, angle);
  Vector3 target = definition.target ? vector3(*definition.target) : subject.center;
  if (definition.is_moved()) {
    const CameraPose pose = move(camera, definition, subject, size, time);
    target = pose.target;
    up = normalized(pose.up);
  }
  if (angle != 0) {
    camera.position = target + turned(camera.position - target, up, angle);
    orient(camera, turned(camera.forward, up, angle), up);
  }
  camera.aperture = definition.aperture;
  const double to_target = dot(target - camera.position, camera.forward);
  camera.focus = definition.focus.value_or(std::max(to_target, 1e-3 * subject.size));
  // A little wider than the picture is high, as surgeons set their picture.
  if (camera.kind == CameraKind::kEndoscope) camera.field_stop = 1.12 * camera.tangent_y;
  const double depth = length(extent.center - camera.position);
  camera.nearest = std::max(0.02 * depth, 1e-3 * extent.size);
  camera.farthest = depth + 20 * extent.reach;
  return camera;
}

Camera behind_the_lens(const Camera& camera) {
  if (camera.lens.distortion() == LensDistortion{}) return camera;
  const auto ideal_of = [&](Tangents seen) {
    const std::optional<Tangents> ideal = camera.lens.undistorted(seen);
    if (!ideal || !camera.lens.is_unfolded(*ideal)) {
      throw PictureFailure(
          "the camera's lens folds its picture over before the border; take smaller coefficients or a smaller field of "
          "view");
    }
    return *ideal;
  };
  // What the field stop covers needs no picture.
  const double stop = camera.field_stop > 0 ? camera.field_stop : std::numeric_limits<double>::max();
  const double x = std::min(camera.tangent_x, stop);
  const double y = std::min(camera.tangent_y, stop);
  Camera pinhole = camera;
  pinhole.lens = Lens();
  double widening = 0;
  constexpr int kAlongTheBorder = 64;
  for (int i = -kAlongTheBorder; i <= kAlongTheBorder; ++i) {
    const double part = static_cast<double>(i) / kAlongTheBorder;
    for (const Tangents& seen : {Tangents{x, part * y}, {-x, part * y}, {part * x, y}, {part * x, -y}}) {
      // Corners that the stop covers are left out.
      const double radius = std::hypot(seen[0], seen[1]);
      const double kept = std::min(1.0, stop / radius);
      const Tangents ideal = ideal_of({kept * seen[0], kept * seen[1]});
      widening = std::max({widening, std::abs(ideal[0]) / camera.tangent_x, std::abs(ideal[1]) / camera.tangent_y});
    }
  }
  // Between the places that were looked at the border may reach a little further.
  widening *= 1.002;
  pinhole.tangent_x *= widening;
  pinhole.tangent_y *= widening;
  if (camera.field_stop > 0) pinhole.field_stop = ideal_of({camera.field_stop, 0})[0];
  return pinhole;
}

Camera resting_camera(const CameraDefinition& definition, const SceneExtent& extent, ImageSize size) {
  CameraDefinition resting = definition;
  resting.keyframes.clear();
  resting.follow.reset();
  resting.push_ins.clear();
  resting.orbit_speed = 0;
  return resolve_camera(resting, extent, size, 0);
}

Matrix4 Camera::matrix() const {
  return perspective_matrix(tangent_x, tangent_y, nearest, farthest) * eye_matrix(position, right, up, -forward);
}

std::optional<std::array<double, 2>> Camera::pixel(Vector3 point, ImageSize size) const {
  const Vector3 offset = point - position;
  const double depth = dot(offset, forward);
  if (!(depth > 0)) return std::nullopt;
  const Tangents ideal = {dot(offset, right) / depth, -dot(offset, up) / depth};
  if (!lens.is_unfolded(ideal)) return std::nullopt;
  const Tangents seen = lens.distorted(ideal);
  return std::array<double, 2>{0.5 * size.width * (1 + seen[0] / tangent_x),
                               0.5 * size.height * (1 + seen[1] / tangent_y)};
}

bool Camera::shows(const std::array<double, 2>& pixel, ImageSize size) const {
  const double x = 2 * pixel[0] / size.width - 1, y = 2 * pixel[1] / size.height - 1;
  if (std::abs(x) > 1 || std::abs(y) > 1) return false;
  return field_stop == 0 || std::hypot(x * tangent_x, y * tangent_y) <= field_stop;
}

}  // namespace thinwall
