// Cuts that part a body: pieces that fall or are held, and contents that are shared out.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "engine/cutting/CutSurface.hpp"
#include "engine/cutting/SurfacePath.hpp"
#include "engine/equilibrium/RigidMotions.hpp"
#include "engine/mesh/Shapes.hpp"
#include "engine/simulation/CutTransfer.hpp"
#include "tests/engine/simulation/CutSheets.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

constexpr double kRadius = 20e-3;  // metres, of balls

/// Cuts along a polyline through points brought to the surface, to its end. Gives the number of pieces
/// that come off.
std::size_t cut_along(Body& body, const std::vector<Eigen::Vector3d>& points,
                      const std::optional<Eigen::Vector3d>& direction = {}) {
  const PathResult way = surface_path(body.surface(), points, direction, 1);
  EXPECT_FALSE(way.problem);
  Cut cut = body.cut({.from = {}, .points = way.path.pieces.front().points}, {});
  std::size_t separated = cut.separated.size();
  while (cut.tip && !cut.rest.empty() && !cut.triangles.empty()) {
    cut = body.cut({.from = cut.tip, .points = cut.rest}, {});
    separated += cut.separated.size();
  }
  return separated;
}

std::vector<Eigen::Vector3d> circle(const Eigen::Vector3d& center, double radius, int corners) {
  std::vector<Eigen::Vector3d> points;
  for (int k = 0; k <= corners; ++k) {
    const double angle = 2 * std::numbers::pi * (k % corners) / corners;
    points.push_back(center + radius * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0));
  }
  return points;
}

void rest(Body& body, int steps, double duration = 0.01) {
  for (int k = 0; k < steps; ++k) body.advance({}, {}, duration);
}

SimulationOptions options_of(Analysis analysis) {
  SimulationOptions options;
  options.analysis = analysis;
  return options;
}

struct Piece {
  double mass = 0, elastic = 0;  // kg, joule
  Eigen::Vector3d center = Eigen::Vector3d::Zero(), velocity = Eigen::Vector3d::Zero();
};

std::vector<Piece> pieces_of(const Body& body) {
  const BodyModel& model = body.model();
  const std::vector<int> parts = wall_parts(model);
  std::vector<Piece> pieces(static_cast<std::size_t>(*std::ranges::max_element(parts)) + 1);
  for (int v = 0; v < model.vertices(); ++v) {
    Piece& piece = pieces[parts[v]];
    const double mass = model.mass[3 * v];
    piece.mass += mass;
    piece.center += mass * body.state().equilibrium.position.segment<3>(3 * v);
    piece.velocity += mass * body.state().velocity.segment<3>(3 * v);
  }
  for (Piece& piece : pieces) piece.center /= piece.mass, piece.velocity /= piece.mass;
  for (int t = 0; t < model.triangles(); ++t) {
    const auto corners = corners_of(model.surface[t], body.state().equilibrium.position);
    MembraneMemory memory;
    memory.tension_field = model.definition.tension_field;
    pieces[parts[model.surface[t][0]]].elastic +=
        membrane_terms(model.rest[t], model.material(t), corners, memory).strain_energy;
  }
  return pieces;
}

TEST(APieceCutOutOfAStretchedSheet, ShrinksToItsOwnSizeWhereItIs) {
  for (const Analysis analysis : {Analysis::kQuasiStatic, Analysis::kDynamic}) {
    const double stretch = 1.1;
    Body body(stretched_sheet(800, stretch), {}, options_of(analysis));
    body.settle();
    const std::size_t separated = cut_along(body, circle({2e-3, 1e-3, 0}, 7e-3, 24), -Eigen::Vector3d::UnitZ());
    ASSERT_EQ(separated, 1u);
    ASSERT_EQ(pieces_of(body).size(), 2u);
    const std::vector<Piece> before = pieces_of(body);
    rest(body, analysis == Analysis::kDynamic ? 50 : 12);
    const std::vector<Piece> after = pieces_of(body);
    const int disc = after[0].mass < after[1].mass ? 0 : 1;
    EXPECT_GT(before[disc].elastic, 1e-5);
    EXPECT_LT((after[disc].center - before[disc].center).norm(), 1e-6);
    EXPECT_LT(after[disc].elastic, 1e-3 * before[disc].elastic);
    EXPECT_LT(std::abs(body.state().books.imbalance()), 1e-9 * before[1 - disc].elastic);
  }
}

TEST(APieceCutOutOfASheet, FallsFreelyUnderGravity) {
  SimulationOptions options = options_of(Analysis::kDynamic);
  options.gravity = {0, 0, -9.81};
  Body body(stretched_sheet(600, 1.05), {}, options);
  body.settle();
  cut_along(body, circle({2e-3, 1e-3, 0}, 7e-3, 24), -Eigen::Vector3d::UnitZ());
  const std::vector<Piece> before = pieces_of(body);
  const int disc = before[0].mass < before[1].mass ? 0 : 1;
  rest(body, 30, 5e-3);
  const Piece after = pieces_of(body)[disc];
  EXPECT_NEAR(after.velocity.z(), -9.81 * 0.15, 0.01 * 9.81 * 0.15);
}

TEST(AFlapThatIsCutOff, GoesOnAsItWentThen) {
  // A corner of a sheet that two sides hold: cut on one side, and on the other before the first lips are wholly free.
  BodyDefinition definition = stretched_sheet(600, 1.1);
  definition.fixed = {{.region = BelowRegion{.axis = 0, .at = -19.9e-3}},
                      {.region = AboveRegion{.axis = 1, .at = 19.9e-3}}};
  Body body(definition, {}, options_of(Analysis::kDynamic));
  body.settle();
  const auto cut_from = [&](const Eigen::Vector3d& border, const Eigen::Vector3d& end) {
    const PathResult way = surface_path(body.surface(), std::array{border, end}, {}, 30e-3);
    EXPECT_FALSE(way.problem);
    return body.cut({.from = {}, .points = way.path.pieces.front().points}, {});
  };
  const Cut first = cut_from({4e-3, -30e-3, 0}, {4e-3, -2e-3, 0});
  ASSERT_TRUE(first.tip);
  rest(body, 3, 1e-3);
  const Eigen::Vector3d tip = body.state().equilibrium.position.segment<3>(3 * *first.tip);
  cut_from({30e-3, tip.y(), 0}, tip);
  const std::vector<Piece> before = pieces_of(body);
  ASSERT_EQ(before.size(), 2u);
  const int flap = before[0].mass < before[1].mass ? 0 : 1;
  double gained = 0;  // metres / second
  for (int k = 0; k < 20; ++k) {
    rest(body, 1, 1e-3);
    gained = std::max(gained, (pieces_of(body)[flap].velocity - before[flap].velocity).norm());
  }
  std::printf("at %.2g m/s it gained %.2g m/s\n", before[flap].velocity.norm(), gained);
  EXPECT_GT(before[flap].velocity.norm(), 1e-3);
  EXPECT_LT(gained, 1e-6 * before[flap].velocity.norm());
}

TEST(ASheetCutInTwo, IsHeldOrFallsWhereNothingHoldsIt) {
  for (const Analysis analysis : {Analysis::kQuasiStatic, Analysis::kDynamic}) {
    BodyDefinition definition = stretched_sheet(600, 1.05);
    definition.fixed = {{.region = BelowRegion{.axis = 0, .at = -19.9e-3}, .clamped = true}};
    SimulationOptions options = options_of(analysis);
    options.gravity = {0, 0, -9.81};
    definition.model = WallModel::kShell;
    Body body(definition, {}, options);
    body.settle();
    const std::size_t separated = cut_along(body, {{3e-3, -25e-3, 0}, {4e-3, 25e-3, 0}});
    ASSERT_EQ(separated, 1u);
    const std::vector<Piece> before = pieces_of(body);
    rest(body, 20, 5e-3);
    const std::vector<Piece> after = pieces_of(body);
    const int loose = after[0].center.x() > after[1].center.x() ? 0 : 1;
    const Eigen::Vector3d moved = after[loose].center - before[loose].center;
    if (analysis == Analysis::kQuasiStatic) {
      EXPECT_LT(moved.norm(), 1e-9);
    } else {
      EXPECT_NEAR(moved.z(), -0.5 * 9.81 * 0.1 * 0.1, 0.05 * 0.5 * 9.81 * 0.1 * 0.1);
    }
  }
}

/// Lets what has been cut come to rest, and holds it against what must stay.
void leak(Body& body, double fluid, int steps, double duration) {
  const BodyState& state = body.state();
  for (int k = 0; k < steps; ++k) {
    body.advance({}, {}, duration);
    EXPECT_NEAR(state.fluid_volume.sum() + state.leaked.sum(), fluid, 1e-9 * fluid);
    EXPECT_GE(state.leaked.minCoeff(), 0);
    EXPECT_GE(state.air.minCoeff(), 0);
    EXPECT_LT(std::abs(state.books.imbalance()), 1e-8 * state.books.script_work);
  }
}

/// Gravity under which a ball hardly sags, metres / second^2.
constexpr double kWeak = 1;

TEST(ABallCutInTwo, HasTwoOpenChambersThatShareTheFluid) {
  for (const Analysis analysis : {Analysis::kQuasiStatic, Analysis::kDynamic}) {
    BodyDefinition definition = make_body(make_sphere(kRadius, 320), 1e-3, neo_hookean(30e3));
    definition.fluid.initial_pressure = 300;
    definition.toughness = {20};
    definition.fixed = {{.region = BelowRegion{.axis = 2, .at = -0.8 * kRadius}}};
    SimulationOptions options = options_of(analysis);
    if (analysis == Analysis::kDynamic) options.gravity = {0, 0, -kWeak};
    Body body(definition, {}, options);
    body.settle();
    const double fluid = body.state().fluid_volume[0], pressure = body.state().equilibrium.pressure[0];
    // Around, and across the beginning.
    std::vector<Eigen::Vector3d> ring = circle({0, 0, 0.1 * kRadius}, 1.1 * kRadius, 24);
    ring.front() += Eigen::Vector3d(0, 0, 10e-3);
    ring.back() = ring[3] + Eigen::Vector3d(0, 0, 12e-3);
    ring.erase(ring.begin() + 1, ring.begin() + 3);
    const std::size_t separated = cut_along(body, ring);
    ASSERT_EQ(separated, 1u);
    ASSERT_EQ(body.model().chambers.size(), 2u);
    ASSERT_EQ(body.model().openings.size(), 2u);
    const BodyState& state = body.state();
    for (int c = 0; c < 2; ++c) {
      EXPECT_TRUE(body.model().is_open(c));
      const double higher = (body.model().chambers[c].level).z();
      const double weight = 1010 * kWeak * higher * (analysis == Analysis::kDynamic ? 1 : 0);
      EXPECT_NEAR(state.equilibrium.pressure[c], pressure - weight, 1e-9 * pressure);
      // One part may hold a little less below the lips than the wall did.
      EXPECT_NEAR(state.fluid_volume[c], state.volume[c], 1e-9 * fluid);
    }
    EXPECT_GT(state.fluid_volume[0], state.fluid_volume[1]);
    EXPECT_LT(state.leaked.sum(), 0.02 * fluid);
    leak(body, fluid, analysis == Analysis::kDynamic ? 5 : 15, 5e-3);
    EXPECT_GT(state.leaked[0], 0);
    EXPECT_GT(state.leaked[1], 0);
  }
}

/// A ball that is cut in two above its middle.
struct CutBall {
  Body body{make_body(make_sphere(kRadius, 320), 1e-3, neo_hookean(30e3)), {}, {}};
  Cut cut;
  BodyModel after;

  CutBall() {
    body.settle();
    std::vector<Eigen::Vector3d> ring = circle({0, 0, 0.1 * kRadius}, 1.1 * kRadius, 24);
    ring.insert(ring.end(), {ring[1], ring[2]});
    const PathResult way = surface_path(body.surface(), ring, {}, 1);
    EXPECT_FALSE(way.problem);
    CutSurface surface(body.model().definition.mesh);
    cut = surface.cut({.from = {}, .points = way.path.pieces.front().points});
    EXPECT_EQ(cut.separated.size(), 1u);
    after = make_body_model(cut_definition(body.model(), surface, cut));
  }

  BodyState carried(const BodyState& state, const Eigen::Vector3d& gravity) const {
    return carried_over(body.model(), state, after, cut, gravity);
  }
};

TEST(ABallCutInTwo, HasAllItsFluidInTheLowerPartWhereThatStandsBelowTheCutAndSpillsWhatFindsNoRoom) {
  const CutBall ball;
  BodyState state = ball.body.state();
  const double fluid = state.fluid_volume[0] *= 0.7, surface = -0.2 * kRadius;
  state.air[0] = 0.3 / 0.7 * fluid;
  state.equilibrium.pressure[0] = 1010 * 9.81 * (surface - ball.body.model().chambers[0].level.z());
  const BodyState carried = ball.carried(state, {0, 0, -9.81});
  ASSERT_EQ(carried.fluid_volume.size(), 2);
  const int lower = ball.after.chambers[0].level.z() < ball.after.chambers[1].level.z() ? 0 : 1;
  EXPECT_NEAR(carried.fluid_volume[lower] + carried.leaked[lower], fluid, 1e-12 * fluid);
  EXPECT_EQ(carried.fluid_volume[1 - lower] + carried.leaked[1 - lower], 0);
  // The part below 0.1 radii is 57.5 % of a ball; lips follow triangles of 0.3 radii, here to 0.014 radii above.
  EXPECT_NEAR(carried.leaked[lower] / fluid, 0.125 / 0.7, 0.03);
  const double lifted = 1010 * 9.81 * carried.leaked[lower] * 0.1 * kRadius;
  EXPECT_NEAR(carried.leaked_gravity, lifted, 0.2 * lifted);
}

TEST(ABallCutInTwo, LeavesItsFluidToTheFirstChamberWhereNeitherHasRoom) {
  const CutBall ball;
  BodyState flat = ball.body.state();
  for (Eigen::Index k = 2; k < flat.equilibrium.position.size(); k += 3) flat.equilibrium.position[k] = 0;
  const BodyState carried = ball.carried(flat, Eigen::Vector3d::Zero());
  ASSERT_EQ(carried.fluid_volume.size(), 2);
  EXPECT_NEAR(carried.fluid_volume[0] + carried.leaked[0], flat.fluid_volume[0], 1e-12 * flat.fluid_volume[0]);
  EXPECT_EQ(carried.fluid_volume[1] + carried.leaked[1], 0);
}

TEST(AFlakeCutOffAFilledBody, HoldsNothingAndLeavesAnOpening) {
  for (const Analysis analysis : {Analysis::kQuasiStatic, Analysis::kDynamic}) {
    BodyDefinition definition = pressurised_hemisphere(400, 600);
    definition.toughness = {20};
    Body body(definition, {}, options_of(analysis));
    body.settle();
    const double fluid = body.state().fluid_volume[0], pressure = body.state().equilibrium.pressure[0];
    std::vector<Eigen::Vector3d> ring = circle({1e-3, 1e-3, 30e-3}, 6e-3, 16);
    ring.insert(ring.end(), {ring[1], ring[2]});
    const std::size_t separated = cut_along(body, ring, -Eigen::Vector3d::UnitZ());
    ASSERT_EQ(separated, 1u);
    ASSERT_EQ(body.model().chambers.size(), 1u);
    ASSERT_EQ(body.model().openings.size(), 1u);
    EXPECT_EQ(body.state().equilibrium.pressure[0], pressure);
    EXPECT_NEAR(body.state().open_area[0], std::numbers::pi * 36e-6, 0.25 * std::numbers::pi * 36e-6);
    leak(body, fluid, analysis == Analysis::kDynamic ? 8 : 15, 5e-3);
    EXPECT_LT(body.state().equilibrium.pressure[0], 0.5 * pressure);
  }
}

}  // namespace
}  // namespace thinwall
