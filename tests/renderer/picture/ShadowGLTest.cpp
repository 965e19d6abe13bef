#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/renderer/picture/ShaderMath.hpp"

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
