#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/renderer/picture/ShaderMath.hpp"

namespace thinwall {
namespace {

class Shading : public testing::Test {
 protected:
  OffscreenContext context_{DeviceChoice{}};
  CurrentContext current_{context_};
};

TEST_F(Shading, AScatteringBallSendsBackAsMuchLightAsAMatteOne) {
  // The mean over all directions; a matte surface's is a quarter.
  const auto results = test::run_shader({"scattering.glsl"}, R"(
    vec3 width = vec3(0.03, 0.08, 0.175) * float(1 + index);
    vec3 sum = vec3(0.0);
    for (int k = 0; k < 4000; ++k) sum += scattered_cosine((float(k) + 0.5) / 2000.0 - 1.0, width);
    result = vec4(sum / 4000.0, 1.0);)",
                                        4);
  for (const auto& result : results) {
    // The fit of the mean is within 0.0016.
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(result[k], 0.25, 4.5e-4);
  }
}

TEST_F(Shading, LightThatDoesNotTravelFallsAsOnAMatteSurface) {
  const auto results = test::run_shader(
      {"scattering.glsl"}, "result = vec4(scattered_cosine(0.1 * float(index) - 1.0, vec3(1e-3)), 1.0);", 21);
  for (std::size_t k = 0; k < results.size(); ++k) {
    // At the border half of the width is left.
    EXPECT_NEAR(results[k][0], std::max(0.1 * static_cast<double>(k) - 1.0, 0.0), 6e-4);
  }
}

TEST_F(Shading, RedGoesDeepestIntoTheDark) {
  const auto result =
      test::run_shader({"scattering.glsl"}, "result = vec4(scattered_cosine(-0.2, vec3(0.3, 0.13, 0.09)), 1.0);", 1)[0];
  EXPECT_GT(result[0], 2 * result[1]);
  EXPECT_GT(result[1], result[2]);
}

/// The part of an even environment that microfacets of GGX with Smith's joint masking and Schlick's Fresnel term
/// reflect, by quadrature over the halfway vectors that are seen (Heitz 2018) in closed form for sampling the
/// distribution of normals.
double reflected_by_microfacets(double nv, double roughness, double reflectance) {
  const double alpha = roughness * roughness, squared = alpha * alpha;
  const double vx = std::sqrt(1 - nv * nv), vz = nv;
  const auto lambda = [&](double cosine) { return 0.5 * (std::sqrt(1 + squared * (1 / (cosine * cosine) - 1)) - 1); };
  double sum = 0;
  constexpr int kRings = 400, kSpokes = 200;
  for (int ring = 0; ring < kRings; ++ring) {
    const double u = (ring + 0.5) / kRings;
    const double hz = std::sqrt((1 - u) / (1 + (squared - 1) * u)), radius = std::sqrt(1 - hz * hz);
    for (int spoke = 0; spoke < kSpokes; ++spoke) {
      const double hx = radius * std::cos(2 * std::numbers::pi * (spoke + 0.5) / kSpokes);
      const double vh = vx * hx + vz * hz;
      const double nl = 2 * vh * hz - vz;
      if (vh <= 0 || nl <= 0) continue;
      const double fresnel = reflectance + (1 - reflectance) * std::pow(1 - vh, 5);
      sum += fresnel / (1 + lambda(nl) + lambda(nv)) * vh / (nv * hz);
    }
  }
  return sum / (kRings * kSpokes);
}

TEST_F(Shading, AnEvenEnvironmentIsReflectedAsByMicrofacets) {
  // (roughness, cosine)
  const auto results = test::run_shader({"reflection.glsl"}, R"(
    vec2 part = reflected_part(0.2 + 0.2 * float(index % 5), 0.2 + 0.2 * float(index / 5));
    result = vec4(part, 0.0, 1.0);)",
                                        25);
  for (int index = 0; index < 25; ++index) {
    const double roughness = 0.2 + 0.2 * (index / 5), nv = std::min(0.2 + 0.2 * (index % 5), 0.999);
    const auto& part = results[static_cast<std::size_t>(index)];
    const double expected = reflected_by_microfacets(nv, roughness, 0.035);
    // The fit was made for the whole: it gives up to 0.065 too little where the look is along the surface, else 0.015.
    EXPECT_NEAR(0.035 * part[0] + part[1], expected, nv < 0.3 ? 0.07 : 0.02)
        << "roughness " << roughness << ", cosine " << nv;
  }
}

TEST_F(Shading, WhatIsReflectedIsNeverMoreThanWhatCame) {
  // Gloss, flesh below it and the wet layer, white and in the same light from everywhere.
  const auto results = test::run_shader({"reflection.glsl"}, R"(
    float nv = 0.02 + 0.98 * float(index % 32) / 31.0;
    float roughness = float(index / 32) / 31.0;
    vec2 part = reflected_part(nv, roughness);
    float film = 0.022 + 0.978 * fresnel_weight(nv);
    result = vec4(0.035 * part.x + part.y, film, part.x + part.y, 1.0);)",
                                        1024);
  for (const auto& result : results) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_GE(result[k], 0);
      // The fit for a mirror of any roughness comes to 1.0006 at most.
      EXPECT_LE(result[k], 1.001);
    }
  }
}

TEST_F(Shading, TheGlintOfALampIsNoMoreThanItsLight) {
  // What a mirror of rough microfacets sends towards the viewer of lamps all over the hemisphere, one after the other.
  const auto results = test::run_shader({"reflection.glsl"}, R"(
    float alpha = 0.15 + 0.25 * float(index % 3);
    float nv = 0.3 + 0.35 * float(index / 3);
    vec3 view = vec3(sqrt(1.0 - nv * nv), 0.0, nv);
    float sum = 0.0;
    const int kSteps = 200;
    for (int i = 0; i < kSteps; ++i) {
      float z = (float(i) + 0.5) / float(kSteps);
      for (int j = 0; j < kSteps; ++j) {
        float turn = 2.0 * kPi * (float(j) + 0.5) / float(kSteps);
        vec3 toward = vec3(sqrt(1.0 - z * z) * vec2(cos(turn), sin(turn)), z);
        sum += glint(vec3(0, 0, 1), view, toward, alpha);
      }
    }
    result = vec4(2.0 * sum / float(kSteps * kSteps), alpha, nv, 1.0);)",
                                        9);
  for (const auto& result : results) {
    // Microfacets lose what bounces more than once. Both quadratures err by some 0.2 %.
    EXPECT_LT(result[0], 1.003) << "width " << result[1] << ", cosine " << result[2];
    const double nv = std::min(static_cast<double>(result[2]), 0.999);
    EXPECT_NEAR(result[0], reflected_by_microfacets(nv, std::sqrt(result[1]), 1), 0.005);
  }
}

TEST_F(Shading, TheWayThroughALayerOfWaterIsBentTowardsItsNormal) {
  const auto results = test::run_shader({"reflection.glsl"}, "result = vec4(slant(0.1 * float(index)));", 11);
  for (int index = 0; index <= 10; ++index) {
    const double outside = std::acos(0.1 * index), inside = std::asin(std::sin(outside) / 1.33);
    EXPECT_NEAR(results[static_cast<std::size_t>(index)][0], 1 / std::cos(inside), 1e-5);
  }
}

TEST_F(Shading, ABranchOfADeepVesselComesUpAwayFromIt) {
  // At places half the vessel's half width apart: beside a deep one, beside one at the surface.
  const auto results = test::run_shader(
      {"vessel.glsl"}, "float away = 0.5 * float(index); result = vec2(risen(away, 0.0), risen(away, 1.0)).xyxy;", 11);
  EXPECT_EQ(results[1][1], 0) << "it begins within the vessel, which covers it";
  EXPECT_EQ(results[3][1], 1) << "beside one at the surface it is seen from the border on";
  EXPECT_LT(results[4][0], 0.5) << "beside a deep one it is not, at twice as far from the middle";
  EXPECT_EQ(results[10][0], 1);
  for (std::size_t k = 1; k < results.size(); ++k) EXPECT_LT(results[k][0] - results[k - 1][0], 0.2);
}

TEST_F(Shading, AVesselLosesItsRoomAllAlongAForkAndNotBehindIt) {
  // By tenths of the way through a fork, and in the fields of half the room behind it.
  const auto results = test::run_shader(
      {"vessel.glsl"}, "result = vec4(index < 11 ? room_in_fork(2.0, 0.025 * float(index)) : room_in_fork(1.0, 0.0));",
      12);
  EXPECT_EQ(results[0][0], 2);
  for (std::size_t k = 1; k < results.size(); ++k) EXPECT_NEAR(results[k][0], std::max(2 - 0.1 * double(k), 1.0), 1e-5);
}

TEST_F(Shading, AColourChartIsShownAsTheFilmCurveSays) {
  const auto results = test::run_shader({"tone.glsl"}, R"(
    vec3 patch_color = vec3(index % 4, (index / 4) % 4, index / 16) * vec3(0.6) + 0.01;
    result = vec4(displayed(patch_color), 1.0);)",
                                        64);
  for (int index = 0; index < 64; ++index) {
    const double patch[3] = {0.6 * (index % 4) + 0.01, 0.6 * (index / 4 % 4) + 0.01, 0.6 * (index / 16) + 0.01};
    const double luminance = 0.2126 * patch[0] + 0.7152 * patch[1] + 0.0722 * patch[2];
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = std::max(0.72 * (0.95 * patch[k] + 0.05 * luminance) - 0.004, 0.0);
      EXPECT_NEAR(results[static_cast<std::size_t>(index)][k], x * (6.2 * x + 0.5) / (x * (6.2 * x + 1.7) + 0.06),
                  1e-5);
    }
  }
}

TEST_F(Shading, TheSlopeOfTheNoiseIsThatOfItsValue) {
  constexpr double kStep = 1e-2;
  // Each in a draw of its own: in one shader NVIDIA's driver 580.159 takes both sides of a difference for the same.
  const auto noise_beside = [](const std::string& offset) {
    return test::run_shader({"frame.glsl", "noise.glsl"},
                            "result = noise(vec3(0.37, -1.21, 2.53) * float(index) * 0.173 + " + offset + ");", 2000);
  };
  const auto there = noise_beside("vec3(0)");
  std::vector<double> error(there.size());  // of the slope, squared
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string axis = k == 0 ? "vec3(1e-2, 0, 0)" : k == 1 ? "vec3(0, 1e-2, 0)" : "vec3(0, 0, 1e-2)";
    const auto after = noise_beside(axis), before = noise_beside("-" + axis);
    for (std::size_t i = 0; i < there.size(); ++i) {
      const double slope = (static_cast<double>(after[i][3]) - static_cast<double>(before[i][3])) / (2 * kStep);
      error[i] += std::pow(slope - static_cast<double>(there[i][k]), 2);
    }
  }
  double largest = 0, mean = 0, value = 0;
  for (std::size_t i = 0; i < there.size(); ++i) {
    largest = std::max(largest, std::sqrt(error[i]));
    mean += std::hypot(there[i][0], there[i][1], there[i][2]) / 2000.0;
    value = std::max(value, static_cast<double>(std::abs(there[i][3])));
  }
  EXPECT_GT(mean, 0.5);
  // The differences err by h^2 / 6 of the third derivative, some hundred.
  EXPECT_LT(largest, 0.02 * mean);
  EXPECT_LT(value, 1.3);
  EXPECT_GT(value, 0.6);
}

TEST_F(Shading, TheNoiseHasNoSeams) {
  // Steps of 1e-4 along a long way change it by no more than its steepest slope allows.
  const auto results = test::run_shader({"frame.glsl", "noise.glsl"}, R"(
    float largest = 0.0;
    for (int k = 0; k < 500; ++k) {
      vec3 place = vec3(0.61, 0.29, -0.47) * (float(index) * 0.05 + float(k) * 1e-4) + 1.7;
      largest = max(largest, abs(noise(place + vec3(1e-3, 7e-4, -5e-4)).w - noise(place).w));
    }
    result = vec4(largest);)",
                                        400);
  for (const auto& result : results) EXPECT_LT(result[0], 1.5e-3 * 6);
}

}  // namespace
}  // namespace thinwall
