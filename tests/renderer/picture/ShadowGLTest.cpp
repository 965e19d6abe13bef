#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "renderer/picture/Renderer.hpp"
#include "renderer/picture/ToolCover.hpp"
#include "tests/renderer/picture/ShaderMath.hpp"
#include "tests/renderer/shape/CutSheets.hpp"

namespace thinwall {
namespace {

/// A shadow's border across the raster of its map at a slant is as straight as what casts it.
TEST(Shadow, ItsBorderHasNoStairs) {
  const OffscreenContext context{DeviceChoice{}};
  const CurrentContext current{context};
  constexpr int kTexels = 64, kPlaces = 64;
  constexpr double kSlant = 0.37, kStart = 20;
  std::vector<float> depths;
  for (int y = 0; y < kTexels; ++y) {
    for (int x = 0; x < kTexels; ++x) depths.push_back(y + 0.5 < kStart + kSlant * (x + 0.5) ? 0.0F : 1.0F);
  }
  const Texture map = create_texture(GL_DEPTH_COMPONENT32F, kTexels, kTexels, GL_LINEAR);
  glTextureParameteri(map.name(), GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glTextureParameteri(map.name(), GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  glTextureSubImage2D(map.name(), 0, 0, 0, kTexels, kTexels, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
  glBindTextureUnit(0, map.name());
  // Texels from the line to where half of the light comes, and what light is left four texels to both sides.
  const auto results = test::run_shader({"shadow.glsl"}, R"(
    float x = 20.0 + 0.31 * float(index), line = 20.0 + 0.37 * x;
    float low = -4.0, high = 4.0;
    for (int turn = 0; turn < 16; ++turn) {
      float middle = 0.5 * (low + high);
      if (lit_part(vec3(x, line + middle, 32.0) / 64.0) < 0.5) low = middle; else high = middle;
    }
    result = vec4(low, lit_part(vec3(x, line - 4.0, 32.0) / 64.0), lit_part(vec3(x, line + 4.0, 32.0) / 64.0), 1.0);)",
                                        kPlaces);
  double most = 0;
  for (const auto& result : results) {
    most = std::max(most, std::abs(double{result[0]}));
    EXPECT_EQ(result[1], 0);
    EXPECT_NEAR(result[2], 1, 1e-6);
  }
  RecordProperty("texels_off", std::to_string(most));
  // Half a texel is what the raster itself errs by; 0.36 was seen, 1.2 with taps that stand the same way to all texels.
  EXPECT_LT(most, 0.42);
}

TEST(Shadow, OfToolsIsTheSofterTheFartherTheyAre) {
  const OffscreenContext context{DeviceChoice{}};
  const CurrentContext current{context};
  // At the spreads that the blurs have, and between them.
  const std::array<double, 4>& spreads = ToolCover::kSpreads;
  std::string places;
  for (std::size_t k = 0; k < 4; ++k) places += std::to_string(spreads[k]) + ", ";
  for (std::size_t k = 0; k < 3; ++k) places += std::to_string(0.5 * (spreads[k] + spreads[k + 1])) + ", ";
  const auto results = test::run_shader({"shadow.glsl"}, "float spreads[9] = float[9](" + places + R"(0.0, 100.0);
    result = vec4(past_tools(spreads[index], vec4(0.8, 0.6, 0.3, 0.1)));)",
                                        9);
  const std::array<double, 9> expected{0.2, 0.4, 0.7, 0.9, 0.3, 0.55, 0.8, 0.2, 0.9};
  for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(results[i][0], expected[i], 1e-5) << i;
}

TEST(Shadow, BeforeAToolThereIsNone) {
  const OffscreenContext context{DeviceChoice{}};
  const CurrentContext current{context};
  const auto results = test::run_shader({"shadow.glsl"}, R"(
    result = vec4(past_tools(-0.07 * float(index), vec4(0.8)));)",
                                        4);
  // A thin one may touch what lies before its middle.
  EXPECT_NEAR(results[1][0], 0.2, 1e-6);
  EXPECT_NEAR(results[2][0], 1, 1e-6);
  EXPECT_NEAR(results[3][0], 1, 1e-6);
}

/// Pixels over the borders of the shadow that a level plate, `above` metres over a sheet, throws on it aside, as far as
/// the plate does not hide them: between a quarter and three quarters of what it takes of the light, along a row.
int border_below_plate(double above) {
  Snapshot snapshot;
  snapshot.surfaces = {test::patched_sheet(12, 0.01, 0)};
  SnapshotTool plate;
  plate.kind = SnapshotToolKind::kPlate;
  plate.length = 0.04;
  plate.width = 0.03;
  plate.thickness = 0.001;
  plate.tip = {0, 0, above};
  snapshot.tools.push_back(plate);
  ViewDefinition view;
  view.camera = {.position = Double3{0, -0.001, 0.25}, .target = Double3{0, 0, 0}, .field_of_view = 0.5};
  view.lights.key_direction = Double3{-1, 0, 1};
  view.look.bodies["organ"] = {.roughness = 1, .wetness = 0, .mottling = 0, .relief = 0};
  const ImageSize size{640, 360};
  const Image lit = Renderer(DeviceChoice{}, size, Tier::kDraft).draw(snapshot, view);
  const Image shadowed = Renderer(DeviceChoice{}, size, Tier::kRecord).draw(snapshot, view);
  const int row = size.height / 2 - 40;  // where the shaft throws no shadow
  std::vector<double> left;
  for (int x = size.width / 2; x < size.width / 2 + 150; ++x) {  // to the border of the sheet
    const std::size_t pixel = 3 * static_cast<std::size_t>(size.width * row + x);
    left.push_back(shadowed.pixels[pixel] / std::max(1.0, static_cast<double>(lit.pixels[pixel])));
  }
  const double least = *std::ranges::min_element(left);
  return static_cast<int>(std::ranges::count_if(
      left, [&](double part) { return part > least + 0.25 * (1 - least) && part < least + 0.75 * (1 - least); }));
}

TEST(Shadow, OfAToolIsSharpBelowItAndSoftFarFromIt) {
  const int near = border_below_plate(0.002), middle = border_below_plate(0.02), far = border_below_plate(0.04);
  // 6, 10 and 30 were seen, the last of two borders, of which the plate hides one when it is near; a texel of the map
  // is 4 pixels wide.
  EXPECT_LT(near, 8);
  EXPECT_GT(middle, 1.3 * near);
  EXPECT_GT(far, 2 * middle);
}

TEST(Shadow, WhatIsTurnedFromTheLightMirrorsNoneOfIt) {
  const OffscreenContext context{DeviceChoice{}};
  const CurrentContext current{context};
  const auto results = test::run_shader({"shadow.glsl"}, R"(
    float angle = radians(10.0 * float(index));
    result = vec4(key_mirrored(0.8, vec3(0.0, 0.0, 1.0), vec3(sin(angle), 0.0, cos(angle))));)",
                                        19);
  for (int index = 0; index < 19; ++index) {
    const float mirrored = results[static_cast<std::size_t>(index)][0];
    // Between 80 and 100 degrees it fades.
    if (index != 9) {
      EXPECT_NEAR(mirrored, index < 9 ? 0.8 : 0.0, 1e-6) << 10 * index << " degrees";
    }
  }
}

}  // namespace
}  // namespace thinwall
