#include "renderer/camera/Lens.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "renderer/camera/LensFold.hpp"
#include "tests/renderer/camera/OpenCvProjections.hpp"

namespace thinwall {
namespace {

constexpr LensDistortion kBarrel{.k1 = -0.32, .k2 = 0.11, .k3 = -0.02};
constexpr LensDistortion kSkewed{.k1 = -0.28, .k2 = 0.09, .p1 = -0.0015, .p2 = 0.0011, .k3 = -0.01};

TEST(Lens, PutsPointsWhereOpenCvPutsThem) {
  double worst = 0;
  for (const auto& [coefficients, point, pixel] : test::kOpenCvProjections) {
    const auto [k1, k2, p1, p2, k3] = coefficients;
    const Lens lens({k1, k2, p1, p2, k3});
    const Tangents seen = lens.distorted({point[0] / point[2], point[1] / point[2]});
    worst = std::max({worst, std::abs(639.5 + test::kOpenCvFocalLength * seen[0] - pixel[0]),
                      std::abs(359.5 + test::kOpenCvFocalLength * seen[1] - pixel[1])});
  }
  // The reference is written to a ten-thousandth of a pixel.
  EXPECT_LT(worst, 1e-4);
}

TEST(Lens, GoesBackToWhereItCameFrom) {
  for (const LensDistortion& distortion : {kBarrel, kSkewed, LensDistortion{.k1 = 0.4}, LensDistortion{}}) {
    const Lens lens(distortion);
    for (double x = -0.9; x <= 0.9; x += 0.15) {
      for (double y = -0.6; y <= 0.6; y += 0.15) {
        const auto ideal = lens.undistorted(lens.distorted({x, y}));
        ASSERT_TRUE(ideal) << x << ", " << y;
        EXPECT_NEAR((*ideal)[0], x, 1e-11);
        EXPECT_NEAR((*ideal)[1], y, 1e-11);
      }
    }
  }
}

TEST(Lens, FoldsWhereTheRadialPartStopsGrowing) {
  // r - r^3 / 4 grows up to r^2 = 4 / 3, where it is 2 / 3 r.
  const Lens lens({.k1 = -0.25});
  EXPECT_NEAR(lens.unfolded_radius(), std::sqrt(4.0 / 3), 1e-12);
  const double edge = 2.0 / 3 * std::sqrt(4.0 / 3);
  EXPECT_TRUE(lens.undistorted({0.999 * edge, 0}));
  EXPECT_FALSE(lens.undistorted({1.001 * edge, 0})) << "no ray arrives there";
  EXPECT_FALSE(lens.undistorted({2 * edge, 2 * edge}));
}

TEST(Lens, WithoutAFoldReachesEverywhere) {
  EXPECT_TRUE(std::isinf(Lens().unfolded_radius()));
  EXPECT_TRUE(std::isinf(Lens({.k1 = 0.1, .k2 = 0.01}).unfolded_radius()));
}

TEST(Lens, TheFirstOfTwoFoldsCounts) {
  // Growth 1 + 3 k1 s + 5 k2 s^2 with zeros at s = 1 and s = 2.
  const Lens lens({.k1 = -0.5, .k2 = 0.1});
  EXPECT_NEAR(lens.unfolded_radius(), 1, 1e-12);
}

TEST(Lens, GoesBackFromFarOutWhereHighPowersBendMost) {
  const Lens lens({.k1 = 3, .k2 = 5, .k3 = 8});
  for (double radius = 0.1; radius < 3; radius += 0.1) {
    const Tangents seen = lens.distorted({0.6 * radius, 0.8 * radius});
    const auto ideal = lens.undistorted(seen);
    ASSERT_TRUE(ideal) << radius;
    EXPECT_NEAR(std::hypot((*ideal)[0], (*ideal)[1]), radius, 1e-11);
  }
}

TEST(Lens, TangentialCoefficientsFoldToo) {
  // x + 3 p2 x^2 along x: it turns back at x = -1 / (6 p2), where it is half of that; without a round fold.
  const Lens lens({.p2 = 0.5});
  EXPECT_TRUE(std::isinf(lens.unfolded_radius()));
  EXPECT_TRUE(lens.is_unfolded({-0.33, 0}));
  EXPECT_FALSE(lens.is_unfolded({-0.37, 0})) << "a thirty-second part beyond";
  EXPECT_FALSE(lens.is_unfolded({-10, 0}));
  EXPECT_TRUE(lens.is_unfolded({10, 0}));
  EXPECT_TRUE(lens.undistorted({-0.166, 0}));
  EXPECT_FALSE(lens.undistorted({-0.17, 0})) << "no ray arrives there";
  // The same along y, which is what p1 bends.
  const Lens upright({.p1 = 0.5});
  EXPECT_TRUE(upright.is_unfolded({0, -0.33}));
  EXPECT_FALSE(upright.is_unfolded({0, -0.37}));
}

TEST(Lens, GoesBackInSmallPartsWhereNewtonsMethodWouldCrossAFoldThatIsNotRound) {
  const Lens lens({.k1 = -0.298, .k2 = 0.076, .p1 = -0.005, .p2 = 0.074, .k3 = -0.005});
  const auto ideal = lens.undistorted(lens.distorted({-0.86, -1.97}));
  ASSERT_TRUE(ideal);
  EXPECT_NEAR((*ideal)[0], -0.86, 1e-11);
  EXPECT_NEAR((*ideal)[1], -1.97, 1e-11);
}

TEST(LensFold, ThePictureEndsAtATangentialFoldToo) {
  // Beyond the fold x + 1.5 x^2 + 0.9 x^5 comes back to where a wide picture ends: rays arrive at all of its border.
  const LensDistortion lens{.k2 = 0.9, .p2 = 0.5};
  const ImageSize size{.width = 200, .height = 120};
  const double widest = unfolded_field_of_view(CameraKind::kPinhole, lens, 2.4, size);
  EXPECT_LT(widest, 2 * std::atan(1.0 / 6 / (200.0 / 120)) + 0.01);
  EXPECT_GT(widest, 0.15);
}

TEST(LensFold, WhatIsNarrowerThanTheWidestIsWholeToo) {
  const LensDistortion lens{.k1 = -0.18, .k2 = 0.02, .p1 = 0.03, .p2 = -0.02};
  const ImageSize size{.width = 200, .height = 120};
  const double widest = unfolded_field_of_view(CameraKind::kPinhole, lens, 1, size);
  EXPECT_LT(widest, 1);
  // Forty halvings leave 1e-12; near a fold Newton's method ends a root of rounding before it.
  for (double part = 0.5; part < 1; part += 0.01) {
    EXPECT_EQ(unfolded_field_of_view(CameraKind::kPinhole, lens, part * widest, size), part * widest) << part;
    EXPECT_NEAR(unfolded_field_of_view(CameraKind::kPinhole, lens, (1.02 + part) * widest, size), widest, 1e-6) << part;
  }
}

TEST(LensFold, ThePictureIsWholeUpToTheFieldOfViewWhoseCornersReachTheFold) {
  // r - 0.3 r^3 reaches 2 / 3 r where r^2 = 1 / 0.9; a corner of 320 x 180 lies hypot(1, 16 / 9) half heights out.
  const LensDistortion lens{.k1 = -0.3};
  const double edge = 2.0 / 3 / std::sqrt(0.9);
  const ImageSize size{.width = 320, .height = 180};
  const double widest = 2 * std::atan(edge / std::hypot(1, 16.0 / 9));
  EXPECT_NEAR(unfolded_field_of_view(CameraKind::kPinhole, lens, 2, size), widest, 1e-4);
  EXPECT_EQ(unfolded_field_of_view(CameraKind::kPinhole, lens, 0.99 * widest, size), 0.99 * widest);
  EXPECT_EQ(unfolded_field_of_view(CameraKind::kPinhole, {.k1 = 0.3}, 2, size), 2);
  // An endoscope's stop covers the corners: it lies 1.12 half heights out.
  EXPECT_NEAR(unfolded_field_of_view(CameraKind::kEndoscope, lens, 2, size), 2 * std::atan(edge / 1.12), 1e-4);
}

}  // namespace
}  // namespace thinwall
