#include "renderer/picture/TissuePieces.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "renderer/picture/DrawnPieces.hpp"
#include "tests/renderer/picture/CutSheets.hpp"

namespace thinwall {
namespace {

bool is_closed(const SnapshotSurface& surface) {
  const DrawnTopology drawn = drawn_topology(surface.topology, DrawnEdges::kStraight);
  return encloses_its_inside(surface, drawn.borders, drawn_pieces(surface, drawn, surface));
}

/// The same with all triangles turned over.
SnapshotSurface turned_over(const SnapshotSurface& surface) {
  auto topology = std::make_shared<SnapshotTopology>(*surface.topology);
  for (Triangle& triangle : topology->triangles) std::swap(triangle[1], triangle[2]);
  SnapshotSurface result = surface;
  result.topology = topology;
  return result;
}

TEST(TissuePieces, ABallEnclosesItsInsideAndOneThatFacesInwardsDoesNot) {
  const SnapshotSurface ball = test::sphere("organ", {0.1, 0, 0}, 0.03, 2);
  EXPECT_TRUE(is_closed(ball));
  EXPECT_FALSE(is_closed(turned_over(ball)));
}

TEST(TissuePieces, ASheetIsClosedByTheThicknessThatIsDrawn) {
  const SnapshotSurface sheet = test::slit_sheet(6, 0.002, 0);
  EXPECT_TRUE(is_closed(sheet));
  SnapshotSurface thin = sheet;
  auto topology = std::make_shared<SnapshotTopology>(*sheet.topology);
  topology->thickness.clear();
  thin.topology = topology;
  EXPECT_FALSE(is_closed(thin)) << "nothing is behind its triangles";
}

TEST(TissuePieces, LayersAreBareAtCutsAndCoveredWhereASheetEnds) {
  const SnapshotSurface sheet = test::slit_sheet(6, 0.002, 0);
  const DrawnTopology drawn = drawn_topology(sheet.topology, DrawnEdges::kStraight);
  std::vector<TissuePiece> pieces = drawn_pieces(sheet, drawn, sheet);
  cover_open_borders(drawn.borders, drawn.is_lip, pieces);
  const auto rim = std::ranges::find(pieces, TissueSide::kRim, &TissuePiece::side);
  ASSERT_NE(rim, pieces.end());
  int bare = 0, covered = 0;
  for (std::size_t k = 0; k < drawn.borders.size(); ++k) {
    const bool is_cut = drawn.is_lip[drawn.borders[k].start] && drawn.is_lip[drawn.borders[k].end];
    (is_cut ? bare : covered) += 1;
    EXPECT_EQ(rim->vertices[4 * k + 1].wound > 0, is_cut) << "the inner start of border " << k;
  }
  EXPECT_GT(bare, 0);
  EXPECT_GT(covered, 0);
}

}  // namespace
}  // namespace thinwall
