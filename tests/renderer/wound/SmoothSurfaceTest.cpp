#include "renderer/wound/SmoothSurface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/renderer/shape/CutSheets.hpp"

namespace thinwall {
namespace {

constexpr double kRadius = 0.006;  // metres

/// A slit sheet whose upper lip is pulled into an arc; its vertices lie on the circle.
SnapshotSurface arched_slit() {
  SnapshotSurface sheet = test::slit_sheet(10, 0.001, 0);
  for (std::uint32_t v = 121; v < sheet.positions.size(); ++v) {
    const double x = sheet.topology->rest_positions[v][0];
    sheet.positions[v][1] = static_cast<float>(std::sqrt(kRadius * kRadius - x * x) - 0.8 * kRadius);
  }
  return sheet;
}

struct Smoothed {
  explicit Smoothed(const SnapshotSurface& surface)
      : borders(border_edges(*surface.topology)),
        is_lip(cut_lips(*surface.topology, borders)),
        lips(smooth_surface(surface.topology, borders, is_lip, true)),
        positions(smooth_positions(lips, surface.positions)) {}
  std::vector<BorderEdge> borders;
  std::vector<char> is_lip;
  SmoothSurface lips;
  std::vector<Float3> positions;
};

double area(const SnapshotTopology& topology, const std::vector<Float3>& points) {
  double sum = 0;
  for (const Triangle& triangle : topology.triangles) {
    const Vector3 a = vector3(points[triangle[0]]);
    sum += 0.5 * length(cross(vector3(points[triangle[1]]) - a, vector3(points[triangle[2]]) - a));
  }
  return sum;
}

TEST(SmoothSurface, PassThroughTheVerticesOfTheMeshExactly) {
  const SnapshotSurface sheet = arched_slit();
  const Smoothed smooth(sheet);
  ASSERT_GT(smooth.lips.points.size(), 20U);
  ASSERT_EQ(smooth.positions.size(), sheet.positions.size() + smooth.lips.points.size());
  EXPECT_TRUE(std::equal(sheet.positions.begin(), sheet.positions.end(), smooth.positions.begin()));
}

/// An edge of 1 mm leaves a circle of 6 mm by 21 um in its middle, a curve through the circle's tangents by 0.04 um;
/// the last edges of the slit, beside the corners at its ends, know the circle at one end only.
TEST(SmoothSurface, FollowACircleFarMoreCloselyThanTheEdgesOfTheMesh) {
  const SnapshotSurface sheet = arched_slit();
  const Smoothed smooth(sheet);
  int on_the_arc = 0;
  for (std::size_t k = 0; k < smooth.lips.points.size(); ++k) {
    const CurvePoint& point = smooth.lips.points[k];
    if (point.start < 121 || point.end < 121 || point.before < 121 || point.after < 121) continue;
    const Float3& place = smooth.positions[sheet.positions.size() + k];
    EXPECT_NEAR(std::hypot(place[0], place[1] + 0.8 * kRadius), kRadius, 0.2e-6) << k;
    ++on_the_arc;
  }
  EXPECT_GE(on_the_arc, 9);
}

TEST(SmoothSurface, LeaveAStraightLipStraightAndTheRestShapeAsItIs) {
  const SnapshotSurface sheet = test::slit_sheet(10, 0.001, 0);
  const Smoothed smooth(sheet);
  for (std::size_t v = sheet.positions.size(); v < smooth.positions.size(); ++v) {
    EXPECT_NEAR(smooth.positions[v][1], 0, 1e-9);
  }
  // Positions are single precision numbers of up to 5 mm.
  EXPECT_NEAR(area(*smooth.lips.topology, smooth.lips.topology->rest_positions),
              area(*sheet.topology, sheet.topology->rest_positions), 1e-9);
  EXPECT_EQ(smooth.lips.topology->thickness.size(), smooth.lips.topology->triangles.size());
  EXPECT_EQ(smooth.lips.topology->cut_times.size(), smooth.positions.size());
}

TEST(SmoothSurface, StayStraightWhereACutRunsOutOfASheet) {
  // The borders of the strip meet the lips at right angles; they are not how these go on.
  const SnapshotTopology strip = test::cut_strip();
  const Smoothed smooth({.body = "organ",
                         .topology = std::make_shared<SnapshotTopology>(strip),
                         .positions = strip.rest_positions,
                         .fields = {}});
  ASSERT_EQ(smooth.lips.points.size(), 6U);
  for (std::size_t v = strip.rest_positions.size(); v < smooth.positions.size(); ++v) {
    EXPECT_EQ(smooth.positions[v][0], 0.002F) << v;
  }
}

TEST(SmoothSurface, LeaveNoHoleBesideTheLips) {
  const SnapshotSurface sheet = test::slit_sheet(10, 0.001, 0);
  const Smoothed smooth(sheet);
  const std::size_t added = smooth.lips.points.size() / 3;
  EXPECT_EQ(border_edges(*smooth.lips.topology).size(), smooth.borders.size() + 3 * added);
}

TEST(SmoothSurface, AreLipsOfTheFinerSurfaceToo) {
  const Smoothed smooth(test::slit_sheet(10, 0.001, 0));
  const std::vector<char> is_lip = cut_lips(*smooth.lips.topology, border_edges(*smooth.lips.topology));
  for (std::size_t v = smooth.is_lip.size(); v < is_lip.size(); ++v) EXPECT_TRUE(is_lip[v]) << v;
}

TEST(SmoothSurface, NeverLeaveAnEdgeByMoreThanAFifthOfItsLength) {
  SnapshotSurface sheet = test::slit_sheet(10, 0.001, 0);
  // A lip that turns by 70 degrees at both ends of an edge, close to which its neighbours lie.
  sheet.positions[123] = {-0.0005F, 0, 0};
  sheet.positions[124] = {0.0005F, 0, 0};
  sheet.positions[122] = {-0.000534F, -0.000094F, 0};
  sheet.positions[125] = {0.000534F, -0.000094F, 0};
  const Smoothed smooth(sheet);
  for (std::size_t k = 0; k < smooth.lips.points.size(); ++k) {
    const CurvePoint& point = smooth.lips.points[k];
    const Vector3 a = vector3(sheet.positions[point.start]), b = vector3(sheet.positions[point.end]);
    const Vector3 straight = (1 - point.part) * a + point.part * b;
    EXPECT_LE(length(vector3(smooth.positions[sheet.positions.size() + k]) - straight), 0.2001 * length(b - a));
  }
}

TEST(SmoothSurface, AreNoneWhereNothingIsCut) {
  SnapshotTopology whole;
  whole.rest_positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  whole.triangles = {{0, 1, 2}};
  const SnapshotSurface sheet{.body = "organ",
                              .topology = std::make_shared<SnapshotTopology>(whole),
                              .positions = whole.rest_positions,
                              .fields = {}};
  const Smoothed smooth(sheet);
  EXPECT_TRUE(smooth.lips.points.empty());
  EXPECT_EQ(smooth.lips.topology, sheet.topology);
}

TEST(SmoothSurface, IsRoundThroughTheVerticesOfABall) {
  const SnapshotSurface ball = test::sphere("ball", {0, 0, 0}, 0.02, 2);
  const Smoothed smooth(ball);
  // 128 triangles of 8 mm: the middles of their edges lie 0.4 mm and more below the ball.
  ASSERT_EQ(smooth.lips.points.size(), 192U);
  EXPECT_TRUE(std::equal(ball.positions.begin(), ball.positions.end(), smooth.positions.begin()));
  for (std::size_t v = ball.positions.size(); v < smooth.positions.size(); ++v) {
    EXPECT_NEAR(length(vector3(smooth.positions[v])), 0.02, 0.00015);
  }
  EXPECT_TRUE(border_edges(*smooth.lips.topology).empty()) << "no cracks";
  EXPECT_EQ(smooth.lips.topology->triangles.size(), 4 * ball.topology->triangles.size());
}

TEST(SmoothSurface, IsTheMeshItselfWhereThatIsFineOrFlat) {
  const SnapshotSurface ball = test::sphere("ball", {0, 0, 0}, 0.02, 5);
  EXPECT_EQ(Smoothed(ball).lips.topology, ball.topology);
  const SnapshotSurface square = test::quad("sheet", {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}});
  EXPECT_EQ(Smoothed(square).lips.topology, square.topology);
}

TEST(SmoothSurface, LeavesTheEdgesOfCapsStraight) {
  const SnapshotSurface ball = test::sphere("ball", {0, 0, 0}, 0.02, 2);
  SnapshotTopology capped = *ball.topology;
  capped.cap_triangles = {capped.triangles.back()};
  capped.triangles.pop_back();
  const Smoothed smooth({.body = "organ",
                         .topology = std::make_shared<SnapshotTopology>(capped),
                         .positions = ball.positions,
                         .fields = {}});
  ASSERT_FALSE(smooth.lips.points.empty());
  EXPECT_TRUE(border_edges(*smooth.lips.topology).empty());
}

TEST(SmoothSurface, TheirMapOfWoundsGoesOnBetweenTheVertices) {
  const SnapshotSurface sheet = test::slit_sheet(10, 0.001, 0);
  const Smoothed smooth(sheet);
  const WoundMap coarse = map_wounds(*sheet.topology, smooth.borders, smooth.is_lip);
  const WoundMap fine = refined(coarse, smooth.lips);
  ASSERT_EQ(fine.lip.size(), smooth.positions.size());
  EXPECT_EQ(fine.ends.size(), coarse.ends.size());
  for (std::size_t k = 0; k < smooth.lips.points.size(); ++k) {
    const CurvePoint& point = smooth.lips.points[k];
    const std::size_t v = sheet.positions.size() + k;
    EXPECT_EQ(fine.lip[v], v);
    EXPECT_EQ(fine.from_lip[v], 0);
    EXPECT_NEAR(fine.from_end[v],
                (1 - point.part) * coarse.from_end[point.start] + point.part * coarse.from_end[point.end], 1e-15);
  }
}

}  // namespace
}  // namespace thinwall
