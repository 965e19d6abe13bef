// What the supports hold, what the tool feels and what the masses resist add up, and the tool's force is the slope of
// the stored energy.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "engine/mesh/Shapes.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

struct Scene {
  const char* name;
  ToolDefinition tool;
  Eigen::Vector3d begin, end;  // metres, tip
  Analysis analysis;
  FluidKind fluid;
};

std::vector<Scene> scenes() {
  std::vector<Scene> all;
  for (const Analysis analysis : {Analysis::kQuasiStatic, Analysis::kDynamic}) {
    for (const FluidKind fluid : {FluidKind::kIncompressible, FluidKind::kCompressible}) {
      all.push_back({"point", point_tool(), {1.3e-3, 0.4e-3, 23e-3}, {1.3e-3, 0.9e-3, 17e-3}, analysis, fluid});
      all.push_back({"line", line_tool(8e-3), {0.4e-3, 0, 23e-3}, {0.4e-3, 0.5e-3, 17e-3}, analysis, fluid});
      all.push_back({"sphere", sphere_tool(5e-3), {3e-3, 1e-3, 23e-3}, {2e-3, 1e-3, 17e-3}, analysis, fluid});
    }
  }
  return all;
}

Body make_scene_body(const Scene& scene) {
  BodyDefinition definition = pressurised_hemisphere(256, 300);
  definition.fluid.kind = scene.fluid;
  definition.fluid.bulk_modulus = 50e3;
  SimulationOptions options;
  options.analysis = scene.analysis;
  Body body(definition, {scene.tool}, options);
  body.settle();
  return body;
}

const char* words(const Scene& scene) {
  if (scene.analysis == Analysis::kDynamic) {
    return scene.fluid == FluidKind::kIncompressible ? "dynamic, incompressible" : "dynamic, compressible";
  }
  return scene.fluid == FluidKind::kIncompressible ? "quasi-static, incompressible" : "quasi-static, compressible";
}

TEST(ForceBalance, SupportsHoldWhatTheToolPressesAndWhatTheMassesResist) {
  double seen = 0;
  for (const Scene& scene : scenes()) {
    Body body = make_scene_body(scene);
    double largest = 0, worst = 0;
    move(body, pose_at(scene.begin), scene.end, 12, 5e-3, [&](const ToolPose&) {
      const BodyState& state = body.state();
      const Eigen::Vector3d tool = state.contacts[0].force;
      const Eigen::Vector3d support = support_force(body);
      const Eigen::Vector3d inertia = momentum_rate(body);
      // The base carries the wall's pull and the pressure on its cap; both are far larger than their difference.
      const double load = std::max({tool.norm(), support.norm(), state.equilibrium.pressure[0] * 1e-3});
      largest = std::max(largest, tool.norm());
      worst = std::max(worst, (support - tool - inertia).norm() / load);
    });
    EXPECT_GT(largest, 0.01) << scene.name;
    EXPECT_LT(worst, 1e-8) << scene.name << ", " << words(scene);
    seen = std::max(seen, worst);
  }
  std::printf("largest imbalance over the largest load: %.1e\n", seen);
}

TEST(ForceBalance, FreeQuasiStaticBodyWithoutToolsCarriesNoNetForce) {
  BodyDefinition definition = make_body(make_sphere(20e-3, 320), 1e-3, mooney_rivlin(8e3, 2e3));
  definition.fluid.initial_pressure = 400;
  Body body(definition, {}, quasi_static());
  body.settle();
  const Eigen::VectorXd forces = internal_forces(body);
  EXPECT_LT(forces.cwiseAbs().maxCoeff(), 1e-8 * largest_single_force(body));
  EXPECT_LT(body.state().equilibrium.rigid_reaction.cwiseAbs().maxCoeff(), 1e-8 * largest_single_force(body));
}

struct Press {
  ToolDefinition tool;
  BodyDefinition body;
  Eigen::Vector3d above, deep, aside;  // metres, where the tip begins, is pressed to, and is held
  std::vector<int> axes;               // along which it can move
};

Press point_press() {
  return {.tool = point_tool(),
          .body = pressurised_hemisphere(256, 300),
          .above = {1.3e-3, 0.4e-3, 22e-3},
          .deep = {1.3e-3, 0.4e-3, 18e-3},
          .aside = {1.6e-3, 0.6e-3, 17e-3},
          .axes = {0, 1, 2}};
}

/// Along the crown, where all points that it will ever hold are met at once. Its ends are guided along y.
Press line_press() {
  return {.tool = line_tool(10e-3),
          .body = fingerpad(5e-3, 500),
          .above = {0, 0, 10.1e-3},
          .deep = {0, 0, 8e-3},
          .aside = {0.4e-3, 0, 7e-3},
          .axes = {0, 2}};
}

/// Stored energy and tool force after quasi-static steps to `aside` and on to `aside + step`.
struct Pressed {
  double energy;          // joule
  Eigen::Vector3d force;  // newton
};

Pressed pressed_to(const Press& press, FluidKind fluid, const Eigen::Vector3d& step) {
  BodyDefinition definition = press.body;
  definition.fluid.kind = fluid;
  definition.fluid.bulk_modulus = 50e3;
  Body body(definition, {press.tool}, quasi_static());
  body.settle();
  ToolPose pose = move(body, pose_at(press.above), press.deep, 2, 1);
  pose = move(body, pose, press.aside, 2, 1);
  move(body, pose, press.aside + step, 1, 1);
  return {.energy = body.state().books.stored(), .force = body.state().contacts[0].force};
}

TEST(ForceBalance, MultiplierOfAPointOrLineToolIsTheSlopeOfTheStoredEnergy) {
  // Central differences over h err by h^2 times the third derivative, so halving h quarters the error. In all
  // directions, as the tool holds the tissue sideways too.
  for (const FluidKind fluid : {FluidKind::kIncompressible, FluidKind::kCompressible}) {
    for (const Press& press : {point_press(), line_press()}) {
      const Pressed here = pressed_to(press, fluid, Eigen::Vector3d::Zero());
      ASSERT_GT(here.force.norm(), 0.01);
      for (const int axis : press.axes) {
        std::array<double, 2> error{};
        for (int level = 0; level < 2; ++level) {
          const double h = level == 0 ? 2e-4 : 1e-4;
          const Eigen::Vector3d step = h * Eigen::Vector3d::Unit(axis);
          const double difference =
              (pressed_to(press, fluid, step).energy - pressed_to(press, fluid, -step).energy) / (2 * h);
          error[level] = std::abs(difference + here.force[axis]);  // the tissue's force on the tool resists
        }
        std::printf("%s, axis %d: force %.6f N, errors of the differences %.2e, %.2e\n", press.tool.name.c_str(), axis,
                    here.force[axis], error[0], error[1]);
        EXPECT_LT(error[1], 1e-3 * here.force.norm()) << press.tool.name << axis;
        EXPECT_NEAR(error[0] / error[1], 4, 0.5) << press.tool.name << axis;
      }
    }
  }
}

}  // namespace
}  // namespace thinwall
