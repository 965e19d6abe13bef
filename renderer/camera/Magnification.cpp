#include "renderer/camera/Magnification.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "renderer/snapshot/RestDiagonal.hpp"

namespace thinwall {
namespace {

void magnify(Float3& point, double factor) {
  for (float& part : point) part *= static_cast<float>(factor);
}

void magnify(Double3& point, double factor) {
  for (double& part : point) part *= factor;
}

void magnify(std::optional<Double3>& point, double factor) {
  if (point) magnify(*point, factor);
}

void magnify(SnapshotTool& tool, double factor) {
  for (double* length : {&tool.radius, &tool.length, &tool.width, &tool.thickness, &tool.opening, &tool.depth}) {
    *length *= factor;
  }
  magnify(tool.tip, factor);
}

SnapshotTopology magnified_topology(SnapshotTopology topology, double factor) {
  for (Float3& position : topology.rest_positions) magnify(position, factor);
  for (float& thickness : topology.thickness) thickness *= static_cast<float>(factor);
  for (Float3& products : topology.rest_metric) magnify(products, factor * factor);
  return topology;
}

}  // namespace

double magnification_of(const Snapshot& snapshot) {
  constexpr double kSmallest = 0.012, kLargestFactor = 1 << 20;  // metres, across a scene that is drawn as it is
  const double size = rest_diagonal(snapshot.surfaces);
  if (!(size > 0) || !(size < kSmallest)) return 1;
  return std::min(kLargestFactor, std::exp2(std::ceil(std::log2(kSmallest / size))));
}

CameraDefinition magnified(const CameraDefinition& camera, double factor) {
  CameraDefinition result = camera;
  for (auto* point : {&result.position, &result.target, &result.followed_point}) magnify(*point, factor);
  for (CameraKeyframe& key : result.keyframes) {
    magnify(key.position, factor);
    magnify(key.target, factor);
  }
  result.aperture *= factor;
  if (result.focus) *result.focus *= factor;
  return result;
}

ViewDefinition magnified(const ViewDefinition& view, double factor) {
  ViewDefinition result = view;
  result.camera = magnified(view.camera, factor);
  for (HighlightDefinition& highlight : result.highlights) {
    magnify(highlight.center, factor);
    highlight.radius *= factor;
  }
  if (result.look.data && row_of(result.look.data->quantity).unit == "m") {
    for (auto* end : {&result.look.data->from, &result.look.data->to}) {
      if (*end) **end *= factor;
    }
  }
  return result;
}

Snapshot Magnifier::magnified(const Snapshot& snapshot, double factor) {
  if (std::exchange(factor_, factor) != factor) topologies_.clear();
  Snapshot result = snapshot;
  topologies_.replace_in(result,
                         [&](const SnapshotTopology& topology) { return magnified_topology(topology, factor); });
  for (SnapshotSurface& surface : result.surfaces) {
    for (Float3& position : surface.positions) magnify(position, factor);
    for (SnapshotField& field : surface.fields) {
      if (field.unit != "m") continue;
      for (float& value : field.values) value *= static_cast<float>(factor);
    }
  }
  for (SnapshotTool& tool : result.tools) magnify(tool, factor);
  for (SnapshotScalar& scalar : result.scalars) {
    if (scalar.unit == "m^3") scalar.value *= factor * factor * factor;
  }
  return result;
}

}  // namespace thinwall
