#include "renderer/ground_truth/OpticalFlow.hpp"

namespace thinwall {
namespace {

/// Part of the depth by which a place must lie behind another one to be hidden: rounding is far less, and a tool comes
/// no nearer to the wall that it lies before.
constexpr double kBehind = 1e-6;

}  // namespace

OpticalFlow optical_flow(const SeenMoment& from, const SeenMoment& to) {
  const MaterialMatch match({from.snapshot, from.geometry}, {to.snapshot, to.geometry});
  const std::size_t pixels = from.seen.places.size();
  OpticalFlow result(pixels);
  const auto width = static_cast<std::size_t>(from.seen.size.width);
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    if (from.seen.places[pixel].triangle == kNoIndex) continue;
    const auto place = match.find(from.seen.places[pixel]);
    result.state[pixel] = FlowState::kAbsent;
    if (!place) continue;
    const Vector3 point = to.projection.in_camera(point_at(to.geometry, *place));
    result.state[pixel] = FlowState::kOutside;
    const auto landed = to.projection.land(point);
    if (!landed) continue;
    const std::size_t column = pixel % width, row = pixel / width;
    result.flow[pixel] = {static_cast<float>((*landed)[0] - static_cast<double>(column)),
                          static_cast<float>((*landed)[1] - static_cast<double>(row))};
    result.is_known[pixel] = 1;
    const auto ray = to.projection.ray(*landed);
    if (!ray || point.z < to.projection.nearest()) continue;
    const double open = nearest_depth(to.seen, to.projection.nearest(), *landed, *ray);
    const bool is_drawn = !to.geometry.parts[to.geometry.triangles[place->triangle].part].is_hidden;
    result.state[pixel] = is_drawn && open >= point.z * (1 - kBehind) ? FlowState::kSeen : FlowState::kHidden;
  }
  return result;
}

}  // namespace thinwall
