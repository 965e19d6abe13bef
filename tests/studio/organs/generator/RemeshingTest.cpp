#include "studio/organs/remeshing/Remeshing.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "engine/mesh/MeshMeasures.hpp"
#include "engine/mesh/MeshTopology.hpp"
#include "studio/organs/generator/ImplicitBody.hpp"
#include "studio/organs/generator/Polygonisation.hpp"

namespace thinwall {
namespace {

constexpr double kOneDegree = std::numbers::pi / 180;

const ImplicitBody kEgg = swept_sphere_body({{{0, 0, 0}, 0.01}, {{0.008, 0, 0}, 0.008}, {{0.016, 0.004, 0}, 0.004}});

TriangleSurface remeshed(const RemeshingOptions& options) {
  return remesh(polygonise(kEgg, {-0.012, -0.012, -0.012}, {0.022, 0.012, 0.012}, 1e-3), surface_of(kEgg), options);
}

SurfaceMesh mesh_of(const TriangleSurface& surface) {
  return {surface.vertices, surface.triangles, {}, {}};
}

TEST(Remeshing, MeetsEvenCountsExactlyWithWellShapedTrianglesOnTheSurface) {
  for (const int wanted : {300, 1000, 3000}) {
    const TriangleSurface surface = remeshed({.triangles = wanted});
    EXPECT_EQ(static_cast<int>(surface.triangles.size()), wanted);
    EXPECT_TRUE(is_closed(topology_of(static_cast<int>(surface.vertices.size()), surface.triangles)));
    const MeshQuality quality = quality_of(mesh_of(surface));
    // 37 to 44 and 55 degrees were seen.
    EXPECT_GT(quality.least_angle, 33 * kOneDegree) << wanted;
    EXPECT_GT(quality.median_angle, 53 * kOneDegree) << wanted;
    for (const Eigen::Vector3d& v : surface.vertices) EXPECT_NEAR(kEgg(v).value, 0, 1e-9);
  }
}

TEST(Remeshing, RelativeEdgeLengthIsFollowed) {
  const TriangleSurface surface = remeshed(
      {.triangles = 2000, .relative_edge_length = [](const Eigen::Vector3d& p) { return p[0] > 0.006 ? 0.5 : 1.0; }});
  const std::vector<double> areas = triangle_areas(surface.vertices, surface.triangles);
  double fine = 0, coarse = 0;
  int fine_count = 0, coarse_count = 0;
  for (std::size_t t = 0; t < areas.size(); ++t) {
    const double x = surface.vertices[surface.triangles[t][0]][0];
    if (x > 0.008) {
      fine += areas[t];
      ++fine_count;
    } else if (x < 0.004) {
      coarse += areas[t];
      ++coarse_count;
    }
  }
  // Half the length is a quarter of the area.
  EXPECT_NEAR((coarse / coarse_count) / (fine / fine_count), 4, 0.6);
}

TEST(Remeshing, IsTheSameEveryTime) {
  const TriangleSurface first = remeshed({.triangles = 500});
  const TriangleSurface second = remeshed({.triangles = 500});
  EXPECT_EQ(first.vertices, second.vertices);
  EXPECT_EQ(first.triangles, second.triangles);
}

}  // namespace
}  // namespace thinwall
