#include "renderer/shape/Outline.hpp"

#include <gtest/gtest.h>

#include "tests/renderer/shape/TestMeshes.hpp"

namespace thinwall {
namespace {

std::vector<std::uint32_t> corners_of(const SnapshotSurface& surface) {
  std::vector<std::uint32_t> corners;
  for (const Triangle& triangle : surface.topology->triangles) {
    corners.insert(corners.end(), triangle.begin(), triangle.end());
  }
  return corners;
}

std::vector<OutlineSegment> outline_of(const SnapshotSurface& surface, Vector3 eye) {
  std::vector<OutlineSegment> outline;
  append_outline(
      mesh_edges(corners_of(surface)), [&](std::uint32_t i) { return vector3(surface.positions[i]); }, eye, outline);
  return outline;
}

TEST(MeshEdges, AClosedSurfaceHasThreeEdgesForTwoTrianglesAndNoBorder) {
  const SnapshotSurface sphere = test::sphere("organ", {}, 1, 3);
  const std::vector<MeshEdge> edges = mesh_edges(corners_of(sphere));
  EXPECT_EQ(2 * edges.size(), 3 * sphere.topology->triangles.size());
  for (const MeshEdge& edge : edges) EXPECT_NE(edge.right, MeshEdge::kNone);
}

TEST(Outline, OfAnOctahedronFromAboveItsTipIsItsBelt) {
  const std::vector<OutlineSegment> outline = outline_of(test::sphere("organ", {}, 1, 0), {0.1, 0.05, 9});
  EXPECT_EQ(outline.size(), 4u);
  for (const OutlineSegment& segment : outline) {
    EXPECT_EQ(segment.start[2], 0);
    EXPECT_EQ(segment.end[2], 0);
  }
}

TEST(Outline, OfASquareIsItsBorderAndNotItsDiagonal) {
  const SnapshotSurface square = test::quad("organ", {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}});
  const std::vector<OutlineSegment> outline = outline_of(square, {0.3, 0.2, 5});
  EXPECT_EQ(outline.size(), 4u);
  for (const OutlineSegment& segment : outline) {
    EXPECT_TRUE(segment.start[0] == segment.end[0] || segment.start[1] == segment.end[1]);
  }
}

}  // namespace
}  // namespace thinwall
