#include <gtest/gtest.h>

#include <cmath>

#include "tests/renderer/picture/ShaderMath.hpp"

namespace thinwall {
namespace {

constexpr int kSeenPlaces = 500;

/// Directions all around (Fibonacci's), and numbers that go with them.
const char* const kSample = R"(
    float height = 1.0 - 2.0 * (float(index) + 0.5) / 500.0, turn = 2.3999632 * float(index);
    vec3 normal = vec3(sqrt(1.0 - height * height) * vec2(cos(turn), sin(turn)), height);
    float depth = 0.003 * exp(0.012 * float(index));
    vec3 place = 0.5 + 0.5 * normal.zxy;
    vec3 state = fract(vec3(0.37, 0.11, 0.53) * float(index));
    vec4 grid = vec4(-0.05, 0.02, 0.3, 0.1 / 65535.0);
    Seen seen = seen_from(numbers_of(1.7 * normal, depth, place, state, LAYERED), grid, LAYERED);
)";

auto results_of(const std::string& told, bool is_layered) {
  const OffscreenContext context{DeviceChoice{}};
  const CurrentContext current{context};
  std::string code = std::string(kSample) + told;
  for (std::size_t at = code.find("LAYERED"); at != std::string::npos; at = code.find("LAYERED")) {
    code.replace(at, 7, is_layered ? "true" : "false");
  }
  return test::run_shader({"seen.glsl"}, code, kSeenPlaces);
}

TEST(Seen, DirectionsDepthsAndPlacesComeBack) {
  const auto results = results_of(
      "result = vec4(distance(seen.normal, normal), abs(seen.depth / depth - 1.0), "
      "distance(seen.rest, vec3(-0.05, 0.02, 0.3) + 0.1 * place), length(seen.normal));",
      false);
  for (const auto& [turned, farther, moved, size] : results) {
    EXPECT_LT(turned, 8e-5);
    EXPECT_LT(farther, 8e-6);
    EXPECT_LT(moved, 1.4e-6) << "metres";
    EXPECT_NEAR(size, 1, 1e-5);
  }
}

TEST(Seen, TheStateComesBackInStepsOf255) {
  const auto results = results_of(
      "result = vec4(seen.blanch - state.x, 0.5 * seen.thickness - state.z, 0.5 + 0.5 * seen.bend - state.y, "
      "seen.wound);",
      false);
  for (const auto& [blanch, thickness, bend, wound] : results) {
    EXPECT_LT(std::abs(blanch), 0.51 / 255);
    EXPECT_LT(std::abs(thickness), 0.51 / 255);
    EXPECT_LT(std::abs(bend), 0.51 / 255);
    EXPECT_EQ(wound, 0);
  }
}

TEST(Seen, OfLayeredPartsTheWoundComesBackFinely) {
  const auto results = results_of(
      "result = vec4(0.5 + 0.5 * seen.wound - state.x, 0.5 + 0.5 * seen.bend - state.y, seen.blanch, seen.thickness);",
      true);
  for (const auto& [wound, bend, blanch, thickness] : results) {
    EXPECT_LT(std::abs(wound), 1e-5);
    EXPECT_LT(std::abs(bend), 0.51 / 255);
    EXPECT_EQ(blanch, 0);
    EXPECT_EQ(thickness, 0);
  }
}

}  // namespace
}  // namespace thinwall
