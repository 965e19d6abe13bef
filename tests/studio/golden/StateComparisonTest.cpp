#include <gtest/gtest.h>

#include "studio/golden/GoldenComparison.hpp"
#include "tests/studio/SyntheticRun.hpp"

namespace thinwall {
namespace {

TEST(StateComparisonTest, MovementsFarBelowAPixelAreNoChange) {
  const SyntheticRun run;
  const Snapshot golden = run.moment(10).snapshot;
  Snapshot moved = golden;
  moved.surfaces[0].positions[7][0] += 1e-8F;
  EXPECT_EQ(compare_states(golden, moved, false).verdict, StateVerdict::kClose);
  EXPECT_TRUE(compare_states(golden, moved, false).explanation.starts_with("no vertex has moved by more than "));
  EXPECT_EQ(compare_states(golden, golden, false).explanation, "no vertex has moved");
  moved.surfaces[0].positions[7][0] += 1e-5F;
  EXPECT_EQ(compare_states(golden, moved, false).verdict, StateVerdict::kChanged);
}

TEST(StateComparisonTest, MovementsCountAsPartsOfTheSurfacesSize) {
  Snapshot golden = SyntheticRun().moment(10).snapshot;
  for (Float3& point : golden.surfaces[0].positions) point = {1000 * point[0], 1000 * point[1], 1000 * point[2]};
  Snapshot moved = golden;
  moved.surfaces[0].positions[7][0] += 1e-4F;  // metres, of some tens
  EXPECT_EQ(compare_states(golden, moved, false).verdict, StateVerdict::kClose);
}

TEST(StateComparisonTest, TellsOfTheBodyThatHasMovedMost) {
  Snapshot golden = SyntheticRun().moment(10).snapshot;
  golden.surfaces.push_back(golden.surfaces[0]);
  golden.surfaces[1].body = "second";
  Snapshot moved = golden;
  moved.surfaces[1].positions[7][0] += 1e-3F;
  const StateComparison comparison = compare_states(golden, moved, false);
  EXPECT_EQ(comparison.verdict, StateVerdict::kChanged);
  EXPECT_TRUE(comparison.explanation.starts_with("vertex 7 of second has moved by 1 mm")) << comparison.explanation;
}

TEST(StateComparisonTest, AnotherMeshIsAChange) {
  const SyntheticRun coarse({.side = 5});
  const SyntheticRun fine({.side = 7});
  const StateComparison comparison = compare_states(coarse.moment(3).snapshot, fine.moment(3).snapshot, false);
  EXPECT_EQ(comparison.verdict, StateVerdict::kChanged);
  EXPECT_EQ(comparison.explanation, "the mesh of organ has changed");
}

TEST(StateComparisonTest, AToolThatStandsElsewhereIsAChangeWhereNoWallHasMoved) {
  const Snapshot golden = SyntheticRun().moment(0).snapshot;
  const auto told = [&](auto change) {
    Snapshot today = golden;
    change(today.tools[0]);
    const StateComparison comparison = compare_states(golden, today, true);
    EXPECT_EQ(comparison.verdict, StateVerdict::kChanged);
    return comparison.explanation;
  };
  EXPECT_EQ(told([](SnapshotTool& tool) { tool.tip[0] += 1e-3; }),
            "probe is 1 mm from where it was, though no wall has moved");
  EXPECT_EQ(told([](SnapshotTool& tool) {
              tool.axis = {1, 0, 0};
            }),
            "probe is turned by 90 deg, though no wall has moved");
  EXPECT_EQ(told([](SnapshotTool& tool) { tool.opening = 2e-3; }),
            "probe is 2 mm otherwise open, though no wall has moved");
  EXPECT_EQ(compare_states(golden, golden, true).verdict, StateVerdict::kEqual);
}

}  // namespace
}  // namespace thinwall
