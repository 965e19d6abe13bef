#include "engine/fluid/FluidWeight.hpp"

#include <gtest/gtest.h>

#include "engine/fluid/EnclosedVolume.hpp"
#include "engine/mesh/Shapes.hpp"
#include "tests/engine/HyperDual.hpp"

namespace thinwall {
namespace {

const Eigen::Vector3d kGravity(0.3, -1.2, -9.7);

TEST(FluidWeight, GradientAndHessianAgreeWithExactDerivatives) {
  const std::array<Eigen::Vector3d, 3> corners = {Eigen::Vector3d(0.3, -0.2, 0.9), Eigen::Vector3d(1.1, 0.4, 0.2),
                                                  Eigen::Vector3d(-0.5, 0.8, 0.1)};
  const CornerDerivatives exact = corner_derivatives(
      [](const auto& x) {
        auto mean = dot(x[0], cross(x[1], x[2])) * HyperDual(0);
        for (int k = 0; k < 3; ++k) {
          for (int axis = 0; axis < 3; ++axis) mean = mean + x[k][axis] * HyperDual(kGravity[axis] / 4);
        }
        return mean * dot(x[0], cross(x[1], x[2])) / 6;
      },
      corners);
  const FluidMoment moment = fluid_moment_of(corners, kGravity);
  EXPECT_NEAR(moment.value, exact.value, 1e-15);
  EXPECT_LT((moment.gradient - exact.gradient).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_LT((fluid_moment_hessian(corners, kGravity) - exact.hessian).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(FluidWeight, IsThatOfTheFirstMomentAlongGravity) {
  const std::array<Eigen::Vector3d, 3> corners = {
      {Eigen::Vector3d(0.9, 0.2, -0.1), Eigen::Vector3d(-0.3, 1.1, 0.4), Eigen::Vector3d(0.2, -0.5, 1.3)}};
  const FirstMoment first = first_moment_of(corners);
  const FluidMoment moment = fluid_moment_of(corners, kGravity);
  EXPECT_NEAR(moment.value, kGravity.dot(first.value), 1e-14);
  EXPECT_EQ(moment.value, fluid_moment_value(corners, kGravity));
  EXPECT_LT((moment.gradient - first.gradient * kGravity).norm(), 1e-14);
}

TEST(FluidWeight, FirstMomentsOfTrianglesSideBySideAreThoseOfEachToTheBit) {
  std::array<std::array<Eigen::Vector3d, 3>, kLanes> triangles;
  double corners[9][kLanes];
  for (int lane = 0; lane < kLanes; ++lane) {
    triangles[lane] = {Eigen::Vector3d(0.3, -0.1, 0.7), Eigen::Vector3d(1.2, 0.4, 0.2),
                       Eigen::Vector3d(-0.2, 0.9, 1.1)};
    triangles[lane][lane % 3] *= 1.0 / (lane + 3);
    for (int k = 0; k < 9; ++k) corners[k][lane] = triangles[lane][k / 3][k % 3];
  }
  FirstMoments moments;
  first_moments_of(corners, moments);
  for (int lane = 0; lane < kLanes; ++lane) {
    const FirstMoment alone = first_moment_of(triangles[lane]);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(moments.value[axis][lane], alone.value[axis]) << "axis " << axis << " of lane " << lane;
      for (int k = 0; k < 9; ++k) {
        EXPECT_EQ(moments.gradient[axis][k][lane], alone.gradient(k, axis)) << axis << ", " << k << ", " << lane;
      }
    }
  }
}

TEST(FluidWeight, OfAClosedSurfaceIsVolumeTimesTheHeightOfItsCentroid) {
  // A ball of 80 triangles moved away from the origin; and its buoyancy is volume times gravity (Archimedes).
  const SurfaceMesh mesh = make_sphere(1, 80);
  const Eigen::Vector3d shift(0.4, 0.1, -2);
  double value = 0, volume = 0;
  Eigen::Vector3d push = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3i& t : mesh.triangles) {
    const std::array<Eigen::Vector3d, 3> corners = {mesh.vertices[t[0]] + shift, mesh.vertices[t[1]] + shift,
                                                    mesh.vertices[t[2]] + shift};
    const FluidMoment moment = fluid_moment_of(corners, kGravity);
    value += moment.value;
    volume += volume_of(corners);
    for (int k = 0; k < 3; ++k) push += moment.gradient.segment<3>(3 * k);
  }
  EXPECT_NEAR(value, volume * kGravity.dot(shift), 1e-12);
  EXPECT_LT((push - volume * kGravity).norm(), 1e-12);
}

}  // namespace
}  // namespace thinwall
