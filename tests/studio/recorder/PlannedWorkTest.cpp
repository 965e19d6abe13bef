#include "studio/recorder/PlannedWork.hpp"

#include <gtest/gtest.h>

#include "studio/scenario/LoadScenario.hpp"
#include "studio/take/TakeError.hpp"
#include "tests/studio/TemporaryFolder.hpp"

namespace thinwall {
namespace {

constexpr const char* kBalloon = R"(thinwall: 1
bodies:
  balloon:
    surface: { shape: sphere, radius: 20 mm, triangles: 320 }
    wall: { thickness: 1 mm, material: { law: neo_hookean, shear_modulus: 20 kPa }, toughness: 0.1 kJ/m^2 }
tools:
  finger: { kind: sphere, radius: 3 mm }
  blade: { kind: scalpel }
timeline:
)";

std::vector<PlannedWork> work_of(const std::string& timeline) {
  const TemporaryFolder folder;
  write_bytes(folder / "s.yaml", kBalloon + timeline);
  return planned_work(load_scenario(folder / "s.yaml", {}).resolved);
}

TEST(PlannedWork, LastsAsLongAsWaysAndSpeedsAskFor) {
  const std::vector<PlannedWork> work = work_of(R"(
  - wait: { for: 0.25 s }
  - palpate: { tool: finger, at: [0, 0, 20 mm], depth: 5 mm, speed: 10 mm/s, standoff: 5 mm, hold: 0.5 s }
  - incise: { tool: blade, path: [[0, 0, 20 mm], [6 mm, 0, 20 mm], [6 mm, 4 mm, 19 mm]], depth: 2 mm, speed: 10 mm/s, standoff: 3 mm, withdraw: false, start: 4 s }
)");
  ASSERT_EQ(work.size(), 2U) << "nothing is done where nobody works";
  EXPECT_EQ(work[0].tool, "finger");
  EXPECT_EQ(work[0].body, "balloon");
  EXPECT_DOUBLE_EQ(work[0].begin, 0.25);
  EXPECT_NEAR(work[0].end, 0.25 + 2 * 1.0 + 0.5, 1e-12) << "down and back over 10 mm, and the hold";
  EXPECT_DOUBLE_EQ(work[1].begin, 4);
  EXPECT_NEAR(work[1].end, 4 + (2 + 3 + 6 + std::sqrt(17.0)) / 10, 1e-12) << "in, and along the path";
}

TEST(PlannedWork, AMoveGoesOnFromWhereTheToolWasLeft) {
  const std::vector<PlannedWork> work = work_of(R"(
  - move: { tool: finger, from: [0, 0, 40 mm], to: [10 mm, 0, 30 mm], direction: [0, 0, -1], for: 1 s }
  - move: { tool: finger, by: [0, 5 mm, 0], direction: [0, 0, -1], for: 2 s }
)");
  ASSERT_EQ(work.size(), 2U);
  EXPECT_EQ(work[0].places, (std::vector<Double3>{{0, 0, 0.04}, {0.01, 0, 0.03}}));
  ASSERT_EQ(work[1].places.size(), 2U);
  EXPECT_EQ(work[1].places[0], (Double3{0.01, 0, 0.03}));
  EXPECT_NEAR(work[1].places[1][1], 0.005, 1e-15);
  EXPECT_DOUBLE_EQ(work[1].begin, 1);
  EXPECT_DOUBLE_EQ(work[1].end, 3);
}

/// A square of 20 mm at the height z, metres.
Snapshot square(float z) {
  auto topology = std::make_shared<SnapshotTopology>();
  topology->rest_positions = {{-0.01F, -0.01F, 0}, {0.01F, -0.01F, 0}, {0.01F, 0.01F, 0}, {-0.01F, 0.01F, 0}};
  topology->triangles = {{0, 1, 2}, {0, 2, 3}};
  Snapshot snapshot;
  snapshot.surfaces = {{.body = "sheet", .topology = topology, .positions = topology->rest_positions, .fields = {}}};
  for (Float3& position : snapshot.surfaces[0].positions) position[2] = z;
  return snapshot;
}

TEST(PlannedWork, IsDoneWhereItsLineMeetsTheWallAndBelow) {
  const PlannedWork press{
      .tool = "finger", .body = "sheet", .places = {{0.002, 0, 0.5}}, .direction = Double3{0, 0, -1}, .depth = 0.003};
  const std::vector<Double3> places = places_of(press, square(0.001F));
  ASSERT_EQ(places.size(), 2U);
  EXPECT_NEAR(places[0][0], 0.002, 1e-9);
  EXPECT_NEAR(places[0][2], 0.001, 1e-9);
  EXPECT_NEAR(places[1][2], -0.002, 1e-9);
}

TEST(PlannedWork, AlongAPathIsDoneAllTheWayOnTheWallAsItIs) {
  const PlannedWork cut{.tool = "blade", .body = "sheet", .places = {{-0.006, 0, 0}, {0.006, 0, 0}}};
  const std::vector<Double3> places = places_of(cut, square(0.001F));
  ASSERT_GE(places.size(), 5U);
  double farthest = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    EXPECT_NEAR(places[i][2], 0.001, 1e-9);
    if (i > 0) farthest = std::max(farthest, places[i][0] - places[i - 1][0]);
  }
  EXPECT_NEAR(places.front()[0], -0.006, 1e-9);
  EXPECT_NEAR(places.back()[0], 0.006, 1e-9);
  EXPECT_LE(farthest, 0.003);
}

TEST(PlannedWork, ATakeOfWhichNothingIsKnownHasNoneAndADamagedOneIsRefused) {
  EXPECT_TRUE(planned_work("").empty());
  EXPECT_TRUE(planned_work("{}").empty());
  EXPECT_THROW(planned_work(R"({"timeline": [{"palpate": {"tool": "a", "at": 5}}]})"), TakeError);
}

}  // namespace
}  // namespace thinwall
