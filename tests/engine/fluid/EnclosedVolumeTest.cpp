#include "engine/fluid/EnclosedVolume.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>
#include <vector>

#include "engine/mesh/Shapes.hpp"
#include "tests/engine/HyperDual.hpp"

namespace thinwall {
namespace {

using Corners = std::array<Eigen::Vector3d, 3>;

Corners some_corners() {
  return {Eigen::Vector3d(0.3, -0.1, 0.7), Eigen::Vector3d(1.2, 0.4, 0.2), Eigen::Vector3d(-0.2, 0.9, 1.1)};
}

/// Volume and total gradient of a mesh with its caps, moved by `shift`.
struct Total {
  double volume = 0;
  std::vector<Eigen::Vector3d> gradient;  // (vertices x 3)
};

Total total_of(const SurfaceMesh& mesh, const Eigen::Vector3d& shift) {
  Total total{.volume = 0, .gradient = std::vector<Eigen::Vector3d>(mesh.vertices.size(), Eigen::Vector3d::Zero())};
  for (const auto* list : {&mesh.triangles, &mesh.cap_triangles}) {
    for (const Eigen::Vector3i& triangle : *list) {
      const Corners corners = {mesh.vertices[triangle[0]] + shift, mesh.vertices[triangle[1]] + shift,
                               mesh.vertices[triangle[2]] + shift};
      total.volume += volume_of(corners);
      const auto gradient = volume_gradient_of(corners);
      for (int k = 0; k < 3; ++k) total.gradient[triangle[k]] += gradient.segment<3>(3 * k);
    }
  }
  return total;
}

TEST(EnclosedVolume, GradientsOfTrianglesSideBySideAreThoseOfEachToTheBit) {
  std::array<Corners, kLanes> triangles;
  double corners[9][kLanes], gradients[9][kLanes];
  for (int lane = 0; lane < kLanes; ++lane) {
    triangles[lane] = some_corners();
    triangles[lane][lane % 3] *= 1.0 / (lane + 3);
    for (int k = 0; k < 9; ++k) corners[k][lane] = triangles[lane][k / 3][k % 3];
  }
  volume_gradients_of(corners, gradients);
  for (int lane = 0; lane < kLanes; ++lane) {
    const auto alone = volume_gradient_of(triangles[lane]);
    for (int k = 0; k < 9; ++k) EXPECT_EQ(gradients[k][lane], alone[k]) << "component " << k << " of lane " << lane;
  }
}

TEST(EnclosedVolume, CubeAndTetrahedronHaveTheVolumesOfTheSchoolbook) {
  SurfaceMesh tetrahedron;
  tetrahedron.vertices = {{0, 0, 0}, {3, 0, 0}, {0, 2, 0}, {0, 0, 5}};
  tetrahedron.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  EXPECT_NEAR(total_of(tetrahedron, {0, 0, 0}).volume, 5, 1e-15);
  SurfaceMesh cube;
  for (int k = 0; k < 8; ++k) cube.vertices.emplace_back(k & 1, (k >> 1) & 1, (k >> 2) & 1);
  cube.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  EXPECT_NEAR(total_of(cube, {0, 0, 0}).volume, 1, 1e-15);
}

TEST(EnclosedVolume, FineSphereApproachesFourThirdsPi) {
  const double exact = 4 * std::numbers::pi / 3;
  const double coarse = exact - total_of(make_sphere(1, 320), {0, 0, 0}).volume;
  const double fine = exact - total_of(make_sphere(1, 1280), {0, 0, 0}).volume;
  EXPECT_GT(fine, 0);                  // an inscribed polyhedron
  EXPECT_NEAR(coarse / fine, 4, 0.1);  // flat facets: second order; seen 3.96
  EXPECT_LT(fine, 0.01 * exact);
}

TEST(EnclosedVolume, GradientAndHessianAgreeWithExactDerivativesOfTheTripleProduct) {
  const CornerDerivatives exact =
      corner_derivatives([](const auto& x) { return dot(x[0], cross(x[1], x[2])) / 6; }, some_corners());
  EXPECT_NEAR(volume_of(some_corners()), exact.value, 1e-16);
  EXPECT_LT((volume_gradient_of(some_corners()) - exact.gradient).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_LT((volume_hessian_of(some_corners()) - exact.hessian).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(EnclosedVolume, HessianIsSymmetric) {
  const Eigen::Matrix<double, 9, 9> hessian = volume_hessian_of(some_corners());
  EXPECT_EQ((hessian - hessian.transpose()).cwiseAbs().maxCoeff(), 0);
}

TEST(EnclosedVolume, PressureGivesEachVertexAThirdOfTheAreaVectorsAroundIt) {
  const SurfaceMesh mesh = make_sphere(1, 80);
  std::vector<Eigen::Vector3d> shares(mesh.vertices.size(), Eigen::Vector3d::Zero());
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    const Eigen::Vector3d &a = mesh.vertices[triangle[0]], &b = mesh.vertices[triangle[1]],
                          &c = mesh.vertices[triangle[2]];
    for (const int vertex : triangle) shares[vertex] += (b - a).cross(c - a) / 6;
  }
  const Total total = total_of(mesh, {3, 1, -2});
  for (std::size_t v = 0; v < shares.size(); ++v) EXPECT_LT((total.gradient[v] - shares[v]).norm(), 1e-14);
}

TEST(EnclosedVolume, ClosedSurfaceKnowsNoOrigin) {
  const Eigen::Vector3d shift(0.5, -2, 1);
  for (const SurfaceMesh& mesh : {make_sphere(1, 80), make_hemisphere(1, 64), make_semicylinder(1, 2, 200)}) {
    const Total here = total_of(mesh, {0, 0, 0}), there = total_of(mesh, shift);
    // Terms of the shifted sum are some ten times the volume; residuals seen 1e-15.
    EXPECT_NEAR(there.volume, here.volume, 1e-13);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero(), torque = Eigen::Vector3d::Zero();
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
      EXPECT_LT((there.gradient[v] - here.gradient[v]).norm(), 1e-14);
      sum += here.gradient[v];
      torque += mesh.vertices[v].cross(here.gradient[v]);
    }
    // An even pressure neither pushes nor turns a closed body.
    EXPECT_LT(sum.norm(), 1e-14);
    EXPECT_LT(torque.norm(), 1e-14);
  }
}

TEST(EnclosedVolume, GrowsByThriceItsShareWhenTheSurfaceIsBlownUp) {
  // x . dV/dx = 3 V: volume is homogeneous of degree three (Euler).
  const Corners corners = some_corners();
  Eigen::Matrix<double, 9, 1> x;
  x << corners[0], corners[1], corners[2];
  EXPECT_NEAR(x.dot(volume_gradient_of(corners)), 3 * volume_of(corners), 1e-15);
  EXPECT_LT((volume_hessian_of(corners) * x - 2 * volume_gradient_of(corners)).norm(), 1e-15);
}

}  // namespace
}  // namespace thinwall
