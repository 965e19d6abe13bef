#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "renderer/camera/Camera.hpp"
#include "renderer/image/PictureFailure.hpp"
#include "renderer/picture/Renderer.hpp"
#include "tests/renderer/shape/TestMeshes.hpp"

namespace thinwall {
namespace {

constexpr ImageSize kLensSize{640, 360};
constexpr LensDistortion kBarrel{.k1 = -0.3, .k2 = 0.1, .p1 = 0.002, .p2 = -0.001};

ViewDefinition through(const LensDistortion& lens) {
  ViewDefinition view;
  view.camera.position = Double3{0, 0, 0.1};
  view.camera.target = Double3{0, 0, 0};
  view.camera.up = Double3{0, 1, 0};
  view.camera.field_of_view = 1;
  view.camera.lens = lens;
  view.look.floor = false;
  view.look.background = {0, 0, 0};
  return view;
}

/// A small bright plate at a place of the plane z = 0.
Snapshot plate(double x, double y) {
  constexpr double kHalf = 0.0015;
  const auto corner = [&](double sx, double sy) {
    return Float3{static_cast<float>(x + sx * kHalf), static_cast<float>(y + sy * kHalf), 0};
  };
  Snapshot snapshot;
  snapshot.surfaces.push_back(test::quad("plate", {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)}));
  return snapshot;
}

/// Where the middle of what is bright lies, pixels.
std::array<double, 2> middle_of_the_light(const Image& image) {
  double weight = 0, x = 0, y = 0;
  for (int row = 0; row < image.size.height; ++row) {
    for (int column = 0; column < image.size.width; ++column) {
      const auto level = image.pixels[3 * static_cast<std::size_t>(row * image.size.width + column)];
      if (level < 60) continue;
      weight += level;
      x += level * (column + 0.5);
      y += level * (row + 0.5);
    }
  }
  return {x / weight, y / weight};
}

TEST(LensPicture, ThingsAppearWhereTheLensPutsThem) {
  Renderer renderer(DeviceChoice{}, kLensSize, Tier::kRecord);
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, std::pair{0.06, 0.02}, std::pair{-0.07, -0.03}}) {
    const Snapshot snapshot = plate(x, y);
    const ViewDefinition view = through(kBarrel);
    const Camera camera = resolve_camera(view.camera, scene_extent(snapshot), kLensSize, 0);
    const auto expected = camera.pixel({x, y, 0}, kLensSize);
    ASSERT_TRUE(expected);
    const auto found = middle_of_the_light(renderer.draw(snapshot, view));
    // The plate is lit unevenly and its picture a little bent, so the middle is known to some tenths of a pixel;
    // without the lens the outer ones lie tens of pixels off.
    EXPECT_NEAR(found[0], (*expected)[0], 0.5);
    EXPECT_NEAR(found[1], (*expected)[1], 0.5);
  }
}

TEST(LensPicture, ALensThatBendsNothingChangesNothing) {
  Renderer renderer(DeviceChoice{}, kLensSize, Tier::kRecord);
  const Snapshot snapshot = plate(0.02, 0.01);
  const Image plain = renderer.draw(snapshot, through({}));
  renderer.draw(snapshot, through(kBarrel));
  EXPECT_EQ(renderer.draw(snapshot, through({})).pixels, plain.pixels) << "whatever was drawn before";
}

TEST(LensPicture, ALensThatFoldsThePictureIsRefused) {
  Renderer renderer(DeviceChoice{}, kLensSize, Tier::kDraft);
  EXPECT_THROW(renderer.draw(plate(0, 0), through({.k1 = -1})), PictureFailure);
}

TEST(LensPicture, BeyondTheFieldStopNothingIsSeenWhereTheLensFolds) {
  // The picture's corners are at a tangent of 1.11, but r (1 - 0.2 r^2) never exceeds 0.86.
  Renderer renderer(DeviceChoice{}, kLensSize, Tier::kDraft);
  ViewDefinition view = through({.k1 = -0.2});
  view.camera.kind = CameraKind::kEndoscope;
  view.look.background = {1, 1, 1};
  const Image image = renderer.draw(plate(0, 0), view);
  const Camera camera = resolve_camera(view.camera, scene_extent(plate(0, 0)), kLensSize, 0);
  int bright = 0;
  for (int row = 0; row < kLensSize.height; ++row) {
    for (int column = 0; column < kLensSize.width; ++column) {
      const double x = (2 * (column + 0.5) / kLensSize.width - 1) * camera.tangent_x;
      const double y = (2 * (row + 0.5) / kLensSize.height - 1) * camera.tangent_y;
      if (std::hypot(x, y) < 1.1 * camera.field_stop) continue;
      const auto pixel = image.pixels.begin() + 3 * static_cast<std::ptrdiff_t>(row * kLensSize.width + column);
      bright += *std::max_element(pixel, pixel + 3) > 8 ? 1 : 0;
    }
  }
  EXPECT_EQ(bright, 0);
}

TEST(LensPicture, NoiseDependsOnSeedAndMomentAlone) {
  Renderer renderer(DeviceChoice{}, kLensSize, Tier::kDraft);
  Snapshot snapshot = plate(0, 0);
  ViewDefinition view = through({});
  const Image clean = renderer.draw(snapshot, view);
  view.camera.noise = 2;
  const Image noisy = renderer.draw(snapshot, view);
  EXPECT_NE(noisy.pixels, clean.pixels);
  snapshot.time = 0.5;
  EXPECT_NE(renderer.draw(snapshot, view).pixels, noisy.pixels);
  snapshot.time = 0;
  EXPECT_EQ(renderer.draw(snapshot, view).pixels, noisy.pixels);
  view.camera.seed = 2;
  EXPECT_NE(renderer.draw(snapshot, view).pixels, noisy.pixels);
}

}  // namespace
}  // namespace thinwall
