#pragma once

#include "renderer/camera/Camera.hpp"
#include "renderer/camera/SceneExtent.hpp"
#include "renderer/camera/View.hpp"
#include "renderer/image/Image.hpp"
#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// A scene before one of the cameras of its view, with all decided that labels and ground truth go by as well.
struct SeenScene {
  ViewDefinition view = {};  // with that camera, which may bring a lamp
  SceneExtent extent = {};
  Camera camera = {};
  Camera resting = {};  // the view's own before anything moves it, by which lamps in the open stand
  bool is_inside() const { return view.lights.endoscope > 0; }
};

/// Throws as resolve_camera does.
SeenScene seen_scene(const Snapshot& snapshot, const ViewDefinition& view, const CameraDefinition& seen_by,
                     ImageSize size);

}  // namespace thinwall
