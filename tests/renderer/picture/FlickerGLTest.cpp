#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "renderer/look/OrganLooks.hpp"
#include "renderer/picture/Renderer.hpp"
#include "tests/renderer/shape/TestMeshes.hpp"

namespace thinwall {
namespace {

constexpr ImageSize kFlickerSize{320, 192};
constexpr int kTile = 16;  // pixels on a side

/// Means of the channels of all tiles, in 8-bit levels.
std::vector<double> tiles_of(const Image& image) {
  const int columns = kFlickerSize.width / kTile, rows = kFlickerSize.height / kTile;
  std::vector<double> tiles(static_cast<std::size_t>(3 * columns * rows));
  for (int y = 0; y < kFlickerSize.height; ++y) {
    for (int x = 0; x < kFlickerSize.width; ++x) {
      for (int c = 0; c < 3; ++c) {
        const auto pixel = static_cast<std::size_t>(3 * (y * kFlickerSize.width + x) + c);
        const auto tile = static_cast<std::size_t>(3 * ((y / kTile) * columns + x / kTile) + c);
        tiles[tile] += image.pixels[pixel] / static_cast<double>(kTile * kTile);
      }
    }
  }
  return tiles;
}

// What was seen, and a quarter more for another driver's rounding.
constexpr double kDryJolt = 0.5;
constexpr double kBloodJolt = 0.75;  // 1.5 where blood on skin begins with its whole rim, 2.2 where faces that are
                                     // turned away show blood along their lips
constexpr double kLightJolt = 0.95;  // 1.6 where the cells of the shade on the floor are twice as large

struct Unrest {
  double change = 0;  // levels, the largest of a tile from a frame to the next
  double jolt = 0;    // levels, the largest of a tile's second differences: what an eye takes for flicker
};

Unrest unrest_of(const std::vector<std::vector<double>>& frames) {
  Unrest unrest;
  for (std::size_t t = 1; t < frames.size(); ++t) {
    for (std::size_t k = 0; k < frames[t].size(); ++k) {
      const double change = frames[t][k] - frames[t - 1][k];
      unrest.change = std::max(unrest.change, std::abs(change));
      if (t < 2) continue;
      unrest.jolt = std::max(unrest.jolt, std::abs(change - (frames[t - 1][k] - frames[t - 2][k])));
    }
  }
  return unrest;
}

constexpr double kAlong = 0.0005, kAcross = 0.002;  // metres between vertices, along the cut as a blade leaves them
constexpr std::uint32_t kColumns = 97, kRows = 15;

double column_at(std::uint32_t column) {
  return kAlong * (static_cast<double>(column) - 0.5 * (kColumns - 1));
}

/// Half the width of a wound between `start` and `tip` (metres along x), round at the start and pointed at the tip.
double half_width(double x, double start, double tip) {
  const double behind = std::max(0.0, tip - x) / 0.008, ahead = std::max(0.0, x - start) / 0.008;
  return 0.0025 * behind * behind / (1 + behind * behind) * ahead * ahead / (1 + ahead * ahead);
}

/// A sheet of skin with a cut along y = 0 up to `tip`. As where a blade goes, a vertex is doubled when the tip has
/// passed it, and its twins part from there on.
Snapshot cut_up_to(double tip, double time) {
  constexpr std::uint32_t kMiddle = kRows / 2, kFirst = 16;
  auto topology = std::make_shared<SnapshotTopology>();
  SnapshotSurface sheet;
  sheet.body = "skin";
  const double start = column_at(kFirst);
  const auto add = [&](std::uint32_t i, std::uint32_t j, double side) {
    const double x = column_at(i), y = kAcross * (static_cast<double>(j) - 0.5 * (kRows - 1));
    topology->rest_positions.push_back({static_cast<float>(x), static_cast<float>(y), 0});
    const double moved = side * half_width(x, start, tip) * std::exp(-std::abs(y) / 0.006);
    sheet.positions.push_back({static_cast<float>(x), static_cast<float>(y + moved), 0});
  };
  for (std::uint32_t j = 0; j < kRows; ++j) {
    for (std::uint32_t i = 0; i < kColumns; ++i) add(i, j, j < kMiddle ? -1 : j > kMiddle ? 1 : -1);
  }
  std::vector<std::uint32_t> twin(kColumns, 0);
  for (std::uint32_t i = kFirst + 1; i < kColumns && column_at(i) < tip; ++i) {
    twin[i] = static_cast<std::uint32_t>(topology->rest_positions.size());
    add(i, kMiddle, 1);
  }
  for (std::uint32_t j = 0; j + 1 < kRows; ++j) {
    for (std::uint32_t i = 0; i + 1 < kColumns; ++i) {
      const std::uint32_t a = j * kColumns + i;
      for (Triangle triangle : {Triangle{a, a + 1, a + kColumns + 1}, Triangle{a, a + kColumns + 1, a + kColumns}}) {
        for (std::uint32_t& corner : triangle) {
          if (j >= kMiddle && corner / kColumns == kMiddle && twin[corner % kColumns] != 0) {
            corner = twin[corner % kColumns];
          }
        }
        topology->triangles.push_back(triangle);
      }
    }
  }
  topology->thickness.assign(topology->triangles.size(), 0.002F);
  topology->cut_times.assign(topology->rest_positions.size(), kNeverCut);
  for (std::uint32_t i = kFirst; i < kColumns && column_at(i) < tip; ++i) {
    const auto cut_at = static_cast<float>(time - (tip - column_at(i)) / 0.006);
    topology->cut_times[kMiddle * kColumns + i] = cut_at;
    if (twin[i] != 0) topology->cut_times[twin[i]] = cut_at;
  }
  sheet.topology = topology;
  Snapshot snapshot;
  snapshot.surfaces = {sheet};
  snapshot.time = time;
  return snapshot;
}

Unrest of_slow_cut(double bleeding) {
  Renderer renderer(DeviceChoice{}, kFlickerSize, Tier::kRecord);
  ViewDefinition view;
  view.camera.position = Double3{0, -0.05, 0.06};
  view.camera.target = Double3{0, 0, 0};
  view.look.bodies["skin"] = *find_organ_look("skin");
  view.look.bodies["skin"].bleeding = bleeding;
  constexpr double kSpeed = 0.006, kFrame = 1.0 / 60;  // m/s, seconds: a vertex is doubled every 5 frames
  std::vector<std::vector<double>> frames;
  for (int frame = 0; frame < 60; ++frame) {
    const double time = 1 + frame * kFrame;
    frames.push_back(tiles_of(renderer.draw(cut_up_to(kSpeed * frame * kFrame - 0.004, time), view)));
  }
  return unrest_of(frames);
}

/// Nothing moves by itself when the mesh changes: vertices are doubled one after the other, and triangles of rim,
/// lining and films appear with them.
TEST(Flicker, ASlowCutChangesNoPlaceSuddenly) {
  const Unrest dry = of_slow_cut(0), bleeding = of_slow_cut(1);
  for (const auto& [name, unrest] : {std::pair{"dry", dry}, std::pair{"bleeding", bleeding}}) {
    RecordProperty(std::string(name) + "_change", std::to_string(unrest.change));
    RecordProperty(std::string(name) + "_second_difference", std::to_string(unrest.jolt));
    EXPECT_GT(unrest.change, 0.2) << "something happens";
  }
  EXPECT_LT(dry.jolt, kDryJolt);
  EXPECT_LT(bleeding.jolt, kBloodJolt);
}

/// A light that goes around a thing at rest slides over it.
TEST(Flicker, AMovingLightChangesNoPlaceSuddenly) {
  Renderer renderer(DeviceChoice{}, kFlickerSize, Tier::kRecord);
  Snapshot snapshot;
  snapshot.surfaces = {test::sphere("organ", {0, 0, 0.03}, 0.03, 4)};
  ViewDefinition view;
  view.look.bodies["organ"] = *find_organ_look("stomach");
  std::vector<std::vector<double>> frames;
  for (int frame = 0; frame < 40; ++frame) {
    const double angle = 0.01 * frame;
    view.lights.key_direction = Double3{std::cos(angle), std::sin(angle) - 1, 1.2};
    frames.push_back(tiles_of(renderer.draw(snapshot, view)));
  }
  const Unrest unrest = unrest_of(frames);
  RecordProperty("largest_change", std::to_string(unrest.change));
  RecordProperty("largest_second_difference", std::to_string(unrest.jolt));
  EXPECT_GT(unrest.change, 0.2);
  EXPECT_LT(unrest.jolt, kLightJolt);
}

}  // namespace
}  // namespace thinwall
