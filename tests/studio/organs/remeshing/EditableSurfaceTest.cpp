#include "studio/organs/remeshing/EditableSurface.hpp"

#include <gtest/gtest.h>

#include <array>

#include "engine/mesh/MeshMeasures.hpp"
#include "engine/mesh/MeshTopology.hpp"

namespace thinwall {
namespace {

/// Corners at 1 along each axis and its reverse; 0 and 1 on x, 2 and 3 on y, 4 and 5 on z.
EditableSurface octahedron() {
  TriangleSurface surface;
  surface.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  surface.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return EditableSurface(surface);
}

void expect_closed(const EditableSurface& surface, int triangles) {
  const TriangleSurface all = surface.compact();
  const MeshTopology topology = topology_of(static_cast<int>(all.vertices.size()), all.triangles);
  EXPECT_TRUE(is_closed(topology));
  EXPECT_EQ(topology.euler_characteristic, 2);
  EXPECT_EQ(static_cast<int>(all.triangles.size()), triangles);
  EXPECT_EQ(surface.triangle_count(), triangles);
  EXPECT_GT(enclosed_volume(all.vertices, all.triangles), 0);
}

TEST(EditableSurface, SplitAddsTwoTrianglesAndKeepsTheVolume) {
  EditableSurface surface = octahedron();
  const int middle = surface.split(0, 2, {0.5, 0.5, 0});
  expect_closed(surface, 10);
  EXPECT_EQ(surface.valence(middle), 4);
  EXPECT_EQ(surface.valence(4), 5);
  const TriangleSurface all = surface.compact();
  EXPECT_NEAR(enclosed_volume(all.vertices, all.triangles), 4.0 / 3, 1e-15);
}

TEST(EditableSurface, CollapseUndoesASplit) {
  EditableSurface surface = octahedron();
  const int middle = surface.split(0, 2, {0.5, 0.5, 0});
  ASSERT_TRUE(surface.may_collapse(0, middle));
  surface.collapse(0, middle, {1, 0, 0});
  expect_closed(surface, 8);
  EXPECT_TRUE(surface.triangles_at(middle).empty());
  EXPECT_TRUE(surface.has_edge(0, 2));
}

TEST(EditableSurface, TurnedEdgeJoinsTheFarCorners) {
  EditableSurface surface = octahedron();
  surface.split(0, 2, {0.5, 0.5, 0});
  EXPECT_EQ(surface.far_corners(0, 4), (std::array<int, 2>{3, 6}));
  ASSERT_TRUE(surface.may_turn(0, 4));
  surface.turn(0, 4);
  EXPECT_TRUE(surface.has_edge(3, 6));
  EXPECT_FALSE(surface.has_edge(0, 4));
  expect_closed(surface, 10);
}

TEST(EditableSurface, CollapseThatWouldPinchIsNotAllowed) {
  TriangleSurface tetrahedron;
  tetrahedron.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  tetrahedron.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  const EditableSurface surface(tetrahedron);
  for (const auto& [a, b] : surface.edges()) {
    EXPECT_FALSE(surface.may_collapse(a, b));
    EXPECT_FALSE(surface.may_turn(a, b));
  }
}

TEST(EditableSurface, WaistOfThreeEdgesIsNotCollapsed) {
  // Three rings of three vertices above one another, closed at top and bottom: the middle ring is no triangle.
  TriangleSurface prism;
  for (int ring = 0; ring < 3; ++ring) {
    prism.vertices.insert(prism.vertices.end(), {{0, 0, 1.0 * ring}, {1, 0, 1.0 * ring}, {0, 1, 1.0 * ring}});
  }
  prism.triangles = {{0, 2, 1}, {6, 7, 8}};
  for (int ring = 0; ring < 2; ++ring) {
    for (int k = 0; k < 3; ++k) {
      const int here = 3 * ring + k;
      const int next = 3 * ring + (k + 1) % 3;
      prism.triangles.insert(prism.triangles.end(), {{here, next, next + 3}, {here, next + 3, here + 3}});
    }
  }
  const EditableSurface surface(prism);
  expect_closed(surface, 14);
  EXPECT_FALSE(surface.may_collapse(3, 4));
  EXPECT_TRUE(surface.may_collapse(0, 3));
}

/// A square of four triangles around vertex 4.
EditableSurface open_square() {
  return EditableSurface(
      {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}}, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}});
}

bool is_manifold(const EditableSurface& surface) {
  const TriangleSurface all = surface.compact();
  return is_oriented_manifold(topology_of(static_cast<int>(all.vertices.size()), all.triangles));
}

TEST(EditableSurface, KnowsItsBorders) {
  const EditableSurface square = open_square();
  EXPECT_EQ(square.edges().size(), 8u);
  EXPECT_TRUE(square.is_border(0, 1));
  EXPECT_TRUE(square.is_border(1, 0));
  EXPECT_FALSE(square.is_border(0, 4));
  EXPECT_TRUE(square.is_at_border(0));
  EXPECT_FALSE(square.is_at_border(4));
  EXPECT_EQ(square.far_corners(1, 0), (std::array<int, 2>{-1, 4}));
}

TEST(EditableSurface, BordersAreSplitAndCollapsedButNotTurned) {
  EditableSurface square = open_square();
  EXPECT_FALSE(square.may_turn(0, 1));
  const int middle = square.split(0, 1, {0.5, 0, 0});
  EXPECT_EQ(square.triangle_count(), 5);
  EXPECT_TRUE(square.is_border(0, middle));
  EXPECT_TRUE(is_manifold(square));
  ASSERT_TRUE(square.may_collapse(0, middle));
  square.collapse(0, middle, {0, 0, 0});
  EXPECT_EQ(square.triangle_count(), 4);
  EXPECT_TRUE(is_manifold(square));
}

TEST(EditableSurface, EdgeAcrossFromBorderToBorderMayNotCollapse) {
  // Two triangles side by side: merging the ends of their common edge would leave nothing but a pinched band.
  EditableSurface band({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}},
                        {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}}});
  EXPECT_FALSE(band.may_collapse(1, 2));
}

}  // namespace
}  // namespace thinwall
