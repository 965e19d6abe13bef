#pragma once

#include "renderer/camera/Camera.hpp"
#include "renderer/camera/SceneExtent.hpp"

namespace thinwall {

/// Of a camera around an axis.
struct Turn {
  Vector3 center;            // metres, of a place of the axis
  Vector3 axis = {0, 0, 1};  // of length one
  double angle = 0;          // radians, from where the camera stands to where it has gone
};

/// Moves the camera, which looks its way, so that its window just holds all rest points, and where it goes round on
/// `turn`, all that it has been on; where walls have grown out of the picture, aside and back from there until it holds
/// them too, up to three times as far. The camera stands before its turn.
void frame(Camera& camera, const SceneExtent& extent, const Turn& turn);

}  // namespace thinwall
