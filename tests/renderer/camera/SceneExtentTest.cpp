#include "renderer/camera/SceneExtent.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>

#include "renderer/image/PictureFailure.hpp"
#include "tests/renderer/shape/CutSheets.hpp"

namespace thinwall {
namespace {

Snapshot snapshot_of(const SnapshotSurface& surface) {
  Snapshot snapshot;
  snapshot.surfaces.push_back(surface);
  return snapshot;
}

TEST(SceneExtent, TheFloorTouchesWhatStandsOnIt) {
  const SceneExtent extent = scene_extent(snapshot_of(test::sphere("organ", {0, 0, 0.5}, 0.02, 2)));
  EXPECT_FLOAT_EQ(static_cast<float>(extent.floor_height), 0.48f);
  EXPECT_NEAR(extent.size, 0.04 * std::sqrt(3.0), 1e-8);  // single precision positions
}

TEST(SceneExtent, AFlatSheetFloatsAboveTheFloor) {
  const SnapshotSurface sheet = test::quad("sheet", {{{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {0, 2, 0}}});
  EXPECT_NEAR(scene_extent(snapshot_of(sheet)).floor_height, -0.25 * 2, 1e-12);
}

TEST(SceneExtent, TheFloorGivesWayToWhatIsPressedThroughIt) {
  SnapshotSurface sphere = test::sphere("organ", {}, 1, 1);
  sphere.positions[5] = {0, 0, -3};
  EXPECT_EQ(scene_extent(snapshot_of(sphere)).floor_height, -3);
}

TEST(SceneExtent, TheFloorStaysWhereItIsWhenAPieceFalls) {
  SnapshotSurface sheet = test::patched_sheet(40, 0.001, 8);
  const double before = scene_extent(snapshot_of(sheet)).floor_height;
  for (std::size_t v = sheet.positions.size() - 81; v < sheet.positions.size(); ++v) sheet.positions[v][2] = -0.05f;
  EXPECT_EQ(scene_extent(snapshot_of(sheet)).floor_height, before);
}

TEST(SceneExtent, SmallMotionLeavesTheReachAsItIs) {
  SnapshotSurface sphere = test::sphere("organ", {}, 1, 1);
  const double before = scene_extent(snapshot_of(sphere)).reach;
  sphere.positions[4] = {0, 0, 1.05f};
  EXPECT_EQ(scene_extent(snapshot_of(sphere)).reach, before);
  sphere.positions[4] = {0, 0, 5};
  EXPECT_GE(scene_extent(snapshot_of(sphere)).reach, 5);
}

/// z of what a patched sheet of 2 mm lies on, with its vertices moved by `move`.
double height_below(SnapshotSurface sheet, const std::function<void(Float3&)>& move) {
  auto topology = std::make_shared<SnapshotTopology>(*sheet.topology);
  topology->thickness.assign(topology->triangles.size(), 0.002F);
  sheet.topology = topology;
  std::ranges::for_each(sheet.positions, move);
  const std::vector<BorderEdge> borders = border_edges(*topology);
  const std::vector<char> is_lip = cut_lips(*topology, borders);
  std::vector<BorderEdge> ends;
  std::ranges::copy_if(borders, std::back_inserter(ends),
                       [&](const BorderEdge& edge) { return !is_lip[edge.start] || !is_lip[edge.end]; });
  return lying_height(snapshot_of(sheet), std::vector<std::vector<BorderEdge>>{ends});
}

TEST(SceneExtent, ASheetLiesWithItsEndsAndGivesWayBetweenThem) {
  const SnapshotSurface sheet = test::patched_sheet(40, 0.001, 8);
  const auto is_end = [](const Float3& place) { return std::max(std::abs(place[0]), std::abs(place[1])) > 0.0195F; };
  EXPECT_NEAR(height_below(sheet, [](Float3&) {}), -0.002, 1e-9);
  EXPECT_NEAR(height_below(sheet, [&](Float3& place) { place[2] = is_end(place) ? 0 : -0.03F; }), -0.002, 1e-9);
  EXPECT_NEAR(height_below(sheet, [&](Float3& place) { place[2] = is_end(place) ? -0.01F : 0; }), -0.012, 1e-9);
}

TEST(SceneExtent, WhatIsOpenAtItsTopLiesWithItsBottom) {
  const SnapshotSurface bowl =
      test::surface_of("bowl", {{-1, 0, 1}, {1, -1, 1}, {1, 1, 1}, {0, 0, -2}}, {{0, 3, 1}, {1, 3, 2}, {2, 3, 0}});
  EXPECT_EQ(height_below(bowl, [](Float3&) {}), -2);
}

TEST(SceneExtent, AClosedBodyLiesWithItsLowestPoint) {
  const Snapshot snapshot = snapshot_of(test::sphere("organ", {0, 0, 0.5}, 0.02, 2));
  EXPECT_NEAR(lying_height(snapshot, std::vector(1, std::vector<BorderEdge>())), 0.48, 1e-7);
}

void expect_refused(const SnapshotSurface& surface, const std::string& message) {
  try {
    scene_extent(snapshot_of(surface));
    FAIL() << "accepted: " << message;
  } catch (const PictureFailure& failure) {
    EXPECT_EQ(failure.what(), message);
  }
}

TEST(SceneExtent, DamagedSurfacesAreRefusedByName) {
  SnapshotSurface sphere = test::sphere("organ", {}, 1, 0);
  sphere.positions[2][1] = std::numeric_limits<float>::quiet_NaN();
  expect_refused(sphere, "body 'organ' cannot be drawn: a position is not a finite number");

  sphere = test::sphere("organ", {}, 1, 0);
  sphere.positions.pop_back();
  expect_refused(sphere, "body 'organ' cannot be drawn: 5 positions for 6 vertices; the take is damaged");

  expect_refused(test::surface_of("organ", {{0, 0, 0}}, {{0, 0, 7}}),
                 "body 'organ' cannot be drawn: a triangle names vertex 7 of 1; the take is damaged");
}

}  // namespace
}  // namespace thinwall
