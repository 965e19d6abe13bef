#include "studio/scenario/ResolvedCameras.hpp"

#include <nlohmann/json.hpp>

#include "renderer/image/PictureCorner.hpp"
#include "studio/scenario/ResolvedValues.hpp"

namespace thinwall {
namespace {

using Json = nlohmann::json;

CameraEase to_ease(const Json& mapping) {
  return mapping.at("ease") == "linear" ? CameraEase::kLinear : CameraEase::kSmooth;
}

CameraKeyframe to_keyframe(const Json& key) {
  return {.time = key.at("at"),
          .position = find_resolved<Double3>(key, "position"),
          .target = find_resolved<Double3>(key, "target"),
          .up = find_resolved<Double3>(key, "up"),
          .field_of_view = find_resolved<double>(key, "field_of_view"),
          .ease = to_ease(key)};
}

CameraDefinition to_camera(const Json& camera) {
  CameraDefinition result{.position = find_resolved<Double3>(camera, "position"),
                          .target = find_resolved<Double3>(camera, "target"),
                          .facing = find_resolved<Double3>(camera, "facing"),
                          .elevation = find_resolved<double>(camera, "elevation"),
                          .up = find_resolved<Double3>(camera, "up"),
                          .field_of_view = camera.at("field_of_view"),
                          .orbit_speed = camera.at("orbit_speed"),
                          .kind = camera.at("kind") == "endoscope" ? CameraKind::kEndoscope : CameraKind::kPinhole,
                          .exposure = camera.value("exposure", 0.0),
                          .lamp = find_resolved<double>(camera, "lamp"),
                          .aperture = camera.value("aperture", 0.0),
                          .focus = find_resolved<double>(camera, "focus"),
                          .auto_exposure = camera.value("auto_exposure", false),
                          .noise = camera.value("noise", 0.0),
                          .seed = camera.value("seed", 1U)};
  if (camera.contains("lens")) {
    const Json& lens = camera.at("lens");
    result.lens = {
        .k1 = lens.at("k1"), .k2 = lens.at("k2"), .p1 = lens.at("p1"), .p2 = lens.at("p2"), .k3 = lens.at("k3")};
  }
  for (const Json& key : camera.value("keyframes", Json::array())) result.keyframes.push_back(to_keyframe(key));
  for (const Json& push : camera.value("push_in", Json::array())) {
    result.push_ins.push_back(
        {.begin = push.at("from"), .end = push.at("until"), .factor = push.at("to"), .ease = to_ease(push)});
  }
  if (camera.contains("follow")) {
    const Json& follow = camera.at("follow");
    result.follow = {
        .tool = follow.at("tool"), .smoothing = follow.at("smooth"), .travels = follow.at("how") == "travel"};
  }
  return result;
}

CameraCut to_cut(const Json& cut) {
  return {.time = cut.at("at"),
          .camera = cut.at("camera"),
          .beside = find_resolved<std::string>(cut, "beside"),
          .inset = find_resolved<std::string>(cut, "inset"),
          .corner = find_corner(cut, "corner")};
}

}  // namespace

void read_cameras(const std::string& resolved, ViewDefinition& view) {
  const Json scenario = Json::parse(resolved);
  view.camera = to_camera(scenario.at("camera"));
  view.cameras.clear();
  view.cuts.clear();
  const Json cameras = scenario.value("cameras", Json::object());
  for (const auto& [name, camera] : cameras.items()) view.cameras[name] = to_camera(camera);
  for (const Json& cut : scenario.value("cuts", Json::array())) view.cuts.push_back(to_cut(cut));
}

}  // namespace thinwall
