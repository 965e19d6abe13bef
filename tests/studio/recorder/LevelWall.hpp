#pragma once

#include <memory>

#include "renderer/camera/CameraDefinition.hpp"
#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// A level wall `wall` about the origin, of two triangles. Metres, from its middle to its edges along x and y.
inline Snapshot level_wall(float along, float across) {
  auto topology = std::make_shared<SnapshotTopology>();
  topology->rest_positions = {{-along, -across, 0}, {along, -across, 0}, {along, across, 0}, {-along, across, 0}};
  topology->triangles = {{0, 1, 2}, {0, 2, 3}};
  Snapshot snapshot;
  snapshot.surfaces = {{.body = "wall", .topology = topology, .positions = topology->rest_positions, .fields = {}}};
  return snapshot;
}

/// One camera, metres.
inline Shot shot_from(Double3 position, Double3 target) {
  Shot shot;
  shot.camera = {.position = position, .target = target};
  return shot;
}

}  // namespace thinwall
