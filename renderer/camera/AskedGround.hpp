#pragma once

#include "renderer/camera/View.hpp"

namespace thinwall {

/// Whether a view has a ground below what one of its cameras shows; in the light of an endoscope's lamp there is none.
inline bool asks_for_ground(const ViewDefinition& view, const CameraDefinition& camera) {
  return view.look.floor && !(camera.lamp.value_or(view.lights.endoscope) > 0);
}

}  // namespace thinwall
