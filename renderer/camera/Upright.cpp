#include "renderer/camera/Upright.hpp"

#include <cmath>
#include <utility>

#include "renderer/snapshot/Float3.hpp"

namespace thinwall {
namespace {

void turn_by(const Turn& turn, Float3& place) {
  place = float3(turn.of(vector3(place)));
}

void turn_by(const Turn& turn, Double3& place) {
  const auto [x, y, z] = turn.of(vector3(place));
  place = {x, y, z};
}

void turn_by(const Turn& turn, Camera& camera) {
  for (Vector3* vector : {&camera.position, &camera.right, &camera.up, &camera.forward}) *vector = turn.of(*vector);
}

}  // namespace

std::optional<Turn> turn_upright(const Double3& gravity) {
  if (lies_below(gravity)) return std::nullopt;
  const Vector3 up = -normalized(vector3(gravity));
  // Where y is up, x stays to the right: z comes towards the viewer.
  const Vector3 axis = std::abs(up.x) < 0.9 ? Vector3{1, 0, 0} : Vector3{0, 1, 0};
  const Vector3 right = normalized(axis - dot(axis, up) * up);
  return Turn{.x = right, .y = cross(up, right), .z = up};
}

Snapshot Turner::turned(const Snapshot& snapshot, const Turn& turn) {
  if (std::exchange(gravity_, snapshot.gravity) != snapshot.gravity) topologies_.clear();
  Snapshot result = snapshot;
  topologies_.replace_in(result, [&](SnapshotTopology topology) {
    for (Float3& position : topology.rest_positions) turn_by(turn, position);
    return topology;
  });
  for (SnapshotSurface& surface : result.surfaces) {
    for (Float3& position : surface.positions) turn_by(turn, position);
  }
  for (SnapshotTool& tool : result.tools) {
    for (Double3* vector : {&tool.tip, &tool.direction, &tool.axis, &tool.force}) turn_by(turn, *vector);
  }
  turn_by(turn, result.gravity);
  return result;
}

SeenScene turned(const SeenScene& seen, const Snapshot& upright, const Turn& turn) {
  SeenScene result = seen;
  result.extent = scene_extent(upright);
  turn_by(turn, result.camera);
  turn_by(turn, result.resting);
  if (result.view.lights.key_direction) turn_by(turn, *result.view.lights.key_direction);
  for (HighlightDefinition& highlight : result.view.highlights) turn_by(turn, highlight.center);
  return result;
}

}  // namespace thinwall
