#include "renderer/snapshot/HalfEdges.hpp"

#include <gtest/gtest.h>

namespace thinwall {
namespace {

TEST(HalfEdges, TellTheTriangleOfAnEdgeInItsSense) {
  const std::vector<Triangle> wall = {{0, 1, 2}, {2, 1, 3}}, caps = {{7, 3, 1}};
  const HalfEdges edges({wall, caps});
  EXPECT_EQ(edges.triangle_of(1, 2), 0U);
  EXPECT_EQ(edges.triangle_of(2, 1), 1U);
  EXPECT_EQ(edges.triangle_of(3, 2), 1U);
  EXPECT_EQ(edges.triangle_of(3, 1), 2U) << "lists are counted one after the other";
  EXPECT_EQ(edges.triangle_of(1, 7), 2U);
  EXPECT_EQ(edges.triangle_of(2, 3), HalfEdges::kNone) << "the other way";
  EXPECT_EQ(edges.triangle_of(0, 3), HalfEdges::kNone);
  EXPECT_EQ(edges.triangle_of(5, 0), HalfEdges::kNone) << "a vertex without triangles";
  EXPECT_EQ(edges.triangle_of(8, 0), HalfEdges::kNone) << "no such vertex";
}

TEST(HalfEdges, OfTwoTrianglesWithAnEdgeTellTheFirst) {
  const std::vector<Triangle> triangles = {{4, 5, 6}, {0, 1, 2}, {3, 0, 1}};
  EXPECT_EQ(HalfEdges({triangles}).triangle_of(0, 1), 1U);
}

TEST(HalfEdges, ThereAreNoneWithoutTriangles) {
  EXPECT_EQ(HalfEdges({std::span<const Triangle>()}).triangle_of(0, 1), HalfEdges::kNone);
}

}  // namespace
}  // namespace thinwall
