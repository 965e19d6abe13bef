#include "studio/organs/generator/Polygonisation.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <utility>

#include "engine/mesh/MeshMeasures.hpp"
#include "engine/mesh/MeshTopology.hpp"

namespace thinwall {
namespace {

MeshTopology topology_of_surface(const TriangleSurface& surface) {
  return topology_of(static_cast<int>(surface.vertices.size()), surface.triangles);
}

TEST(Polygonisation, SphereIsClosedFacesOutwardsAndHasItsVolume) {
  const TriangleSurface sphere =
      polygonise(sphere_body({0.0001, 0.0002, 0.0003}, 0.01), {-0.012, -0.012, -0.012}, {0.012, 0.012, 0.012}, 1e-3);
  EXPECT_TRUE(is_closed(topology_of_surface(sphere)));
  EXPECT_EQ(topology_of_surface(sphere).euler_characteristic, 2);
  const double exact = 4 * std::numbers::pi / 3 * 1e-6;
  // An inscribed polyhedron with cells of a tenth of the radius: 0.5 % was seen.
  EXPECT_NEAR(enclosed_volume(sphere.vertices, sphere.triangles), exact, 0.01 * exact);
}

TEST(Polygonisation, SurfaceThroughGridPointsIsClosedToo) {
  const TriangleSurface sphere =
      polygonise(sphere_body({0, 0, 0}, 0.004), {-0.006, -0.006, -0.006}, {0.006, 0.006, 0.006}, 1e-3);
  EXPECT_TRUE(is_closed(topology_of_surface(sphere)));
}

TEST(Polygonisation, TunnelIsKept) {
  // A ring of spheres.
  std::vector<AxisPoint> ring;
  for (const auto& [x, y] : {std::pair{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}}) {
    ring.push_back({0.01 * Eigen::Vector3d(x, y, 0), 0.003});
  }
  const TriangleSurface torus =
      polygonise(swept_sphere_body(ring), {-0.016, -0.016, -0.006}, {0.016, 0.016, 0.006}, 1e-3);
  EXPECT_TRUE(is_closed(topology_of_surface(torus)));
  EXPECT_EQ(topology_of_surface(torus).euler_characteristic, 0);
}

}  // namespace
}  // namespace thinwall
