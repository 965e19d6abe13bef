#include "renderer/snapshot/BorderEdges.hpp"

#include <gtest/gtest.h>

#include "renderer/snapshot/CutTimes.hpp"
#include "tests/renderer/shape/CutSheets.hpp"

namespace thinwall {
namespace {

std::vector<char> lips_of(const SnapshotTopology& topology) {
  return cut_lips(topology, border_edges(topology));
}

TEST(CutLips, AreWhereBordersHaveTwins) {
  EXPECT_EQ(lips_of(test::cut_strip()), (std::vector<char>{0, 0, 1, 1, 0, 0, 0, 0, 1, 1}));
}

TEST(CutLips, AreNotWhereASheetEnds) {
  const SnapshotSurface sheet = test::quad("sheet", {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}});
  EXPECT_EQ(lips_of(*sheet.topology), std::vector<char>(4, 0));
}

TEST(CutLips, IncludeTheTipBetweenTheLips) {
  // A fan around the tip 0, open between 1 and its twin 5.
  SnapshotTopology topology;
  topology.rest_positions = {{0, 0, 0},       {0.002f, 0, 0},  {0, 0.002f, 0},
                             {-0.002f, 0, 0}, {0, -0.002f, 0}, {0.002f, 0, 0}};
  topology.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}};
  EXPECT_EQ(lips_of(topology)[0], 1);
}

TEST(CutLips, IncludeWhatOnlyOneSideOfACutHas) {
  // Its left side's edge from 2 to 3 is divided at a quarter and at a half.
  SnapshotTopology topology = test::cut_strip();
  topology.rest_positions.insert(topology.rest_positions.end(), {{0.002f, 0.0005f, 0}, {0.002f, 0.001f, 0}});
  topology.triangles[0] = {0, 2, 10};
  topology.triangles.insert(topology.triangles.end(), {{0, 10, 11}, {0, 11, 3}});
  EXPECT_EQ(lips_of(topology), (std::vector<char>{0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 1, 1}));
}

TEST(CutTimes, TellWhenAVertexCameToLieAtACut) {
  const SnapshotTopology cut = test::cut_strip();
  SnapshotTopology before = cut;
  EXPECT_EQ(cut_times(cut, before, 1.5),
            (std::vector<float>{kNeverCut, kNeverCut, 1.5, 1.5, kNeverCut, kNeverCut, kNeverCut, kNeverCut, 1.5, 1.5}));
  before.cut_times = {kNeverCut, kNeverCut, 0.5, kNeverCut};
  EXPECT_EQ(cut_times(cut, before, 1.5)[2], 0.5) << "it keeps the time of its first cut";
  EXPECT_EQ(cut_times(cut, before, 1.5)[3], 1.5);
}

}  // namespace
}  // namespace thinwall
