#include "renderer/camera/SeenScene.hpp"

namespace thinwall {

SeenScene seen_scene(const Snapshot& snapshot, const ViewDefinition& view, const CameraDefinition& seen_by,
                     ImageSize size) {
  SeenScene seen{.view = view, .extent = scene_extent(snapshot)};
  seen.view.camera = seen_by;
  seen.view.lights.endoscope = seen_by.lamp.value_or(view.lights.endoscope);
  seen.camera = resolve_camera(seen_by, seen.extent, size, snapshot.time);
  if (!seen.is_inside()) seen.resting = resting_camera(view.camera, seen.extent, size);
  return seen;
}

}  // namespace thinwall
