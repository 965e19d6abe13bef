#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <vector>

#include "renderer/picture/Renderer.hpp"
#include "tests/renderer/shape/TestMeshes.hpp"

namespace thinwall {
namespace {

/// Inverse of what tone.glsl makes of a grey radiance, by bisection; `level` in 8 bits.
double radiance_of(double level) {
  double low = 0, high = 100;
  for (int step = 0; step < 60; ++step) {
    const double middle = 0.5 * (low + high);
    const double x = std::max(0.72 * middle - 0.004, 0.0);
    (255 * x * (6.2 * x + 0.5) / (x * (6.2 * x + 1.7) + 0.06) < level ? low : high) = middle;
  }
  return low;
}

double level_at(const Image& image, int x, int y) {
  return image.pixels[3 * (static_cast<std::size_t>(y) * image.size.width + x) + 1];
}

/// Mean over a square of 7 pixels, so that dithering and rounding even out.
double mean_level(const Image& image, int x, int y) {
  double sum = 0;
  for (int j = -3; j <= 3; ++j) {
    for (int i = -3; i <= 3; ++i) sum += level_at(image, x + i, y + j);
  }
  return sum / 49;
}

TissueLook white() {
  TissueLook look;
  look.color = {1, 1, 1};
  look.roughness = 1;
  look.wetness = 0;
  look.mottling = 0;
  return look;
}

/// From `distance` above the origin down on it; all light is the lamp's.
ViewDefinition endoscope(double distance) {
  ViewDefinition view;
  view.camera = {.position = Double3{0, 0, distance}, .target = Double3{0, 0, 0}, .up = Double3{0, 1, 0}};
  view.camera.field_of_view = 1;
  view.camera.kind = CameraKind::kEndoscope;
  view.lights.endoscope = 1;
  view.lights.environment = 0;
  view.look.floor = false;
  view.look.bodies["organ"] = white();
  return view;
}

SnapshotSurface wall(float x, float z, float half) {
  return test::quad("organ", {{{x - half, -half, z}, {x + half, -half, z}, {x + half, half, z}, {x - half, half, z}}});
}

Image draw(const std::vector<SnapshotSurface>& surfaces, const ViewDefinition& view, ImageSize size = {160, 90}) {
  Snapshot snapshot;
  snapshot.surfaces = surfaces;
  return Renderer(DeviceChoice{}, size, Tier::kRecord).draw(snapshot, view);
}

TEST(Endoscope, ItsLightFallsWithTheSquareOfTheDistance) {
  // Two walls side by side, one at 50 mm and one at 80 mm; the lamp 4 mm above the lens is 0.2 mm farther.
  ViewDefinition view = endoscope(0.1);
  view.camera.exposure = -1;
  const std::vector<SnapshotSurface> walls = {wall(-0.012f, 0.05f, 0.01f), wall(0.02f, 0.02f, 0.015f)};
  const Image image = draw(walls, view, {320, 180});
  // Where the middle of each is seen, 0.24 and 0.25 beside the line of sight.
  const auto column = [&](double tangent) { return static_cast<int>(160 + 90 * tangent / std::tan(0.5)); };
  const double near = radiance_of(mean_level(image, column(-0.24), 90));
  const double far = radiance_of(mean_level(image, column(0.25), 90));
  // (80 / 50)^2; cosines and darkening of the lens are the same on both sides. A level is 2 % of the darker.
  EXPECT_NEAR(near / far, 2.56, 0.10);
}

TEST(Endoscope, ExposesTheMiddleOfTheSceneAlikeFromAnyDistance) {
  const auto level = [](double distance) { return mean_level(draw({wall(0, 0, 0.02f)}, endoscope(distance)), 80, 45); };
  // The lamp is 4 mm beside the lens, which takes 0.5 % of the light off at 80 mm.
  EXPECT_NEAR(level(0.4), level(0.2), 1.5);
  EXPECT_NEAR(level(0.4), level(0.08), 3);
  // White is bright, but not burnt out.
  EXPECT_GT(level(0.4), 180);
  EXPECT_LT(level(0.4), 240);
}

TEST(Endoscope, HasARoundPictureThatIsDarkerTowardsItsBorder) {
  ViewDefinition view = endoscope(0.1);
  view.lights.environment = 1;
  view.lights.environment_contrast = 0;
  view.lights.endoscope = 1e-9;
  const Image image = draw({wall(0, 0, 0.2f)}, view, {320, 180});
  const double middle = radiance_of(mean_level(image, 160, 90));
  EXPECT_NEAR(middle, 1, 0.02);
  for (const int offset : {40, 80}) {
    const double tangent = offset / 90.0 * std::tan(0.5);
    EXPECT_NEAR(radiance_of(mean_level(image, 160 + offset, 90)), middle / std::pow(1 + 0.8 * tangent * tangent, 2),
                0.02);
  }
  // The stop is 1.12 half heights from the middle.
  EXPECT_GT(level_at(image, 160 + 97, 90), 50);
  EXPECT_LE(level_at(image, 160 + 103, 90), 1);
  EXPECT_LE(level_at(image, 2, 2), 1);
}

TEST(Endoscope, AStepOfExposureDoublesTheLight) {
  for (const CameraKind kind : {CameraKind::kPinhole, CameraKind::kEndoscope}) {
    ViewDefinition view = endoscope(0.1);
    view.camera.kind = kind;
    view.camera.exposure = -2;
    const double darker = radiance_of(mean_level(draw({wall(0, 0, 0.2f)}, view), 80, 45));
    view.camera.exposure = -1;
    EXPECT_NEAR(radiance_of(mean_level(draw({wall(0, 0, 0.2f)}, view), 80, 45)), 2 * darker, 0.03 * darker);
  }
}

TEST(Endoscope, SeesTheWallOfTheCavityWhereverItLooks) {
  // Towards a ball from aside, level and up from below, where there is no ground to be seen above the horizon. Once
  // nearer than the cavity is wide, once farther.
  const std::vector<SnapshotSurface> surfaces = {test::sphere("organ", {0, 0, 0}, 0.03, 3)};
  for (const double distance : {0.1, 0.4}) {
    for (const double rise : {0.5, 0.0, -0.5}) {
      ViewDefinition view = endoscope(0.1);
      view.look.bodies.clear();
      view.look.floor = true;
      view.camera.position = Double3{0, -distance * std::cos(rise), distance * std::sin(rise)};
      view.camera.up = Double3{0, 0, 1};
      const Image image = draw(surfaces, view, {320, 180});
      for (int side = 0; side < 8; ++side) {
        const double angle = 0.25 * std::numbers::pi * side;
        const int x = 160 + static_cast<int>(80 * std::cos(angle)), y = 90 + static_cast<int>(80 * std::sin(angle));
        // Seen: 17 and more; 0 where nothing is.
        EXPECT_GT(image.pixels[3 * (static_cast<std::size_t>(y) * 320 + x)], 12)
            << distance << ' ' << rise << ' ' << side;
      }
    }
  }
}

TEST(Endoscope, AWetLiningGlistensAlsoWhereItIsSeenAslant) {
  // From within a ball, from below its middle: around the lamp's own reflection, where the wall is turned by 12 to 25
  // degrees off the line of sight, hills of the mucosa turn to the lens.
  ViewDefinition view = endoscope(0.1);
  view.look.bodies["organ"] = {};
  view.camera.position = Double3{0, 0, -0.018};
  view.camera.target = Double3{0, 0, 0.03};
  view.camera.field_of_view = 1.5;
  SnapshotSurface ball = test::sphere("organ", {0, 0, 0}, 0.03, 4);
  auto topology = std::make_shared<SnapshotTopology>(*ball.topology);
  topology->thickness.assign(topology->triangles.size(), 0.003F);
  ball.topology = topology;
  const Image image = draw({ball}, view, {640, 360});
  int glistening = 0, all = 0;
  for (int y = 0; y < 360; ++y) {
    for (int x = 140; x < 500; ++x) {
      const double radius = std::hypot(x - 319.5, y - 179.5);
      if (radius < 80 || radius > 160) continue;
      ++all;
      const std::size_t first = 3 * (static_cast<std::size_t>(y) * 640 + x);
      glistening += image.pixels[first + 1] > 120 ? 1 : 0;
    }
  }
  // Seen: 0.0039 of them; 0.0005 of a lining that is as smooth as a serosa.
  EXPECT_GT(glistening, 0.002 * all);
  EXPECT_LT(glistening, 0.05 * all) << "not frosted";
}

/// Mean difference that folds make to the lining of a ball that is blown up `stretch` times, seen from its middle.
double shown_folds(float stretch) {
  SnapshotSurface ball = test::sphere("organ", {0, 0, 0}, 0.03, 4);
  auto topology = std::make_shared<SnapshotTopology>(*ball.topology);
  topology->thickness.assign(topology->triangles.size(), 0.003F);
  ball.topology = topology;
  for (Float3& place : ball.positions) {
    for (float& coordinate : place) coordinate *= stretch;
  }
  ViewDefinition view = endoscope(0.1);
  view.camera.position = Double3{0, 0, -0.018 * double{stretch}};
  view.camera.target = Double3{0, 0, 0.03 * double{stretch}};
  view.camera.field_of_view = 1.5;
  const auto draw_folded = [&](double folds) {
    view.look.bodies["organ"] = {.folds = folds};
    return draw({ball}, view, {320, 180});
  };
  // The weakest of folds have the same mucus.
  const Image folded = draw_folded(1), level = draw_folded(1e-6);
  double sum = 0;
  for (std::size_t i = 1; i < folded.pixels.size(); i += 3) sum += std::abs(folded.pixels[i] - level.pixels[i]);
  return sum / (320 * 180);
}

TEST(Endoscope, TheLiningOfAStomachIsFoldedWhereItIsSlack) {
  const double slack = shown_folds(1), filled = shown_folds(1.7F);
  RecordProperty("slack", std::to_string(slack));
  RecordProperty("filled", std::to_string(filled));
  EXPECT_GT(slack, 3) << "levels";
  // A wall that is stretched to a third of its thickness has smoothed its folds out.
  EXPECT_LT(filled, 0.1);
}

TEST(Endoscope, APictureIsTheSameAloneAndInASequence) {
  const std::vector<SnapshotSurface> surfaces = {test::sphere("organ", {0, 0, 0}, 0.03, 3)};
  Snapshot snapshot;
  snapshot.surfaces = surfaces;
  ViewDefinition view = endoscope(0.1);
  view.look.bodies.clear();
  view.look.floor = true;
  Renderer renderer(DeviceChoice{}, {160, 90}, Tier::kRecord);
  renderer.draw(snapshot, {});
  const Image in_sequence = renderer.draw(snapshot, view);
  EXPECT_EQ(in_sequence.pixels, draw(surfaces, view).pixels);
  EXPECT_NE(in_sequence.pixels, renderer.draw(snapshot, {}).pixels);
}

TEST(Endoscope, AFieldStopIsThatOfThePictureNotOfTheOneBefore) {
  const std::vector<SnapshotSurface> surfaces = {wall(0, 0, 0.1F)};
  Snapshot snapshot;
  snapshot.surfaces = surfaces;
  const ViewDefinition wide = endoscope(0.1);
  ViewDefinition narrow = wide;
  narrow.camera.field_of_view = 0.6;
  Renderer renderer(DeviceChoice{}, {160, 90}, Tier::kRecord);
  renderer.draw(snapshot, wide);
  EXPECT_EQ(renderer.draw(snapshot, narrow).pixels, draw(surfaces, narrow).pixels);
  EXPECT_EQ(renderer.draw(snapshot, {}).pixels, draw(surfaces, {}).pixels);
  EXPECT_EQ(renderer.draw(snapshot, wide).pixels, draw(surfaces, wide).pixels);
}

/// Largest second difference in time of the mean level of tiles of 10 x 10 pixels.
double roughest_tile(const std::vector<Image>& frames) {
  const auto tile_mean = [](const Image& image, int x, int y) {
    double sum = 0;
    for (int j = 0; j < 10; ++j) {
      for (int i = 0; i < 10; ++i) sum += level_at(image, 10 * x + i, 10 * y + j);
    }
    return sum / 100;
  };
  double largest = 0;
  for (std::size_t k = 1; k + 1 < frames.size(); ++k) {
    for (int y = 0; y < frames[k].size.height / 10; ++y) {
      for (int x = 0; x < frames[k].size.width / 10; ++x) {
        largest = std::max(largest, std::abs(tile_mean(frames[k - 1], x, y) - 2 * tile_mean(frames[k], x, y) +
                                             tile_mean(frames[k + 1], x, y)));
      }
    }
  }
  return largest;
}

TEST(Endoscope, AMovingLightDoesNotFlickerOnTheTissue) {
  // The lens goes round slowly, and its lamp with it: 0.2 degrees a frame.
  const std::vector<SnapshotSurface> surfaces = {test::sphere("organ", {0, 0, 0}, 0.03, 4)};
  std::vector<Image> frames;
  for (int frame = 0; frame < 8; ++frame) {
    ViewDefinition view = endoscope(0.1);
    view.look.bodies.clear();
    const double angle = 0.2 * frame * std::numbers::pi / 180;
    view.camera.position = Double3{0.1 * std::sin(angle), 0, 0.1 * std::cos(angle)};
    frames.push_back(draw(surfaces, view, {320, 180}));
  }
  // Glints that come and go; 3 levels of 255.
  EXPECT_LT(roughest_tile(frames), 4);
}

TEST(Wounds, BleedAtTheirLips) {
  // Two halves of a sheet, parted by a cut along y: the borders at the cut are twins at rest.
  const auto half = [](float from, float to) {
    return std::array<Float3, 4>{{{from, -0.02f, 0}, {to, -0.02f, 0}, {to, 0.02f, 0}, {from, 0.02f, 0}}};
  };
  std::vector<Float3> positions;
  for (const auto& corners : {half(-0.02f, 0), half(0, 0.02f)})
    positions.insert(positions.end(), corners.begin(), corners.end());
  const SnapshotSurface cut = test::surface_of("organ", positions, {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}});
  ViewDefinition view = endoscope(0.06);
  view.look.bodies["organ"] = {.color = {0.8, 0.7, 0.6}, .patches = 0, .vessels = 0, .capillaries = 0, .clearness = 0};
  // How much redder the lips are than the wall beside them, above and below the lamp's glint in the middle, where they
  // are reddest: blood gathers here and there.
  const auto redder = [&](double bleeding) {
    view.look.bodies["organ"].bleeding = bleeding;
    const Image image = draw({cut}, view, {320, 180});
    const auto reddest = [&](int x) {
      std::vector<double> parts;
      for (int y = 37; y < 143; ++y) {
        if (y > 66 && y < 113) continue;
        const std::size_t first = 3 * (static_cast<std::size_t>(y) * 320 + x);
        parts.push_back((image.pixels[first] + 1.0) / (image.pixels[first + 1] + 1.0));
      }
      std::ranges::sort(parts, std::greater());
      return std::accumulate(parts.begin(), parts.begin() + 20, 0.0) / 20;
    };
    return reddest(159) / reddest(130);
  };
  // Seen: 1.61 where blood has gathered, in which the lamp's glint takes some of the red; 1.02 without, of the edge
  // that is bare.
  EXPECT_GT(redder(1), 1.4 * redder(0));
}

}  // namespace
}  // namespace thinwall
