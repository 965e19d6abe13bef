#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/look/OrganLooks.hpp"
#include "renderer/picture/Renderer.hpp"
#include "tests/renderer/shape/TestMeshes.hpp"

namespace thinwall {
namespace {

constexpr ImageSize kTissueSize{96, 96};

Image draw(const SnapshotSurface& surface, const ViewDefinition& view, Tier tier = Tier::kDraft) {
  Snapshot snapshot;
  snapshot.surfaces = {surface};
  return Renderer(DeviceChoice{}, kTissueSize, tier).draw(snapshot, view);
}

/// A sheet of 40 mm across z = 0 in `parts` x `parts` squares, each of two triangles.
SnapshotSurface sheet(int parts) {
  std::vector<Float3> positions;
  std::vector<Triangle> triangles;
  const auto row = static_cast<std::uint32_t>(parts + 1);
  for (int j = 0; j <= parts; ++j) {
    for (int i = 0; i <= parts; ++i) {
      positions.push_back({0.04f * (static_cast<float>(i) / static_cast<float>(parts) - 0.5f),
                           0.04f * (static_cast<float>(j) / static_cast<float>(parts) - 0.5f), 0});
    }
  }
  for (std::uint32_t j = 0; j + 1 < row; ++j) {
    for (std::uint32_t i = 0; i + 1 < row; ++i) {
      const std::uint32_t a = j * row + i;
      triangles.insert(triangles.end(), {{a, a + 1, a + row + 1}, {a, a + row + 1, a + row}});
    }
  }
  return test::surface_of("organ", std::move(positions), std::move(triangles));
}

/// Seen from straight above: 28 mm of the sheet.
ViewDefinition from_above(const char* organ) {
  ViewDefinition view;
  view.camera = {.position = Double3{0, 0, 0.1},
                 .target = Double3{0, 0, 0},
                 .up = Double3{0, 1, 0},
                 .field_of_view = 2 * std::atan(0.14)};
  view.look.floor = false;
  view.look.bodies["organ"] = *find_organ_look(organ);
  return view;
}

/// Of the whole picture, 8-bit levels.
std::array<double, 3> mean_color(const Image& image) {
  std::array<double, 3> sums{};
  for (std::size_t i = 0; i < image.pixels.size(); ++i) sums[i % 3] += image.pixels[i];
  for (double& sum : sums) sum /= static_cast<double>(image.pixels.size() / 3);
  return sums;
}

int largest_difference(const Image& a, const Image& b) {
  int largest = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    largest = std::max(largest, std::abs(int{a.pixels[i]} - int{b.pixels[i]}));
  }
  return largest;
}

class Organ : public testing::TestWithParam<std::string> {};

TEST_P(Organ, InAFurnaceIsNeverBrighterThanTheFurnace) {
  ViewDefinition view = from_above(GetParam().c_str());
  view.lights = {.key = 0, .fill = 0, .environment = 1, .environment_contrast = 0, .key_direction = {}};
  const Image organ = draw(sheet(2), view);
  TissueLook white;
  white.color = {1, 1, 1};
  white.mottling = 0;
  view.look.bodies["organ"] = white;
  const double furnace = mean_color(draw(sheet(2), view))[0] + 1.5;
  for (const std::uint8_t level : organ.pixels) EXPECT_LE(level, furnace);
}

TEST_P(Organ, LooksTheSameHoweverItIsCutIntoTriangles) {
  const ViewDefinition view = from_above(GetParam().c_str());
  // Rest places that are interpolated over other triangles differ in the last bits; a level with the dithering.
  EXPECT_LE(largest_difference(draw(sheet(1), view), draw(sheet(7), view)), 2);
}

TEST_P(Organ, KeepsItsPatternWhereTheTissueGoes) {
  ViewDefinition view = from_above(GetParam().c_str());
  view.lights.key_direction = Double3{0.3, 0.4, 0.8};
  const Image before = draw(sheet(3), view);
  SnapshotSurface moved = sheet(3);
  for (Float3& position : moved.positions) position[0] += 0.25f;
  // The scene's centre and size come from the rest places, so only the camera goes along.
  view.camera.position = Double3{0.25, 0, 0.1};
  view.camera.target = Double3{0.25, 0, 0};
  EXPECT_LE(largest_difference(before, draw(moved, view)), 4);
}

TEST_P(Organ, HasAPatternThatIsSeenButNotLoud) {
  const ViewDefinition view = from_above(GetParam().c_str());
  const Image image = draw(sheet(1), view);
  const std::array<double, 3> mean = mean_color(image);
  double variance = 0;
  for (std::size_t i = 1; i < image.pixels.size(); i += 3) variance += std::pow(image.pixels[i] - mean[1], 2);
  const double deviation = std::sqrt(variance / (static_cast<double>(image.pixels.size()) / 3));
  EXPECT_GT(deviation, 1.0);
  EXPECT_LT(deviation, 40.0);
}

INSTANTIATE_TEST_SUITE_P(Kinds, Organ,
                         testing::Values("tissue", "gallbladder", "stomach", "liver", "skin", "vessel", "fingerpad"),
                         [](const auto& kind) { return kind.param; });

TEST(Tissue, AStretchedWallShowsMoreOfWhatIsBehindIt) {
  SnapshotSurface stretched = sheet(1);
  for (Float3& position : stretched.positions) position = {2 * position[0], 2 * position[1], 0};
  // Green behind a red wall: how much more green in the picture than of a wall that lets nothing through.
  const auto green_gained = [](const SnapshotSurface& surface) {
    ViewDefinition view = from_above("tissue");
    TissueLook& look = view.look.bodies["organ"];
    look = {.color = {0.8, 0.5, 0.4}, .patches = 0, .vessels = 0, .capillaries = 0, .through = {0.1, 0.9, 0.1}};
    look.clearness = 0;
    const std::array<double, 3> opaque = mean_color(draw(surface, view));
    look.clearness = 0.1;
    const std::array<double, 3> clear = mean_color(draw(surface, view));
    return clear[1] / clear[0] - opaque[1] / opaque[0];
  };
  // Four times thinner: 0.1 ^ (1 / 4) = 56 % come through instead of 10 %.
  EXPECT_GT(green_gained(sheet(1)), 0.02);
  EXPECT_GT(green_gained(stretched), 2 * green_gained(sheet(1)));
}

/// How much neighbours of a row differ, on the mean.
double roughness_of(const Image& image) {
  double sum = 0;
  int count = 0;
  for (std::size_t i = 1; i + 3 < image.pixels.size(); i += 3) {
    if ((i / 3) % kTissueSize.width == kTissueSize.width - 1U) continue;
    sum += std::abs(int{image.pixels[i + 3]} - int{image.pixels[i]});
    ++count;
  }
  return sum / count;
}

/// The part of the pixels of `image` whose green is less than that of `other` by more than 6 levels.
double darker_part(const Image& image, const Image& other) {
  int darker = 0;
  for (std::size_t i = 1; i < image.pixels.size(); i += 3) darker += image.pixels[i] + 6 < other.pixels[i] ? 1 : 0;
  return 3.0 * darker / static_cast<double>(image.pixels.size());
}

TEST(Tissue, SkinShowsPoresFromNearByAndDoesNotSparkleFromAfar) {
  ViewDefinition view = from_above("skin");
  view.lights.key_direction = Double3{0.5, 0.4, 0.6};
  view.camera.position = Double3{0, 0, 0.02};  // 0.06 mm for a pixel
  const Image skin = draw(sheet(2), view);
  const double near = roughness_of(skin);
  view.look.bodies["organ"].pores = 1e-3;  // as good as none
  const double pores = darker_part(skin, draw(sheet(2), view));
  EXPECT_GT(pores, 0.005);
  EXPECT_LT(pores, 0.10);
  view.look.bodies["organ"].pores = 1;
  view.camera.position = Double3{0, 0, 0.13};  // 0.4 mm
  EXPECT_GT(near, 1.0);
  EXPECT_LT(roughness_of(draw(sheet(2), view)), 0.8 * near);
}

TEST(Tissue, RidgesOfAFingerpadRunAroundItsMiddle) {
  // How much more a picture changes from left to right than from above to below.
  const auto across_over_along = [](double x, double y) {
    ViewDefinition view = from_above("fingerpad");
    view.camera.position = Double3{x, y, 0.1};
    view.camera.target = Double3{x, y, 0};
    view.camera.field_of_view = 2 * std::atan(0.02);  // 4 mm, of which 24 pixels are a millimetre
    const Image image = draw(sheet(2), view);
    constexpr int kHalfRidge = 6;  // pixels
    double across = 0, along = 0;
    const auto green = [&](int column, int row) {
      return static_cast<double>(image.pixels[static_cast<std::size_t>(3 * (row * kTissueSize.width + column) + 1)]);
    };
    for (int row = kHalfRidge; row < kTissueSize.height; ++row) {
      for (int column = kHalfRidge; column < kTissueSize.width; ++column) {
        across += std::abs(green(column, row) - green(column - kHalfRidge, row));
        along += std::abs(green(column, row) - green(column, row - kHalfRidge));
      }
    }
    return across / along;
  };
  EXPECT_GT(across_over_along(0.006, 0), 2) << "beside the middle";
  EXPECT_LT(across_over_along(0, 0.006), 0.5) << "before it";
  EXPECT_LT(across_over_along(0, -0.006), 0.5) << "behind it";
}

TEST(Tissue, SkinShowsItsLayersWhereASheetEnds) {
  SnapshotSurface surface = sheet(8);
  auto topology = std::make_shared<SnapshotTopology>(*surface.topology);
  topology->thickness.assign(topology->triangles.size(), 0.004F);
  surface.topology = topology;
  ViewDefinition view = from_above("skin");
  // The side of 4 mm fills two thirds of the picture.
  view.camera = {.position = Double3{0, -0.05, -0.002},
                 .target = Double3{0, 0, -0.002},
                 .up = Double3{0, 0, 1},
                 .field_of_view = 2 * std::atan(0.1)};
  view.lights.key_direction = Double3{0.3, -0.8, 0.5};
  const Image image = draw(surface, view);
  const auto yellow_at = [&](int row) {
    const std::vector<std::uint8_t> line(image.pixels.begin() + 3 * row * kTissueSize.width,
                                         image.pixels.begin() + 3 * (row + 1) * kTissueSize.width);
    const auto [red, green, blue] = mean_color({.size = {kTissueSize.width, 1}, .pixels = line});
    return (green - blue) / red;
  };
  EXPECT_GT(yellow_at(74), yellow_at(40) + 0.15) << "fat below the dermis";
}

TEST(Tissue, PalesWhereItIsPressed) {
  const ViewDefinition view = from_above("stomach");
  const std::array<double, 3> before = mean_color(draw(sheet(1), view));
  SnapshotSurface pressed = sheet(1);
  pressed.fields.push_back({.name = "contact_pressure", .unit = "Pa", .values = std::vector<float>(4, 20000)});
  const std::array<double, 3> after = mean_color(draw(pressed, view));
  EXPECT_LT(after[0] - after[1], 0.8 * (before[0] - before[1])) << "less red";
}

/// Pixels of a smooth, wet, black ball that mirror the lamp and are brighter than `level`.
double highlight_of(double lamp_size, int level = 120) {
  ViewDefinition view = from_above("liver");
  view.lights.fill = 0;
  TissueLook& look = view.look.bodies["organ"];
  look = {.color = {0, 0, 0}, .roughness = 1, .wetness = 1, .lamp_size = lamp_size, .mottling = 0, .clearness = 0};
  const Image image = draw(test::sphere("organ", {}, 0.013, 5), view);
  double count = 0;
  for (std::size_t i = 0; i < image.pixels.size(); i += 3) count += image.pixels[i] > level ? 1 : 0;
  return count;
}

TEST(Tissue, FatEndsWithItsLobules) {
  ViewDefinition view = from_above("gallbladder");
  TissueLook& look = view.look.bodies["organ"];
  // Yellow on blue, and nothing else.
  look.color = {0.25, 0.3, 0.8};
  look.fat = {0.85, 0.7, 0.25};
  look.patches = look.vessels = look.capillaries = look.clearness = look.wetness = look.sheen = 0;
  look.fattiness = 0.5;
  const Image image = draw(sheet(1), view);
  std::vector<int> yellow;
  for (std::size_t i = 0; i < image.pixels.size(); i += 3) yellow.push_back(image.pixels[i] - image.pixels[i + 2]);
  const auto [least, most] = std::ranges::minmax(yellow);
  const auto part_below = [&](double part) {
    const auto count = std::ranges::count_if(yellow, [&](int value) { return value < std::lerp(least, most, part); });
    return static_cast<double>(count) / static_cast<double>(yellow.size());
  };
  EXPECT_GT(part_below(0.3), 0.2) << "bare";
  EXPECT_LT(part_below(0.7), 0.8) << "fat";
  EXPECT_LT(part_below(0.7) - part_below(0.3), 0.14) << "neither: 0.09 was seen, 0.22 where it fades out";
}

TEST(Tissue, HasVesselsThatRunAlongTheBody) {
  ViewDefinition view = from_above("tissue");
  view.camera.field_of_view = 2 * std::atan(0.18);
  TissueLook& look = view.look.bodies["organ"];
  look.patches = look.relief = look.clearness = look.wetness = 0;
  look.vessels = look.capillaries = 1;
  look.vessel_spacing = 0.004;
  const Image image = draw(sheet(1), view);
  // The body's line goes from left to right.
  double along = 0, across = 0;
  for (int row = 1; row < kTissueSize.height; ++row) {
    for (int column = 1; column < kTissueSize.width; ++column) {
      const int pixel = 3 * (row * kTissueSize.width + column) + 1;
      const auto level = [&](int i) { return static_cast<double>(image.pixels[static_cast<std::size_t>(i)]); };
      along += std::abs(level(pixel) - level(pixel - 3));
      across += std::abs(level(pixel) - level(pixel - 3 * kTissueSize.width));
    }
  }
  RecordProperty("ratio", std::to_string(across / along));
  // Seen: 2.6, as side vessels leave trunks at angles; vessels that run anywhere made 0.6.
  EXPECT_GT(across, 2 * along);
}

TEST(Tissue, MirrorsASmallerLampInASmallerHighlight) {
  const double whole = highlight_of(1), half = highlight_of(0.5);
  ASSERT_GT(half, 20);
  // Seen: 27 of 89 pixels; a quarter, were the borders sharp.
  EXPECT_LT(half, 0.55 * whole);
}

TEST(Tissue, MirrorsALampThatIsBrightestInItsMiddle) {
  const double core = highlight_of(1, 180), whole = highlight_of(1, 100);
  // Seen: 29 of 113 pixels; of an evenly bright box none is as bright.
  ASSERT_GT(core, 5);
  EXPECT_LT(core, 0.5 * whole);
}

TEST(Tissue, ReliefTooFineForThePixelsIsLeftOut) {
  ViewDefinition view = from_above("skin");
  TissueLook& look = view.look.bodies["organ"];
  look.patches = 0;
  const auto deviation = [&](double size) {
    look.relief_size = size;
    const Image image = draw(sheet(1), view);
    const std::array<double, 3> mean = mean_color(image);
    double variance = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) variance += std::pow(image.pixels[i] - mean[i % 3], 2);
    return std::sqrt(variance / static_cast<double>(image.pixels.size()));
  };
  // A pixel is 0.29 mm wide.
  EXPECT_LT(deviation(0.0001), 0.5 * deviation(0.003));
}

TEST(Tissue, ReliefThatASlantMakesTooFineIsLeftOut) {
  ViewDefinition view = from_above("skin");
  view.camera.position = Double3{0, -0.1, 0.008};
  view.camera.up = Double3{0, 0, 1};
  TissueLook& look = view.look.bodies["organ"];
  look.patches = 0;
  look.relief_size = 0.004;
  look.relief = 0.4;
  // The sheet is eleven pixels high, each of which covers 3.6 mm of it; how much their rows differ.
  const Image image = draw(sheet(1), view);
  const int width = image.size.width, height = image.size.height;
  double jumps = 0;
  int count = 0;
  for (int row = height / 2 - 2; row <= height / 2 + 2; ++row) {
    for (int column = width / 4; column < 3 * width / 4; ++column) {
      const std::size_t pixel = 3 * static_cast<std::size_t>(row * width + column);
      jumps += std::abs(int{image.pixels[pixel + 3 * static_cast<std::size_t>(width)]} - int{image.pixels[pixel]});
      ++count;
    }
  }
  // Seen: 1.4 levels; 3.5, were it left out by the mean of a pixel's height and width there.
  EXPECT_LT(jumps / count, 2.2);
}

/// Skin is greasy rather than wet: its fine relief does not sparkle in a lamp as frost does.
TEST(Tissue, DrySkinDoesNotSparkleInALamp) {
  Snapshot snapshot;
  snapshot.surfaces = {sheet(8)};
  ViewDefinition view = from_above("skin");
  view.camera.position = Double3{0, -0.002, 0.03};
  view.camera.field_of_view = 0.3;
  view.lights.endoscope = 1;
  view.camera.exposure = -1;
  const Image image = Renderer(DeviceChoice{}, {240, 240}, Tier::kRecord).draw(snapshot, view);
  std::vector<int> levels;
  for (std::size_t y = 60; y < 180; ++y) {
    for (std::size_t x = 60; x < 180; ++x) levels.push_back(image.pixels[3 * (240 * y + x) + 2]);
  }
  std::ranges::sort(levels);
  // Seen: 10, and 45 of a film as smooth as water.
  EXPECT_LT(levels[levels.size() * 99 / 100] - levels[levels.size() / 2], 25);
}

/// Along its rim a wet wall mirrors the room as a veil: relief seen along itself hides what would glint, or it is fur.
TEST(Tissue, HasNoFurAlongTheRimOfAWetBall) {
  Snapshot snapshot;
  snapshot.surfaces = {test::sphere("organ", {0, 0, 0}, 0.01, 5)};
  ViewDefinition view = from_above("vessel");
  view.camera.position = Double3{0.05, -0.08, 0.04};
  view.camera.up = Double3{0, 0, 1};
  view.camera.field_of_view = 0.22;
  constexpr int kWide = 240;
  const Image image = Renderer(DeviceChoice{}, {kWide, kWide}, Tier::kRecord).draw(snapshot, view);
  const auto level = [&](int x, int y) { return int{image.pixels[3 * static_cast<std::size_t>(kWide * y + x) + 2]}; };
  int tufts = 0;
  for (int y = 2; y < kWide - 2; ++y) {
    for (int x = 2; x < kWide - 2; ++x) {
      const double off = std::hypot(x - 0.5 * kWide, y - 0.5 * kWide) / (0.5 * kWide * 0.01 / (0.1025 * 0.11));
      if (off < 0.80 || off > 0.95) continue;
      tufts += std::abs(4 * level(x, y) - level(x - 2, y) - level(x + 2, y) - level(x, y - 2) - level(x, y + 2)) > 48;
    }
  }
  EXPECT_LT(tufts, 50) << "5 were seen, 194 of relief that is as steep at the rim";
}

}  // namespace
}  // namespace thinwall
