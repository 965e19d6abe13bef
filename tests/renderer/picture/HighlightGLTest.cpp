#include <gtest/gtest.h>

#include <cmath>

#include "renderer/camera/Camera.hpp"
#include "renderer/picture/Renderer.hpp"
#include "tests/renderer/shape/TestMeshes.hpp"

namespace thinwall {
namespace {

constexpr ImageSize kHighlightSize{320, 240};

/// A sheet, stretched along x, seen from above.
Snapshot sheet(float stretch) {
  Snapshot snapshot;
  snapshot.surfaces.push_back(
      test::quad("sheet", {Float3{-0.02F, -0.02F, 0}, {0.02F, -0.02F, 0}, {0.02F, 0.02F, 0}, {-0.02F, 0.02F, 0}}));
  for (Float3& position : snapshot.surfaces[0].positions) position[0] *= stretch;
  return snapshot;
}

ViewDefinition from_above() {
  ViewDefinition view;
  view.camera.position = Double3{0, 0, 0.1};
  view.camera.target = Double3{0, 0, 0};
  view.camera.up = Double3{0, 1, 0};
  return view;
}

HighlightDefinition blue_spot() {
  return {.body = "sheet", .center = {0.008, 0, 0}, .radius = 0.004, .color = {0, 0, 1}, .begin = 1, .end = 2};
}

/// How much bluer a place has become.
int bluer(const Image& with, const Image& without, Vector3 place) {
  const Camera camera = resolve_camera(from_above().camera, scene_extent(sheet(1)), kHighlightSize, 0);
  const auto [x, y] = *camera.pixel(place, kHighlightSize);
  const auto first = 3 * static_cast<std::size_t>(std::floor(y) * kHighlightSize.width + std::floor(x));
  const auto blue = [&](const Image& image) { return image.pixels[first + 2] - image.pixels[first]; };
  return blue(with) - blue(without);
}

TEST(Highlight, MarksTheMaterialAndGoesWithIt) {
  Renderer renderer(DeviceChoice{}, kHighlightSize, Tier::kDraft);
  for (const float stretch : {1.0F, 1.5F}) {
    Snapshot snapshot = sheet(stretch);
    snapshot.time = 1.5;
    ViewDefinition view = from_above();
    const Image without = renderer.draw(snapshot, view);
    view.highlights = {blue_spot()};
    const Image with = renderer.draw(snapshot, view);
    const double s = stretch;
    EXPECT_GT(bluer(with, without, {0.008 * s, 0, 0}), 15) << "a tint inside";
    EXPECT_GT(bluer(with, without, {0.01185 * s, 0, 0}), 100) << "a ring at the border";
    EXPECT_EQ(bluer(with, without, {0.0125 * s, 0, 0}), 0) << "nothing outside";
    EXPECT_EQ(bluer(with, without, {-0.008 * s, 0, 0}), 0);
  }
}

TEST(Highlight, IsShownInItsSpanAndOnItsBodyOnly) {
  Renderer renderer(DeviceChoice{}, kHighlightSize, Tier::kDraft);
  Snapshot snapshot = sheet(1);
  ViewDefinition view = from_above();
  const auto changes = [&](double time, const HighlightDefinition& highlight) {
    snapshot.time = time;
    view.highlights.clear();
    const Image without = renderer.draw(snapshot, view);
    view.highlights = {highlight};
    return renderer.draw(snapshot, view).pixels != without.pixels;
  };
  EXPECT_FALSE(changes(0.9, blue_spot()));
  EXPECT_TRUE(changes(1, blue_spot()));
  EXPECT_FALSE(changes(2.1, blue_spot()));
  HighlightDefinition elsewhere = blue_spot();
  elsewhere.body = "other";
  EXPECT_FALSE(changes(1.5, elsewhere));
}

}  // namespace
}  // namespace thinwall
