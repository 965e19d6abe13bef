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

/// What the middle of each pixel shows: nothing is blended.
struct SeenPlaces {
  ImageSize size;
  std::vector<ScenePlace> places;  // (height x width)
  std::vector<double> depth;       // (height x width), metres along the line of sight; infinite where nothing is seen
  std::vector<Vector3> points;     // of the geometry, metres in the camera's axes
  std::vector<std::vector<std::uint32_t>> tiles;  // triangles that may be seen in squares of pixels, row after row
};

/// The nearest place of the scene on the ray of each pixel's middle, in double precision, whatever the lens: a ray
/// (u, v, 1) meets a triangle a, b, c where (u, v, 1) . (b x c) and its like have one sign; they are its weights but
/// for their sum (Olano and Greer 1997). Of places at the same depth that of the earlier triangle counts.
SeenPlaces see(const SceneGeometry& geometry, const Projection& projection);

/// Metres along the line of sight to the nearest place of the scene on a ray, which belongs to a point of the picture;
/// infinite where there is none.
double nearest_depth(const SceneGeometry& geometry, const SeenPlaces& seen, double nearest, PicturePoint point,
                     RayPoint ray);

/// The point of a place, metres.
Vector3 point_at(const SceneGeometry& geometry, const ScenePlace& place);

}  // namespace thinwall
