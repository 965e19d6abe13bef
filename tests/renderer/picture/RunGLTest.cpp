#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "renderer/look/FluidLooks.hpp"
#include "renderer/picture/Renderer.hpp"
#include "tests/renderer/shape/CutSheets.hpp"

namespace thinwall {
namespace {

constexpr ImageSize kSize{240, 240};
constexpr double kSteepness = 0.8;  // radians, of the sheet that bile runs down

/// The lower half of a slit sheet, seen by an endoscope at right angles, with what has run out on it. `shear`: of the
/// sheet since its rest, along the slit.
Image picture_of_run(const char* fluid, double leaked, double shear = 0) {
  const Double3 middle = {0, -0.008 * std::cos(kSteepness), -0.008 * std::sin(kSteepness)};
  ViewDefinition view;
  view.camera.kind = CameraKind::kEndoscope;
  view.camera.position =
      Double3{middle[0], middle[1] - 0.06 * std::sin(kSteepness), middle[2] + 0.06 * std::cos(kSteepness)};
  view.camera.target = middle;
  view.camera.field_of_view = 0.3;
  view.lights.endoscope = 1;
  view.look.floor = false;
  // Only what runs down glistens.
  view.look.bodies["organ"] = {.color = {0.3, 0.3, 0.3}, .roughness = 1, .wetness = 0, .mottling = 0, .sheen = 0};
  view.look.bodies["organ"].contents = *find_fluid_look(fluid);
  view.look.bodies["organ"].bleeding = 0;
  Snapshot snapshot;
  snapshot.surfaces = {test::slit_sheet(20, 0.002, kSteepness)};
  for (Float3& position : snapshot.surfaces[0].positions) position[0] += static_cast<float>(shear) * position[1];
  snapshot.time = 3;
  snapshot.scalars = {{"organ.leaked", "m^3", leaked}};
  return Renderer(DeviceChoice{}, kSize, Tier::kRecord).draw(snapshot, view);
}

Image picture_of_bile(double leaked) {
  return picture_of_run("bile", leaked);
}

/// Sizes of the patches of pixels that are brighter than `level`, where neighbours share a side.
std::vector<int> bright_patches(const Image& image, int level) {
  const int width = image.size.width, height = image.size.height;
  std::vector<char> is_left(static_cast<std::size_t>(width) * height);
  for (std::size_t i = 0; i < is_left.size(); ++i) is_left[i] = image.pixels[3 * i + 1] > level ? 1 : 0;
  std::vector<int> sizes, next;
  for (int first = 0; first < width * height; ++first) {
    if (!is_left[static_cast<std::size_t>(first)]) continue;
    sizes.push_back(0);
    next = {first};
    is_left[static_cast<std::size_t>(first)] = 0;
    while (!next.empty()) {
      const int at = next.back(), x = at % width;
      next.pop_back();
      ++sizes.back();
      for (const int step : {x > 0 ? -1 : 0, x + 1 < width ? 1 : 0, -width, width}) {
        const int beside = at + step;
        if (beside < 0 || beside >= width * height || !is_left[static_cast<std::size_t>(beside)]) continue;
        is_left[static_cast<std::size_t>(beside)] = 0;
        next.push_back(beside);
      }
    }
  }
  return sizes;
}

int covered_by_bile(double leaked) {
  const Image dry = picture_of_bile(0), wet = picture_of_bile(leaked);
  int covered = 0;
  for (std::size_t i = 0; i < dry.pixels.size(); i += 3)
    covered += std::abs(wet.pixels[i] - dry.pixels[i]) > 12 ? 1 : 0;
  return covered;
}

TEST(Run, OfALeakTwiceAsLargeCoversMore) {
  // All have run to the end of the sheet.
  const int small = covered_by_bile(4e-7), twice = covered_by_bile(8e-7), much = covered_by_bile(4e-6);
  RecordProperty("small", small);
  RecordProperty("twice", twice);
  RecordProperty("much", much);
  EXPECT_GT(twice, 1.08 * small);
  EXPECT_GT(much, 1.4 * small);
}

TEST(Run, OfBloodHidesTheWallBelow) {
  // So little that it runs at half of the usual width and depth.
  const Image dry = picture_of_run("blood", 0), wet = picture_of_run("blood", 2e-7);
  std::vector<double> left;  // parts of the green
  for (std::size_t i = 0; i < dry.pixels.size(); i += 3) {
    const double before = dry.pixels[i + 1], after = wet.pixels[i + 1];
    if (after < 0.85 * before) left.push_back(after / before);
  }
  ASSERT_GT(left.size(), 500U) << "pixels";
  const auto middle = left.begin() + static_cast<std::ptrdiff_t>(left.size() / 2);
  std::ranges::nth_element(left, middle);
  RecordProperty("left", std::to_string(*middle));
  // Half of it is nearer to its edge, where it is thin.
  EXPECT_LT(*middle, 0.55) << "0.43 was seen, 0.70 of blood as clear as wine";
}

TEST(Run, MirrorsTheLampInLongPiecesNotInCrumbs) {
  constexpr int kLips = 30;  // rows at the top, where lips glisten
  Image image = picture_of_bile(4e-6);
  std::fill_n(image.pixels.begin(), 3 * kLips * kSize.width, std::uint8_t{0});
  const std::vector<int> sizes = bright_patches(image, 170);
  const double mean = std::accumulate(sizes.begin(), sizes.end(), 0.0) / static_cast<double>(sizes.size());
  EXPECT_GT(std::accumulate(sizes.begin(), sizes.end(), 0), 1000) << "glossy";
  EXPECT_GT(mean, 50) << "pixels; 57 were seen, 26 where what is fine is not levelled";
}

/// Places below the lips where green goes up and down, or down and up, three times from pixel to neighbouring pixel in
/// a line.
int teeth(const Image& image) {
  constexpr int kLips = 40, kTooth = 8;  // rows at the top, levels
  const auto green = [&](int x, int y) { return static_cast<int>(image.pixels[3UL * (y * kSize.width + x) + 1]); };
  int count = 0;
  for (const auto& [right, down] : {std::pair{0, 1}, {1, 0}, {1, 1}, {-1, 1}}) {
    for (int y = kLips; y + 3 < kSize.height; ++y) {
      for (int x = 3; x + 3 < kSize.width; ++x) {
        std::array<int, 3> changes{};
        for (int k = 0; k < 3; ++k)
          changes[k] = green(x + (k + 1) * right, y + (k + 1) * down) - green(x + k * right, y + k * down);
        const bool turns = changes[0] * changes[1] < 0 && changes[1] * changes[2] < 0;
        count += turns && std::ranges::all_of(changes, [](int change) { return std::abs(change) > kTooth; }) ? 1 : 0;
      }
    }
  }
  return count;
}

TEST(Run, MirrorsTheLampWithoutTeethWhereItsWallIsSheared) {
  const int count = teeth(picture_of_run("bile", 4e-6, 0.6));
  RecordProperty("teeth", count);
  EXPECT_LT(count, 8) << "1 was seen, 38 where each triangle shears its part of the unevenness";
}

}  // namespace
}  // namespace thinwall
