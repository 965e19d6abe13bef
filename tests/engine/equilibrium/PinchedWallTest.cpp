// Jaws that close on a single layer of wall: how hard they squeeze it, and that it stays between them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/mesh/Shapes.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

constexpr double kModulus = 60e3;    // pascal, Young's
constexpr double kThickness = 1e-3;  // metres
constexpr double kHalfLength = 0.01;

/// A flap of 20 mm in z = 0 that is held at x = -10 mm, of bending stiffness so that it stands out by itself.
BodyDefinition flap() {
  BodyDefinition flap =
      make_body(make_sheet(2 * kHalfLength, 2 * kHalfLength, 800), kThickness, neo_hookean(kModulus / 3));
  flap.fluid.kind = FluidKind::kNone;
  flap.model = WallModel::kShell;
  flap.fixed = {{.region = BelowRegion{.axis = 0, .at = -kHalfLength + 1e-6}}};
  return flap;
}

const ToolDefinition kForceps{.name = "grip",
                              .kind = ToolKind::kForceps,
                              .length = 0.03,
                              .width = 0.006,
                              .thickness = 0.002,
                              .opening = 0.004,
                              .friction = 0.8};

/// Jaws that reach over the free edge by 4 mm, along the flap.
ToolPose over_the_edge(double opening) {
  ToolPose pose = pose_at({kHalfLength - 0.004, 0, 0}, -Eigen::Vector3d::UnitX());
  pose.axis = Eigen::Vector3d::UnitY();
  pose.opening = opening;
  return pose;
}

/// A flap between jaws that have closed to `opening`, metres.
Body pinched(double opening, const ToolDefinition& forceps = kForceps) {
  Body body(flap(), {forceps}, dynamic());
  body.settle();
  ToolPose now = over_the_edge(kForceps.opening);
  const int steps = 40;
  for (int k = 1; k <= steps; ++k) {
    const ToolPose next = over_the_edge(kForceps.opening + (opening - kForceps.opening) * k / steps);
    body.advance({&now, 1}, {&next, 1}, 5e-3);
    now = next;
  }
  return body;
}

TEST(PinchedWall, IsSqueezedAsItYieldsAcrossWhereJawsLeaveItLessRoomThanItIsThick) {
  double first = 0;  // metres^2
  for (const double opening : {0.7e-3, 0.5e-3, 0.3e-3}) {
    Body body = pinched(opening);
    const double squeeze = body.squeeze(0, over_the_edge(opening));
    const double area = squeeze / (kModulus * (1 - opening / kThickness));
    std::printf("%.1f mm: %.4f N, as over %.2f mm^2\n", 1e3 * opening, squeeze, 1e6 * area);
    // 3.5 mm by 5 mm lie between their plane sides, and vertices 1 mm apart stand for all: always the same ones.
    EXPECT_GT(area, 14e-6);
    EXPECT_LT(area, 19e-6);
    if (first == 0) first = area;
    EXPECT_NEAR(area, first, 1e-3 * first) << "the force rises evenly";
  }
}

TEST(PinchedWall, IsLeftAloneByJawsThatLeaveItRoom) {
  Body body = pinched(1.05 * kThickness);
  EXPECT_EQ(body.squeeze(0, over_the_edge(1.05 * kThickness)), 0);
  EXPECT_FALSE(body.state().contacts[0].touching);
}

TEST(PinchedWall, GoesWhereTheJawsGoAndPullsThemBack) {
  const double opening = 0.5 * kThickness, way = 2e-3;
  Body body = pinched(opening);
  const ToolPose begin = over_the_edge(opening);
  const Eigen::VectorXd before = body.state().equilibrium.position;
  move(body, begin, begin.tip + way * Eigen::Vector3d::UnitX(), 20, 10e-3);
  double least = 1, most = 0;
  for (int v = 0; v < body.model().vertices(); ++v) {
    const Eigen::Vector3d rest = before.segment<3>(3 * v);
    if (rest.x() < kHalfLength - 3e-3 || std::abs(rest.y()) > 2e-3) continue;
    const double moved = body.state().equilibrium.position[3 * v] - rest.x();
    least = std::min(least, moved);
    most = std::max(most, moved);
  }
  const Eigen::Vector3d force = body.state().contacts[0].force;
  std::printf("moved by %.4f to %.4f mm, pulled back by %.4f N\n", 1e3 * least, 1e3 * most, -force.x());
  // They stick: all but the give of friction.
  EXPECT_NEAR(least, way, 2e-6);
  EXPECT_NEAR(most, way, 2e-6);
  // E h w e at a strain of 2 / 16: as wide as the flap 0.15 N, as the jaws 0.045 N.
  EXPECT_LT(force.x(), -0.045);
  EXPECT_GT(force.x(), -0.15);
}

TEST(PinchedWall, IsNeverPulledHarderThanFrictionHoldsIt) {
  const double opening = 0.7 * kThickness;
  ToolDefinition smooth = kForceps;
  smooth.friction = 0.1;
  Body body = pinched(opening, smooth);
  const ToolPose begin = over_the_edge(opening);
  double hardest = 0;  // newton
  move(body, begin, begin.tip + 6e-3 * Eigen::Vector3d::UnitX(), 60, 10e-3, [&](const ToolPose& now) {
    const double pull = -body.state().contacts[0].force.x();
    hardest = std::max(hardest, pull);
    EXPECT_LE(pull, 2 * smooth.friction * body.squeeze(0, now) * (1 + 1e-3)) << "on both of its sides";
  });
  std::printf("pulled with %.4f N at most\n", hardest);
  EXPECT_GT(hardest, 0.05);
  EXPECT_FALSE(body.state().contacts[0].touching) << "it has slipped out";
}

}  // namespace
}  // namespace thinwall
