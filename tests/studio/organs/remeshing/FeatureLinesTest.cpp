#include "studio/organs/remeshing/FeatureLines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/mesh/Shapes.hpp"

namespace thinwall {
namespace {

constexpr double kFiftyDegrees = 50 * std::numbers::pi / 180;

TriangleSurface box() {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
          {{0, 3, 2},
           {0, 2, 1},
           {4, 5, 6},
           {4, 6, 7},
           {0, 1, 5},
           {0, 5, 4},
           {1, 2, 6},
           {1, 6, 5},
           {2, 3, 7},
           {2, 7, 6},
           {3, 0, 4},
           {3, 4, 7}}};
}

TEST(FeatureLines, BoxHasTwelveCreasesAndEightCorners) {
  const FeatureLines lines(box(), kFiftyDegrees, 2);
  EXPECT_EQ(lines.edge_count(), 12u);
  for (int v = 0; v < 8; ++v) EXPECT_TRUE(lines.is_corner(v)) << v;
  EXPECT_TRUE(lines.has_edge(0, 1));
  EXPECT_FALSE(lines.has_edge(0, 2)) << "a diagonal of a side";
}

TEST(FeatureLines, CreasesShorterThanTheLeastLengthDoNotCount) {
  EXPECT_TRUE(FeatureLines(box(), kFiftyDegrees, 12.1).empty());
}

TEST(FeatureLines, RoundBodyHasNone) {
  const SurfaceMesh ball = make_sphere(1, 320);
  EXPECT_TRUE(FeatureLines({ball.vertices, ball.triangles}, kFiftyDegrees, 0).empty());
}

TEST(FeatureLines, BorderOfASheetIsALineWithFourCorners) {
  const SurfaceMesh sheet = make_sheet(1, 1, 200);
  const FeatureLines lines({sheet.vertices, sheet.triangles}, kFiftyDegrees, 100);
  EXPECT_FALSE(lines.empty());
  int corners = 0;
  for (int v = 0; v < static_cast<int>(sheet.vertices.size()); ++v) {
    corners += lines.is_corner(v) ? 1 : 0;
    if (lines.is_on_line(v)) {
      EXPECT_NEAR(std::max(std::abs(sheet.vertices[v][0]), std::abs(sheet.vertices[v][1])), 0.5, 1e-15);
    }
  }
  EXPECT_EQ(corners, 4);
}

TEST(FeatureLines, StepsOfTheSurfaceAreFollowed) {
  FeatureLines lines(box(), kFiftyDegrees, 2);
  lines.split(0, 1, 8);
  EXPECT_FALSE(lines.has_edge(0, 1));
  EXPECT_TRUE(lines.has_edge(0, 8));
  EXPECT_TRUE(lines.has_edge(8, 1));
  EXPECT_FALSE(lines.is_corner(8));
  lines.collapse(0, 8);
  EXPECT_TRUE(lines.has_edge(0, 1));
  EXPECT_FALSE(lines.is_on_line(8));
}

TEST(FeatureLines, ProjectionHeedsTheDirection) {
  const FeatureLines lines(box(), kFiftyDegrees, 2);
  // Near the upright edge in the corner, but along x.
  const Eigen::Vector3d along_x = lines.project({0.1, 0.02, 0.2}, {1, 0, 0});
  EXPECT_NEAR((along_x - Eigen::Vector3d(0.1, 0, 0)).norm(), 0, 1e-15);
  const Eigen::Vector3d upright = lines.project({0.1, 0.02, 0.2}, {0, 0, 1});
  EXPECT_NEAR((upright - Eigen::Vector3d(0, 0, 0.2)).norm(), 0, 1e-15);
}

}  // namespace
}  // namespace thinwall
