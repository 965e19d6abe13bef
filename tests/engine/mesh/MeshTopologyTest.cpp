#include "engine/mesh/MeshTopology.hpp"

#include <gtest/gtest.h>

namespace thinwall {
namespace {

using Triangles = std::vector<Eigen::Vector3i>;

const Triangles kTetrahedron = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

TEST(MeshTopology, TetrahedronIsClosedWithEulerCharacteristicTwo) {
  const MeshTopology topology = topology_of(4, kTetrahedron);
  EXPECT_TRUE(is_closed(topology));
  EXPECT_EQ(topology.edges.size(), 6u);
  EXPECT_EQ(topology.euler_characteristic, 2);
  EXPECT_EQ(topology.component_count, 1);
  EXPECT_TRUE(topology.boundary_loops.empty());
}

TEST(MeshTopology, EdgesAreAscendingAndKnowTheirTriangles) {
  const MeshTopology topology = topology_of(4, kTetrahedron);
  const std::vector<std::array<int, 2>> expected = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
  EXPECT_EQ(topology.edges, expected);
  EXPECT_EQ(std::vector<int>(triangles_at(topology, 3).begin(), triangles_at(topology, 3).end()),
            (std::vector<int>{0, 2}));
  EXPECT_EQ(topology.triangle_edges[1], (std::array<int, 3>{0, 4, 2}));
}

TEST(MeshTopology, MissingTriangleLeavesOneLoopInTheSenseOfTheWall) {
  const MeshTopology topology = topology_of(4, Triangles(kTetrahedron.begin() + 1, kTetrahedron.end()));
  EXPECT_TRUE(is_oriented_manifold(topology));
  EXPECT_FALSE(is_closed(topology));
  EXPECT_EQ(topology.open_edges.size(), 3u);
  EXPECT_EQ(topology.boundary_loops, (std::vector<std::vector<int>>{{0, 1, 2}}));
  EXPECT_EQ(topology.euler_characteristic, 1);
}

TEST(MeshTopology, ThreeTrianglesAtAnEdgeAreCrowded) {
  const MeshTopology topology = topology_of(5, Triangles{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  ASSERT_EQ(topology.crowded_edges.size(), 1u);
  EXPECT_EQ(topology.edges[topology.crowded_edges[0]], (std::array<int, 2>{0, 1}));
  EXPECT_FALSE(is_oriented_manifold(topology));
}

TEST(MeshTopology, TrianglesTurnedAgainstEachOtherAreContrary) {
  const MeshTopology topology = topology_of(4, Triangles{{0, 1, 2}, {0, 1, 3}});
  ASSERT_EQ(topology.contrary_edges.size(), 1u);
  EXPECT_EQ(topology.edges[topology.contrary_edges[0]], (std::array<int, 2>{0, 1}));
}

TEST(MeshTopology, TwoFansThatMeetInOneVertexAreNotManifoldThere) {
  const MeshTopology topology = topology_of(5, Triangles{{0, 1, 2}, {0, 3, 4}});
  EXPECT_EQ(topology.non_manifold_vertices, (std::vector<int>{0}));
  EXPECT_EQ(topology.component_count, 2);
  EXPECT_TRUE(topology.crowded_edges.empty());
}

TEST(MeshTopology, UnusedVerticesDoNotCount) {
  EXPECT_EQ(topology_of(9, kTetrahedron).euler_characteristic, 2);
  EXPECT_TRUE(topology_of(9, kTetrahedron).non_manifold_vertices.empty());
}

TEST(MeshTopology, ComponentsAreNumberedByFirstTriangle) {
  Triangles two = {{4, 5, 6}};
  two.insert(two.end(), kTetrahedron.begin(), kTetrahedron.end());
  two.push_back({5, 4, 7});
  const MeshTopology topology = topology_of(8, two);
  EXPECT_EQ(topology.triangle_component, (std::vector<int>{0, 1, 1, 1, 1, 0}));
}

}  // namespace
}  // namespace thinwall
