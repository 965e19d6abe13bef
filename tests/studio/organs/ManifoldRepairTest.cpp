#include "studio/organs/ManifoldRepair.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <utility>

#include "engine/mesh/MeshMeasures.hpp"
#include "engine/mesh/MeshTopology.hpp"

namespace thinwall {
namespace {

using Block = std::array<int, 3>;

/// The faces between unit blocks and the space around them, with shared corners.
RawSurface surface_of_blocks(const std::vector<Block>& blocks) {
  static constexpr int kFaces[6][4][3] = {
      {{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}}, {{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, 1, 0}},
      {{0, 1, 0}, {0, 1, 1}, {1, 1, 1}, {1, 1, 0}}, {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}},
      {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}, {{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}};
  RawSurface surface;
  std::map<Block, int> index;
  for (const Block& block : blocks) {
    for (int face = 0; face < 6; ++face) {
      Block beside = block;
      beside[face / 2] += face % 2 == 0 ? 1 : -1;
      if (std::find(blocks.begin(), blocks.end(), beside) != blocks.end()) continue;
      std::array<int, 4> corners{};
      for (int k = 0; k < 4; ++k) {
        const Block at = {block[0] + kFaces[face][k][0], block[1] + kFaces[face][k][1], block[2] + kFaces[face][k][2]};
        const auto [entry, is_new] = index.try_emplace(at, static_cast<int>(surface.vertices.size()));
        if (is_new) surface.vertices.emplace_back(at[0], at[1], at[2]);
        corners[k] = entry->second;
      }
      surface.triangles.emplace_back(corners[0], corners[1], corners[2]);
      surface.triangles.emplace_back(corners[0], corners[2], corners[3]);
    }
  }
  surface.parts.assign(surface.triangles.size(), 0);
  return surface;
}

TEST(ManifoldRepair, BlocksThatTouchAlongAnEdgeArePartedAsSolids) {
  RawSurface surface = surface_of_blocks({{0, 0, 0}, {1, 1, 0}});
  ASSERT_EQ(topology_of_surface(surface).crowded_edges.size(), 1u);
  const SplitPlaces places = split_apart(surface);
  ASSERT_EQ(places.edges.size(), 1u);
  EXPECT_EQ(places.edges[0], Eigen::Vector3d(1, 1, 0.5));
  EXPECT_TRUE(places.vertices.empty());
  EXPECT_TRUE(is_closed(topology_of_surface(surface)));
  // Joined the other way, across the gaps, they would be one.
  EXPECT_EQ(topology_of_surface(surface).component_count, 2);
  EXPECT_EQ(surface.vertices.size(), 16u);
}

TEST(ManifoldRepair, BlocksThatTouchInACornerAreParted) {
  RawSurface surface = surface_of_blocks({{0, 0, 0}, {1, 1, 1}});
  const SplitPlaces places = split_apart(surface);
  EXPECT_TRUE(places.edges.empty());
  EXPECT_EQ(places.vertices, (std::vector<Eigen::Vector3d>{{1, 1, 1}}));
  EXPECT_TRUE(is_closed(topology_of_surface(surface)));
}

TEST(ManifoldRepair, PartsThatTouchNeedNotFaceTheSameWay) {
  RawSurface surface = surface_of_blocks({{0, 0, 0}, {1, 1, 0}});
  for (std::size_t t = 0; t < 12; ++t) std::swap(surface.triangles[t][0], surface.triangles[t][1]);
  EXPECT_EQ(split_apart(surface).turned, 12);
  EXPECT_TRUE(is_closed(topology_of_surface(surface)));
  EXPECT_NEAR(enclosed_volume(surface.vertices, surface.triangles), 2, 1e-15);
}

TEST(ManifoldRepair, WallThatBranchesStaysJoined) {
  RawSurface surface = surface_of_blocks({{0, 0, 0}, {1, 0, 0}});
  const auto vertex = [&](double x, double y, double z) {
    return static_cast<int>(std::find(surface.vertices.begin(), surface.vertices.end(), Eigen::Vector3d(x, y, z)) -
                            surface.vertices.begin());
  };
  surface.triangles.emplace_back(vertex(1, 0, 0), vertex(1, 1, 0), vertex(1, 1, 1));
  surface.triangles.emplace_back(vertex(1, 0, 0), vertex(1, 1, 1), vertex(1, 0, 1));
  surface.parts.resize(surface.triangles.size(), 0);
  EXPECT_TRUE(remove_flaps(surface).places.empty());
  EXPECT_TRUE(split_apart(surface).edges.empty());
  EXPECT_EQ(topology_of_surface(surface).crowded_edges.size(), 4u);
}

TEST(ManifoldRepair, SmallFlapIsRemovedAndALargeOneStays) {
  for (const double length : {0.1, 2.0}) {
    RawSurface surface = surface_of_blocks({{0, 0, 0}});
    const Eigen::Vector3i t = surface.triangles[0];
    surface.vertices.push_back(surface.vertices[t[0]] + Eigen::Vector3d(length, -length, -length));
    surface.triangles.emplace_back(t[0], t[1], static_cast<int>(surface.vertices.size()) - 1);
    surface.parts.push_back(0);
    const RemovedFlaps removed = remove_flaps(surface);
    EXPECT_EQ(removed.triangles, length < 1 ? 1 : 0);
    EXPECT_EQ(surface.triangles.size(), length < 1 ? 12u : 13u);
  }
}

TEST(ManifoldRepair, AnyHeapOfBlocksBecomesAClosedOrientedManifoldOfTheSameVolume) {
  std::mt19937 random(20260101);
  int touching = 0;
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<Block> blocks;
    for (int i = 0; i < 27; ++i) {
      if (random() % 100 < 45) blocks.push_back({i % 3, i / 3 % 3, i / 9});
    }
    if (blocks.empty()) continue;
    RawSurface surface = surface_of_blocks(blocks);
    touching += is_closed(topology_of_surface(surface)) ? 0 : 1;
    EXPECT_EQ(remove_flaps(surface).triangles, 0) << trial;
    split_apart(surface);
    remove_unused_vertices(surface);
    EXPECT_TRUE(is_closed(topology_of_surface(surface))) << trial;
    // A hollow is a surface of its own, which is turned outwards; only heaps without one keep the volume.
    if (topology_of_surface(surface).component_count == 1) {
      EXPECT_NEAR(enclosed_volume(surface.vertices, surface.triangles), static_cast<double>(blocks.size()), 1e-12);
    }
  }
  EXPECT_GT(touching, 200);
}

}  // namespace
}  // namespace thinwall
