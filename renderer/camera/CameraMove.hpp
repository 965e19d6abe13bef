#pragma once

#include "renderer/camera/CameraDefinition.hpp"
#include "renderer/snapshot/Vector.hpp"

namespace thinwall {

/// Where a camera stands, what it looks at, and how wide.
struct CameraPose {
  Vector3 position;          // metres
  Vector3 target;            // metres
  Vector3 up = {0, 0, 1};    // direction
  double field_of_view = 1;  // radians, vertical
};

/// The pose at `time` (seconds) of a camera that would stand at `own`: its keyframes, then what it follows, then its
/// push-ins. At a keyframe's time the pose is the keyframe's to the last bit. Between two the target goes straight, and
/// the camera goes round it on the shorter arc while its distance changes by equal factors in equal parts of the way;
/// before the first and after the last it stays. A pure function of its arguments.
CameraPose moved_pose(const CameraDefinition& camera, const CameraPose& own, double time);

/// Radians by which a camera has gone round at `time` (seconds): it sets out and comes to rest as one does that is
/// moved by hand, over kOrbitEase, or half of the time that there is.
double orbit_angle(const CameraDefinition& camera, double time);
inline constexpr double kOrbitEase = 0.8;  // seconds

}  // namespace thinwall
