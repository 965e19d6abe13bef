// Cuts of walls that are crumpled as they lie: the stress-free surface is smooth, the wall is not.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "engine/cutting/CutSurface.hpp"
#include "engine/mesh/Shapes.hpp"
#include "tests/engine/cutting/CheckedCuts.hpp"

namespace thinwall {
namespace {

using Corners = std::array<Eigen::Vector3d, 3>;

template <typename Vertices>
Corners corners(const Vertices& vertices, const Eigen::Vector3i& triangle) {
  return {vertices[triangle[0]], vertices[triangle[1]], vertices[triangle[2]]};
}

/// tr C + 1 / det C - 3: zero at rest, without bound where a triangle is crushed.
double strain_energy(const Corners& rest, const Corners& now) {
  Eigen::Matrix<double, 3, 2> before, after;
  before << rest[1] - rest[0], rest[2] - rest[0];
  after << now[1] - now[0], now[2] - now[0];
  const Eigen::Matrix2d metric = (before.transpose() * before).inverse() * (after.transpose() * after);
  return metric.trace() + 1 / metric.determinant() - 3;
}

/// Triangles of a cut with more than twice the energy, and a tenth, of all that lay in their places.
int strained_triangles(const SurfaceMesh& before, const std::vector<Eigen::Vector3d>& placement,
                       const CutSurface& after, const Cut& cut) {
  std::vector<Eigen::Vector3d> now = placement;
  now.resize(after.mesh().vertices.size());
  for (const VertexSource& source : cut.vertices) {
    const Corners triangle = corners(placement, before.triangles[source.before.triangle]);
    now[source.vertex].setZero();
    for (int k = 0; k < 3; ++k) now[source.vertex] += source.before.weights[k] * triangle[k];
  }
  int strained = 0;
  for (const TriangleSource& source : cut.triangles) {
    double most = 0;
    for (const TriangleShare& share : source.before) {
      const Eigen::Vector3i& triangle = before.triangles[share.triangle];
      most = std::max(most, strain_energy(corners(before.vertices, triangle), corners(placement, triangle)));
    }
    const Eigen::Vector3i& triangle = after.mesh().triangles[source.triangle];
    // The placement of a vertex is known to round-off only.
    const double energy = strain_energy(corners(after.mesh().vertices, triangle), corners(now, triangle));
    strained += energy > (2 * most + 0.1) * (1 + 1e-9);
  }
  return strained;
}

/// Over sixty sheets whose vertices lie up to 0.4 of an edge from where they belong, in random directions.
int strained_triangles_of_crumpled_sheets(bool knows_placement) {
  int strained = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    const SurfaceMesh mesh = make_sheet(2, 2, 400);
    std::vector<Eigen::Vector3d> placement = mesh.vertices;
    for (Eigen::Vector3d& place : placement) {
      place += 0.06 * Eigen::Vector3d(unit(engine), unit(engine), unit(engine));
    }
    CutSurface surface(mesh);
    const Eigen::Vector3d from(-0.6, 0.5 * unit(engine), 0), to(0.6, 0.5 * unit(engine), 0);
    CutOptions options;
    if (knows_placement) options.placement = placement;
    const Cut cut = surface.cut({.from = {}, .points = points_at(mesh, {from, to})}, options);
    EXPECT_GT(cut.length, 1.0);
    strained += strained_triangles(mesh, placement, surface, cut);
  }
  return strained;
}

TEST(ACutOfACrumpledWall, MakesNoTriangleThatIsStrainedFarMoreThanWhatLayThere) {
  EXPECT_EQ(strained_triangles_of_crumpled_sheets(true), 0);
  EXPECT_GT(strained_triangles_of_crumpled_sheets(false), 0);
}

}  // namespace
}  // namespace thinwall
