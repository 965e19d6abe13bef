#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "renderer/look/OrganLooks.hpp"
#include "renderer/picture/Renderer.hpp"
#include "tests/renderer/shape/CutSheets.hpp"

namespace thinwall {
namespace {

/// The faces of a cut that gapes, seen from the side of one lip.
Image draw_gaping(double bleeding, std::optional<Double3> key_direction = {}, const std::string& organ = "skin") {
  SnapshotSurface sheet = test::slit_sheet(40, 0.0005, 0);
  const std::vector<BorderEdge> borders = border_edges(*sheet.topology);
  const std::vector<char> is_lip = cut_lips(*sheet.topology, borders);
  for (std::size_t v = 0; v < sheet.positions.size(); ++v) {
    const bool is_far = v >= 41 * 41 || sheet.topology->rest_positions[v][1] > 0;
    const bool is_end = is_lip[v] && std::abs(sheet.topology->rest_positions[v][0]) > 0.0089F;
    if (!is_end) sheet.positions[v][1] += is_far ? 0.002F : -0.004F;
  }
  Snapshot snapshot;
  snapshot.surfaces = {sheet};
  snapshot.time = 3;
  ViewDefinition view;
  view.camera = {.position = Double3{0, -0.03, 0.025},
                 .target = Double3{0, 0.0015, -0.001},
                 .up = Double3{0, 0, 1},
                 .field_of_view = 0.3};
  view.look.floor = false;
  view.look.bodies["organ"] = *find_organ_look(organ);
  view.look.bodies["organ"].bleeding = bleeding;
  view.lights.key_direction = key_direction;
  return Renderer(DeviceChoice{}, {384, 216}, Tier::kRecord).draw(snapshot, view);
}

constexpr int kFaceTop = 92, kFaceFoot = 118, kFaceLeft = 90, kFaceRight = 290;  // pixels, of its middle

double spread_of(const std::vector<double>& values) {
  double sum = 0, squares = 0;
  for (const double value : values) sum += value, squares += value * value;
  const double mean = sum / static_cast<double>(values.size());
  return std::sqrt(squares / static_cast<double>(values.size()) - mean * mean);
}

TEST(CutFace, HasFatInLobulesBelowTheDermis) {
  const Image dry = draw_gaping(0);
  std::vector<double> borders;  // rows where yellow begins
  for (int column = kFaceLeft; column < kFaceRight; ++column) {
    int row = kFaceTop;
    const auto is_yellow = [&] {
      const auto pixel = static_cast<std::size_t>(3 * (row * 384 + column));
      return dry.pixels[pixel + 2] < 0.75 * dry.pixels[pixel + 1];
    };
    while (row < kFaceFoot && !is_yellow()) ++row;
    borders.push_back(row);
  }
  RecordProperty("spread", std::to_string(spread_of(borders)));
  EXPECT_GT(spread_of(borders), 1.7) << "pixels: 2.2 was seen, 1.1 of a border without lobules";
}

TEST(CutFace, IsPaleThenDarkThenPink) {
  // Of the wall of a stomach: serosa, muscle and mucosa.
  const Image dry = draw_gaping(0, {}, "stomach");
  const auto mean = [&](int row, std::size_t channel) {
    double sum = 0;
    for (int column = kFaceLeft; column < kFaceRight; ++column)
      sum += dry.pixels[static_cast<std::size_t>(3 * (row * 384 + column)) + channel];
    return sum / (kFaceRight - kFaceLeft);
  };
  std::vector<double> greens;
  for (int row = kFaceTop - 3; row < kFaceFoot; ++row) greens.push_back(mean(row, 1));
  const auto muscle = std::ranges::min_element(greens);
  const double serosa = *std::max_element(greens.begin(), muscle), mucosa = *std::max_element(muscle, greens.end());
  RecordProperty("serosa", std::to_string(serosa));
  RecordProperty("muscle", std::to_string(*muscle));
  RecordProperty("mucosa", std::to_string(mucosa));
  EXPECT_GT(serosa, 2 * *muscle);
  EXPECT_GT(mucosa, 2 * *muscle) << "3.6 times was seen, 1.4 of one tone throughout";
}

TEST(CutFace, HasNoPaleLayerWithinASolidOrgan) {
  const Image dry = draw_gaping(0, {}, "liver");
  std::vector<int> greens;  // below the capsule
  for (int row = kFaceTop + 4; row < kFaceFoot; ++row) {
    for (int column = kFaceLeft; column < kFaceRight; ++column)
      greens.push_back(dry.pixels[static_cast<std::size_t>(3 * (row * 384 + column)) + 1]);
  }
  std::ranges::sort(greens);
  const int pale = greens[greens.size() * 85 / 100];
  RecordProperty("pale", pale);
  EXPECT_LT(pale, 28) << "levels: 19 was seen, 37 with one";
}

TEST(CutFace, OfASolidOrganIsOfLobulesUpToItsCapsule) {
  const Image dry = draw_gaping(0, {}, "liver");
  const auto red = [&](int row, int column) {
    return static_cast<double>(dry.pixels[static_cast<std::size_t>(3 * (row * 384 + column))]);
  };
  constexpr int kLobule = 3;  // pixels, within the width of one
  double uneven = 0, sum = 0;
  for (int row = kFaceTop + 10; row < kFaceFoot; ++row) {
    for (int column = kFaceLeft; column < kFaceRight; ++column) {
      uneven += std::abs(red(row, column) - 0.5 * (red(row, column - kLobule) + red(row, column + kLobule)));
      sum += red(row, column);
    }
  }
  RecordProperty("uneven", std::to_string(uneven / sum));
  EXPECT_GT(uneven / sum, 0.038) << "0.044 was seen, 0.031 of ragged layers, 0.019 of hills as wide as the capsule's";
}

TEST(CutFace, IsCoatedWithBloodUnevenlyAndMoreBelow) {
  const Image dry = draw_gaping(0), bleeding = draw_gaping(1);
  const auto left = [&](int row) {
    std::vector<double> parts;
    for (int column = kFaceLeft; column < kFaceRight; ++column) {
      const auto pixel = static_cast<std::size_t>(3 * (row * 384 + column) + 1);
      parts.push_back((bleeding.pixels[pixel] + 1.0) / (dry.pixels[pixel] + 1.0));
    }
    return parts;
  };
  const auto mean = [](const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  };
  EXPECT_LT(mean(left(kFaceFoot)), mean(left(kFaceTop)) - 0.1);
  EXPECT_LT(std::ranges::min(left(105)), 0.3) << "here it is thick";
  EXPECT_GT(std::ranges::max(left(105)), 0.55) << "there thin";
  EXPECT_GT(spread_of(left(105)), 0.1);
}

TEST(CutFace, GlistensWithBloodAllAlong) {
  const Image image = draw_gaping(1);
  int columns = 0;
  for (int column = kFaceLeft; column < kFaceRight; ++column) {
    int brightest = 0;
    for (int row = kFaceTop; row < kFaceFoot; ++row) {
      brightest = std::max<int>(brightest, image.pixels[static_cast<std::size_t>(3 * (row * 384 + column) + 1)]);
    }
    columns += brightest > 130 ? 1 : 0;
  }
  EXPECT_GE(columns, 21) << "26 were seen, 16 of blood as level as on skin";
}

TEST(CutFace, InTheShadeIsLitByTheOtherWhichIsRed) {
  const Image image = draw_gaping(0, Double3{-0.3, 0.5, 0.3});
  constexpr int kDermisFoot = 104;
  double sum = 0;
  for (int row = kFaceTop; row < kDermisFoot; ++row) {
    for (int column = kFaceLeft; column < kFaceRight; ++column) {
      const auto pixel = static_cast<std::size_t>(3 * (row * 384 + column));
      sum += image.pixels[pixel + 2] / (image.pixels[pixel] + 1.0);
    }
  }
  const double blue_over_red = sum / ((kDermisFoot - kFaceTop) * (kFaceRight - kFaceLeft));
  RecordProperty("blue_over_red", std::to_string(blue_over_red));
  EXPECT_LT(blue_over_red, 0.55) << "0.52 was seen, 0.59 of what light the room alone sends there";
}

TEST(CutFace, HasBloodThatTheWallsLightInTheShade) {
  const Image image = draw_gaping(1, Double3{-0.3, 0.5, 0.3});
  std::vector<int> reds;
  for (int row = kFaceTop; row < kFaceFoot; ++row) {
    for (int column = kFaceLeft; column < kFaceRight; ++column) {
      reds.push_back(image.pixels[static_cast<std::size_t>(3 * (row * 384 + column))]);
    }
  }
  const auto darkest = reds.begin() + static_cast<std::ptrdiff_t>(reds.size() / 10);
  std::ranges::nth_element(reds, darkest);
  EXPECT_GT(*darkest, 65) << "levels: 69 were seen, 62 without their light";
}

}  // namespace
}  // namespace thinwall
