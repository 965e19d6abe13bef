#include <gtest/gtest.h>

#include <cmath>

#include "renderer/camera/Lens.hpp"
#include "tests/renderer/picture/ShaderMath.hpp"

namespace thinwall {
namespace {

class LensShader : public testing::Test {
 protected:
  OffscreenContext context_{DeviceChoice{}};
  CurrentContext current_{context_};
};

constexpr LensDistortion kLens{.k1 = -0.28, .k2 = 0.09, .p1 = -0.0015, .p2 = 0.0011, .k3 = -0.01};
const std::string kText =
    "Lens lens = Lens(vec4(-0.28, 0.09, -0.0015, 0.0011), -0.01, 1e9);\n"
    "vec2 point = vec2(float(index % 20) * 0.09 - 0.86, float(index / 20) * 0.05 - 0.48);\n";

Tangents point_of(int index) {
  return {(index % 20) * 0.09 - 0.86, (index / 20) * 0.05 - 0.48};
}

TEST_F(LensShader, PutsPointsWhereTheProcessorPutsThem) {
  const auto results =
      test::run_shader({"lens.glsl"}, kText + "result = vec4(lens_distorted(lens, point), 0, 0);", 400);
  const Lens lens(kLens);
  for (int i = 0; i < 400; ++i) {
    const Tangents expected = lens.distorted(point_of(i));
    EXPECT_NEAR(results[i][0], expected[0], 1e-6);  // a dozen roundings of floats about one
    EXPECT_NEAR(results[i][1], expected[1], 1e-6);
  }
}

TEST_F(LensShader, GoesBackAsTheProcessorDoes) {
  const auto results =
      test::run_shader({"lens.glsl"}, kText + "result = vec4(lens_undistorted(lens, point), 0, 0);", 400);
  const Lens lens(kLens);
  for (int i = 0; i < 400; ++i) {
    const auto expected = lens.undistorted(point_of(i));
    if (!expected) continue;
    // A thousandth of a pixel is 2e-6 in a picture of 1280 pixels; near the corners the map is half as steep.
    EXPECT_NEAR(results[i][0], (*expected)[0], 4e-6) << i;
    EXPECT_NEAR(results[i][1], (*expected)[1], 4e-6) << i;
  }
}

TEST_F(LensShader, GoesBackFromFarOutWhereHighPowersBendMost) {
  const auto results = test::run_shader({"lens.glsl"},
                                        "Lens lens = Lens(vec4(3.0, 5.0, 0.0, 0.0), 8.0, 1e9);\n"
                                        "vec2 point = vec2(0.05, 0.02) * float(index);\n"
                                        "result = vec4(lens_undistorted(lens, point), 0, 0);",
                                        60);
  const Lens lens({.k1 = 3, .k2 = 5, .k3 = 8});
  for (int i = 0; i < 60; ++i) {
    const auto expected = lens.undistorted({0.05 * i, 0.02 * i});
    ASSERT_TRUE(expected);
    EXPECT_NEAR(results[i][0], (*expected)[0], 4e-6) << i;
    EXPECT_NEAR(results[i][1], (*expected)[1], 4e-6) << i;
  }
}

}  // namespace
}  // namespace thinwall
