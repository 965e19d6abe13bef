#include "renderer/picture/TissuePieces.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace thinwall
