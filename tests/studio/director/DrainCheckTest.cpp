#include "studio/director/DrainCheck.hpp"

#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <vector>

#include "engine/mesh/Shapes.hpp"
#include "studio/scenario/InputError.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

/// Two balls of one wall, a smaller and a larger one, at rest; with an orifice between them or without.
Body two_balls(bool has_orifice) {
  SurfaceMesh mesh = make_sphere(0.02, 80);
  const SurfaceMesh other = make_sphere(0.025, 80);
  const int count = static_cast<int>(mesh.vertices.size());
  for (const Eigen::Vector3d& vertex : other.vertices) mesh.vertices.push_back(vertex + Eigen::Vector3d(0.06, 0, 0));
  for (const Eigen::Vector3i& triangle : other.triangles) mesh.triangles.push_back(triangle.array() + count);
  BodyDefinition definition = make_body(mesh, 1e-3, mooney_rivlin(8e3, 2e3));
  definition.fixed = {{.region = BelowRegion{.axis = 2, .at = -0.015}}};
  definition.fluid.chambers = {{.name = "small"}, {.name = "large", .inside = {0.06, 0, 0}}};
  if (has_orifice) definition.fluid.orifices = {{.from = 0, .to = 1, .area = 1e-6}};
  Body body(definition, {}, quasi_static());
  body.settle();
  return body;
}

/// What is said of clips that drain the chambers one after the other, metres^3; empty when nothing is.
std::string told_of_draining(const Body& body, double small, double large) {
  const std::vector<Clip> timeline(2);
  std::vector<ScheduledClip> clips;
  for (const auto& [chamber, name, drained] : {std::tuple(0, "small", small), std::tuple(1, "large", large)}) {
    const FillClip clip{.body = "balls", .chamber = name, .added = -drained, .drains = true};
    clips.push_back({.plan = FillPlan{.clip = clip, .chamber = chamber}, .begin = static_cast<double>(chamber)});
  }
  try {
    refuse_overdrawn(timeline, clips, [&](const std::string&) -> const Body& { return body; });
  } catch (const InputErrors& refusal) {
    return refusal.what();
  }
  return "";
}

TEST(DrainCheck, OfChambersByThemselvesEachGivesWhatItHolds) {
  const Body balls = two_balls(false);
  const Eigen::VectorXd& held = balls.state().fluid_volume;
  EXPECT_EQ(told_of_draining(balls, 0.9 * held[0], 0.9 * held[1]), "");
  const std::string told = told_of_draining(balls, 1.1 * held[0], 0.9 * held[1]);
  EXPECT_NE(told.find("chamber `small` of body `balls` holds"), std::string::npos) << told;
}

TEST(DrainCheck, ChambersThatOrificesJoinGiveWhatTheyHoldTogether) {
  const Body balls = two_balls(true);
  const Eigen::VectorXd& held = balls.state().fluid_volume;
  EXPECT_EQ(told_of_draining(balls, 1.1 * held[0], 0.8 * held[1]), "");
  const std::string told = told_of_draining(balls, 1.1 * held[0], held[1]);
  EXPECT_NE(told.find("that body `balls` holds"), std::string::npos) << told;
}

}  // namespace
}  // namespace thinwall
