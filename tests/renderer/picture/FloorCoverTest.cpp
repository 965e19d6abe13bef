#include "renderer/picture/FloorCover.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "renderer/shape/SurfaceVertices.hpp"

namespace thinwall {
namespace {

constexpr double kFloorSize = 0.1, kHalfWidth = 0.2, kFloor = -0.05;

/// A square plate of 80 mm above the middle of the floor, counter-clockwise from above.
std::vector<SurfaceVertex> plate(float height) {
  std::vector<SurfaceVertex> vertices(4);
  vertices[0].position = {-0.04F, -0.04F, height};
  vertices[1].position = {0.04F, -0.04F, height};
  vertices[2].position = {0.04F, 0.04F, height};
  vertices[3].position = {-0.04F, 0.04F, height};
  return vertices;
}

const std::vector<std::uint32_t> kFromAbove = {0, 1, 2, 0, 2, 3};
const std::vector<std::uint32_t> kFromBelow = {2, 1, 0, 3, 2, 0};

std::array<double, 2> taken_at(std::span<const std::uint8_t> pixels, double x, double y) {
  const auto texel = [](double place) {
    return static_cast<std::size_t>(FloorCover::kResolution * (0.5 + 0.5 * place / kHalfWidth));
  };
  const std::size_t first = 2 * (FloorCover::kResolution * texel(y) + texel(x));
  return {pixels[first] / 255.0, pixels[first + 1] / 255.0};
}

FloorCover cover_of(float height, const std::vector<std::uint32_t>& corners, bool is_closed, Vector3 toward_light) {
  FloorCover cover;
  cover.begin({.center = {}, .size = kFloorSize, .height = kFloor, .half_width = kHalfWidth}, toward_light);
  cover.stand(std::span<const SurfaceVertex>(plate(height)));
  cover.lay(corners, is_closed);
  return cover;
}

TEST(FloorCover, TakesTheLightFromAllAroundBelowAndTheKeyLightAside) {
  FloorCover cover = cover_of(-0.03F, kFromAbove, false, {3, 0, 1});
  const auto pixels = cover.blurred();
  // 20 mm above the floor, so the shadow goes 60 mm aside, away from the light.
  EXPECT_NEAR(taken_at(pixels, 0, 0)[0], std::exp(-7 * 0.02 / kFloorSize), 0.01);
  EXPECT_NEAR(taken_at(pixels, -0.06, 0)[1], 1, 0.01);
  EXPECT_NEAR(taken_at(pixels, 0.03, 0)[1], 0, 0.01);
  EXPECT_NEAR(taken_at(pixels, -0.15, 0)[0], 0, 0.01);
  EXPECT_NEAR(taken_at(pixels, 0.0, 0.15)[1], 0, 0.01);
}

TEST(FloorCover, TheLowestCountsWhateverComesFirst) {
  FloorCover cover = cover_of(0.05F, kFromAbove, false, {0, 0, 1});
  for (const float height : {-0.045F, 0.0F}) {
    cover.stand(std::span<const SurfaceVertex>(plate(height)));
    cover.lay(kFromAbove, false);
  }
  EXPECT_NEAR(taken_at(cover.blurred(), 0, 0)[0], std::exp(-7 * 0.005 / kFloorSize), 0.01);
}

TEST(FloorCover, OfWhatIsClosedTheSidesThatFaceDownCount) {
  FloorCover up = cover_of(-0.03F, kFromAbove, true, {0, 0, 1}), down = cover_of(-0.03F, kFromBelow, true, {0, 0, 1});
  EXPECT_EQ(taken_at(up.blurred(), 0, 0)[0], 0);
  EXPECT_EQ(taken_at(up.blurred(), 0, 0)[1], 0);
  EXPECT_GT(taken_at(down.blurred(), 0, 0)[0], 0.2);
  EXPECT_NEAR(taken_at(down.blurred(), 0, 0)[1], 1, 0.01);
}

TEST(FloorCover, ALightAtTheHorizonThrowsNoShadow) {
  // 0.1 mm above the floor: its shadow would lie 10 mm aside.
  FloorCover cover = cover_of(-0.0499F, kFromAbove, false, {1, 0, 0.01});
  const auto pixels = cover.blurred();
  for (std::size_t i = 1; i < pixels.size(); i += 2) ASSERT_EQ(pixels[i], 0);
}

TEST(FloorCover, BordersAreSoftAndWhatIsCoveredKeepsItsSum) {
  FloorCover cover = cover_of(-0.05F, kFromAbove, false, {0, 0, 1});
  const auto pixels = cover.blurred();
  double around = 0, key = 0;
  for (std::size_t i = 0; i < pixels.size(); i += 2) {
    around += pixels[i] / 255.0;
    key += pixels[i + 1] / 255.0;
  }
  // 80 mm of 400 mm: 19.2 texels on a side.
  EXPECT_NEAR(around, 19.2 * 19.2, 8);
  EXPECT_NEAR(key, 19.2 * 19.2, 8);
  EXPECT_NEAR(taken_at(pixels, 0.04, 0)[0], 0.5, 0.15);
  EXPECT_NEAR(taken_at(pixels, 0.04, 0)[1], 0.5, 0.2);
  EXPECT_GT(taken_at(pixels, 0.055, 0)[0], taken_at(pixels, 0.055, 0)[1]) << "the light from all around is softer";
}

}  // namespace
}  // namespace thinwall
