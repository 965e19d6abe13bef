// Many small bodies with parameters drawn at random, all of them ordinary: none may fail.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>
#include <string>

#include "engine/mesh/Shapes.hpp"
#include "engine/simulation/SimulationFailure.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

struct Draw {
  BodyDefinition body;
  ToolDefinition tool;
  SimulationOptions options;
  Eigen::Vector3d aim = Eigen::Vector3d::Zero();  // metres, beside the axis
  double depth = 0;                               // metres
  double speed = 0;                               // metres / second
  std::string words;
};

class Drawer {
 public:
  explicit Drawer(unsigned seed) : random_(seed) {}

  Draw draw() {
    Draw draw;
    std::ostringstream words;
    const double radius = 20e-3, modulus = between(10e3, 80e3), thickness = between(0.5e-3, 2e-3);
    const int triangles = 60 + pick(400);
    const int shape = pick(4), law = pick(3), fluid = pick(2), tool = pick(3);
    static constexpr const char* kShapes[] = {"sphere", "hemisphere", "semicylinder", "cylinder"};
    static constexpr const char* kFluids[] = {"incompressible", "compressible"};
    const SurfaceMesh mesh = shape == 0   ? make_sphere(radius, triangles)
                             : shape == 1 ? make_hemisphere(radius, triangles)
                             : shape == 2 ? make_semicylinder(radius, 30e-3, triangles)
                                          : make_cylinder(radius, 40e-3, triangles);
    const Material material = law == 0   ? neo_hookean(modulus)
                              : law == 1 ? mooney_rivlin(0.4 * modulus, 0.1 * modulus)
                                         : st_venant_kirchhoff(3 * modulus, 0.4);
    draw.body = make_body(mesh, thickness, material);
    draw.body.fluid.kind = fluid == 0 ? FluidKind::kIncompressible : FluidKind::kCompressible;
    draw.body.fluid.bulk_modulus = between(50e3, 500e3);
    if (shape == 1 || shape == 2) draw.body.fixed.push_back(fixed_group("base"));
    if (shape == 2 || shape == 3) draw.body.fixed.push_back(fixed_group("ends"));
    // Up to a third of what a balloon of that wall holds.
    const double pressure = pick(4) == 0 ? 0 : between(0.02, 0.33) * 1.2 * modulus * thickness / radius;
    draw.body.fluid.initial_pressure = pressure;
    draw.tool = tool == 0   ? point_tool()
                : tool == 1 ? line_tool(between(5e-3, 25e-3))
                            : sphere_tool(between(2e-3, 10e-3));
    draw.options.analysis = pick(2) == 0 ? Analysis::kQuasiStatic : Analysis::kDynamic;
    draw.options.time_step = between(2e-3, 20e-3);
    draw.aim = {between(-5e-3, 5e-3), between(-5e-3, 5e-3), 0};
    draw.depth = between(1e-3, 7e-3);
    draw.speed = between(5e-3, 80e-3);
    words << kShapes[shape] << " of " << mesh.triangles.size() << " triangles, " << material.law->name << " " << modulus
          << " Pa, " << thickness * 1e3 << " mm, " << kFluids[fluid] << " at " << pressure << " Pa, " << draw.tool.name
          << " (length " << draw.tool.length * 1e3 << ", radius " << draw.tool.radius * 1e3 << " mm), "
          << (draw.options.analysis == Analysis::kDynamic ? "dynamic" : "quasi-static") << ", step "
          << draw.options.time_step * 1e3 << " ms, aim " << draw.aim.head<2>().transpose() * 1e3 << " mm, depth "
          << draw.depth * 1e3 << " mm at " << draw.speed * 1e3 << " mm/s";
    draw.words = words.str();
    return draw;
  }

 private:
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  int pick(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }

  std::mt19937 random_;
};

struct Outcome {
  int steps = 0, halvings = 0, most_iterations = 0;
  double residual_books = 0;  // imbalance of the books over the tool's work
};

Outcome palpate(const Draw& draw) {
  Outcome outcome;
  Body body(draw.body, {draw.tool}, draw.options);
  body.settle();
  const ToolPose far = pose_at(draw.aim + Eigen::Vector3d(0, 0, 60e-3));
  const auto travel = travel_to_contact(body.surface(), draw.tool, far, far.direction);
  if (!travel) return outcome;
  const Eigen::Vector3d start = far.tip + (*travel - 1e-3) * far.direction;
  const Eigen::Vector3d deep = start + (1e-3 + draw.depth) * far.direction;
  const int steps = std::clamp(static_cast<int>((draw.depth + 1e-3) / (draw.speed * draw.options.time_step)), 4, 40);
  double work = 0;
  const auto note = [&](const ToolPose&) {
    ++outcome.steps;
    outcome.halvings += body.report().halvings;
    outcome.most_iterations = std::max(outcome.most_iterations, body.report().newton_iterations);
    work = std::max(work, body.state().books.tool_work);
    outcome.residual_books = std::max(outcome.residual_books, std::abs(body.state().books.imbalance()));
  };
  ToolPose pose = move(body, pose_at(start), deep, steps, draw.options.time_step, note);
  pose = move(body, pose, deep, 3, draw.options.time_step, note);
  move(body, pose, start, steps, draw.options.time_step, note);
  outcome.residual_books /= std::max(work, 1e-9);
  return outcome;
}

TEST(Robustness, OrdinaryBodiesDrawnAtRandomAreAllPalpated) {
  constexpr int kBodies = 30;
  Drawer drawer(20);
  int failed = 0, halvings = 0, steps = 0;
  for (int k = 0; k < kBodies; ++k) {
    const Draw draw = drawer.draw();
    try {
      const Outcome outcome = palpate(draw);
      steps += outcome.steps;
      halvings += outcome.halvings;
      if (outcome.halvings > 0 || outcome.most_iterations > 40) {
        std::printf("%2d: %d halvings, up to %d iterations a step: %s\n", k, outcome.halvings, outcome.most_iterations,
                    draw.words.c_str());
      }
      EXPECT_LT(outcome.residual_books, 1e-7) << draw.words;
    } catch (const SimulationFailure& failure) {
      ++failed;
      ADD_FAILURE() << k << ": " << draw.words << ": " << failure.what();
    }
  }
  std::printf("%d of %d bodies failed; %d steps, %d halvings\n", failed, kBodies, steps, halvings);
}

/// Why a body that is blown up to a pressure above what its wall bears fails.
std::string end_of_burst(SimulationOptions options) {
  BodyDefinition definition = make_body(make_sphere(20e-3, 80), 1e-3, neo_hookean(20e3));
  definition.fluid.initial_pressure = 300;
  Body body(definition, {}, options);
  body.settle();
  try {
    // Balloons of that wall bear 1240 Pa (0.62 of 2 mu h / R).
    for (double pressure = 400; pressure < 5e3; pressure += 100) {
      body.advance({}, {}, 10e-3, {.load_factors = {}, .fluids = {{.pressure = pressure}}});
    }
  } catch (const SimulationFailure& failure) {
    return failure.what();
  }
  return "it did not fail";
}

TEST(Robustness, ABodyThatBurstsInMotionIsSaidToHaveGrown) {
  const std::string reason = end_of_burst(dynamic());
  EXPECT_NE(reason.find("; it has grown to "), std::string::npos) << reason;
  EXPECT_NE(reason.find(" times its volume, and a wall holds only so much pressure"), std::string::npos) << reason;
}

TEST(Robustness, APressureThatNoWallBearsIsRefusedWithTheLargestThatItDoes) {
  BodyDefinition definition = make_body(make_sphere(20e-3, 320), 1e-3, neo_hookean(20e3));
  definition.fluid.initial_pressure = 2000;
  Body body(definition, {}, quasi_static());
  try {
    body.settle();
    FAIL() << "it bears " << body.state().volume[0] << " m^3";
  } catch (const SimulationFailure& failure) {
    const std::string what = failure.what(), words = "its wall bears ";
    ASSERT_NE(what.find("it bursts: "), std::string::npos) << what;
    const std::size_t at = what.find(words);
    ASSERT_NE(at, std::string::npos) << what;
    // 2 mu h / R (1 / stretch - 1 / stretch^7) at the limit point, stretch^6 = 7 (Treloar 1975). Found on steps of 15 %
    // of the volume, and of flat triangles.
    const double exact = 2 * 20e3 * 1e-3 / 20e-3 * (std::pow(7, -1.0 / 6) - std::pow(7, -7.0 / 6));
    EXPECT_NEAR(std::stod(what.substr(at + words.size())), exact, 0.02 * exact) << what;
  }
}

TEST(Robustness, AStepThatTakesTooManyIterationsIsGivenUp) {
  SimulationOptions options = dynamic();
  const auto divisions = [&] {
    const std::string reason = end_of_burst(options), words = "with the step divided ";
    const std::size_t at = reason.find(words);
    return at == std::string::npos ? 0 : std::stoi(reason.substr(at + words.size()));
  };
  const int all = divisions();
  options.maximum_step_iterations = 100;
  const int few = divisions();
  EXPECT_GT(few, 0);
  EXPECT_LT(few, all);
  EXPECT_NE(end_of_burst(options).find(" iterations in all"), std::string::npos);
}

}  // namespace
}  // namespace thinwall
