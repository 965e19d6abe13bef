#include "renderer/shape/WoundBed.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "tests/renderer/shape/CutSheets.hpp"

namespace thinwall {
namespace {

TissuePiece bed_of(const SnapshotSurface& sheet, double depth, double time = 1) {
  const std::vector<BorderEdge> borders = border_edges(*sheet.topology);
  const std::vector<char> is_lip = cut_lips(*sheet.topology, borders);
  return wound_bed(sheet, borders, is_lip, bed_depth(sheet, borders, is_lip, depth, time));
}

TEST(WoundBed, LiesBelowTheSheetAndComesUpToItsBorders) {
  const TissuePiece bed = bed_of(test::slit_sheet(40, 0.001, 0), 0.004);
  ASSERT_EQ(bed.corners.size(), 3U * 2 * 40 * 40);
  for (const SurfaceVertex& vertex : bed.vertices) {
    const double inwards = 0.020 - std::max(std::abs(vertex.rest[0]), std::abs(vertex.rest[1]));
    // The wall is 2 mm thick; from below it the bed goes down two millimetres in one.
    EXPECT_NEAR(vertex.position[2], -std::min(0.004, 0.002 + 2 * inwards), 1e-8);
  }
}

TEST(WoundBed, IsNotSeenBesideBordersThatHaveMoved) {
  SnapshotSurface sheet = test::slit_sheet(40, 0.001, 0);
  for (Float3& place : sheet.positions) {
    if (place[0] > 0.0195F) place[0] = 0.015F;
  }
  const TissuePiece bed = bed_of(sheet, 0.004);
  float right = -1, left = 1;
  for (const std::uint32_t corner : bed.corners) {
    right = std::max(right, bed.vertices[corner].position[0]);
    left = std::min(left, bed.vertices[corner].position[0]);
  }
  EXPECT_LE(right, 0.012F);
  EXPECT_GT(right, 0.010F);
  EXPECT_NEAR(left, -0.020, 1e-7);
}

TEST(WoundBed, MakesRoomForWhatHangsDown) {
  SnapshotSurface sheet = test::slit_sheet(40, 0.001, 0);
  sheet.positions[20 * 41 + 20][2] = -0.006f;
  // 6 mm, the wall's 2 and a gap of 1.
  for (const SurfaceVertex& vertex : bed_of(sheet, 0.004).vertices) {
    const bool is_inside = std::max(std::abs(vertex.rest[0]), std::abs(vertex.rest[1])) < 0.016F;
    if (!is_inside) continue;
    EXPECT_NEAR(vertex.position[2], -0.009, 1e-7);
  }
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
  return -static_cast<double>(bed_of(sheet, 0.004, 1 + later).vertices.back().position[2]);
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
