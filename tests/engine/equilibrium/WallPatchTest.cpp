#include "engine/equilibrium/WallPatch.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "engine/contact/FoldPotential.hpp"
#include "engine/equilibrium/PatchEnergy.hpp"
#include "engine/equilibrium/PatchRelaxation.hpp"
#include "engine/mesh/Shapes.hpp"
#include "engine/solver/BlockPattern.hpp"
#include "tests/engine/simulation/DrawnBlade.hpp"
#include "tests/engine/simulation/RandomNumbers.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

constexpr double kRadius = 20e-3;  // metres

/// A membrane that is in motion, somewhat out of shape.
struct MovingWall {
  BodyModel model = make_body_model(make_body(make_hemisphere(kRadius, 4096), 1e-3, neo_hookean(20e3)));
  EquilibriumProblem problem;
  Eigen::VectorXd position = model.rest_position;  // metres
  Eigen::VectorXd force;                           // newton, any
  std::vector<char> held = std::vector<char>(model.vertices(), 0);

  MovingWall() {
    RandomNumbers numbers(1, 1);
    for (double& place : position) place = 1.05 * place + numbers.between(-2e-5, 2e-5);
    problem.inertia = 1e4;
    problem.inertia_target = model.rest_position;
    force = Eigen::VectorXd::Zero(model.unknowns());
    force[3 * middle()] = 1e-3;
  }

  /// A vertex far from the border.
  int middle() const {
    int highest = 0;
    for (int v = 0; v < model.vertices(); ++v) {
      if (model.rest_position[3 * v + 2] > model.rest_position[3 * highest + 2]) highest = v;
    }
    return highest;
  }

  /// A vertex that shares an edge with it.
  int neighbour() const {
    for (const Eigen::Vector3i& triangle : model.surface) {
      for (int k = 0; k < 3; ++k) {
        if (triangle[k] == middle()) return triangle[(k + 1) % 3];
      }
    }
    return -1;
  }

  /// A vertex of the patch's middle and the triangle opposite an edge from it, taken to be near each other.
  std::vector<NearPair> folds(const WallPatch& patch) const {
    const auto lacks_middle = [&](int t) { return (model.surface[t].array() != middle()).all(); };
    const int t = *std::ranges::find_if(patch.triangles, lacks_middle);
    const Eigen::Vector3i& corners = model.surface[t];
    return {{.kind = PairKind::kPointTriangle,
             .vertices = {middle(), corners[0], corners[1], corners[2]},
             .range = 5e-3,
             .area = 1e-6,
             .parallel = 0}};
  }
};

/// A patch and its energy about a place.
struct Patched : MovingWall {
  WallPatch patch = patch_around(model, force, held).value();
  PatchEnergy energy{model, problem, patch, folds(patch), 1e3, position, force};
};

TEST(WallPatchTest, ReachesTwoRingsFromTheForce) {
  const MovingWall wall;
  const auto patch = patch_around(wall.model, wall.force, wall.held);
  ASSERT_TRUE(patch);
  std::vector<char> rings(wall.model.vertices(), 0);
  rings[wall.middle()] = 1;
  for (int ring = 0; ring < 2; ++ring) {
    const std::vector<char> inner = rings;
    for (const Eigen::Vector3i& triangle : wall.model.surface) {
      if (inner[triangle[0]] || inner[triangle[1]] || inner[triangle[2]]) {
        for (const int vertex : triangle) rings[vertex] = 1;
      }
    }
  }
  EXPECT_EQ(patch->has, rings);
  EXPECT_EQ(patch->unknowns.size(), 3 * static_cast<std::size_t>(std::ranges::count(rings, 1)));
}

TEST(WallPatchTest, LeavesOutWhatIsHeldOrFixed) {
  MovingWall wall;
  const int held = wall.neighbour();
  ASSERT_TRUE(patch_around(wall.model, wall.force, wall.held)->has[held]);
  wall.held[held] = 1;
  wall.model.fixed[3 * wall.middle() + 1] = 1;
  const auto patch = patch_around(wall.model, wall.force, wall.held);
  ASSERT_TRUE(patch);
  EXPECT_FALSE(patch->has[held]);
  EXPECT_EQ(patch->number[3 * held], -1);
  EXPECT_EQ(patch->number[3 * wall.middle() + 1], -1);
  EXPECT_GE(patch->number[3 * wall.middle()], 0);
}

TEST(WallPatchTest, IsNoneWhereTheForceIsSpreadOrTheWallIsSmall) {
  MovingWall wall;
  EXPECT_FALSE(patch_around(wall.model, Eigen::VectorXd::Ones(wall.model.unknowns()), wall.held));
  const BodyModel small = make_body_model(make_body(make_hemisphere(kRadius, 400), 1e-3, neo_hookean(20e3)));
  Eigen::VectorXd force = Eigen::VectorXd::Zero(small.unknowns());
  force[0] = 1;
  EXPECT_FALSE(patch_around(small, force, std::vector<char>(small.vertices(), 0)));
}

TEST(PatchEnergyTest, BeginsWithTheForceThatIsGiven) {
  const Patched wall;
  EXPECT_EQ(wall.energy.gradient()[wall.patch.number[3 * wall.middle()]], 1e-3);
  EXPECT_LT((wall.energy.gradient() - wall.force(wall.patch.unknowns)).norm(), 1e-16);
}

// Round-off of the largest entry is 1e-16 of it; sums differ in their order.
TEST(PatchEnergyTest, HasTheCurvatureOfTheWholeWallAndOfWhatIsNear) {
  Patched wall;
  wall.problem.inertia = 0;
  wall.problem.least_motion = {.part = 0.5, .from = wall.model.rest_position};
  wall.energy.evaluate(wall.position, true);
  EquilibriumTerms whole;
  evaluate(wall.model, wall.problem, wall.position, Eigen::VectorXd(), true, whole);
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(wall.energy.hessian().rows(), wall.energy.hessian().cols());
  for (const int row : wall.patch.unknowns) {
    for (const int column : wall.patch.unknowns) {
      if (row / 3 != column / 3 && !is_coupled(wall.model.pattern, row / 3, column / 3)) continue;
      expected(wall.patch.number[row], wall.patch.number[column]) =
          whole.values[entry_address(wall.model.pattern, row, column)];
    }
  }
  const NearPair& near = wall.energy.folds()[0];
  const Eigen::Matrix<double, 12, 12> fold = fold_of(near, wall.position, 1e3).value().hessian();
  for (int i = 0; i < 12; ++i) {
    for (int j = 0; j < 12; ++j) {
      const int row = wall.patch.number[3 * near.vertices[i / 3] + i % 3];
      const int column = wall.patch.number[3 * near.vertices[j / 3] + j % 3];
      if (row >= 0 && column >= 0) expected(row, column) += fold(i, j);
    }
  }
  ASSERT_GT(fold.norm(), 1e-3 * expected.norm());
  const Eigen::MatrixXd hessian = wall.energy.hessian().selfadjointView<Eigen::Lower>();
  EXPECT_LT((hessian - expected).lpNorm<Eigen::Infinity>(), 1e-14 * expected.lpNorm<Eigen::Infinity>());
}

// Differences over 1e-7 m are off by 1.4e-10 N, and by 2e-8 of the largest entry: their round-off.
void expect_derivatives(Patched& wall) {
  wall.energy.evaluate(wall.position, true);
  const Eigen::VectorXd gradient = wall.energy.gradient();
  const Eigen::MatrixXd hessian = wall.energy.hessian().selfadjointView<Eigen::Lower>();
  ASSERT_TRUE(fold_of(wall.energy.folds()[0], wall.position, 1e3)) << "no fold to be tried";
  constexpr double kStep = 1e-7;
  for (std::size_t k = 0; k < wall.patch.unknowns.size(); ++k) {
    const auto number = static_cast<Eigen::Index>(k);
    Eigen::VectorXd moved = wall.position;
    moved[wall.patch.unknowns[k]] += kStep;
    wall.energy.evaluate(moved, false);
    const double more = wall.energy.value();
    Eigen::VectorXd slope = wall.energy.gradient();
    moved[wall.patch.unknowns[k]] -= 2 * kStep;
    wall.energy.evaluate(moved, false);
    EXPECT_NEAR((more - wall.energy.value()) / (2 * kStep), gradient[number], 1e-9);
    slope = (slope - wall.energy.gradient()) / (2 * kStep);
    EXPECT_LT((slope - hessian.col(number)).lpNorm<Eigen::Infinity>(), 1e-7 * hessian.lpNorm<Eigen::Infinity>());
  }
}

TEST(PatchEnergyTest, DerivesAsDifferencesDo) {
  Patched moving;
  moving.problem.inertia = 1e6;  // so that its share is not lost beside the wall's
  expect_derivatives(moving);
  Patched slack;
  slack.problem.inertia = 0;
  slack.problem.least_motion = {.part = 1, .from = slack.model.rest_position};
  expect_derivatives(slack);
}

TEST(PatchRelaxationTest, BringsThePatchToRestAndMovesNothingElse) {
  Patched wall;
  const double before = wall.energy.value();
  const Eigen::VectorXd rest = relaxed(wall.energy, wall.position, 1e-15);
  wall.energy.evaluate(rest, false);
  EXPECT_LT(wall.energy.gradient().norm(), 1e-14);
  EXPECT_LT(wall.energy.value(), before);
  for (int k = 0; k < wall.model.unknowns(); ++k) {
    if (wall.patch.number[k] < 0) {
      ASSERT_EQ(rest[k], wall.position[k]);
    }
  }
}

// Without patches some of these steps end with a residual of 6e-3, as triangles beside the blade turn to and fro.
TEST(PatchRelaxationTest, LetsCutsOfLooseToleranceHoldIt) {
  BodyDefinition ball = make_body(make_sphere(kRadius, 5120), 1e-3, neo_hookean(20e3));
  ball.fluid.initial_pressure = 300;
  ball.fixed = {{.region = BelowRegion{.axis = 2, .at = -10e-3}}};
  ball.toughness = {100};
  Body body(ball, {test_blade()}, {.analysis = Analysis::kDynamic, .tolerance = 1e-3});
  body.settle();
  double largest = 0;
  draw_blade(body, {.points = {{-8e-3, 0.7e-3, 12e-3}, {1e-3, 0.7e-3, 12e-3}}, .step = 0.5e-3, .duration = 1.0 / 30},
             [&] { largest = std::max(largest, body.report().residual_share); });
  EXPECT_GT(body.state().cut.length, 5e-3);
  EXPECT_LE(largest, 1e-3);
}

}  // namespace
}  // namespace thinwall
