#include "renderer/ground_truth/OpticalFlow.hpp"

#include <algorithm>
#include <cmath>

namespace thinwall {
namespace {

/// Parts of the depth by which a place lies behind another one that hides it: where the ray meets the very triangle that
/// the pixel's middle shows, of another part; and where it passes beside it, or meets a bend of the same part.
constexpr double kBehindTriangle = 1e-6;
constexpr double kBehindSurroundings = 1e-3;

struct Cover {
  double depth = 0;      // metres
  bool is_met = false;  // whether the ray meets the triangle; else the depth is that of its nearest place by weights
};

Cover cover_on_ray(const SeenMoment& moment, std::uint32_t triangle, RayPoint ray) {
  std::array<Vector3, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    corners[k] = moment.projection.in_camera(moment.geometry.points[moment.geometry.triangles[triangle].corners[k]]);
  }
  const Vector3 direction{ray[0], ray[1], 1};
  std::array<double, 3> weights = {dot(direction, cross(corners[1], corners[2])),
                                   dot(direction, cross(corners[2], corners[0])),
                                   dot(direction, cross(corners[0], corners[1]))};
  const double side = dot(corners[0], cross(corners[1], corners[2])) < 0 ? -1 : 1;
  Cover cover{.is_met = true};
  double sum = 0;
  for (double& weight : weights) {
    cover.is_met = cover.is_met && side * weight >= 0;
    weight = std::max(0.0, side * weight);
    sum += weight;
  }
  cover.depth = (weights[0] * corners[0].z + weights[1] * corners[1].z + weights[2] * corners[2].z) / sum;
  return cover;
}

bool is_hidden(const SeenMoment& moment, const ScenePlace& place, double depth, PicturePoint landed, RayPoint ray) {
  const ImageSize size = moment.projection.size();
  const int column = std::clamp(static_cast<int>(std::floor(landed[0] + 0.5)), 0, size.width - 1);
  const int row = std::clamp(static_cast<int>(std::floor(landed[1] + 0.5)), 0, size.height - 1);
  const ScenePlace& shown = moment.seen.places[static_cast<std::size_t>(row) * static_cast<std::size_t>(size.width) +
                                               static_cast<std::size_t>(column)];
  if (shown.triangle == kNone || shown.triangle == place.triangle) return false;
  const auto& triangles = moment.geometry.triangles;
  const Cover cover = cover_on_ray(moment, shown.triangle, ray);
  const bool is_clear = cover.is_met && triangles[shown.triangle].part != triangles[place.triangle].part;
  return cover.depth < depth * (1 - (is_clear ? kBehindTriangle : kBehindSurroundings));
}

}  // namespace

OpticalFlow optical_flow(const SeenMoment& from, const SeenMoment& to) {
  const MaterialMatch match({from.snapshot, from.geometry}, {to.snapshot, to.geometry});
  const std::size_t pixels = from.seen.places.size();
  OpticalFlow result{.flow = std::vector<std::array<float, 2>>(pixels),
                     .state = std::vector<FlowState>(pixels, FlowState::kNothing)};
  const auto width = static_cast<std::size_t>(from.seen.size.width);
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    if (from.seen.places[pixel].triangle == kNone) continue;
    const auto place = match.find(from.seen.places[pixel]);
    result.state[pixel] = FlowState::kAbsent;
    if (!place) continue;
    const Vector3 point = to.projection.in_camera(point_at(to.geometry, *place));
    result.state[pixel] = FlowState::kOutside;
    const auto landed = to.projection.land(point);
    if (!landed) continue;
    result.flow[pixel] = {static_cast<float>((*landed)[0] - static_cast<double>(pixel % width)),
                          static_cast<float>((*landed)[1] - static_cast<double>(pixel / width))};
    const auto ray = to.projection.ray(*landed);
    if (!ray || point.z < to.projection.nearest()) continue;
    result.state[pixel] = is_hidden(to, *place, point.z, *landed, *ray) ? FlowState::kHidden : FlowState::kSeen;
  }
  return result;
}

}  // namespace thinwall
