#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "renderer/look/FluidLooks.hpp"
#include "renderer/look/OrganLooks.hpp"
#include "renderer/picture/Renderer.hpp"
#include "tests/renderer/shape/CutSheets.hpp"

namespace thinwall {
namespace {

constexpr ImageSize kWoundSize{96, 96};

/// A ball of 20 mm that is open at the top, half full.
Snapshot open_bowl(double fluid_part) {
  const SnapshotSurface ball = test::sphere("bowl", {0, 0, 0}, 0.02, 4);
  std::vector<Triangle> kept;
  for (const Triangle& triangle : ball.topology->triangles) {
    bool below = false;
    for (const std::uint32_t vertex : triangle) below = below || ball.positions[vertex][2] < 0.012f;
    if (below) kept.push_back(triangle);
  }
  SnapshotSurface bowl = test::surface_of("bowl", ball.positions, kept);
  auto topology = std::make_shared<SnapshotTopology>(*bowl.topology);
  topology->thickness.assign(topology->triangles.size(), 0.001f);
  bowl.topology = topology;
  Snapshot snapshot;
  snapshot.surfaces = {bowl};
  constexpr double kVolume = 3e-5;  // about that of the bowl
  snapshot.scalars = {{"bowl.volume", "m^3", kVolume}, {"bowl.fluid_volume", "m^3", fluid_part * kVolume}};
  return snapshot;
}

ViewDefinition from_above() {
  ViewDefinition view;
  view.camera = {.position = Double3{0, 0, 0.1},
                 .target = Double3{0, 0, 0},
                 .up = Double3{0, 1, 0},
                 .field_of_view = 2 * std::atan(0.1)};
  view.look.floor = false;
  view.look.bodies["bowl"] = *find_organ_look("stomach");
  view.look.bodies["bowl"].contents = *find_fluid_look("bile");
  return view;
}

std::array<int, 3> middle_of(const Image& image) {
  const std::size_t pixel = 3 * (48 * 96 + 48);
  return {image.pixels[pixel], image.pixels[pixel + 1], image.pixels[pixel + 2]};
}

TEST(Wound, IsDrawnAsOftenAsItIsAskedForInADraft) {
  Snapshot slit;
  slit.surfaces = {test::slit_sheet(10, 0.001, 0)};
  slit.time = 1;
  for (const Snapshot& snapshot : {slit, open_bowl(0.5)}) {
    Renderer renderer(DeviceChoice{}, kWoundSize, Tier::kDraft);
    const Image first = renderer.draw(snapshot, from_above());
    EXPECT_EQ(renderer.draw(snapshot, from_above()).pixels, first.pixels);
  }
}

TEST(Wound, ShowsTheFluidInAnOpenedOrgan) {
  Renderer renderer(DeviceChoice{}, kWoundSize, Tier::kRecord);
  const std::array<int, 3> dry = middle_of(renderer.draw(open_bowl(0), from_above()));
  EXPECT_GT(dry[0], dry[1] + 20) << "the lining is red";
  for (const double part : {1.0, 0.5}) {
    const std::array<int, 3> bile = middle_of(renderer.draw(open_bowl(part), from_above()));
    EXPECT_LT(std::abs(bile[0] - bile[1]), 25) << "bile is green to brown, at " << part;
    EXPECT_GT(bile[1], bile[2] + 20) << part;
  }
}

TEST(Wound, LetsTheBottomBeSeenThroughShallowClearFluid) {
  Renderer renderer(DeviceChoice{}, kWoundSize, Tier::kRecord);
  ViewDefinition view = from_above();
  const std::array<int, 3> dry = middle_of(renderer.draw(open_bowl(0), view));
  view.look.bodies["bowl"].contents = *find_fluid_look("water");
  const std::array<int, 3> water = middle_of(renderer.draw(open_bowl(0.1), view));
  EXPECT_LT(std::abs(water[0] - dry[0]), 40);
  EXPECT_GT(water[0], water[1] + 10) << "the lining below it is red";
}

TEST(Wound, LeavesTheBottomPinkThroughSerum) {
  Renderer renderer(DeviceChoice{}, kWoundSize, Tier::kRecord);
  ViewDefinition view = from_above();
  view.lights.environment = 0;  // its surface mirrors nothing
  view.lights.key = 2;
  view.look.bodies["bowl"].contents = *find_fluid_look("serum");
  const std::array<int, 3> dry = middle_of(renderer.draw(open_bowl(0), view));
  const std::array<int, 3> serum = middle_of(renderer.draw(open_bowl(1), view));
  // 32 mm of it turn what lies below neither brown nor milky.
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_GT(serum[c], 0.85 * dry[c]) << c;
    EXPECT_LT(serum[c], dry[c] + 10) << c;
  }
}

TEST(Wound, FluidGlistensWhereItClimbsTheWallsAcrossFromTheLens) {
  ViewDefinition view = from_above();
  view.camera.kind = CameraKind::kEndoscope;
  view.camera.position = Double3{0, -0.065, 0.08};
  view.camera.target = Double3{0, 0.012, 0.003};
  view.lights.endoscope = 1;
  const Image image = Renderer(DeviceChoice{}, kWoundSize, Tier::kRecord).draw(open_bowl(0.6), view);
  int glistening = 0;
  // Along the far shore.
  for (std::size_t i = 3U * 96 * 28; i < 3U * 96 * 40; i += 3) {
    glistening += std::min({image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]}) > 200 ? 1 : 0;
  }
  EXPECT_GE(glistening, 3) << "6 were seen, none of a level without a meniscus";
}

TEST(Wound, WhatRunsOutHasNoBrightStreaksWhereItIsSeenAlongTheWall) {
  // Only the cavity is mirrored; the lamp's light is next to none.
  ViewDefinition view;
  constexpr double kSteepness = 1.2, kCosine = 0.3;
  const double aside = std::sqrt(1 - kCosine * kCosine);
  view.camera = {.position = Double3{0.08 * aside, -0.08 * kCosine * std::sin(kSteepness) - 0.003,
                                     0.08 * kCosine * std::cos(kSteepness) - 0.01},
                 .target = Double3{0, -0.003, -0.01},
                 .field_of_view = 0.4};
  view.camera.kind = CameraKind::kEndoscope;
  view.lights.endoscope = 0.02;
  view.look.bodies["organ"] = *find_organ_look("gallbladder");
  Snapshot snapshot;
  snapshot.surfaces = {test::slit_sheet(20, 0.002, kSteepness)};
  snapshot.time = 3;
  Renderer renderer(DeviceChoice{}, kWoundSize, Tier::kRecord);
  const Image dry = renderer.draw(snapshot, view);
  snapshot.scalars = {{"organ.leaked", "m^3", 3e-6}};
  const Image wet = renderer.draw(snapshot, view);
  int most = 0, changed = 0;
  for (std::size_t i = 0; i < dry.pixels.size(); i += 3) {
    changed += wet.pixels[i] != dry.pixels[i] ? 1 : 0;
    most = std::max(most, wet.pixels[i] - dry.pixels[i]);
  }
  EXPECT_GT(changed, 20);
  EXPECT_LT(most, 55) << "levels of red; 52 were seen, 72 where slopes of the film turn away from the lens";
}

TEST(Wound, APoolGlistensBesideWhereALevelOneWouldMirrorTheLamp) {
  ViewDefinition view = from_above();
  view.camera.kind = CameraKind::kEndoscope;
  view.camera.position = Double3{0, -0.015, 0.078};
  view.lights.endoscope = 1;
  view.look.bodies["bowl"].contents = *find_fluid_look("blood");
  const Image image = Renderer(DeviceChoice{}, kWoundSize, Tier::kRecord).draw(open_bowl(0.9), view);
  int glistening = 0;
  for (std::size_t y = 36; y < 60; ++y) {
    for (std::size_t i = 3 * (96 * y + 36); i < 3 * (96 * y + 60); i += 3) glistening += image.pixels[i + 1] > 100;
  }
  EXPECT_GE(glistening, 50) << "65 were seen, 32 where it is nearly at rest";
}

TEST(Wound, APoolOfCloudyFluidIsNotAsPlainAsPaint) {
  ViewDefinition view = from_above();
  view.lights.environment = 0;  // its surface mirrors nothing
  view.lights.key = 2;
  view.look.bodies["bowl"].contents = *find_fluid_look("gastric_juice");
  const Image image = Renderer(DeviceChoice{}, kWoundSize, Tier::kRecord).draw(open_bowl(0.9), view);
  int least = 255, most = 0;
  for (std::size_t y = 34; y < 62; ++y) {
    for (std::size_t x = 34; x < 62; ++x) {
      least = std::min<int>(least, image.pixels[3 * (96 * y + x) + 1]);
      most = std::max<int>(most, image.pixels[3 * (96 * y + x) + 1]);
    }
  }
  EXPECT_GT(most - least, 8) << "12 and 13 were seen on two drivers, 5 of one colour with waves";
}

/// Columns of the pixels that a run of clear fluid makes darker, with the lamp on the side of `aside`.
std::vector<double> darker_columns(double aside) {
  ViewDefinition view;
  view.camera = {.position = Double3{0, -0.05, 0.06}, .target = Double3{0, -0.006, -0.003}, .field_of_view = 0.12};
  view.lights.key_direction = Double3{aside, 0, 0.4};
  view.look.bodies["organ"] = *find_organ_look("gallbladder");
  view.look.bodies["organ"].contents = *find_fluid_look("water");
  Snapshot snapshot;
  snapshot.surfaces = {test::slit_sheet(20, 0.002, 0.5)};
  snapshot.time = 3;
  Renderer renderer(DeviceChoice{}, kWoundSize, Tier::kRecord);
  const Image dry = renderer.draw(snapshot, view);
  snapshot.scalars = {{"organ.leaked", "m^3", 1e-6}};
  const Image wet = renderer.draw(snapshot, view);
  std::vector<double> columns;
  for (std::size_t i = 0; i < dry.pixels.size(); i += 3) {
    if (wet.pixels[i + 1] + 2 < dry.pixels[i + 1]) columns.push_back(static_cast<double>(i / 3 % kWoundSize.width));
  }
  return columns;
}

TEST(Wound, WhatRunsOutIsDarkAlongTheRimThatIsTurnedToTheLamp) {
  const auto mean = [](const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  };
  const std::vector<double> left = darker_columns(-1), right = darker_columns(1);
  ASSERT_GE(left.size(), 20);
  ASSERT_GE(right.size(), 20);
  EXPECT_LT(mean(left), mean(right) - 5) << "pixels";
}

TEST(Wound, IsAlikeWhateverWasDrawnBefore) {
  Renderer renderer(DeviceChoice{}, kWoundSize, Tier::kRecord);
  const Image first = renderer.draw(open_bowl(0.5), from_above());
  renderer.draw(open_bowl(1.0), from_above());
  EXPECT_EQ(renderer.draw(open_bowl(0.5), from_above()).pixels, first.pixels);
}

/// A sheet with a slit, `time` seconds after it was cut: as it bleeds, and as it would be without blood.
std::pair<Image, Image> draw_slit(const std::string& organ, double time, ImageSize size) {
  Snapshot snapshot;
  snapshot.surfaces = {test::slit_sheet(20, 0.002, 0)};
  snapshot.time = time;
  ViewDefinition view = from_above();
  view.look.bodies["organ"] = *find_organ_look(organ);
  Renderer renderer(DeviceChoice{}, size, Tier::kRecord);
  Image bleeding = renderer.draw(snapshot, view);
  view.look.bodies["organ"].bleeding = 0;
  return {std::move(bleeding), renderer.draw(snapshot, view)};
}

TEST(Wound, BleedsAlongACutAndNotWithoutOne) {
  const auto [bleeding, dry] = draw_slit("stomach", 5, kWoundSize);
  std::size_t reddened = 0;
  for (std::size_t pixel = 0; pixel < bleeding.pixels.size(); pixel += 3) {
    if (bleeding.pixels[pixel + 1] + 30 < dry.pixels[pixel + 1]) ++reddened;
  }
  // 36 of 40 mm at 4.8 pixels a millimetre, 1 to 2 mm wide: some hundreds of pixels; and less than a hundred for each
  // of the two or three trickles that creep on from there.
  EXPECT_GT(reddened, 150U);
  EXPECT_LT(reddened, 1200U);
}

TEST(Wound, BloodPaintsNoEvenRibbonAlongALip) {
  const auto [bleeding, dry] = draw_slit("skin", 8, {384, 384});
  // Of the middle half of the cut, 19 pixels a millimetre: how many columns have blood 0.45 mm above it.
  int bloody = 0, columns = 0;
  for (int column = 96; column < 288; ++column, ++columns) {
    const auto pixel = static_cast<std::size_t>(3 * ((192 - 9) * 384 + column) + 1);
    if (bleeding.pixels[pixel] + 30 < dry.pixels[pixel]) ++bloody;
  }
  RecordProperty("bloody", bloody);
  EXPECT_GT(bloody, columns / 8);
  EXPECT_LT(bloody, 5 * columns / 6);
}

TEST(Wound, BloodOnSkinHasARimAndIsDeeperInColourFartherIn) {
  const auto [bleeding, dry] = draw_slit("skin", 8, {384, 384});
  // How much green blood takes, from 0.25 mm beside the cut on; 19 pixels a millimetre.
  const auto taken = [&bleeding = bleeding, &dry = dry](int row, int column) {
    const auto pixel = static_cast<std::size_t>(3 * (row * 384 + column) + 1);
    return dry.pixels[pixel] - bleeding.pixels[pixel];
  };
  // Of each column's way from bare skin to the cut: what the second pixel of blood takes, and what the last does.
  double rim = 0, inside = 0;
  int rims = 0;
  for (int column = 96; column < 288; ++column) {
    int row = 150;
    while (row < 187 && taken(row, column) < 12) ++row;
    if (row > 180) continue;
    ++rims;
    rim += taken(row + 1, column);
    inside += taken(187, column);
  }
  ASSERT_GT(rims, 20) << "there is blood";
  RecordProperty("rim", std::to_string(rim / rims));
  RecordProperty("inside", std::to_string(inside / rims));
  EXPECT_GT(rim / rims, 30) << "the rim is not airbrushed";
  EXPECT_GT(inside, 1.2 * rim);
}

TEST(Wound, OfSkinShowsYellowFatOnItsGround) {
  SnapshotSurface sheet = test::slit_sheet(40, 0.001, 0);
  for (std::size_t v = 0; v < sheet.positions.size(); ++v) {
    const float y = sheet.topology->rest_positions[v][1];
    const float side = v >= 41 * 41 || y > 0 ? 1 : -1;
    if (std::abs(y) < 0.015F) sheet.positions[v][1] += side * 0.003F * std::exp(-std::abs(y) / 0.004F);
  }
  Snapshot snapshot;
  snapshot.surfaces = {sheet};
  snapshot.time = 3;
  ViewDefinition view = from_above();
  view.look.bodies["organ"] = *find_organ_look("skin");
  view.look.bodies["organ"].bleeding = 0;
  const Image image = Renderer(DeviceChoice{}, kWoundSize, Tier::kRecord).draw(snapshot, view);
  // Within the wound, which is 6 mm wide, at 4.8 pixels a millimetre.
  int yellow = 0, all = 0;
  for (int row = 42; row < 54; ++row) {
    for (int column = 20; column < 76; ++column, ++all) {
      const auto pixel = static_cast<std::size_t>(3 * (row * kWoundSize.width + column));
      yellow += image.pixels[pixel + 2] < 0.75 * image.pixels[pixel + 1] ? 1 : 0;
    }
  }
  RecordProperty("yellow", std::to_string(static_cast<double>(yellow) / all));
  EXPECT_GT(yellow, 0.4 * all);
  EXPECT_LT(yellow, 0.95 * all) << "with fascia between its lobules";
}

}  // namespace
}  // namespace thinwall
