#include "tests/benchmarks/engine/published/TetrahedralSolid.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "tests/benchmarks/engine/published/OperationCount.hpp"

namespace thinwall {
namespace {

constexpr double kRadius = 20e-3;  // metres

double volume_of(const TetrahedralMesh& mesh, const std::array<int, 4>& corners) {
  Eigen::Matrix3d edges;
  for (int k = 0; k < 3; ++k) edges.col(k) = mesh.vertices[corners[k + 1]] - mesh.vertices[corners[0]];
  return edges.determinant() / 6;
}

TEST(TetrahedralSolidTest, TheHalfBallHasThePublishedSizeAndFillsItsSurface) {
  const TetrahedralMesh mesh = make_half_ball(kRadius, 4);
  EXPECT_EQ(mesh.vertices.size(), 328U);
  double volume = 0;
  for (const std::array<int, 4>& corners : mesh.tetrahedra) {
    EXPECT_GT(volume_of(mesh, corners), 0);
    volume += volume_of(mesh, corners);
  }
  // Finer ones come near the half ball as the square of the edges: a facetted surface lies inside.
  const double exact = 2.0 / 3 * std::numbers::pi * std::pow(kRadius, 3);
  double finer = 0;
  const TetrahedralMesh fine = make_half_ball(kRadius, 8);
  for (const std::array<int, 4>& corners : fine.tetrahedra) finer += volume_of(fine, corners);
  EXPECT_NEAR((exact - volume) / (exact - finer), 4, 0.3);
}

TEST(TetrahedralSolidTest, PressedItPushesBackWithTheForceThatItsEnergyRisesBy) {
  // A linear chord: over equal small steps the force grows evenly, and it points out of the solid.
  TetrahedralSolid solid(make_half_ball(kRadius, 4), {.mu = 1e3, .lambda = 9e3});
  ASSERT_GT(solid.press(kRadius - 1e-5, 1e-9), 0);
  const double first = solid.crown_force().z();
  ASSERT_GT(solid.press(kRadius - 2e-5, 1e-9), 0);
  EXPECT_GT(first, 0);
  EXPECT_NEAR(solid.crown_force().z(), 2 * first, 2e-2 * first);
  ASSERT_GT(solid.press(kRadius - 2e-3, 1e-9), 0);
  EXPECT_GT(solid.crown_force().z(), 100 * first);
}

TEST(TetrahedralSolidTest, NewtonEndsQuadratically) {
  TetrahedralSolid solid(make_half_ball(kRadius, 4), {.mu = 1e3, .lambda = 9e3});
  // A wrong Hessian would take tens.
  EXPECT_LE(solid.press(kRadius - 0.2e-3, 1e-9), 6);
}

TEST(OperationCountTest, CountsWhatIsExecuted) {
  volatile double sum = 1;
  const double count = count_operations([&] {
    for (int k = 0; k < 500; ++k) sum = sum * 1.5 + 0.25;
  });
  EXPECT_EQ(count, 1000);
  Eigen::Matrix<double, 8, 8> a = Eigen::Matrix<double, 8, 8>::Random(), b = a.transpose();
  Eigen::Matrix<double, 8, 8> product;
  const double dense = count_operations([&] {
    product = a.lazyProduct(b);
    sum = product(0, 0);
  });
  EXPECT_EQ(dense, 8 * 8 * (8 + 7));
}

}  // namespace
}  // namespace thinwall
