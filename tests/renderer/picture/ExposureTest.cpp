#include "renderer/picture/Exposure.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/renderer/shape/TestMeshes.hpp"

namespace thinwall {
namespace {

constexpr ImageSize kSize{320, 240};

/// The exposure for a sheet that an endoscope sees at right angles from `distance` metres; the lamp is of the strength
/// that it has at a tenth of a metre, the sheet of the colour `color`.
double exposure_at(double distance, double lamp = 1, Double3 color = TissueLook{}.color) {
  Snapshot snapshot;
  snapshot.surfaces.push_back(
      test::quad("sheet", {Float3{-0.02F, -0.02F, 0}, {0.02F, -0.02F, 0}, {0.02F, 0.02F, 0}, {-0.02F, 0.02F, 0}}));
  ViewDefinition view;
  view.camera.position = Double3{0, 0, distance};
  view.camera.target = Double3{0, 0, 0};
  view.camera.field_of_view = 1;
  view.look.bodies["sheet"].color = color;
  const Camera camera = resolve_camera(view.camera, scene_extent(snapshot), kSize, 0);
  FrameUniforms frame;
  frame.key_direction = {0, 0, static_cast<float>(distance), static_cast<float>(0.01 * lamp)};
  return metered_exposure(snapshot, view, camera, frame, true);
}

TEST(Exposure, MakesUpForTheFallOffOfTheLamp) {
  // Twice the distance, a quarter of the light, two stops; the corners are lit a little more aslant from near.
  EXPECT_NEAR(exposure_at(0.12) - exposure_at(0.08), 2 * std::log2(1.5), 0.06);
}

TEST(Exposure, ALampTwiceAsStrongTakesOneStop) {
  EXPECT_NEAR(exposure_at(0.1, 1) - exposure_at(0.1, 2), 1, 1e-6);
}

TEST(Exposure, LeavesADarkOrganDarkerThanAPaleOne) {
  // sRGB of 0.5 and 0.25 of the light: one stop apart, of which two thirds stay.
  EXPECT_NEAR(exposure_at(0.1, 1, {0.5371, 0.5371, 0.5371}) - exposure_at(0.1, 1, {0.7354, 0.7354, 0.7354}), 1.0 / 3,
              1e-3);
}

TEST(Exposure, StaysWithinTwoStops) {
  EXPECT_EQ(exposure_at(0.1, 1000), -2);
  EXPECT_EQ(exposure_at(0.1, 1e-5), 2);
}

TEST(Exposure, IsZeroWhereNoWallIsSeen) {
  EXPECT_EQ(metered_exposure({}, {}, {}, {}, true), 0);
}

}  // namespace
}  // namespace thinwall
