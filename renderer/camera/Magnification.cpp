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

std::shared_ptr<const SnapshotTopology> magnified_topology(const SnapshotTopology& topology, double factor) {
  auto result = std::make_shared<SnapshotTopology>(topology);
  for (Float3& position : result->rest_positions) magnify(position, factor);
  for (float& thickness : result->thickness) thickness *= static_cast<float>(factor);
  for (Float3& products : result->rest_metric) magnify(products, factor * factor);
  return result;
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
  std::vector<std::pair<Shared, Shared>> topologies;
  for (SnapshotSurface& surface : result.surfaces) {
    if (!surface.topology) continue;
    const auto known = std::ranges::find(topologies_, surface.topology, &std::pair<Shared, Shared>::first);
    topologies.emplace_back(surface.topology,
                            known != topologies_.end() ? known->second : magnified_topology(*surface.topology, factor));
    surface.topology = topologies.back().second;
    for (Float3& position : surface.positions) magnify(position, factor);
    for (SnapshotField& field : surface.fields) {
      if (field.unit != "m") continue;
      for (float& value : field.values) value *= static_cast<float>(factor);
    }
  }
  topologies_ = std::move(topologies);
  for (SnapshotTool& tool : result.tools) magnify(tool, factor);
  for (SnapshotScalar& scalar : result.scalars) {
    if (scalar.unit == "m^3") scalar.value *= factor * factor * factor;
  }
  return result;
}

}  // namespace thinwall
