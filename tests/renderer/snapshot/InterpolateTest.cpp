#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {
namespace {

std::shared_ptr<const SnapshotTopology> one_triangle() {
  auto topology = std::make_shared<SnapshotTopology>();
  topology->rest_positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  topology->triangles = {{0, 1, 2}};
  return topology;
}

Snapshot snapshot_at(double time, float height, const std::shared_ptr<const SnapshotTopology>& topology) {
  Snapshot snapshot;
  snapshot.time = time;
  snapshot.surfaces.push_back({.body = "organ",
                               .topology = topology,
                               .positions = {{0, 0, height}, {1, 0, height}, {0, 1, 3 * height}},
                               .fields = {{.name = "stress", .unit = "Pa", .values = {height, 2 * height, 0}}}});
  SnapshotTool tool;
  tool.name = "probe";
  tool.tip = {0, 0, height};
  tool.depth = 2 * height;
  tool.force = {0, 0, -height};
  tool.phase = height < 1.5f ? "approach" : "press";
  snapshot.tools.push_back(tool);
  snapshot.scalars.push_back({.name = "organ.pressure", .unit = "Pa", .value = 10.0 * height});
  return snapshot;
}

TEST(Interpolate, EverythingIsLinearInTime) {
  const auto topology = one_triangle();
  const Snapshot middle = interpolate(snapshot_at(2, 1, topology), snapshot_at(6, 3, topology), 3);
  // A quarter of the way from 1 to 3; all numbers are exact in binary.
  EXPECT_EQ(middle.time, 3);
  EXPECT_EQ(middle.surfaces[0].positions[2][2], 4.5f);
  EXPECT_EQ(middle.surfaces[0].fields[0].values[1], 3.0f);
  EXPECT_EQ(middle.tools[0].tip[2], 1.5);
  EXPECT_EQ(middle.tools[0].depth, 3);
  EXPECT_EQ(middle.tools[0].force[2], -1.5);
  EXPECT_EQ(middle.scalars[0].value, 15);
  EXPECT_EQ(middle.tools[0].phase, "approach");
  EXPECT_EQ(middle.surfaces[0].topology, topology);
}

TEST(Interpolate, TheEndsAreTheSnapshotsThemselvesAndTimesBeyondAreClamped) {
  const auto topology = one_triangle();
  Snapshot earlier = snapshot_at(0, 0.1f, topology);
  Snapshot later = snapshot_at(0.3, 0.7f, topology);
  for (const double time : {-1.0, 0.0}) {
    const Snapshot start = interpolate(earlier, later, time);
    EXPECT_EQ(start.time, earlier.time);
    EXPECT_EQ(start.surfaces[0].positions, earlier.surfaces[0].positions);
    EXPECT_EQ(start.tools[0].tip, earlier.tools[0].tip);
  }
  for (const double time : {0.3, 9.0}) {
    const Snapshot end = interpolate(earlier, later, time);
    EXPECT_EQ(end.time, later.time);
    EXPECT_EQ(end.surfaces[0].positions, later.surfaces[0].positions);
    EXPECT_EQ(end.tools[0].tip, later.tools[0].tip);
  }
}

TEST(Interpolate, WhatStaysAsItIsDoesSoToTheLastBit) {
  Snapshot earlier = snapshot_at(0, 0.1f, one_triangle());
  earlier.tools[0].length = 0.03;
  Snapshot later = earlier;
  later.time = 1;
  // Of these weights a part w and the rest add up to something beside 0.03.
  for (double time = 0; time < 1; time += 0.013) {
    const Snapshot between = interpolate(earlier, later, time);
    EXPECT_EQ(between.tools[0].length, 0.03) << time;
    EXPECT_EQ(between.tools[0].tip, earlier.tools[0].tip) << time;
    EXPECT_EQ(between.surfaces[0].positions, earlier.surfaces[0].positions) << time;
  }
}

TEST(Interpolate, ThePhaseIsThatOfTheNearerSnapshotWhoseForceIsMostlyShown) {
  const auto topology = one_triangle();
  const Snapshot earlier = snapshot_at(0.1, 1, topology), later = snapshot_at(0.2, 2, topology);
  const auto phase_at = [&](double time) { return interpolate(earlier, later, time).tools[0].phase; };
  EXPECT_EQ(phase_at(0.1), "approach");
  EXPECT_EQ(phase_at(0.15 - 1e-12), "approach");
  EXPECT_EQ(phase_at(0.15 + 1e-12), "press");
  EXPECT_EQ(phase_at(0.2 - 4e-7), "press") << "the step of 16.6667 ms that belongs to a frame";
  EXPECT_EQ(phase_at(0.2), "press");
  EXPECT_EQ(phase_at(0.2 + 1e-12), "press");
}

TEST(Interpolate, DirectionsKeepLengthOne) {
  const auto topology = one_triangle();
  Snapshot earlier = snapshot_at(0, 1, topology);
  Snapshot later = snapshot_at(1, 1, topology);
  later.tools[0].direction = {1, 0, 0};
  const Double3 direction = interpolate(earlier, later, 0.5).tools[0].direction;
  // Halfway between -z and +x; two roundings of a square root.
  EXPECT_NEAR(direction[0], std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(direction[2], -std::sqrt(0.5), 1e-15);
}

TEST(Interpolate, SnapshotsAtOneTimeGiveTheEarlierOne) {
  const auto topology = one_triangle();
  const Snapshot same = interpolate(snapshot_at(1, 1, topology), snapshot_at(1, 2, topology), 1);
  EXPECT_EQ(same.tools[0].tip[2], 1);
  EXPECT_EQ(same.tools[0].phase, "approach");
}

TEST(Interpolate, ACutIsThereAtOnceAndOpensEvenly) {
  // A square of two triangles is cut along its diagonal from the corner at the origin to the middle, which is new.
  auto whole = std::make_shared<SnapshotTopology>();
  whole->rest_positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  whole->triangles = {{0, 1, 2}, {0, 2, 3}};
  auto cut = std::make_shared<SnapshotTopology>();
  cut->rest_positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5f, 0.5f, 0}, {0, 0, 0}};
  cut->triangles = {{0, 1, 4}, {1, 2, 4}, {5, 4, 3}, {4, 2, 3}};
  Snapshot earlier, later;
  later.time = 1;
  // Raised by 2 on the side of the second corner.
  earlier.surfaces.push_back({.body = "skin",
                              .topology = whole,
                              .positions = {{0, 0, 2}, {1, 0, 2}, {1, 1, 0}, {0, 1, 0}},
                              .fields = {{.name = "stress", .unit = "Pa", .values = {8, 4, 2, 6}}}});
  later.surfaces.push_back({.body = "skin",
                            .topology = cut,
                            .positions = {{0, 0, 2}, {1, 0, 2}, {1, 1, 0}, {0, 1, 0}, {0.5f, 0.5f, 1}, {0, 0.5f, 2}},
                            .fields = {{.name = "stress", .unit = "Pa", .values = {8, 4, 2, 6, 1, 0}}}});
  const SnapshotSurface middle = interpolate(earlier, later, 0.5).surfaces[0];
  EXPECT_EQ(middle.topology, later.surfaces[0].topology);
  EXPECT_EQ(middle.positions[4], (Float3{0.5f, 0.5f, 1}));
  EXPECT_EQ(middle.positions[5], (Float3{0, 0.25f, 2}));
  EXPECT_EQ(middle.fields[0].values[4], 3) << "between the mean of 8 and 2, and 1";
  EXPECT_EQ(middle.fields[0].values[5], 4);
  EXPECT_EQ(interpolate(earlier, later, 0).surfaces[0].topology, earlier.surfaces[0].topology);
  EXPECT_EQ(interpolate(earlier, later, 1).surfaces[0].positions, later.surfaces[0].positions);
}

TEST(Interpolate, AVertexAtAnOlderWoundStaysOnItsSide) {
  // Two halves of a strip that share no vertex: a new one at their common border belongs to the half that it is near.
  auto before = std::make_shared<SnapshotTopology>();
  before->rest_positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {0, -1, 0}};
  before->triangles = {{0, 1, 2}, {3, 5, 4}};
  auto after = std::make_shared<SnapshotTopology>(*before);
  after->rest_positions.push_back({0.5f, 0, 0});
  Snapshot earlier, later;
  later.time = 1;
  earlier.surfaces.push_back({.body = "skin",
                              .topology = before,
                              .positions = {{0, 1, 0}, {1, 1, 0}, {0, 2, 0}, {0, -1, 0}, {1, -1, 0}, {0, -2, 0}},
                              .fields = {}});
  for (const float side : {1.0f, -1.0f}) {
    SnapshotSurface open = earlier.surfaces[0];
    open.topology = after;
    open.positions.push_back({0.5f, side, 0});
    later.surfaces = {open};
    EXPECT_EQ(interpolate(earlier, later, 0.5).surfaces[0].positions[6], (Float3{0.5f, side, 0}));
  }
}

TEST(Interpolate, UnequalLayoutsAreRefusedWithWhatDiffers) {
  const auto topology = one_triangle();
  const Snapshot earlier = snapshot_at(0, 1, topology);
  auto smaller = std::make_shared<SnapshotTopology>(*topology);
  smaller->rest_positions.pop_back();
  Snapshot later = snapshot_at(1, 2, smaller);
  try {
    interpolate(earlier, later, 0.5);
    FAIL() << "another topology was accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "snapshots of unequal layout cannot be interpolated: body 'organ' loses vertices");
  }
  later = snapshot_at(1, 2, topology);
  later.tools.clear();
  EXPECT_THROW(interpolate(earlier, later, 0.5), std::invalid_argument);
}

}  // namespace
}  // namespace thinwall
