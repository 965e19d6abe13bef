#include <gtest/gtest.h>

#include <cmath>

#include "renderer/picture/Renderer.hpp"
#include "tests/renderer/shape/TestMeshes.hpp"

namespace thinwall {
namespace {

constexpr ImageSize kSize{128, 128};

/// A white quad of 40 x 20 mm on black, 100 mm before the camera: its lower border runs along the middle row. A pixel
/// is 0.25 mm there.
Image draw(double aperture, double focus) {
  ViewDefinition view;
  view.camera = {.position = Double3{0, 0, 0.1},
                 .target = Double3{0, 0, 0},
                 .up = Double3{0, 1, 0},
                 .field_of_view = 2 * std::atan(0.16),
                 .aperture = aperture,
                 .focus = focus};
  view.lights = {.key = 0, .fill = 0, .environment = 1, .environment_contrast = 0, .key_direction = {}};
  view.look.floor = false;
  view.look.background = {0, 0, 0};
  view.look.bodies["sheet"] = {.color = {1, 1, 1}, .wetness = 0, .mottling = 0};
  Snapshot snapshot;
  snapshot.surfaces = {test::quad("sheet", {{{-0.02f, 0, 0}, {0.02f, 0, 0}, {0.02f, 0.02f, 0}, {-0.02f, 0.02f, 0}}})};
  return Renderer(DeviceChoice{}, kSize, Tier::kRecord).draw(snapshot, view);
}

/// Rows above the border, up to 20, in which the middle column is darker than well inside by a tenth.
int dimmed_rows(const Image& image) {
  const auto level = [&](int row) { return int{image.pixels[3 * (static_cast<std::size_t>(row) * 128 + 64)]}; };
  const int inside = level(24);
  int rows = 0;
  for (int row = 44; row < 63; ++row) rows += 10 * level(row) < 9 * inside ? 1 : 0;
  return rows;
}

TEST(Focus, LeavesWhatIsInFocusAlone) {
  const Image open = draw(0.005, 0.1), closed = draw(0, 0.1);
  // All rows that the quad fills.
  for (std::size_t byte = 0; byte < std::size_t{3} * 128 * 63; ++byte) {
    ASSERT_EQ(open.pixels[byte], closed.pixels[byte]) << "row " << byte / (3 * 128);
  }
}

TEST(Focus, WithoutAnApertureAllIsSharp) {
  EXPECT_EQ(draw(0, 0.05).pixels, draw(0, 0.1).pixels);
  EXPECT_EQ(dimmed_rows(draw(0, 0.05)), 0);
}

TEST(Focus, BlursTheMoreTheWiderTheLensIsOpen) {
  // The disc has the diameter aperture x |1/0.05 - 1/0.1| x 400 pixels: 4 and 12 pixels.
  const int narrow = dimmed_rows(draw(0.001, 0.05)), wide = dimmed_rows(draw(0.003, 0.05));
  EXPECT_GE(narrow, 1);
  EXPECT_GT(wide, narrow);
  EXPECT_LE(wide, 7) << "not beyond the disc's radius and a pixel";
}

}  // namespace
}  // namespace thinwall
