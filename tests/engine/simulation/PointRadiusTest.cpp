// The tip that a bare point on a membrane acts like.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/contact/PointRadius.hpp"
#include "engine/mesh/Shapes.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

constexpr double kRadius = 20e-3;  // metres, of the drum
constexpr double kDepth = 0.1e-3;  // metres, so small that the tension stays what it is

Body pressed_drum(int triangles, const Eigen::Vector2d& at) {
  BodyDefinition drum = make_body(make_disc(kRadius, triangles), 1e-3, neo_hookean(20e3));
  drum.fluid.kind = FluidKind::kNone;
  drum.prestretch = {{.first = 1.3, .second = 1.3}};
  drum.fixed = {{.region = BoundaryRegion{}}};
  Body body(drum, {point_tool()}, quasi_static());
  body.settle();
  move(body, pose_at({at.x(), at.y(), 1e-6}), {at.x(), at.y(), -kDepth}, 1, 1);
  return body;
}

double radius_of(const Body& body) {
  const Attachment& attachment = body.state().attachments.at(0);
  return effective_point_radius(body.model().definition.mesh.triangles, body.state().equilibrium.position,
                                attachment.vertices, attachment.weights);
}

double drum_force(double radius) {
  const double tension = 20e3 * 1e-3 * (1 - std::pow(1.3, -6));
  return 2 * std::numbers::pi * tension * kDepth / std::log(kRadius / radius);
}

TEST(PointRadius, GivesTheForceOfAPointOnADrumAtEveryRefinement) {
  double last = 1;
  for (const int triangles : {384, 1536, 6144}) {
    const Body body = pressed_drum(triangles, {0, 0});
    const double force = body.state().contacts[0].force.z(), expected = drum_force(radius_of(body));
    std::printf("%d triangles: acts like %.4f mm, force %.6f N, of such a tip %.6f N\n", triangles,
                1e3 * radius_of(body), force, expected);
    // Seen 0.2 %; the triangles are not all equilateral.
    EXPECT_NEAR(force, expected, 0.005 * expected);
    EXPECT_LT(force, 0.95 * last);
    last = force;
  }
}

TEST(PointRadius, IsLargerWhereThePointSpreadsItsForceOverATriangle) {
  const Body at_vertex = pressed_drum(1536, {0, 0}), within = pressed_drum(1536, {0.6e-3, 0.4e-3});
  EXPECT_GT(radius_of(within), 1.5 * radius_of(at_vertex));
  const double force = within.state().contacts[0].force.z();
  EXPECT_NEAR(force, drum_force(radius_of(within)), 0.03 * force);
}

TEST(PointRadius, OfALatticeOfEquilateralTrianglesIsThatOfItsResistance) {
  Eigen::VectorXd position(9);
  position << 0, 0, 0, 1, 0, 0, 0.5, std::sqrt(0.75), 0;
  const std::vector<Eigen::Vector3i> triangles = {{0, 1, 2}};
  EXPECT_NEAR(effective_point_radius(triangles, position, {0, 1, 2}, {1, 0, 0}), 0.162079, 1e-6);
  EXPECT_NEAR(effective_point_radius(triangles, position, {0, 1, 2}, {1. / 3, 1. / 3, 1. / 3}), 0.5430, 1e-3);
}

TEST(SeveralTools, PressAtOnceAndEachFeelsItsOwnForce) {
  Body both(pressurised_hemisphere(1024, 300), {sphere_tool(3e-3), sphere_tool(4e-3)}, quasi_static());
  both.settle();
  std::array<ToolPose, 2> from = {pose_at({-8e-3, 0, 22e-3}), pose_at({8e-3, 0, 22e-3})}, to = from;
  for (int step = 0; step < 10; ++step) {
    for (int k = 0; k < 2; ++k) to[k].tip.z() -= 0.6e-3;
    both.advance(from, to, 1);
    from = to;
  }
  const ToolContact &left = both.state().contacts[0], &right = both.state().contacts[1];
  std::printf("%.4f N and %.4f N\n", left.force.norm(), right.force.norm());
  EXPECT_GT(left.force.z(), 0.01);
  EXPECT_GT(right.force.z(), 0.01);
  EXPECT_LT((support_force(both) - left.force - right.force).norm(), 1e-8 * left.force.norm());
}

}  // namespace
}  // namespace thinwall
