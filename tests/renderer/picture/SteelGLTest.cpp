#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "renderer/camera/Camera.hpp"
#include "renderer/camera/SceneExtent.hpp"
#include "renderer/look/OrganLooks.hpp"
#include "renderer/picture/Renderer.hpp"
#include "tests/renderer/shape/TestMeshes.hpp"

namespace thinwall {
namespace {

constexpr ImageSize kSize{640, 360};
constexpr double kLength = 0.014;  // of a blade, metres

/// A scalpel that stands upright on a wall, its flat side to the viewer.
Snapshot scalpel_on_a_wall() {
  Snapshot snapshot;
  snapshot.surfaces = {
      test::quad("organ", {{{-0.03f, -0.03f, 0}, {0.03f, -0.03f, 0}, {0.03f, 0.03f, 0}, {-0.03f, 0.03f, 0}}})};
  SnapshotTool scalpel;
  scalpel.kind = SnapshotToolKind::kScalpel;
  scalpel.length = kLength;
  scalpel.width = 0.005;
  scalpel.thickness = 0.0005;
  scalpel.axis = {1, 0, 0};
  snapshot.tools.push_back(scalpel);
  return snapshot;
}

ViewDefinition from_the_front(const char* organ) {
  ViewDefinition view;
  view.camera = {.position = Double3{0.01, -0.05, 0.035}, .target = Double3{0, 0, 0.01}, .up = Double3{0, 0, 1}};
  view.look.bodies["organ"] = *find_organ_look(organ);
  return view;
}

/// Along the middle of the scalpel's blade and of what it is mounted on, 8-bit levels.
std::vector<std::array<double, 3>> colors_along_steel(const ViewDefinition& view) {
  const Snapshot snapshot = scalpel_on_a_wall();
  const Image image = Renderer(DeviceChoice{}, kSize, Tier::kRecord).draw(snapshot, view);
  const Camera camera = resolve_camera(view.camera, scene_extent(snapshot), kSize, 0);
  std::vector<std::array<double, 3>> colors;
  constexpr int kPlaces = 40;
  for (int k = 0; k < kPlaces; ++k) {
    const double back = kLength * (0.4 + 0.9 * k / kPlaces);
    const auto pixel = camera.pixel({-0.0008, 0, back}, kSize);
    const std::size_t first =
        3 * (static_cast<std::size_t>((*pixel)[1]) * kSize.width + static_cast<std::size_t>((*pixel)[0]));
    std::array<double, 3>& color = colors.emplace_back();
    std::copy_n(image.pixels.begin() + static_cast<std::ptrdiff_t>(first), 3, color.begin());
  }
  return colors;
}

/// The mean of these.
std::array<double, 3> color_of_steel(const ViewDefinition& view) {
  const std::vector<std::array<double, 3>> colors = colors_along_steel(view);
  std::array<double, 3> mean{};
  for (const std::array<double, 3>& color : colors) {
    for (std::size_t c = 0; c < 3; ++c) mean[c] += color[c] / static_cast<double>(colors.size());
  }
  return mean;
}

TEST(Steel, SeenFromNearIsTheSameWhicheverThreadDrawsIt) {
  const Snapshot snapshot = scalpel_on_a_wall();
  ViewDefinition view = from_the_front("liver");
  view.camera = {.position = Double3{0.002, -0.008, 0.026}, .target = Double3{0, 0, 0.022}, .up = Double3{0, 0, 1}};
  Renderer renderer(DeviceChoice{}, {1280, 720}, Tier::kRecord);
  const Image first = renderer.draw(snapshot, view);
  for (int again = 0; again < 6; ++again) EXPECT_TRUE(renderer.draw(snapshot, view).pixels == first.pixels);
}

TEST(Steel, IsDarkBesideTheTangInABladesSlot) {
  const Snapshot snapshot = scalpel_on_a_wall();
  ViewDefinition view = from_the_front("liver");
  view.camera = {.position = Double3{0, -0.05, 0.022}, .target = Double3{0, 0, 0.022}, .up = Double3{0, 0, 1}};
  const Image image = Renderer(DeviceChoice{}, kSize, Tier::kRecord).draw(snapshot, view);
  const Camera camera = resolve_camera(view.camera, scene_extent(snapshot), kSize, 0);
  const double wide = 0.5 * snapshot.tools[0].width;
  const auto level = [&](double aside, double behind) {
    const auto pixel = camera.pixel({aside * wide, 0, kLength + behind * wide}, kSize);
    const auto [x, y] = std::array{static_cast<std::size_t>((*pixel)[0]), static_cast<std::size_t>((*pixel)[1])};
    return static_cast<double>(image.pixels[3 * (y * kSize.width + x) + 1]);
  };
  // Of both sides together, as one mirrors more than the other. Seen: 0.76; 1.27 without that shade.
  EXPECT_LT(level(-0.5, 3) * level(0.5, 3), 0.9 * level(-1.1, 3) * level(1.1, 3));
}

TEST(Steel, IsGreyUnderAnEndoscopesLamp) {
  for (const char* organ : {"gallbladder", "liver"}) {
    ViewDefinition view = from_the_front(organ);
    view.camera.kind = CameraKind::kEndoscope;
    view.lights.endoscope = 1;
    const std::array<double, 3> color = color_of_steel(view);
    // Seen: 54 and 19 %, most of it the lamp's own colour; 34 where flat faces show nothing but hollows.
    EXPECT_GT(color[1], 48) << organ;
    EXPECT_LT(std::ranges::max(color) - std::ranges::min(color), 0.22 * color[0]) << organ;
  }
}

/// What is polished mirrors what is lit and what lies in the dark.
TEST(Steel, IsDarkAndLightInTurnsUnderAnEndoscopesLamp) {
  ViewDefinition view = from_the_front("gallbladder");
  view.camera.kind = CameraKind::kEndoscope;
  view.lights.endoscope = 1;
  double darkest = 255, lightest = 0;
  for (const std::array<double, 3>& color : colors_along_steel(view)) {
    darkest = std::min(darkest, color[1]);
    lightest = std::max(lightest, color[1]);
  }
  // Seen: 40 and 96; 96 and 141 of steel that looked like clay.
  EXPECT_GT(lightest, 2.2 * darkest);
}

TEST(Steel, ShowsTheFrontOfTheRoomWhereItIsTurnedAwayFromTheKeyLight) {
  ViewDefinition view = from_the_front("skin");
  view.lights.key_direction = Double3{0.3, 0.6, 0.8};
  // Seen: 137; 97 of the ground alone.
  EXPECT_GT(color_of_steel(view)[1], 130);
}

TEST(Steel, MirrorsTheTissueOfThisPictureNotOfTheOneBefore) {
  const ViewDefinition view = from_the_front("liver");
  const Snapshot before = scalpel_on_a_wall();
  Snapshot after = before;
  after.surfaces = {
      test::quad("organ", {{{0.02f, 0.02f, 0}, {0.03f, 0.02f, 0}, {0.03f, 0.03f, 0}, {0.02f, 0.03f, 0}}})};
  for (const Tier tier : {Tier::kRecord, Tier::kFinal}) {
    Renderer renderer(DeviceChoice{}, kSize, tier);
    renderer.draw(before, view);
    EXPECT_EQ(renderer.draw(after, view).pixels, Renderer(DeviceChoice{}, kSize, tier).draw(after, view).pixels);
  }
}

/// How far the left outline of a needle goes off its mean course from one row to the next, pixels; its upper end lies
/// `length` metres from the tip.
double largest_stair_of_needle(double length) {
  Snapshot snapshot = scalpel_on_a_wall();
  SnapshotTool& needle = snapshot.tools[0];
  needle.kind = SnapshotToolKind::kNeedle;
  needle.radius = 0.002;
  needle.length = length;
  needle.direction = {0.1, 0, -0.995};
  ViewDefinition view = from_the_front("liver");
  view.camera.target = Double3{-0.003, 0, 0.02};
  view.look.background = {1, 1, 1};
  view.look.ground = Ground::kFloor;
  const Image image = Renderer(DeviceChoice{}, kSize, Tier::kRecord).draw(snapshot, view);
  const Camera camera = resolve_camera(view.camera, scene_extent(snapshot), kSize, 0);
  const auto middle = camera.pixel({-0.1 * 0.02, 0, 0.02}, kSize);
  std::vector<double> place;  // where the outline runs through each row, pixels
  for (int y = static_cast<int>((*middle)[1]) - 40; y < (*middle)[1] + 40; ++y) {
    const auto level = [&](int x) {
      return static_cast<double>(image.pixels[3 * static_cast<std::size_t>(y * kSize.width + x) + 1]);
    };
    int ground = static_cast<int>((*middle)[0]);
    while (ground > 3 && level(ground) < 225) --ground;
    const double light = level(ground - 3), dark = level(ground + 5);
    double covered = 0;
    for (int x = ground - 2; x < ground + 5; ++x) covered += (level(x) - light) / (dark - light);
    place.push_back(ground + 5 - covered);
  }
  double largest = 0;
  for (std::size_t i = 2; i < place.size(); ++i) {
    largest = std::max(largest, std::abs(place[i] - 2 * place[i - 1] + place[i - 2]));
  }
  return largest;
}

TEST(Steel, HasSmoothOutlinesWhereItReachesPastTheCamera) {
  // 0.29 and 0.31 were seen on two drivers, 1.1 where a line with one end behind the camera is left out.
  EXPECT_LT(largest_stair_of_needle(0.03), 0.5);
  EXPECT_LT(largest_stair_of_needle(0.3), 0.5) << "its upper end lies behind the camera";
}

/// The back of a blade that is narrower than a pixel is as even as the broad side beside it.
TEST(Steel, HasNoDashesAlongABladesNarrowBack) {
  Snapshot snapshot = scalpel_on_a_wall();
  snapshot.tools[0].thickness = 0.0003;
  ViewDefinition view = from_the_front("gallbladder");
  view.camera = {.position = Double3{-0.02, -0.06, 0.06}, .target = Double3{0, 0, 0.01}, .up = Double3{0.1, 0, 1}};
  view.camera.kind = CameraKind::kEndoscope;
  view.lights.endoscope = 1;
  const Image image = Renderer(DeviceChoice{}, kSize, Tier::kRecord).draw(snapshot, view);
  const Camera camera = resolve_camera(view.camera, scene_extent(snapshot), kSize, 0);
  std::vector<double> brightest;  // of the pixels around the back, in each row
  const auto low = camera.pixel({-0.0025, 0, 0.011}, kSize), high = camera.pixel({-0.0025, 0, 0.0135}, kSize);
  for (int y = static_cast<int>((*high)[1]); y < (*low)[1]; ++y) {
    const double part = (y - (*high)[1]) / ((*low)[1] - (*high)[1]);
    const int middle = static_cast<int>(std::lerp((*high)[0], (*low)[0], part));
    double most = 0;
    for (int x = middle - 2; x <= middle + 2; ++x) {
      most = std::max(most, static_cast<double>(image.pixels[3 * static_cast<std::size_t>(y * kSize.width + x) + 1]));
    }
    brightest.push_back(most);
  }
  double largest = 0;
  for (std::size_t i = 1; i < brightest.size(); ++i) {
    largest = std::max(largest, std::abs(brightest[i] - brightest[i - 1]));
  }
  // Seen: 25; 51 of dashes.
  EXPECT_LT(largest, 35);
}

TEST(Steel, HasNoDashesWhereAFaceIsSeenAlongItself) {
  Snapshot snapshot = scalpel_on_a_wall();
  snapshot.tools[0].axis = {0, 1, 0};
  const float wide = 0.2F;
  snapshot.surfaces = {test::quad("organ", {{{-wide, -wide, 0}, {wide, -wide, 0}, {wide, wide, 0}, {-wide, wide, 0}}})};
  ViewDefinition view = from_the_front("skin");
  view.camera.target = Double3{0, 0, 0.05};
  view.camera.field_of_view = 0.3;
  Renderer renderer(DeviceChoice{}, kSize, Tier::kRecord);
  int dark = 0;  // pixels, from all around the narrow side of the handle; skin and broad sides have 80 levels and more
  for (int turn = -5; turn <= 5; ++turn) {
    const double angle = 0.025 * turn;
    view.camera.position = Double3{0.1 * std::sin(angle), -0.1 * std::cos(angle), 0.16};
    const Image image = renderer.draw(snapshot, view);
    for (std::size_t i = 1; i < image.pixels.size(); i += 3) dark += image.pixels[i] < 45;
  }
  // Seen: 10; 309 of faces that mirror the dark.
  EXPECT_LT(dark, 60);
}

/// A wide wall in the plane z = 0, with a roof of this height across it where y is 5 to 7 mm.
SnapshotSurface wall_with_a_roof(float height) {
  const float wide = 0.2F;
  std::vector<Float3> positions;
  for (const auto& [y, z] : {std::array{-wide, 0.F}, {0.005F, 0.F}, {0.006F, height}, {0.007F, 0.F}, {wide, 0.F}}) {
    positions.push_back({-wide, y, z});
    positions.push_back({wide, y, z});
  }
  std::vector<Triangle> triangles;
  for (std::uint32_t left = 0; left + 2 < positions.size(); left += 2) {
    triangles.push_back({left, left + 1, left + 3});
    triangles.push_back({left, left + 3, left + 2});
  }
  return test::surface_of("organ", std::move(positions), std::move(triangles));
}

TEST(Steel, SeenAlongItselfShowsNoEdgesOfWhatLiesBehindAsGlassWould) {
  ViewDefinition view = from_the_front("skin");
  view.camera = {.position = Double3{0.008, -0.008, 0.16}, .target = Double3{0, 0.003, 0}, .up = Double3{0, 1, 0}};
  view.camera.field_of_view = 0.3;
  Renderer renderer(DeviceChoice{}, kSize, Tier::kRecord);
  const auto picture = [&](float height, bool has_tool) {
    Snapshot snapshot = scalpel_on_a_wall();
    snapshot.surfaces = {wall_with_a_roof(height)};
    if (!has_tool) snapshot.tools.clear();
    return renderer.draw(snapshot, view);
  };
  const Image flat = picture(0, false), roof = picture(0.003F, false);
  const Image steel_before_flat = picture(0, true), steel_before_roof = picture(0.003F, true);
  const Camera camera = resolve_camera(view.camera, scene_extent(scalpel_on_a_wall()), kSize, 0);
  int behind = 0, largest = 0;
  for (double height = 0.02; height < 0.1; height += 1e-4) {
    // On the middle line, which the handle is all around.
    const auto [x, y] = *camera.pixel({0, 0, height}, kSize);
    const std::size_t green = 3 * (static_cast<std::size_t>(y) * kSize.width + static_cast<std::size_t>(x)) + 1;
    const auto difference = [&](const Image& a, const Image& b) { return std::abs(a.pixels[green] - b.pixels[green]); };
    if (difference(flat, roof) < 20) continue;
    ++behind;
    largest = std::max(largest, difference(steel_before_flat, steel_before_roof));
  }
  EXPECT_GT(behind, 20);
  // 1 is left of 271 pixels, of what the steel mirrors; where the roof shows through it is 39.
  EXPECT_LE(largest, 3);
}

TEST(Steel, HasNoPatternOfRingsThatAreFinerThanThePixels) {
  // A shaft that points at the viewer: its rings, a millimetre apart, are seen as a tenth of that.
  Snapshot snapshot = scalpel_on_a_wall();
  SnapshotTool& probe = snapshot.tools[0];
  probe.kind = SnapshotToolKind::kSphere;
  probe.radius = 0.004;
  probe.tip = {0, 0, 0.002};
  ViewDefinition view = from_the_front("skin");
  view.camera = {.position = Double3{0.02, -0.02, 0.4}, .target = Double3{0, 0, 0}, .up = Double3{0, 1, 0}};
  view.camera.field_of_view = 0.2;
  const Image image = Renderer(DeviceChoice{}, kSize, Tier::kRecord).draw(snapshot, view);
  const Camera camera = resolve_camera(view.camera, scene_extent(snapshot), kSize, 0);
  const auto low = camera.pixel({0, 0, 0.02}, kSize), high = camera.pixel({0, 0, 0.15}, kSize);
  const auto level = [&](int x, int y) {
    return static_cast<double>(image.pixels[3 * static_cast<std::size_t>(y * kSize.width + x) + 1]);
  };
  double off = 0;  // levels by which pixels differ from the mean of their neighbours up and down
  constexpr int kPlaces = 60;
  for (int k = 0; k < kPlaces; ++k) {
    const double part = (k + 0.5) / kPlaces;
    const int x = static_cast<int>(std::lerp((*low)[0], (*high)[0], part)),
              y = static_cast<int>(std::lerp((*low)[1], (*high)[1], part));
    off += std::abs(level(x, y) - 0.5 * (level(x, y - 1) + level(x, y + 1))) / kPlaces;
  }
  // Seen: 0.9; 5.4 of a pattern.
  EXPECT_LT(off, 2.5);
}

/// Pixels above row `end` that stand out of all eight around them by more than 12 levels.
int lonely_pixels(const Image& image, int end) {
  int count = 0;
  const auto level = [&](int x, int y) {
    return static_cast<int>(image.pixels[3 * static_cast<std::size_t>(y * image.size.width + x) + 1]);
  };
  for (int y = 1; y < end; ++y) {
    for (int x = 1; x + 1 < image.size.width; ++x) {
      int most = 0;
      for (int j = -1; j <= 1; ++j) {
        for (int i = -1; i <= 1; ++i) most = i == 0 && j == 0 ? most : std::max(most, level(x + i, y + j));
      }
      count += level(x, y) > most + 12 ? 1 : 0;
    }
  }
  return count;
}

TEST(Steel, HasNoDashesAlongTheArmsOfForceps) {
  // From all around, above their teeth.
  Snapshot snapshot = scalpel_on_a_wall();
  SnapshotTool& forceps = snapshot.tools[0];
  forceps = {};
  forceps.kind = SnapshotToolKind::kForceps;
  forceps.opening = 0.006;
  forceps.length = 0.04;
  forceps.width = 0.005;
  forceps.thickness = 0.002;
  ViewDefinition view = from_the_front("stomach");
  view.camera = {.position = Double3{0, -0.14, 0.10}, .target = Double3{0, 0, 0.03}, .up = Double3{0, 0, 1}};
  view.camera.kind = CameraKind::kEndoscope;
  view.lights.endoscope = 1;
  view.look.bodies["organ"].wetness = 0;
  Renderer renderer(DeviceChoice{}, kSize, Tier::kRecord);
  int lonely = 0;
  for (int turn = 0; turn < 24; ++turn) {
    const double angle = turn * std::numbers::pi / 24;
    forceps.axis = {std::cos(angle), std::sin(angle), 0};
    forceps.direction = {0.12, 0, -0.99};
    lonely += lonely_pixels(renderer.draw(snapshot, view), 150);
  }
  // Seen: 112; 226 where what is narrower than a pixel looks as if it were seen as a whole.
  EXPECT_LT(lonely, 160);
}

TEST(Steel, OfASlenderShaftHasNoStrandsAsARope) {
  Snapshot snapshot = scalpel_on_a_wall();
  SnapshotTool& needle = snapshot.tools[0];
  needle = {};
  needle.kind = SnapshotToolKind::kNeedle;
  needle.radius = 0.0004;
  needle.length = 0.06;
  needle.tip = {0, 0, 0.01};
  ViewDefinition view = from_the_front("stomach");
  view.camera = {.position = Double3{0, -0.14, 0.10}, .target = Double3{0, 0, 0.03}, .up = Double3{0, 0, 1}};
  view.look.bodies["organ"].wetness = 0;
  Renderer renderer(DeviceChoice{}, kSize, Tier::kRecord);
  int lonely = 0;
  for (int lean = 0; lean < 24; ++lean) {
    const double angle = (lean - 12) * std::numbers::pi / 48;
    needle.direction = {std::sin(angle), 0, -std::cos(angle)};
    lonely += lonely_pixels(renderer.draw(snapshot, view), 150);
  }
  RecordProperty("lonely", lonely);
  // Pixels of 24 pictures. Seen: 51; 528 where each shows its own side of the shaft.
  EXPECT_LT(lonely, 150);
}

}  // namespace
}  // namespace thinwall
