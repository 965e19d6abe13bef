#include "studio/organs/remeshing/FeatureLines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

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

TEST(FeatureLines, LinesGoFromCornerToCornerAndAreSplitIntoNoOthers) {
  FeatureLines lines(box(), kFiftyDegrees, 2);
  std::set<int> all;
  for (int v = 0; v < 8; ++v) {
    for (const int beside : lines.neighbours(v)) {
      all.insert(lines.line_of(v, beside));
      EXPECT_EQ(lines.line_of(v, beside), lines.line_of(beside, v));
    }
  }
  EXPECT_EQ(all.size(), 12u);
  const int line = lines.line_of(0, 1);
  lines.split(0, 1, 8);
  EXPECT_EQ(lines.line_of(0, 8), line);
  EXPECT_EQ(lines.line_of(1, 8), line);
}

TEST(FeatureLines, ALineWithoutCornersCloses) {
  const SurfaceMesh disc = make_disc(1, 200);
  const FeatureLines lines({disc.vertices, disc.triangles}, kFiftyDegrees, 0);
  ASSERT_FALSE(lines.empty());
  for (int v = 0; v < static_cast<int>(disc.vertices.size()); ++v) {
    for (const int beside : lines.neighbours(v)) EXPECT_EQ(lines.line_of(v, beside), 0);
  }
}

TEST(FeatureLines, KeepsPeaksAndEdgesThatAreToldBesideItsOwn) {
  FeatureLines lines(box(), kFiftyDegrees, 12.1);
  lines.keep(6);
  EXPECT_TRUE(lines.is_corner(6));
  EXPECT_FALSE(lines.is_on_line(6));
  lines.keep(box(), 0, 2);
  EXPECT_TRUE(lines.has_edge(0, 2));
  EXPECT_TRUE(lines.is_corner(0));
  EXPECT_EQ(lines.edge_count(), 1u);
}

TEST(FeatureLines, ProjectionHeedsTheLineAndTheDirection) {
  const FeatureLines lines(box(), kFiftyDegrees, 2);
  // Nearer to the edge above, which runs the same way.
  const Eigen::Vector3d below = lines.project({0.4, 0.02, 0.9}, {1, 0, 0}, lines.line_of(0, 1));
  EXPECT_NEAR((below - Eigen::Vector3d(0.4, 0, 0)).norm(), 0, 1e-15);
  // A border that turns by 40 degrees, which makes no corner.
  const TriangleSurface bent{{{0, 0, 0}, {1, 0, 0}, {1.766, 0.643, 0}, {0, 1, 0}}, {{0, 1, 3}, {1, 2, 3}}};
  const FeatureLines border(bent, kFiftyDegrees, 0);
  ASSERT_FALSE(border.is_corner(1));
  const Eigen::Vector3d point(1.2, 0.05, 0);
  const Eigen::Vector3d backwards = border.project(point, {-0.5, 1, 0}, border.line_of(0, 1));
  EXPECT_GT((backwards - border.project(point, {1, 0, 0}, border.line_of(0, 1))).norm(), 0.01);
}

}  // namespace
}  // namespace thinwall
