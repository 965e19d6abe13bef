#pragma once

#include <array>
#include <vector>

#include "renderer/ground_truth/Projection.hpp"
#include "renderer/ground_truth/SceneGeometry.hpp"

namespace thinwall {

/// A place on a triangle of a scene.
struct ScenePlace {
  std::uint32_t triangle = kNoIndex;  // kNoIndex: nothing is there
  std::array<double, 3> weights{};    // of its corners, sum 1
};

/// A triangle as rays (u, v, 1) in the camera's axes meet it.
struct RayTriangle {
  std::array<Vector3, 3> products;  // of the corners' neighbours, each belongs to the weight of its corner
  double determinant = 0;

  explicit RayTriangle(const std::array<Vector3, 3>& corners)
      : products{cross(corners[1], corners[2]), cross(corners[2], corners[0]), cross(corners[0], corners[1])},
        determinant(dot(corners[0], products[0])) {}

  /// Weights of the corners but for their sum.
  std::array<double, 3> weights(RayPoint ray) const {
    std::array<double, 3> result;
    for (std::size_t k = 0; k < 3; ++k) result[k] = ray[0] * products[k].x + ray[1] * products[k].y + products[k].z;
    return result;
  }
  bool is_met(const std::array<double, 3>& weights) const {
    return determinant > 0 ? weights[0] >= 0 && weights[1] >= 0 && weights[2] >= 0
                           : weights[0] <= 0 && weights[1] <= 0 && weights[2] <= 0;
  }
};

/// What the middle of each pixel shows: nothing is blended.
struct SeenPlaces {
  ImageSize size;
  std::vector<ScenePlace> places;    // (height x width)
  std::vector<double> depth;         // (height x width), metres along the line of sight; infinite where nothing is seen
  std::vector<Vector3> points;       // of the geometry, metres in the camera's axes
  std::vector<RayTriangle> on_rays;  // (triangles of the geometry)
  std::vector<std::vector<std::uint32_t>> tiles;  // triangles that may be seen in squares of pixels, row after row
};

/// The nearest place of the scene on the ray of each pixel's middle, in double precision, whatever the lens: a ray
/// (u, v, 1) meets a triangle a, b, c where (u, v, 1) . (b x c) and its like have one sign; they are its weights but
/// for their sum (Olano and Greer 1997). Of places at the same depth that of the earlier triangle counts.
SeenPlaces see(const SceneGeometry& geometry, const Projection& projection);

/// Metres along the line of sight to the nearest place of the scene on a ray, which belongs to a point of the picture;
/// infinite where there is none.
double nearest_depth(const SeenPlaces& seen, double nearest, PicturePoint point, RayPoint ray);

/// The point of a place, metres.
Vector3 point_at(const SceneGeometry& geometry, const ScenePlace& place);

}  // namespace thinwall
