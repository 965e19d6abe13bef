#include "renderer/shape/ToolShape.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "renderer/snapshot/Vector.hpp"

namespace thinwall {
namespace {

class EveryTool : public testing::TestWithParam<SnapshotToolKind> {};
class PointedTool : public EveryTool {};

SnapshotTool tool_of(SnapshotToolKind kind) {
  SnapshotTool tool;
  tool.kind = kind;
  tool.radius = 0.005;
  tool.length = 0.04;
  tool.width = 0.02;
  tool.thickness = 0.002;
  tool.opening = 0.004;
  tool.tip = {0.01, -0.02, 0.03};
  tool.direction = {0.6, 0, -0.8};
  tool.axis = {0, 1, 0};
  return tool;
}

TEST_P(PointedTool, TheForemostPointAlongTheDirectionIsTheTip) {
  const SnapshotTool tool = tool_of(GetParam());
  const ToolShape shape = tool_shape(tool, 0.1);
  ASSERT_FALSE(shape.indices.empty());
  double foremost = -1e9;
  double nearest = 1e9;
  for (const ToolVertex& vertex : shape.vertices) {
    const Vector3 offset = vector3(vertex.position) - vector3(tool.tip);
    foremost = std::max(foremost, dot(offset, vector3(tool.direction)));
    nearest = std::min(nearest, length(offset - dot(offset, vector3(tool.axis)) * vector3(tool.axis)));
  }
  // Positions are single precision numbers about 0.1.
  EXPECT_NEAR(foremost, 0, 1e-8);
  EXPECT_NEAR(nearest, 0, 1e-8);
}

TEST_P(EveryTool, NormalsHaveLengthOneAndIndicesNameVertices) {
  const ToolShape shape = tool_shape(tool_of(GetParam()), 0.1);
  for (const ToolVertex& vertex : shape.vertices) EXPECT_NEAR(length(vector3(vertex.normal)), 1, 1e-6);
  for (const std::uint32_t index : shape.indices) EXPECT_LT(index, shape.vertices.size());
}

/// Whose end is seen hangs in the air.
TEST_P(EveryTool, ReachesOutOfPicturesThatAreHigherThanWide) {
  const SnapshotTool tool = tool_of(GetParam());
  double back = 0;
  for (const ToolVertex& vertex : tool_shape(tool, 0.1).vertices) {
    back = std::max(back, -dot(vector3(vertex.position) - vector3(tool.tip), vector3(tool.direction)));
  }
  EXPECT_GT(back, 2.5 * 0.1);
}

/// What is drawn of a tool is what faces the viewer: nobody may look into it or through it.
TEST_P(EveryTool, TrianglesFaceOutwardsAndCloseVolumes) {
  const ToolShape shape = tool_shape(tool_of(GetParam()), 0.1);
  Vector3 areas{};
  double whole = 0, volume = 0;
  for (std::size_t i = 0; i < shape.indices.size(); i += 3) {
    std::array<Vector3, 3> corners;
    Vector3 normal{};
    for (std::size_t k = 0; k < 3; ++k) {
      const ToolVertex& vertex = shape.vertices[shape.indices[i + k]];
      corners[k] = vector3(vertex.position);
      normal = normal + vector3(vertex.normal);
    }
    const Vector3 area = 0.5 * cross(corners[1] - corners[0], corners[2] - corners[0]);
    EXPECT_GE(dot(area, normal), 0);
    areas = areas + area;
    whole += length(area);
    volume += dot(area, corners[0]) / 3;
  }
  // Positions are single precision numbers: a missing lid of the thinnest shaft would be 1e-4 of the whole.
  EXPECT_LT(length(areas), 1e-6 * whole);
  EXPECT_GT(volume, 0);
}

INSTANTIATE_TEST_SUITE_P(Kinds, PointedTool,
                         testing::Values(SnapshotToolKind::kPoint, SnapshotToolKind::kLine, SnapshotToolKind::kSphere));
INSTANTIATE_TEST_SUITE_P(Kinds, EveryTool,
                         testing::Values(SnapshotToolKind::kPoint, SnapshotToolKind::kLine, SnapshotToolKind::kSphere,
                                         SnapshotToolKind::kCapsule, SnapshotToolKind::kPlate,
                                         SnapshotToolKind::kNeedle, SnapshotToolKind::kScalpel,
                                         SnapshotToolKind::kForceps));

TEST(ToolShape, ABallHasItsRadiusAroundItsCentreBehindTheTip) {
  const SnapshotTool tool = tool_of(SnapshotToolKind::kSphere);
  const Vector3 center = vector3(tool.tip) - tool.radius * vector3(tool.direction);
  int on_the_ball = 0;
  for (const ToolVertex& vertex : tool_shape(tool, 0.1).vertices) {
    const Vector3 offset = vector3(vertex.position) - center;
    EXPECT_GT(length(offset), tool.radius - 1e-8);
    if (std::abs(length(offset) - tool.radius) > 1e-8) continue;
    ++on_the_ball;
    EXPECT_GT(dot(normalized(offset), vector3(vertex.normal)), 0.9);
  }
  EXPECT_GT(on_the_ball, 600);
}

TEST(ToolShape, JawsStayWithinWhatPressesAndMeetBehindIt) {
  SnapshotTool tool;
  tool.kind = SnapshotToolKind::kForceps;
  tool.direction = {0, 0, -1};
  tool.axis = {0, 1, 0};
  tool.length = 30e-3;
  tool.width = 6e-3;
  tool.thickness = 2e-3;
  const auto shape_at = [&](double opening) {
    tool.opening = opening;
    return tool_shape(tool, 0.1);
  };
  const ToolShape open = shape_at(10e-3), closed = shape_at(1e-3);
  double innermost = 1, outermost = 0;
  for (const ToolVertex& vertex : open.vertices) {
    const double aside = std::abs(vertex.position[0]);
    if (vertex.position[2] > tool.length + 1e-9) continue;
    innermost = std::min(innermost, aside);
    outermost = std::max(outermost, aside);
    EXPECT_LE(std::abs(vertex.position[1]), 0.5 * tool.width + 1e-9);
    // Its edges are rounded by a quarter of its thickness; where the arm begins the box has its end.
    const double rounding = 0.25 * tool.thickness;
    const double across = std::abs(aside - 6e-3) - (0.5 * tool.thickness - rounding);
    const double along = std::abs(vertex.position[1]) - (0.5 * tool.width - rounding);
    const double ahead = rounding - vertex.position[2];
    const double beyond = std::hypot(std::max(0.0, across), std::max(0.0, along), std::max(0.0, ahead));
    EXPECT_LE(beyond, rounding + 1e-8) << vertex.position[2];
  }
  EXPECT_NEAR(innermost, 5e-3, 1e-9);
  EXPECT_NEAR(outermost, 7e-3, 1e-9);
  const auto behind = [&](const ToolShape& shape) {
    std::vector<Float3> vertices;
    for (const ToolVertex& vertex : shape.vertices) {
      if (vertex.position[2] > 2 * tool.length - 1e-9) vertices.push_back(vertex.position);
    }
    return vertices;
  };
  EXPECT_EQ(behind(open), behind(closed)) << "the handle stays as they close";
}

TEST(ToolShape, ABladeIsSharpAtItsTipHasABellyInFrontAndStaysWithinWhatCuts) {
  SnapshotTool tool;
  tool.kind = SnapshotToolKind::kScalpel;
  tool.direction = {0, 0, -1};
  tool.axis = {0, 1, 0};
  tool.width = 6e-3;
  tool.length = 20e-3;
  tool.thickness = 0.4e-3;
  const ToolShape shape = tool_shape(tool, 0.1);
  double lowest = 1, thickest_at_edge = 0, widest = 0, thickest = 0;
  std::vector<double> belly;  // y' of the edge, from the tip up
  for (const ToolVertex& vertex : shape.vertices) {
    const auto [x, y, z] = vertex.position;
    lowest = std::min<double>(lowest, z);
    if (z < 1e-9) thickest_at_edge = std::max<double>(thickest_at_edge, std::abs(x));
    if (z > tool.length - 1e-9) continue;
    widest = std::max<double>(widest, std::abs(y));
    thickest = std::max<double>(thickest, std::abs(x));
    if (y >= 0 && std::abs(x) < 0.01e-3) belly.push_back(y);
  }
  EXPECT_NEAR(lowest, 0, 1e-9) << "the edge goes through the tip";
  EXPECT_LT(thickest_at_edge, 0.01e-3);
  EXPECT_NEAR(widest, 3e-3, 1e-8);
  EXPECT_NEAR(thickest, 0.2e-3, 1e-8);
  ASSERT_FALSE(belly.empty());
  EXPECT_NEAR(*std::ranges::min_element(belly), 0, 1e-9);
  EXPECT_NEAR(*std::ranges::max_element(belly), 3e-3, 1e-8);
}

TEST(ToolShape, ABladeEndsInAPointWhereEdgeAndBackMeet) {
  SnapshotTool tool = tool_of(SnapshotToolKind::kScalpel);
  tool.tip = {};
  tool.direction = {0, 0, -1};
  tool.length = 2.5 * tool.width;
  // Tangents of the angles off the middle line at which back and edge are seen from the tip.
  double back = 0, edge = 0, thick = 0;
  for (const ToolVertex& vertex : tool_shape(tool, 0.1).vertices) {
    const auto [x, y, z] = vertex.position;
    if (z > 0.25 * tool.width) continue;
    if (z < 1e-9) {
      EXPECT_NEAR(y, 0, 1e-9) << "nothing but the tip is as far in front";
      thick = std::max<double>(thick, std::abs(x));
      continue;
    }
    back = std::max<double>(back, -y / z);
    edge = std::max<double>(edge, y / z);
  }
  // Seen: 0.40 and 0.86.
  EXPECT_LT(back, 0.5);
  EXPECT_LT(edge, 1.0);
  EXPECT_GT(edge, 0.5);
  EXPECT_LT(thick, 0.05 * tool.thickness);
}

TEST(ToolShape, TheBackOfABladeComesDownToItsPointWithoutACorner) {
  SnapshotTool tool = tool_of(SnapshotToolKind::kScalpel);
  tool.tip = {};
  tool.direction = {0, 0, -1};
  std::map<float, double> back;  // lowest y' at a height
  for (const ToolVertex& vertex : tool_shape(tool, 0.1).vertices) {
    const auto [x, y, z] = vertex.position;
    if (z <= tool.length && y <= 0) back[z] = std::min<double>(back[z], y);
  }
  std::erase_if(back, [](const auto& place) { return place.first > 0 && !(place.second < 0); });
  ASSERT_GT(back.size(), 15);
  double before = 0, steepest = 0;
  for (auto next = std::next(back.begin()), last = back.begin(); next != back.end(); last = next++) {
    const double angle = std::atan2(last->second - next->second, double{next->first} - last->first);
    if (last != back.begin()) {
      EXPECT_LT(std::abs(angle - before), 0.06) << "radians, at " << last->first;
    }
    before = angle;
    steepest = std::max(steepest, angle);
  }
  EXPECT_GT(steepest, 0.3);
  EXPECT_NEAR(before, 0, 1e-6) << "straight before the mount";
}

TEST(ToolShape, ABladeAndItsMountAreOnePlate) {
  SnapshotTool tool = tool_of(SnapshotToolKind::kScalpel);
  tool.tip = {};
  tool.direction = {0, 0, -1};
  std::vector<Vector3> normals;
  for (const ToolVertex& vertex : tool_shape(tool, 0.1).vertices) {
    const auto [x, y, z] = vertex.position;
    const bool is_corner = std::abs(z - tool.length) < 1e-6 && std::abs(y + 0.5 * tool.width) < 1e-6 && x > 0;
    if (is_corner && vertex.normal[0] > 0.9F) normals.push_back(vector3(vertex.normal));
  }
  ASSERT_GE(normals.size(), 2);
  for (const Vector3& normal : normals) EXPECT_GT(dot(normal, normals.front()), 1 - 1e-6) << "a seam would be seen";
}

TEST(ToolShape, ABladeIsShadedWhereItLiesInItsHandle) {
  SnapshotTool tool = tool_of(SnapshotToolKind::kScalpel);
  tool.tip = {};
  tool.direction = {0, 0, -1};
  const double wide = 0.5 * tool.width;
  float beside_tang = 0, below_handle = 0, elsewhere = 0;
  for (const ToolVertex& vertex : tool_shape(tool, 0.1).vertices) {
    const double aside = std::abs(vertex.position[1]) / wide, behind = (vertex.position[2] - tool.length) / wide;
    if (behind > 2.3 && behind < 4 && aside < 0.4) beside_tang = std::min(beside_tang, vertex.grip);
    if (behind > 4.2 && behind < 5.5 && aside > 1.2) below_handle = std::min(below_handle, vertex.grip);
    if (behind < 2.1) elsewhere = std::min(elsewhere, vertex.grip);
  }
  EXPECT_LT(beside_tang, -0.3F);
  EXPECT_LT(below_handle, -0.3F);
  EXPECT_EQ(elsewhere, 0);
}

TEST(ToolShape, AHandleRisesOutOfItsBladeWithoutAStep) {
  SnapshotTool tool = tool_of(SnapshotToolKind::kScalpel);
  tool.tip = {};
  tool.direction = {0, 0, -1};
  const double wide = 0.5 * tool.width, thick = 0.5 * tool.thickness;
  int fronts = 0, rears = 0;
  for (const ToolVertex& vertex : tool_shape(tool, 0.1).vertices) {
    const auto [x, y, z] = vertex.position;
    const double behind = (z - tool.length) / wide;
    if (vertex.normal[2] < -0.99F && behind > 4) {
      ++fronts;
      EXPECT_LT(std::abs(x), thick) << "the handle's front stands out of the blade";
    }
    if (vertex.normal[2] > 0.99F && std::abs(y) < 0.4 * wide && std::abs(x) > 1.01 * thick && behind < 8) {
      ++rears;
      EXPECT_GT(behind, 5.3) << "the end of the tang stands out of the handle";
    }
  }
  EXPECT_GT(fronts, 0);
  EXPECT_GT(rears, 0);
}

TEST(ToolShape, NothingNarrowIsSeenWhereABladeSitsOnItsHandle) {
  SnapshotTool tool = tool_of(SnapshotToolKind::kScalpel);
  tool.tip = {};
  tool.direction = {0, 0, -1};
  const double wide = 0.5 * tool.width, thick = 0.5 * tool.thickness;
  double slot = 0, tang = 0, front = 0;
  for (const ToolVertex& vertex : tool_shape(tool, 0.1, ToolDetail::kSeen).vertices) {
    const auto [x, y, z] = vertex.position;
    const double behind = (z - tool.length) / wide, aside = std::abs(y) / wide, out = std::abs(x) / thick;
    const bool is_wall = behind > 1.2 && behind < 3.8 && std::abs(vertex.normal[0]) < 0.5 && vertex.normal[1] * y < 0;
    if (is_wall && aside < 1 && std::abs(out - 1) < 1e-3) {
      slot = std::max(slot, aside);
      EXPECT_NEAR(vertex.normal[0], 0, 1e-6) << "light and dark alternate between pixels";
    }
    if (behind > 2.4 && behind < 2.6 && out > 1.0005) tang = std::max(tang, aside);
    if (std::abs(behind - 4.3) < 1e-3 && aside > 0.5) front = std::max(front, out);
  }
  EXPECT_NEAR(slot, 0.36, 1e-3);
  EXPECT_GT(tang, slot) << "a pixel here and there sees through between them";
  EXPECT_GT(front, 1) << "where faces go through each other stairs are seen";
  EXPECT_LT(front, 1.01) << "a step would be seen as dashes";
}

TEST(ToolShape, ABladeShadesTheTissueAroundIt) {
  SnapshotTool tool = tool_of(SnapshotToolKind::kScalpel);
  tool.tip = {};
  tool.direction = {0, 0, -1};
  const ToolShape shape = tool_shape(tool, 0.1);
  ASSERT_FALSE(shape.rods.empty());
  const ToolRod& blade = shape.rods.front();
  EXPECT_EQ(blade.start[2], 0);
  EXPECT_GT(blade.end[2], tool.length);
  EXPECT_NEAR(blade.radius, 0.25 * tool.width, 1e-8);
}

TEST(ToolShape, AHandleThatWidensIsBentAndHasNoFacets) {
  SnapshotTool tool = tool_of(SnapshotToolKind::kScalpel);
  tool.tip = {};
  tool.direction = {0, 0, -1};
  std::map<Float3, std::vector<Vector3>> normals_at;
  for (const ToolVertex& vertex : tool_shape(tool, 0.1).vertices) {
    // Behind the mount and what joins it to the handle, before its round end.
    const float height = vertex.position[2];
    if (height > tool.length + 3.5 * tool.width && height < tool.length + 10 * tool.width) {
      normals_at[vertex.position].push_back(vector3(vertex.normal));
    }
  }
  ASSERT_FALSE(normals_at.empty());
  for (const auto& [place, normals] : normals_at) {
    for (const Vector3& normal : normals) {
      const double cosine = dot(normal, normals.front());
      EXPECT_FALSE(cosine < 0.99999 && cosine > 0.95)
          << "a crease of " << std::acos(cosine) << " radians at " << place[2];
    }
  }
}

TEST(ToolShape, ASharpEdgeIsALineAndLeavesTheBladeClosed) {
  SnapshotTool tool = tool_of(SnapshotToolKind::kScalpel);
  tool.tip = {};
  tool.direction = {0, 0, -1};
  const ToolShape ground = tool_shape(tool, 0.1), sharp = tool_shape(tool, 0.1, ToolDetail::kSeen);
  const auto beside_the_edge = [&](const ToolShape& shape) {
    return std::ranges::count_if(shape.vertices, [&](const ToolVertex& vertex) {
      const double aside = std::abs(vertex.position[0]);
      return vertex.position[2] < tool.length && aside > 1e-9 && aside < 0.05 * tool.thickness;
    });
  };
  EXPECT_GT(beside_the_edge(ground), 0);
  EXPECT_EQ(beside_the_edge(sharp), 0);
  Vector3 areas{};
  double whole = 0;
  for (std::size_t i = 0; i < sharp.indices.size(); i += 3) {
    const auto corner = [&](std::size_t k) { return vector3(sharp.vertices[sharp.indices[i + k]].position); };
    const Vector3 area = 0.5 * cross(corner(1) - corner(0), corner(2) - corner(0));
    areas = areas + area;
    whole += length(area);
  }
  EXPECT_LT(length(areas), 1e-6 * whole);
}

TEST(ToolShape, TheHandleOfABladeIsFlatAndHasGrooves) {
  SnapshotTool tool = tool_of(SnapshotToolKind::kScalpel);
  tool.direction = {0, 0, -1};
  tool.width = 4e-3;
  double wide = 0, thick = 0, grip = 0;
  for (const ToolVertex& vertex : tool_shape(tool, 0.1).vertices) {
    wide = std::max<double>(wide, std::abs(vertex.position[1] - tool.tip[1]));
    thick = std::max<double>(thick, std::abs(vertex.position[0] - tool.tip[0]));
    grip = std::max<double>(grip, vertex.grip);
  }
  EXPECT_NEAR(wide, 4e-3, 1e-8);
  EXPECT_LT(thick, 0.5 * wide);
  EXPECT_EQ(grip, 1);
}

TEST(ToolShape, AStraightEdgeSpansItsLengthAlongTheAxis) {
  const SnapshotTool tool = tool_of(SnapshotToolKind::kLine);
  double low = 1, high = -1;
  for (const ToolVertex& vertex : tool_shape(tool, 0.1).vertices) {
    const double along = dot(vector3(vertex.position) - vector3(tool.tip), vector3(tool.axis));
    low = std::min(low, along);
    high = std::max(high, along);
  }
  EXPECT_NEAR(low, -0.02, 1e-8);
  EXPECT_NEAR(high, 0.02, 1e-8);
}

}  // namespace
}  // namespace thinwall
