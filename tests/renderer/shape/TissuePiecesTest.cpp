#include "renderer/shape/TissuePieces.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "renderer/shape/DrawnPieces.hpp"
#include "tests/renderer/shape/CutSheets.hpp"

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

/// Of a sheet of 10 x 10 squares of 2 mm with a slit along its middle, the vertex in this column and row.
constexpr std::uint32_t vertex_at(std::uint32_t column, std::uint32_t row) {
  return 11 * row + column;
}

/// As it is drawn and as its triangles alone tell it, with one vertex moved up by `rise` metres.
std::pair<SurfaceVertex, SurfaceVertex> raised(std::uint32_t vertex, float rise, std::uint32_t shown) {
  SnapshotSurface sheet = test::slit_sheet(10, 0.002, 0);
  sheet.positions[vertex][2] += rise;
  const DrawnTopology drawn = drawn_topology(sheet.topology, DrawnEdges::kStraight);
  return {drawn_pieces(sheet, drawn, sheet).front().vertices[shown], wall_vertices(sheet)[shown]};
}

TEST(TissuePieces, ADentBesideALipIsHardlyDark) {
  const auto dent = [](std::uint32_t row) {
    const auto [drawn, told] = raised(vertex_at(5, row), -0.001F, vertex_at(5, row));
    EXPECT_GT(told.curvature, 10) << "1 / metre, in row " << row;
    return drawn.curvature / told.curvature;
  };
  EXPECT_EQ(dent(3), 1) << "away from lips";
  EXPECT_LT(dent(4), 0.5) << "beside one";
  EXPECT_EQ(dent(5), 0) << "in one";
}

TEST(TissuePieces, ABulgeBesideALipIsAsTheMeshTellsIt) {
  const auto [drawn, told] = raised(vertex_at(5, 4), 0.0005F, vertex_at(5, 4));
  ASSERT_LT(told.curvature, -10);
  EXPECT_EQ(drawn.curvature, told.curvature);
}

TEST(TissuePieces, ACrumpleOfALipIsShadedSmoothlyAndASlightOneAsItIs) {
  const std::uint32_t lip = vertex_at(5, 5);
  const auto [sharp, told] = raised(lip, 0.006F, lip);
  EXPECT_GT(sharp.normal[2], told.normal[2] + 0.1F) << "it lies more level than its triangles";
  const auto [slight, told_slight] = raised(lip, 0.0003F, lip);
  EXPECT_EQ(slight.normal, told_slight.normal);
}

}  // namespace
}  // namespace thinwall
