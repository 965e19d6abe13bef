// What does not depend on where the scene is, how it is turned, mirrored or run.

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <Eigen/Geometry>
#include <cmath>
#include <utility>

#include "engine/mesh/Shapes.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

struct Scene {
  BodyDefinition body;
  ToolDefinition tool;
  ToolPose begin;
  Eigen::Vector3d end;
  Analysis analysis;
};

std::vector<Scene> scenes() {
  BodyDefinition supported = pressurised_hemisphere(256, 300);
  BodyDefinition free = make_body(make_sphere(20e-3, 320), 1e-3, mooney_rivlin(8e3, 2e3));
  free.fluid.initial_pressure = 300;
  const Eigen::Vector3d slanting = Eigen::Vector3d(0.2, -0.1, -1).normalized();
  const Eigen::Vector3d above(1.3e-3, 0.4e-3, 24e-3);
  std::vector<Scene> all;
  for (const Analysis analysis : {Analysis::kQuasiStatic, Analysis::kDynamic}) {
    for (const BodyDefinition& body : {supported, free}) {
      for (const ToolDefinition& tool : {point_tool(), line_tool(8e-3), sphere_tool(5e-3)}) {
        all.push_back({body, tool, pose_at(above, slanting), above + 7e-3 * slanting, analysis});
      }
    }
  }
  return all;
}

struct Result {
  Eigen::VectorXd position;
  Eigen::Vector3d force;
  double pressure;
};

Result run(const Scene& scene) {
  SimulationOptions options;
  options.analysis = scene.analysis;
  Body body(scene.body, {scene.tool}, options);
  body.settle();
  move(body, scene.begin, scene.end, 10, 5e-3);
  return {body.state().equilibrium.position, body.state().contacts[0].force, body.state().equilibrium.pressure[0]};
}

/// The scene under x -> turn x + shift; a mirroring turns the triangles over.
Scene moved(Scene scene, const Eigen::Matrix3d& turn, const Eigen::Vector3d& shift) {
  for (Eigen::Vector3d& vertex : scene.body.mesh.vertices) vertex = (turn * vertex + shift).eval();
  if (turn.determinant() < 0) {
    for (auto* list : {&scene.body.mesh.triangles, &scene.body.mesh.cap_triangles}) {
      for (Eigen::Vector3i& triangle : *list) std::swap(triangle[1], triangle[2]);
    }
  }
  scene.begin = {.tip = turn * scene.begin.tip + shift,
                 .direction = turn * scene.begin.direction,
                 .axis = turn * scene.begin.axis};
  scene.end = turn * scene.end + shift;
  return scene;
}

void expect_moved(const Eigen::Matrix3d& turn, const Eigen::Vector3d& shift) {
  // Residuals seen up to 2e-10 of the displacement and 1e-10 of the force; Newton's tolerance leaves 1e-9.
  for (const Scene& scene : scenes()) {
    const Result here = run(scene), there = run(moved(scene, turn, shift));
    double off = 0;
    for (Eigen::Index v = 0; v < here.position.size() / 3; ++v) {
      off = std::max(off, (turn * here.position.segment<3>(3 * v) + shift - there.position.segment<3>(3 * v)).norm());
    }
    EXPECT_GT(here.force.norm(), 1e-3) << scene.tool.name;
    EXPECT_LT(off, 1e-8 * 20e-3) << scene.tool.name;
    EXPECT_LT((turn * here.force - there.force).norm(), 1e-7 * here.force.norm()) << scene.tool.name;
    EXPECT_NEAR(here.pressure, there.pressure, 1e-7 * here.pressure) << scene.tool.name;
  }
}

TEST(Symmetry, TurnedAndShiftedSceneGivesTheTurnedAndShiftedResult) {
  expect_moved(Eigen::AngleAxisd(2.1, Eigen::Vector3d(0.4, 0.7, -0.3).normalized()).toRotationMatrix(),
               {0.05, -0.03, 0.02});
}

TEST(Symmetry, MirroredSceneGivesTheMirroredResult) {
  expect_moved(Eigen::Vector3d(-1, 1, 1).asDiagonal().toDenseMatrix(), Eigen::Vector3d::Zero());
}

TEST(Determinism, EqualScenesGiveEqualBits) {
  for (const Scene& scene : scenes()) {
    const Result first = run(scene), second = run(scene);
    EXPECT_EQ(first.position, second.position) << scene.tool.name;
    EXPECT_EQ(first.force, second.force) << scene.tool.name;
  }
}

TEST(Determinism, NumberOfThreadsDoesNotChangeABit) {
  // Fine enough for several batches of triangles.
  Scene scene = scenes().back();
  scene.body = pressurised_hemisphere(2304, 300);
  std::vector<Result> results;
  for (const int threads : {1, 2, 4}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    results.push_back(run(scene));
  }
  EXPECT_EQ(results[0].position, results[1].position);
  EXPECT_EQ(results[0].position, results[2].position);
  EXPECT_EQ(results[0].force, results[1].force);
}

}  // namespace
}  // namespace thinwall
