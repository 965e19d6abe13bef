#include "studio/commands/CameraPlaces.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <utility>

#include "renderer/camera/Camera.hpp"
#include "renderer/camera/SceneExtent.hpp"
#include "renderer/image/PictureFailure.hpp"
#include "studio/director/BodyExtent.hpp"
#include "studio/scenario/InputError.hpp"
#include "studio/scenario/TextNode.hpp"

namespace thinwall {
namespace {

/// A camera whose place is given.
struct PlacedCamera {
  std::string path;
  SourceLocation location;
  CameraDefinition camera;
};

/// The camera as it is at a place of it: a keyframe has its own position there and, where it is given one, target.
CameraDefinition camera_at(const CameraPlace& place, CameraDefinition camera) {
  if (!place.keyframe) return camera;
  const CameraKeyframe key = camera.keyframes.at(*place.keyframe);
  camera.position = key.position;
  if (key.target) camera.target = key.target;
  return camera;
}

std::string path_of(const CameraPlace& place) {
  const std::string camera = place.name.empty() ? "camera" : "cameras." + place.name;
  return (place.keyframe ? item_path(camera + ".keyframes", *place.keyframe) : camera) + ".position";
}

std::vector<PlacedCamera> placed_cameras(const Scenario& scenario) {
  std::vector<PlacedCamera> placed;
  for (const CameraPlace& place : scenario.camera_places) {
    const CameraDefinition& camera = place.name.empty() ? scenario.view.camera : scenario.view.cameras.at(place.name);
    // On its way one that follows a tool looks at that.
    if (place.keyframe && camera.follow) continue;
    placed.push_back({path_of(place), place.location, camera_at(place, camera)});
  }
  return placed;
}

bool is_within(const SnapshotSurface& surface, const Double3& place) {
  std::vector<Eigen::Vector3i> triangles;
  for (const auto* some : {&surface.topology->triangles, &surface.topology->cap_triangles}) {
    for (const Triangle& one : *some) {
      triangles.emplace_back(static_cast<int>(one[0]), static_cast<int>(one[1]), static_cast<int>(one[2]));
    }
  }
  Eigen::VectorXd position(3 * static_cast<Eigen::Index>(surface.positions.size()));
  for (Eigen::Index k = 0; k < position.size(); ++k) {
    position[k] = surface.positions[static_cast<std::size_t>(k) / 3][static_cast<std::size_t>(k) % 3];
  }
  return is_inside({triangles, position, false}, {place[0], place[1], place[2]});
}

}  // namespace

void refuse_blind_cameras(const Scenario& scenario, const Snapshot& first) {
  const SceneExtent extent = scene_extent(first);
  std::vector<Diagnostic> mistakes;
  for (const PlacedCamera& placed : placed_cameras(scenario)) {
    try {
      resting_camera(placed.camera, extent, scenario.record.size);
    } catch (const PictureFailure& failure) {
      mistakes.push_back({placed.location, placed.path + ": " + failure.what()});
    }
  }
  if (!mistakes.empty()) throw InputErrors(std::move(mistakes));
}

std::vector<std::string> cameras_within_bodies(const Scenario& scenario, const Snapshot& first) {
  std::vector<std::string> notes;
  for (const PlacedCamera& placed : placed_cameras(scenario)) {
    if (placed.camera.kind == CameraKind::kEndoscope) continue;
    for (const SnapshotSurface& surface : first.surfaces) {
      if (!is_within(surface, *placed.camera.position)) continue;
      notes.push_back(fmt::format(
          "{}: the camera stands within body `{}` and sees its lining; for its outside take it farther away, and see "
          "whether the unit is meant so",
          placed.path, surface.body));
    }
  }
  return notes;
}

}  // namespace thinwall
