#include "renderer/picture/ToolCover.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace thinwall {
namespace {

constexpr int kSide = ToolCover::kResolution;

/// The map is the unit square, seen from above: depth grows downwards from a height of 1.
constexpr std::array<float, 16> kFromAbove{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 1, 1};

struct Box {
  std::vector<ToolVertex> vertices;
  std::vector<std::uint32_t> corners;
};

/// Texels of the map, and heights.
Box box(double left, double right, double below, double above, float low, float high) {
  Box result;
  for (int i = 0; i < 8; ++i) {
    ToolVertex vertex;
    vertex.position = {static_cast<float>((i & 1 ? right : left) / kSide),
                       static_cast<float>((i & 2 ? above : below) / kSide), i & 4 ? high : low};
    result.vertices.push_back(vertex);
  }
  // Counter-clockwise from outside, two triangles each.
  for (const auto& [a, b, c, d] : {std::array<std::uint32_t, 4>{4, 5, 7, 6},
                                   {0, 2, 3, 1},
                                   {0, 1, 5, 4},
                                   {2, 6, 7, 3},
                                   {0, 4, 6, 2},
                                   {1, 3, 7, 5}}) {
    result.corners.insert(result.corners.end(), {a, b, c, a, c, d});
  }
  return result;
}

ToolCover cover_of(const Box& tool) {
  ToolCover cover;
  cover.lay(tool.vertices, tool.corners, kFromAbove);
  return cover;
}

double taken_at(const ToolCover& cover, int x, int y, std::size_t blur) {
  return cover.taken()[4 * static_cast<std::size_t>(kSide * y + x) + blur] / 255.0;
}

double depth_at(const ToolCover& cover, int x, int y) {
  return cover.depths()[static_cast<std::size_t>(kSide * y + x)];
}

TEST(ToolCover, TakesAllBehindAWideToolAndNothingFarFromIt) {
  const ToolCover cover = cover_of(box(0, 64, 0, kSide, 0.4F, 0.6F));
  for (std::size_t blur = 0; blur < 4; ++blur) {
    EXPECT_EQ(taken_at(cover, 20, 64, blur), 1);
    EXPECT_EQ(taken_at(cover, 108, 64, blur), 0);
    EXPECT_NEAR(0.5 * (taken_at(cover, 63, 64, blur) + taken_at(cover, 64, 64, blur)), 0.5, 1.0 / 255);
  }
}

/// The slope of a border's profile is the blur itself.
TEST(ToolCover, ItsBlursAreAsWideAsTheyTell) {
  const ToolCover cover = cover_of(box(-10, 64, -10, kSide + 10, 0.4F, 0.6F));
  for (std::size_t blur = 0; blur < 4; ++blur) {
    double variance = 0;
    for (int x = 1; x < kSide; ++x) {
      variance += (taken_at(cover, x - 1, 64, blur) - taken_at(cover, x, 64, blur)) * (x - 64.0) * (x - 64.0);
    }
    // Of 255 steps the tails are lost: up to 1 % was seen.
    EXPECT_NEAR(std::sqrt(variance), ToolCover::kSpreads[blur], 0.02 * ToolCover::kSpreads[blur]) << blur;
  }
}

TEST(ToolCover, ANarrowToolTakesLessTheWiderTheBlur) {
  const ToolCover cover = cover_of(box(62, 66, -10, kSide + 10, 0.4F, 0.6F));
  double before = 1;
  for (std::size_t blur = 0; blur < 4; ++blur) {
    const double taken = taken_at(cover, 64, 64, blur);
    // A Gaussian's part within two texels of its middle, but for half a texel.
    EXPECT_NEAR(taken, std::erf(2 / (std::sqrt(2.0) * ToolCover::kSpreads[blur])), 0.05) << blur;
    EXPECT_LT(taken, before);
    before = taken;
  }
}

TEST(ToolCover, DepthIsThatOfTheMiddleAroundTheToolToo) {
  const ToolCover cover = cover_of(box(50, 70, 50, 70, 0.47F, 0.53F));
  EXPECT_NEAR(depth_at(cover, 60, 60), 0.5, 1e-6);
  EXPECT_NEAR(depth_at(cover, 45, 60), 0.5, 1e-6);
  EXPECT_NEAR(depth_at(cover, 78, 76), 0.5, 1e-6);
  EXPECT_EQ(depth_at(cover, 2, 2), 1);
}

TEST(ToolCover, OfARodAtASlantDepthFollowsItsAxis) {
  Box rod = box(20, 108, 60, 68, 0.47F, 0.53F);
  for (ToolVertex& vertex : rod.vertices) vertex.position[2] += 0.5F * (vertex.position[0] - 0.5F);
  const ToolCover cover = cover_of(rod);
  for (const int x : {30, 64, 98}) EXPECT_NEAR(depth_at(cover, x, 70), 0.5 - 0.5 * ((x + 0.5) / kSide - 0.5), 0.003);
}

TEST(ToolCover, OfAShaftAlongTheLightTheNearEndCounts) {
  const ToolCover cover = cover_of(box(60, 68, 60, 68, 0.2F, 0.9F));
  EXPECT_NEAR(depth_at(cover, 64, 64), 0.8 - 6.0 / kSide, 1e-5);
}

TEST(ToolCover, WhatIsLaidAnewIsAllThatCounts) {
  ToolCover cover = cover_of(box(20, 40, 20, 40, 0.4F, 0.6F));
  const Box other = box(80, 100, 80, 100, 0.12F, 0.18F);
  cover.lay(other.vertices, other.corners, kFromAbove);
  EXPECT_EQ(taken_at(cover, 30, 30, 0), 0);
  EXPECT_EQ(taken_at(cover, 90, 90, 0), 1);
  EXPECT_NEAR(depth_at(cover, 90, 90), 0.85, 1e-6);
}

TEST(ToolCover, WhatReachesOutOfTheMapCountsWithinIt) {
  const ToolCover cover = cover_of(box(-300, 10, -500, 900, -3, 5));
  EXPECT_EQ(taken_at(cover, 2, 64, 0), 1);
  EXPECT_EQ(taken_at(cover, 120, 64, 3), 0);
}

}  // namespace
}  // namespace thinwall
