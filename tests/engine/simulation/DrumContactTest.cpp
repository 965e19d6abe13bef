// A ball on a pretensioned drum, against the closed form of a membrane of even tension: it leaves the ball at the
// contact radius c tangentially, w = (c^2 / R) ln(a / r) outside, so that depth = c^2 / (2 R) + (c^2 / R) ln(a / c) and
// force = 2 pi T c^2 / R.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/mesh/Shapes.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

constexpr double kRadius = 20e-3;    // metres, of the drum and of the ball
constexpr double kModulus = 20e3;    // pascal
constexpr double kThickness = 1e-3;  // metres
constexpr double kPrestretch = 1.3;

double tension() {
  return kModulus * kThickness * (1 - std::pow(kPrestretch, -6));
}

/// A clamped disc whose triangles are seven times smaller in the middle than an even mesh of as many.
BodyDefinition drum(int triangles) {
  SurfaceMesh mesh = make_disc(kRadius, triangles);
  const double grading = 4;
  for (Eigen::Vector3d& vertex : mesh.vertices) {
    const double r = vertex.norm() / kRadius;
    if (r > 0) vertex *= std::sinh(grading * r) / std::sinh(grading) / r;
  }
  BodyDefinition body = make_body(std::move(mesh), kThickness, neo_hookean(kModulus));
  body.fluid.kind = FluidKind::kNone;
  body.prestretch = {{.first = kPrestretch, .second = kPrestretch}};
  body.fixed = {{.region = BoundaryRegion{}}};
  return body;
}

TEST(DrumContact, ForceAndAreaOfABallAreThoseOfTheClosedForm) {
  const ToolDefinition ball = sphere_tool(kRadius);
  for (const int triangles : {3456, 9600}) {
    Body body(drum(triangles), {ball}, quasi_static());
    body.settle();
    ToolPose pose = pose_at({0, 0, 1e-6});
    for (const double part : {0.04, 0.06, 0.08, 0.10}) {
      const double c = part * kRadius;
      const double depth = c * c / (2 * kRadius) + c * c / kRadius * std::log(kRadius / c);
      pose = move(body, pose, {0, 0, -depth}, 4, 1);
      const ToolContact& contact = body.state().contacts[0];
      const double force = 2 * std::numbers::pi * tension() * c * c / kRadius;
      const double area = std::numbers::pi * c * c;
      std::printf("%d triangles, c/R %.2f: force %.6f N, %+.2f %%; area %.4f mm^2, %+.2f %%; %d iterations\n",
                  triangles, part, contact.force.z(), 100 * (contact.force.z() / force - 1), 1e6 * contact.area,
                  100 * (contact.area / area - 1), body.report().newton_iterations);
      EXPECT_NEAR(contact.force.z(), force, 0.02 * force);
      EXPECT_NEAR(contact.area, area, 0.05 * area);
    }
  }
}

}  // namespace
}  // namespace thinwall
