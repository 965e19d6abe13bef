#include "engine/cutting/Gapes.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "engine/mesh/Shapes.hpp"
#include "tests/engine/cutting/CheckedCuts.hpp"

namespace thinwall {
namespace {

/// Vector area within a loop, the sense of the wall's triangles being that of its outer border.
double area_of(const std::vector<Eigen::Vector3d>& vertices, const std::vector<int>& loop) {
  Eigen::Vector3d area = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < loop.size(); ++k) {
    area += 0.5 * vertices[loop[k]].cross(vertices[loop[(k + 1) % loop.size()]]);
  }
  return area.z();
}

/// The vertices with those of a part of the wall moved.
std::vector<Eigen::Vector3d> with_part_moved(const CutSurface& surface, int component, const Eigen::Vector3d& by) {
  std::vector<Eigen::Vector3d> vertices = surface.mesh().vertices;
  std::vector<char> is_part(vertices.size(), 0);
  for (std::size_t t = 0; t < surface.mesh().triangles.size(); ++t) {
    if (surface.components()[t] != component) continue;
    for (const int vertex : surface.mesh().triangles[t]) is_part[vertex] = 1;
  }
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    if (is_part[v]) vertices[v] += by;
  }
  return vertices;
}

TEST(GapesOfASheet, AreNoneBeforeACut) {
  EXPECT_TRUE(gapes_of(sheet()).empty());
}

TEST(GapesOfASheet, AreTheLipsOfASlit) {
  for (int k = 0; k < 12; ++k) {  // whose rounding goes either way
    CutSurface surface = sheet();
    const Cut cut = cut_through(surface, {{-0.5, -0.2, 0}, {0.1, 0.05 * k, 0}, {0.4, 0.2, 0}});
    const auto gapes = gapes_of(surface);
    ASSERT_EQ(gapes.size(), 1U) << k;
    EXPECT_TRUE(std::ranges::is_permutation(gapes[0], cut.wound_loops[0]));
    EXPECT_NEAR(area_of(surface.mesh().vertices, gapes[0]), 0, 1e-15);
  }
}

TEST(GapesOfASheet, GoOverTheMouthOfANotch) {
  CutSurface surface = sheet();
  const Cut cut = cut_through(surface, {{0.05, -1, 0}, {0.1, 0.3, 0}});
  const auto gapes = gapes_of(surface);
  ASSERT_EQ(gapes.size(), 1U);
  const Lips& lips = cut.lips.front();
  EXPECT_EQ(gapes[0].size(), 2 * lips.left.size() - 1);
  // Drawn apart at the border, the lips stand around a triangle.
  std::vector<Eigen::Vector3d> vertices = surface.mesh().vertices;
  for (std::size_t k = 0; k < lips.left.size(); ++k) {
    const double part = (0.3 - vertices[lips.right[k]].y()) / 1.3;
    vertices[lips.right[k]].x() += 0.1 * part;
  }
  EXPECT_NEAR(area_of(vertices, gapes[0]), -0.5 * 0.1 * 1.3, 1e-12);
}

TEST(GapesOfASheet, LieBetweenThePartsThatACutCameRightThrough) {
  CutSurface surface = sheet();
  const Cut cut = cut_through(surface, {{0.05, -1, 0}, {-0.1, 0.2, 0}, {0.3, 1, 0}});
  const auto gapes = gapes_of(surface);
  ASSERT_EQ(gapes.size(), 1U);
  EXPECT_EQ(gapes[0].size(), 2 * cut.lips.front().left.size());
  const auto apart = with_part_moved(surface, cut.separated.front(), {0.1, 0, 0});
  EXPECT_NEAR(std::abs(area_of(apart, gapes[0])), 0.1 * 2, 1e-12);
}

TEST(GapesOfASheet, AreTheHoleThatAPieceLeaves) {
  CutSurface surface = sheet();
  const Cut cut =
      cut_through(surface, {{-0.4, -0.4, 0}, {0.4, -0.4, 0}, {0.4, 0.4, 0}, {-0.4, 0.4, 0}, {-0.4, -0.4, 0}});
  const auto gapes = gapes_of(surface);
  ASSERT_EQ(gapes.size(), 1U);
  EXPECT_NEAR(area_of(surface.mesh().vertices, gapes[0]), -0.64, 1e-12);
  // And stay so wherever the piece goes.
  const auto apart = with_part_moved(surface, cut.separated.front(), {5, 5, 5});
  EXPECT_NEAR(area_of(apart, gapes[0]), -0.64, 1e-12);
}

TEST(GapesOfASheet, TakeInWhatALaterCutAddsToALip) {
  CutSurface surface = sheet();
  cut_through(surface, {{-0.6, 0, 0}, {0.6, 0, 0}});
  const std::size_t before = gapes_of(surface)[0].size();
  const SurfacePoint lip = nearest_point(surface.mesh(), {0.03, 0, 0}, 1);
  const Cut cut = cut_well(surface, {.from = {}, .points = {lip, nearest_point(surface.mesh(), {0.02, 0.5, 0}, 1)}});
  const auto gapes = gapes_of(surface);
  ASSERT_EQ(gapes.size(), 1U);
  EXPECT_GE(gapes[0].size(), before + 2 * cut.lips.front().left.size() - 2);
  EXPECT_NEAR(area_of(surface.mesh().vertices, gapes[0]), 0, 1e-15);
}

TEST(GapesOfASheet, AreOneForEachWound) {
  CutSurface surface = sheet();
  cut_through(surface, {{-0.6, -0.5, 0}, {0.6, -0.5, 0}});
  cut_through(surface, {{-0.6, 0.5, 0}, {0.6, 0.5, 0}});
  cut_through(surface, {{-1, 0, 0}, {-0.5, 0, 0}});
  cut_through(surface, {{1, 0, 0}, {0.5, 0, 0}});
  EXPECT_EQ(gapes_of(surface).size(), 4U);
}

}  // namespace
}  // namespace thinwall
