#include "renderer/picture/WoundBed.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "tests/renderer/picture/CutSheets.hpp"

namespace thinwall {
namespace {

TissuePiece bed_of(const SnapshotSurface& sheet, double depth, double time = 1) {
  const std::vector<BorderEdge> borders = border_edges(*sheet.topology);
  const std::vector<char> is_lip = cut_lips(*sheet.topology, borders);
  return wound_bed(sheet, borders, is_lip, bed_depth(sheet, borders, is_lip, depth, time));
}

TEST(WoundBed, LiesBelowTheSheetAndAwayFromItsBorders) {
  const TissuePiece bed = bed_of(test::slit_sheet(40, 0.001, 0), 0.004);
  ASSERT_FALSE(bed.corners.empty());
  for (const std::uint32_t corner : bed.corners) {
    const Float3& place = bed.vertices[corner].position;
    EXPECT_NEAR(place[2], -0.004, 1e-8);
    EXPECT_LE(std::max(std::abs(place[0]), std::abs(place[1])), 0.0121f);
  }
}

TEST(WoundBed, MakesRoomForWhatHangsDown) {
  SnapshotSurface sheet = test::slit_sheet(40, 0.001, 0);
  sheet.positions[20 * 41 + 20][2] = -0.006f;
  // 6 mm, the wall's 2 and a gap of 1.
  for (const SurfaceVertex& vertex : bed_of(sheet, 0.004).vertices) EXPECT_NEAR(vertex.position[2], -0.009, 1e-7);
}

/// Of a sheet whose patch was cut free at one second, seconds later.
double depth_below(double hanging, double later) {
  SnapshotSurface sheet = test::patched_sheet(40, 0.001, 8);
  auto topology = std::make_shared<SnapshotTopology>(*sheet.topology);
  topology->cut_times.assign(topology->rest_positions.size(), kNeverCut);
  for (std::size_t v = sheet.positions.size() - 81; v < sheet.positions.size(); ++v) {
    sheet.positions[v][2] = static_cast<float>(-hanging);
    topology->cut_times[v] = 1;
  }
  sheet.topology = topology;
  return -static_cast<double>(bed_of(sheet, 0.004, 1 + later).vertices.front().position[2]);
}

TEST(WoundBed, LetsAPieceThatFallsComeToRestAsFarDownAsItLiesItself) {
  // The gap is 1 mm, and there is no thickness.
  EXPECT_NEAR(depth_below(0.006, 0), 0.007, 1e-8) << "as before it was free";
  EXPECT_NEAR(depth_below(0.2, 0.06), 0.007, 1e-8) << "half way from eight millimetres to four";
  EXPECT_NEAR(depth_below(0.2, 0.12), 0.005, 1e-8);
  EXPECT_NEAR(depth_below(0.2, 3), 0.005, 1e-8) << "it stays there, and does not rise to the skin again";
  EXPECT_NEAR(depth_below(0.0035, 3), 0.0045, 1e-8) << "what has fallen less far lies on the bed too";
}

TEST(WoundBed, BearsWhatWasCutFreeAndFallsAndLeavesTheRestWhereItIs) {
  SnapshotSurface sheet = test::patched_sheet(40, 0.001, 8);
  const std::size_t patch = sheet.positions.size() - 81;
  for (std::size_t v = patch; v < sheet.positions.size(); ++v) {
    sheet.positions[v][2] = v % 2 == 0 ? -0.0025F : -0.2F;
  }
  sheet.positions[20][2] = -0.01F;
  const std::vector<BorderEdge> borders = border_edges(*sheet.topology);
  const std::vector<Float3> laid = laid_on_bed(sheet, borders, cut_lips(*sheet.topology, borders), 0.004);
  ASSERT_EQ(laid.size(), sheet.positions.size());
  for (std::size_t v = 0; v < patch; ++v) EXPECT_EQ(laid[v], sheet.positions[v]);
  for (std::size_t v = patch; v < laid.size(); ++v) {
    // The gap is 1 mm, and there is no thickness.
    EXPECT_NEAR(laid[v][2], v % 2 == 0 ? -0.0025 : -0.003, 1e-7) << v;
  }
}

TEST(WoundBed, IsNoneBelowAClosedWall) {
  EXPECT_TRUE(bed_of(test::sphere("ball", {0, 0, 0}, 0.02, 2), 0.004).corners.empty());
}

}  // namespace
}  // namespace thinwall
