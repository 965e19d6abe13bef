#include "renderer/picture/CutLips.hpp"

#include <gtest/gtest.h>

#include "tests/renderer/picture/TestMeshes.hpp"

namespace thinwall {
namespace {

/// A strip of three squares of 2 mm along x, cut between the first and the second: vertices 2 and 3 have the twins
/// 8, 9.
SnapshotTopology cut_strip() {
  SnapshotTopology topology;
  for (const float x : {0.0f, 0.002f, 0.004f, 0.006f}) {
    topology.rest_positions.push_back({x, 0, 0});
    topology.rest_positions.push_back({x, 0.002f, 0});
  }
  topology.rest_positions.push_back({0.002f, 0, 0});
  topology.rest_positions.push_back({0.002f, 0.002f, 0});
  topology.triangles = {{0, 2, 3}, {0, 3, 1}, {8, 4, 5}, {8, 5, 9}, {4, 6, 7}, {4, 7, 5}};
  return topology;
}

TEST(CutLips, AreWhereBordersHaveTwins) {
  const SnapshotTopology topology = cut_strip();
  const std::vector<float> nearness = nearness_to_cuts(topology, border_edges(topology));
  for (const std::size_t lip : {2U, 3U, 8U, 9U}) EXPECT_EQ(nearness[lip], 1) << lip;
  // 2 mm from the cut, half of the reach; then the whole.
  for (const std::size_t beside : {0U, 1U, 4U, 5U}) EXPECT_NEAR(nearness[beside], 0.5, 1e-6) << beside;
  for (const std::size_t far : {6U, 7U}) EXPECT_NEAR(nearness[far], 0, 1e-6) << far;
}

TEST(CutLips, AreNotWhereASheetEnds) {
  const SnapshotSurface sheet = test::quad("sheet", {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}});
  for (const float nearness : nearness_to_cuts(*sheet.topology, border_edges(*sheet.topology)))
    EXPECT_EQ(nearness, kUncut);
}

TEST(CutLips, KeepTheirDistanceOnCoarseTriangles) {
  SnapshotTopology topology = cut_strip();
  for (Float3& position : topology.rest_positions) position = {10 * position[0], 10 * position[1], 0};
  const std::vector<float> nearness = nearness_to_cuts(topology, border_edges(topology));
  // 20 mm are five times the reach.
  EXPECT_NEAR(nearness[4], -4, 1e-5);
}

TEST(CutLips, IncludeTheTipBetweenTheLips) {
  // A fan around the tip 0, open between 1 and its twin 5.
  SnapshotTopology topology;
  topology.rest_positions = {{0, 0, 0},       {0.002f, 0, 0},  {0, 0.002f, 0},
                             {-0.002f, 0, 0}, {0, -0.002f, 0}, {0.002f, 0, 0}};
  topology.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}};
  const std::vector<float> nearness = nearness_to_cuts(topology, border_edges(topology));
  EXPECT_EQ(nearness[0], 1);
}

}  // namespace
}  // namespace thinwall
