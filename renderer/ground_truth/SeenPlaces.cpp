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

double sum(const std::array<double, 3>& weights) {
  return weights[0] + weights[1] + weights[2];
}

std::array<Vector3, 3> corners_of(const SceneGeometry& geometry, const SeenPlaces& seen, std::uint32_t triangle) {
  const auto& [a, b, c] = geometry.triangles[triangle].corners;
  return {seen.points[a], seen.points[b], seen.points[c]};
}

/// Pixels on a side of a tile: few triangles lie in each.
constexpr int kTile = 8;

int tiles_across(ImageSize size) {
  return (size.width + kTile - 1) / kTile;
}

void see_triangle(std::uint32_t triangle, const RayTriangle& on_rays, const PixelBox& box, const Projection& projection,
                  SeenPlaces& seen) {
  for (int row = box.top; row <= box.bottom; ++row) {
    for (int column = box.left; column <= box.right; ++column) {
      const auto pixel =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(seen.size.width) + static_cast<std::size_t>(column);
      const std::optional<RayPoint>& ray = projection.rays()[pixel];
      if (!ray) continue;
      const std::array<double, 3> weights = on_rays.weights(*ray);
      const double whole = sum(weights);
      if (!on_rays.is_met(weights) || whole == 0) continue;
      const double depth = on_rays.determinant / whole;
      if (!(depth >= projection.nearest() && depth < seen.depth[pixel])) continue;
      seen.depth[pixel] = depth;
      seen.places[pixel] = {.triangle = triangle,
                            .weights = {weights[0] / whole, weights[1] / whole, weights[2] / whole}};
    }
  }
}

}  // namespace

SeenPlaces see(const SceneGeometry& geometry, const Projection& projection) {
  const std::size_t pixels = projection.rays().size();
  const ImageSize size = projection.size();
  SeenPlaces seen{.size = size,
                  .places = std::vector<ScenePlace>(pixels),
                  .depth = std::vector<double>(pixels, std::numeric_limits<double>::infinity()),
                  .points = {},
                  .on_rays = {},
                  .tiles = {}};
  seen.points.reserve(geometry.points.size());
  for (const Vector3& point : geometry.points) seen.points.push_back(projection.in_camera(point));
  seen.on_rays.reserve(geometry.triangles.size());
  seen.tiles.resize(static_cast<std::size_t>(tiles_across(size) * ((size.height + kTile - 1) / kTile)));
  for (std::uint32_t t = 0; t < geometry.triangles.size(); ++t) {
    const std::array<Vector3, 3> corners = corners_of(geometry, seen, t);
    const RayTriangle& on_rays = seen.on_rays.emplace_back(corners);
    if (geometry.parts[geometry.triangles[t].part].is_hidden) continue;
    if (std::max({corners[0].z, corners[1].z, corners[2].z}) < projection.nearest()) continue;
    if (on_rays.determinant == 0) continue;
    const PixelBox box = pixel_box(corners, projection);
    if (box.left > box.right || box.top > box.bottom) continue;
    see_triangle(t, on_rays, box, projection, seen);
    for (int row = box.top / kTile; row <= box.bottom / kTile; ++row) {
      for (int column = box.left / kTile; column <= box.right / kTile; ++column) {
        seen.tiles[static_cast<std::size_t>(row * tiles_across(size) + column)].push_back(t);
      }
    }
  }
  return seen;
}

double nearest_depth(const SeenPlaces& seen, double nearest, PicturePoint point, RayPoint ray) {
  const int column = std::clamp(static_cast<int>(std::floor(point[0] + 0.5)), 0, seen.size.width - 1);
  const int row = std::clamp(static_cast<int>(std::floor(point[1] + 0.5)), 0, seen.size.height - 1);
  double found = std::numeric_limits<double>::infinity();
  for (const std::uint32_t t :
       seen.tiles[static_cast<std::size_t>(row / kTile * tiles_across(seen.size) + column / kTile)]) {
    const RayTriangle& on_rays = seen.on_rays[t];
    const std::array<double, 3> weights = on_rays.weights(ray);
    if (!on_rays.is_met(weights)) continue;
    const double depth = on_rays.determinant / sum(weights);
    if (depth >= nearest && depth < found) found = depth;
  }
  return found;
}

Vector3 point_at(const SceneGeometry& geometry, const ScenePlace& place) {
  const auto& corners = geometry.triangles[place.triangle].corners;
  return place.weights[0] * geometry.points[corners[0]] + place.weights[1] * geometry.points[corners[1]] +
         place.weights[2] * geometry.points[corners[2]];
}

}  // namespace thinwall
