#include "renderer/wound/WoundMap.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "renderer/wound/Bleeding.hpp"
#include "renderer/wound/RunFeet.hpp"
#include "renderer/wound/RunPath.hpp"
#include "tests/renderer/shape/CutSheets.hpp"

namespace thinwall {
namespace {

WoundMap map_of(const SnapshotTopology& topology) {
  const std::vector<BorderEdge> borders = border_edges(topology);
  return map_wounds(topology, borders, cut_lips(topology, borders));
}

TEST(WoundMap, TellsTheWayToTheNearestLip) {
  const WoundMap map = map_of(test::cut_strip());
  for (const std::size_t lip : {2U, 3U, 8U, 9U}) EXPECT_EQ(map.from_lip[lip], 0) << lip;
  for (const std::size_t beside : {0U, 1U, 4U, 5U}) EXPECT_NEAR(map.from_lip[beside], 0.002, 1e-9) << beside;
  EXPECT_EQ(map.lip[0], 2U);
  EXPECT_EQ(map.lip[4], 8U);
}

TEST(WoundMap, ItsWaysAreStraightHoweverTheTrianglesLie) {
  SnapshotTopology sheet = *test::slit_sheet(20, 0.001, 0).topology;
  // No edge of a triangle is square to the slit any more, which lies along y = 0.
  for (Float3& place : sheet.rest_positions) place[0] += 0.37F * place[1];
  const WoundMap map = map_of(sheet);
  int beside = 0;
  for (std::size_t v = 0; v < sheet.rest_positions.size(); ++v) {
    const auto& [x, y, z] = sheet.rest_positions[v];
    if (std::abs(x) > 0.006F || std::abs(y) > 0.0025F) continue;
    EXPECT_NEAR(map.from_lip[v], std::abs(y), 1e-9) << x << " " << y;
    beside += y != 0;
  }
  EXPECT_GT(beside, 40);
}

TEST(WoundMap, TellsHowFarLipsGape) {
  SnapshotSurface sheet = test::slit_sheet(20, 0.001, 0);
  const WoundMap map = map_of(*sheet.topology);
  const std::uint32_t middle = 10 * 21 + 10;
  EXPECT_EQ(lip_gapes(sheet, map)[middle], 0) << "closed";
  sheet.positions[middle][1] -= 0.003F;
  const std::vector<double> gapes = lip_gapes(sheet, map);
  EXPECT_NEAR(gapes[middle], 0.003, 1e-8);
  EXPECT_EQ(std::ranges::count(gapes, gapes[middle]), 2) << "both lips";
  EXPECT_EQ(gapes[middle + 2], 0);
  EXPECT_EQ(gapes[5], 0) << "no lip";
}

TEST(WoundMap, TapersTowardsBothEndsOfACut) {
  const SnapshotSurface sheet = test::slit_sheet(20, 0.001, 0);
  const WoundMap map = map_of(*sheet.topology);
  const std::uint32_t row = 21, middle = 10 * row;
  const std::vector<double> tapering = map.tapering(1);
  EXPECT_EQ(tapering[middle + 1], 0) << "an end";
  EXPECT_EQ(tapering[middle + 19], 0) << "the other end";
  EXPECT_EQ(tapering[middle + 10], 1) << "the middle";
  for (std::uint32_t i = 1; i < 4; ++i) EXPECT_LT(tapering[middle + i], tapering[middle + i + 1]);
}

TEST(WoundMap, ItsTaperingGoesOnWithACutBetweenTheVertices) {
  const SnapshotSurface sheet = test::slit_sheet(20, 0.001, 0);
  SnapshotTopology topology = *sheet.topology;
  // From vertex to vertex in 0.1 s.
  for (std::size_t v = 0; v < topology.cut_times.size(); ++v) {
    if (topology.cut_times[v] < 0) continue;
    topology.cut_times[v] = static_cast<float>(100 * (topology.rest_positions[v][0] + 0.01));
  }
  const WoundMap map = map_of(topology);
  const std::uint32_t last = 10 * 21 + 18;  // before the end, reached after 1.8 s
  EXPECT_NEAR(map.tapering(1.8)[last], 0, 1e-4) << "the end is still there";
  EXPECT_NEAR(map.tapering(1.85)[last], 0.5 * map.tapering(1.9)[last], 0.01);
  EXPECT_NEAR(map.tapering(1.9)[last], map.tapering(5)[last], 1e-4) << "it went no farther";
  EXPECT_GT(map.tapering(5)[last], 0.1);
}

std::vector<FluidRun> runs_within(const SnapshotTopology& topology, RunReach reach) {
  const std::vector<BorderEdge> borders = border_edges(topology);
  const WoundMap map = map_of(topology);
  reach.map = &map;
  return find_runs(topology, borders, cut_lips(topology, borders), {0, 0, -1}, reach);
}

std::vector<FluidRun> runs_of(const SnapshotTopology& topology, double push = 0, double level = 0) {
  return runs_within(topology, {.spacing = 0.0045, .longest = 0.03, .push = push, .level = level});
}

TEST(FluidRuns, FollowTheSlopeFromTheLowerLip) {
  const SnapshotSurface sheet = test::slit_sheet(20, 0.001, 0.8);
  const std::vector<FluidRun> runs = runs_of(*sheet.topology);
  ASSERT_GE(runs.size(), 3U);
  double most_swerve = 0;
  for (const FluidRun& run : runs) {
    Vector3 last = point_at(run.path.front(), sheet.positions);
    EXPECT_NEAR(last.y, 0, 1e-7) << "begins at the cut";
    const double x = last.x;
    for (std::size_t k = 1; k < run.path.size(); ++k) {
      const Vector3 place = point_at(run.path[k], sheet.positions);
      EXPECT_NEAR(length(place - last), kRunStep, 1e-6);
      EXPECT_LT(place.z - last.z, -0.8 * kRunStep * std::sin(0.8)) << "downwards";
      EXPECT_LT(std::abs(place.x - x), 0.002) << "about the way of the slope";
      most_swerve = std::max(most_swerve, std::abs(place.x - x));
      last = place;
    }
    // To the border of the sheet, 10 mm below, but for what its bends take.
    EXPECT_NEAR(static_cast<double>(run.path.size() - 1) * kRunStep, 0.0105, 2 * kRunStep);
  }
  EXPECT_GT(most_swerve, 0.0003) << "no run is drawn with a ruler";
}

TEST(FluidRuns, AreNoneOnALevelSheetNorOnATakeThatDoesNotTellWhen) {
  EXPECT_TRUE(runs_of(*test::slit_sheet(20, 0.001, 0).topology).empty());
  SnapshotTopology untold = *test::slit_sheet(20, 0.001, 0.8).topology;
  untold.cut_times.clear();
  EXPECT_TRUE(runs_of(untold).empty());
}

TEST(FluidRuns, CreepOverBothLipsOfALevelSheetAwayFromThem) {
  constexpr double kLevel = 0.006;
  const SnapshotTopology sheet = *test::slit_sheet(20, 0.001, 0).topology;
  const std::vector<FluidRun> runs = runs_of(sheet, 0, kLevel);
  int up = 0, down = 0;  // along y
  for (const FluidRun& run : runs) {
    const Vector3 start = point_at(run.path.front(), sheet.rest_positions);
    const Vector3 end = point_at(run.path.back(), sheet.rest_positions);
    EXPECT_NEAR(start.y, 0, 1e-7) << "begins at the cut";
    EXPECT_GT(std::abs(end.y), 0.0015);
    EXPECT_GT(std::abs(end.y), 1.3 * std::abs(end.x - start.x)) << "it swerves, and leans nowhere";
    ++(end.y > 0 ? up : down);
    EXPECT_LE(static_cast<double>(run.path.size() - 2) * kRunStep, kLevel * run.chance) << "the farther the more comes";
  }
  EXPECT_GT(up, 0);
  EXPECT_GT(down, 0);
}

/// A slit sheet that has been cut from x = -9 mm at 0.1 s to x = 9 mm at 1.9 s.
SnapshotTopology sheet_cut_on(double steepness) {
  SnapshotTopology sheet = *test::slit_sheet(20, 0.001, steepness).topology;
  for (std::size_t v = 0; v < sheet.cut_times.size(); ++v) {
    if (sheet.cut_times[v] >= 0) sheet.cut_times[v] = static_cast<float>(100 * (sheet.rest_positions[v][0] + 0.01));
  }
  return sheet;
}

TEST(FluidRuns, DoNotCreepBesideWhereACutBegins) {
  constexpr double kOff = 0.003;
  const SnapshotTopology sheet = sheet_cut_on(0);
  const auto first_and_last = [&](double off_begin) {
    std::pair<double, double> places{1, -1};
    const RunReach reach{.spacing = 0.0045, .longest = 0.03, .level = 0.006, .off_begin = off_begin};
    for (const FluidRun& run : runs_within(sheet, reach)) {
      const double x = point_at(run.path.front(), sheet.rest_positions).x;
      places = {std::min(places.first, x), std::max(places.second, x)};
    }
    return places;
  };
  EXPECT_LT(first_and_last(0).first, -0.009 + kOff);
  EXPECT_GT(first_and_last(kOff).first, -0.009 + kOff);
  EXPECT_GT(first_and_last(kOff).second, 0.009 - 2 * kOff) << "the other end may go on";
}

TEST(FluidRuns, BeginOffTheEndsOfACutOnceThatHasGoneOn) {
  constexpr double kOff = 0.0028, kThreeEdges = 0.003;
  const SnapshotTopology sheet = sheet_cut_on(0.8);
  const auto begins = [&](double off_ends) {
    std::vector<std::pair<double, double>> all;  // metres along the cut, seconds
    for (const FluidRun& run : runs_within(sheet, {.spacing = 0.0045, .longest = 0.03, .off_ends = off_ends}))
      all.emplace_back(point_at(run.path.front(), sheet.rest_positions).x, run.born);
    return all;
  };
  const auto everywhere = begins(0), within = begins(kOff);
  EXPECT_LT(std::ranges::min(everywhere).first, -0.009 + kOff);
  EXPECT_GT(std::ranges::max(everywhere).first, 0.009 - kOff);
  ASSERT_GE(within.size(), 2U);
  for (const auto& [x, born] : within) {
    EXPECT_LT(std::abs(x), 0.009 - kOff);
    // At 10 mm/s; a lip counts by its later vertex, half a millimetre on. Times are rounded to single precision.
    EXPECT_NEAR(born, 100 * (x + 0.0005 + 0.01 + kThreeEdges), 1e-6) << x;
  }
}

TEST(FluidRuns, DoNotCreepWhereTheWallFalls) {
  const SnapshotTopology slope = *test::slit_sheet(20, 0.001, 0.8).topology;
  const std::vector<FluidRun> runs = runs_of(slope), again = runs_of(slope, 0, 0.006);
  ASSERT_EQ(runs.size(), again.size());
  for (std::size_t k = 0; k < runs.size(); ++k) EXPECT_EQ(runs[k].path.size(), again[k].path.size()) << k;
}

TEST(FluidRuns, StandOnFeetAlongTheirOwnLip) {
  const SnapshotTopology sheet = *test::slit_sheet(20, 0.001, 0.8).topology;
  const std::vector<BorderEdge> borders = border_edges(sheet);
  const std::vector<char> is_lip = cut_lips(sheet, borders);
  const std::vector<FluidRun> all = runs_of(sheet);
  const auto from_middle = [&](const FluidRun& run) {
    return std::abs(point_at(run.path.front(), sheet.rest_positions).x);
  };
  const std::vector<FluidRun> runs = {*std::ranges::min_element(all, {}, from_middle)};
  const std::vector<double> feet = run_feet(sheet, borders, is_lip, runs);
  const double start = point_at(runs.front().path.front(), sheet.rest_positions).x;
  const auto twins = static_cast<std::uint32_t>(21 * 21);  // of the upper lip, see slit_sheet
  for (std::uint32_t v = 0; v < feet.size(); ++v) {
    const double away = std::abs(double{sheet.rest_positions[v][0]} - start);
    if (!is_lip[v] || v >= twins) {
      EXPECT_LT(feet[v], 0.01) << "beyond the cut's end, or off the lips";
    } else if (away < 0.0006) {
      EXPECT_EQ(feet[v], 1) << v;
    } else {
      EXPECT_LT(feet[v], away < 0.004 ? 0.7 : 0.01) << v;
    }
  }
}

/// A slit along the top of a vault of radius 12 mm, on which the wall falls by `lean` to one side.
SnapshotTopology slit_vault(float lean) {
  SnapshotTopology vault = *test::slit_sheet(20, 0.001, 0).topology;
  for (Float3& place : vault.rest_positions) place[2] = -place[1] * place[1] / 0.024F - lean * place[1];
  return vault;
}

TEST(FluidRuns, ArePushedOverALevelCrownToBothSides) {
  const SnapshotTopology vault = slit_vault(0);
  EXPECT_TRUE(runs_of(vault).empty()) << "what only seeps stays";
  // The slope at which fluid runs by itself, a sine of 0.25, begins 3.1 mm from the slit.
  EXPECT_TRUE(runs_of(vault, 0.002).empty());
  const std::vector<FluidRun> runs = runs_of(vault, 0.006);
  int ahead = 0;
  for (const FluidRun& run : runs) {
    EXPECT_NEAR(point_at(run.path.front(), vault.rest_positions).y, 0, 1e-7) << "begins at the cut";
    const double end = point_at(run.path.back(), vault.rest_positions).y;
    EXPECT_GT(std::abs(end), 0.008) << "goes on down the slope";
    ahead += end > 0;
  }
  EXPECT_GE(ahead, 1);
  EXPECT_GE(std::ssize(runs) - ahead, 1);
  EXPECT_TRUE(runs_of(*test::slit_sheet(20, 0.001, 0).topology, 0.006).empty()) << "no slope to be pushed to";
}

TEST(FluidRuns, LeaveASlitAcrossARidgeByItsSides) {
  // A vault along y of radius 12 mm, slit across for 2 mm about its ridge: straight from the lips the wall stays level
  // to its border, while the slope at which fluid runs by itself begins 3.1 mm aside.
  SnapshotTopology vault = *test::slit_sheet(20, 0.001, 0, 9).topology;
  for (Float3& place : vault.rest_positions) place[2] = -place[0] * place[0] / 0.024F;
  EXPECT_TRUE(runs_of(vault).empty()) << "what only seeps stays";
  const std::vector<FluidRun> runs = runs_of(vault, 0.006);
  ASSERT_GE(runs.size(), 2U) << "from both lips";
  for (const FluidRun& run : runs) {
    EXPECT_NEAR(point_at(run.path.front(), vault.rest_positions).y, 0, 1e-7) << "begins at the cut";
    EXPECT_GT(std::abs(point_at(run.path.back(), vault.rest_positions).x), 0.008) << "goes on down the slope";
  }
}

TEST(FluidRuns, OfBothLipsOfASmallHoleRunTogetherOnTheSameSide) {
  // The same ridge, a little askew, so that either lip finds the slope on the same side.
  SnapshotTopology vault = *test::slit_sheet(20, 0.001, 0, 9).topology;
  for (Float3& place : vault.rest_positions) place[2] = -place[0] * place[0] / 0.024F - 0.08F * place[0];
  const std::vector<FluidRun> runs = runs_of(vault, 0.006);
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_GT(point_at(runs.front().path.back(), vault.rest_positions).x, 0.008);
}

TEST(FluidRuns, AreNotPushedUpwards) {
  const SnapshotTopology vault = slit_vault(0.15F);
  const std::vector<FluidRun> runs = runs_of(vault, 0.006);
  ASSERT_GE(runs.size(), 2U);
  for (const FluidRun& run : runs) EXPECT_GT(point_at(run.path.back(), vault.rest_positions).y, 0.008);
}

TEST(FluidRuns, StayWhileTheCutGoesOn) {
  const SnapshotSurface sheet = test::slit_sheet(20, 0.001, 0.8);
  SnapshotTopology growing = *sheet.topology;
  // The cut goes from -x to +x, a millimetre in a tenth of a second.
  for (std::size_t v = 0; v < growing.cut_times.size(); ++v) {
    if (growing.cut_times[v] != kNeverCut) growing.cut_times[v] = 100 * (growing.rest_positions[v][0] + 0.01f);
  }
  const std::vector<FluidRun> runs = runs_of(growing);
  ASSERT_GE(runs.size(), 3U);
  for (std::size_t k = 1; k < runs.size(); ++k) EXPECT_GT(runs[k].born, runs[k - 1].born);
  const double first = point_at(runs[0].path[0], growing.rest_positions).x;
  EXPECT_LT(first, -0.007) << "where the cut began";
}

TEST(Bleeding, SlackensAndDries) {
  EXPECT_EQ(blood_shed(-1), 0);
  EXPECT_NEAR(blood_shed(1e-6), 0.00015e-6, 1e-16) << "at first 0.15 mm/s";
  EXPECT_NEAR(blood_shed(1e3), 0.0006, 1e-12) << "0.6 mm in all";
  EXPECT_EQ(dryness(0), 0);
  EXPECT_NEAR(dryness(60), 1 - std::exp(-1.0), 1e-12);
}

TEST(Bleeding, RunsAsFarAsVolumeAndTimeAllow) {
  EXPECT_NEAR(run_length(1e-9, 0.001, 0.0001, 100, 0.03), 0.01, 1e-12);
  EXPECT_NEAR(run_length(1e-9, 0.001, 0.0001, 0.1, 0.03), 0.003, 1e-12);
  EXPECT_EQ(run_length(1e-9, 0.001, 0.0001, -1, 0.03), 0);
}

}  // namespace
}  // namespace thinwall
