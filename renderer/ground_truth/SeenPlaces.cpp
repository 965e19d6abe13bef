#include "renderer/ground_truth/SeenPlaces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace thinwall {
namespace {

/// The pixels in which a triangle may be seen, last ones included.
struct PixelBox {
  int left = 0, top = 0, right = 0, bottom = 0;
};

/// Pixels by which sides of triangles stay within the box of what lands at their ends and middles.
constexpr double kMargin = 1;

PixelBox pixel_box(const std::array<Vector3, 3>& corners, const Projection& projection) {
  const ImageSize size = projection.size();
  const PixelBox all = {.left = 0, .top = 0, .right = size.width - 1, .bottom = size.height - 1};
  double low[2] = {1e9, 1e9}, high[2] = {-1e9, -1e9}, bulge = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3 &start = corners[k], &end = corners[(k + 1) % 3];
    if (start.z < projection.nearest() || end.z < projection.nearest()) return all;
    const auto a = projection.land(start), b = projection.land(end);
    // The middle of what is seen of the side.
    const auto middle = projection.land((1 / start.z) * start + (1 / end.z) * end);
    if (!a || !b || !middle) return all;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      low[axis] = std::min(low[axis], (*a)[axis]);
      high[axis] = std::max(high[axis], (*a)[axis]);
      // A lens bends straight sides.
      bulge = std::max(bulge, 2 * std::abs((*middle)[axis] - 0.5 * ((*a)[axis] + (*b)[axis])));
    }
  }
  const auto within = [](double value, int last) {
    return static_cast<int>(std::clamp(value, -1.0, static_cast<double>(last) + 1));
  };
  const double margin = kMargin + bulge;
  return {.left = std::max(0, within(std::floor(low[0] - margin), all.right)),
          .top = std::max(0, within(std::floor(low[1] - margin), all.bottom)),
          .right = std::min(all.right, within(std::ceil(high[0] + margin), all.right)),
          .bottom = std::min(all.bottom, within(std::ceil(high[1] + margin), all.bottom))};
}

/// Weights but for their sum, and the depth times it, of the places of a triangle on rays.
struct RayTriangle {
  std::array<Vector3, 3> products;
  double determinant = 0;

  explicit RayTriangle(const std::array<Vector3, 3>& corners)
      : products{cross(corners[1], corners[2]), cross(corners[2], corners[0]), cross(corners[0], corners[1])},
        determinant(dot(corners[0], products[0])) {}
};

void see_triangle(std::uint32_t triangle, const std::array<Vector3, 3>& corners, const Projection& projection,
                  SeenPlaces& seen) {
  const RayTriangle on_rays(corners);
  if (on_rays.determinant == 0) return;
  const double sign = on_rays.determinant > 0 ? 1 : -1;
  const PixelBox box = pixel_box(corners, projection);
  for (int row = box.top; row <= box.bottom; ++row) {
    for (int column = box.left; column <= box.right; ++column) {
      const auto pixel = static_cast<std::size_t>(row) * static_cast<std::size_t>(seen.size.width) +
                         static_cast<std::size_t>(column);
      const std::optional<RayPoint>& ray = projection.rays()[pixel];
      if (!ray) continue;
      std::array<double, 3> weights;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vector3& product = on_rays.products[k];
        weights[k] = (*ray)[0] * product.x + (*ray)[1] * product.y + product.z;
      }
      if (sign * weights[0] < 0 || sign * weights[1] < 0 || sign * weights[2] < 0) continue;
      const double sum = weights[0] + weights[1] + weights[2];
      const double depth = on_rays.determinant / sum;
      if (sum == 0 || !(depth >= projection.nearest() && depth < seen.depth[pixel])) continue;
      seen.depth[pixel] = depth;
      seen.places[pixel] = {.triangle = triangle, .weights = {weights[0] / sum, weights[1] / sum, weights[2] / sum}};
    }
  }
}

}  // namespace

SeenPlaces see(const SceneGeometry& geometry, const Projection& projection) {
  const std::size_t pixels = projection.rays().size();
  SeenPlaces seen{.size = projection.size(),
                  .places = std::vector<ScenePlace>(pixels),
                  .depth = std::vector<double>(pixels, std::numeric_limits<double>::infinity())};
  std::vector<Vector3> points;
  points.reserve(geometry.points.size());
  for (const Vector3& point : geometry.points) points.push_back(projection.in_camera(point));
  for (std::uint32_t t = 0; t < geometry.triangles.size(); ++t) {
    const auto& [a, b, c] = geometry.triangles[t].corners;
    const std::array<Vector3, 3> corners = {points[a], points[b], points[c]};
    if (std::max({corners[0].z, corners[1].z, corners[2].z}) < projection.nearest()) continue;
    see_triangle(t, corners, projection, seen);
  }
  return seen;
}

Vector3 point_at(const SceneGeometry& geometry, const ScenePlace& place) {
  const auto& corners = geometry.triangles[place.triangle].corners;
  return place.weights[0] * geometry.points[corners[0]] + place.weights[1] * geometry.points[corners[1]] +
         place.weights[2] * geometry.points[corners[2]];
}

}  // namespace thinwall
