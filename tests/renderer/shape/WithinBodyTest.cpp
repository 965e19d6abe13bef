#include "renderer/shape/WithinBody.hpp"

#include <gtest/gtest.h>

#include "tests/renderer/shape/CutSheets.hpp"
#include "tests/renderer/shape/TestMeshes.hpp"

namespace thinwall {
namespace {

SnapshotSurface ball() {
  return test::sphere("organ", {0.1, 0, 0}, 0.03, 3);
}

TEST(WithinBody, WhatAClosedWallIsAround) {
  for (const double x : {0.071, 0.1, 0.129}) EXPECT_TRUE(lies_within(ball(), {x, 0, 0})) << x;
  for (const double x : {-0.1, 0.069, 0.131}) EXPECT_FALSE(lies_within(ball(), {x, 0, 0})) << x;
  // In a corner of its box.
  EXPECT_FALSE(lies_within(ball(), {0.125, 0.025, 0.025}));
}

TEST(WithinBody, WhicheverWayItsTrianglesFaceAndWhetherTheyAreWallOrCap) {
  SnapshotSurface turned = ball();
  auto topology = std::make_shared<SnapshotTopology>(*turned.topology);
  for (Triangle& triangle : topology->triangles) std::swap(triangle[1], triangle[2]);
  topology->cap_triangles.assign(topology->triangles.begin(), topology->triangles.begin() + 40);
  topology->triangles.erase(topology->triangles.begin(), topology->triangles.begin() + 40);
  turned.topology = topology;
  EXPECT_TRUE(lies_within(turned, {0.1, 0, 0}));
}

TEST(WithinBody, ASheetHasNoInside) {
  EXPECT_FALSE(lies_within(test::patched_sheet(12, 0.01, 0), {0, 0, 0.001}));
  EXPECT_FALSE(lies_within(
      {.body = "none", .topology = std::make_shared<SnapshotTopology>(), .positions = {}, .fields = {}}, {}));
}

}  // namespace
}  // namespace thinwall
