#include "renderer/picture/WoundBed.hpp"

#include <gtest/gtest.h>

#include "tests/renderer/picture/CutSheets.hpp"

namespace thinwall {
namespace {

TissuePiece bed_of(const SnapshotSurface& sheet, double depth) {
  const std::vector<BorderEdge> borders = border_edges(*sheet.topology);
  return wound_bed(sheet, borders, cut_lips(*sheet.topology, borders), depth);
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

TEST(WoundBed, IsNoneBelowAClosedWall) {
  EXPECT_TRUE(bed_of(test::sphere("ball", {0, 0, 0}, 0.02, 2), 0.004).corners.empty());
}

}  // namespace
}  // namespace thinwall
