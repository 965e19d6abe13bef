// A body that begins under a pressure finds its equilibrium, also where its wall buckles on the way there.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "engine/mesh/MeshMeasures.hpp"
#include "engine/mesh/Shapes.hpp"
#include "engine/simulation/SimulationFailure.hpp"
#include "tests/engine/simulation/DrawnBlade.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

/// A ball of 20 mm with `lobes` bulges around it, as deep as a tenth of its radius.
SurfaceMesh lobed_ball(int lobes, int triangles) {
  SurfaceMesh mesh = make_sphere(20e-3, triangles);
  for (Eigen::Vector3d& at : mesh.vertices) {
    const double around = std::atan2(at.y(), at.x()), up = std::acos(at.z() / at.norm());
    at *= 1 + 0.1 * std::cos(lobes * around) * std::sin(up) + 0.1 * std::cos(lobes * up);
  }
  return mesh;
}

/// A body whose iterations are counted.
struct CountedBody {
  int iterations = 0;
  Body body;

  explicit CountedBody(const BodyDefinition& definition, const SimulationOptions& options = quasi_static())
      : body(definition, {}, counting(options)) {}
  CountedBody(const CountedBody&) = delete;
  CountedBody& operator=(const CountedBody&) = delete;

 private:
  SimulationOptions counting(SimulationOptions options) {
    options.between_iterations = [this] { ++iterations; };
    return options;
  }
};

/// What a step says that cannot be saved.
std::string failure_of(Body& body, const BodyInput& input) {
  try {
    body.advance({}, {}, 10e-3, input);
  } catch (const SimulationFailure& failure) {
    return failure.what();
  }
  return "nothing";
}

/// Pascal that a wall bears at most, by such words; 0 where they do not say.
double pressure_told(const std::string& failure, const std::string& wall = "its wall") {
  const std::string words = ", as " + wall + " bears ";
  const std::size_t at = failure.find(words);
  return at == std::string::npos ? 0 : std::stod(failure.substr(at + words.size()));
}

/// Pascal that a ball of 80 triangles, 20 mm large and 1 mm thick, of shear modulus 20 kPa bears at most: 2 mu h / R
/// (1 / stretch - 1 / stretch^7) at the limit point, stretch^6 = 7 (Treloar 1975). An even polyhedron is as stiff as
/// the sphere of radius 3 V / A, and bears that to 2 %, as its corners are not its faces.
double borne_by_ball() {
  const SurfaceMesh ball = make_sphere(20e-3, 80);
  const double radius = 3 * enclosed_volume(ball) / wall_area(ball);
  return 2 * 20e3 * 1e-3 / radius * (std::pow(7, -1.0 / 6) - std::pow(7, -7.0 / 6));
}

struct Ball {
  int lobes = 0, triangles = 0;
  double thickness = 0;  // metres
};

TEST(Settling, AShellThatBurstsIsNotFollowedOnStepsThatHaveGoneAstray) {
  BodyDefinition definition = make_body(lobed_ball(7, 320), 1e-3, neo_hookean(10e3));
  definition.model = WallModel::kShell;
  definition.fluid.initial_pressure = 1000;
  CountedBody counted(definition);
  auto& [iterations, body] = counted;
  EXPECT_THROW(body.settle(), SimulationFailure);
  std::printf("%d iterations\n", iterations);
  EXPECT_LT(iterations, 145);  // 128; 156 where they are
}

TEST(Settling, AWallThatBucklesOnItsWayTakesHundredsOfIterationsNotThousands) {
  int iterations = 0, factorisations = 0;
  for (const auto& [lobes, triangles, thickness] : {Ball{9, 500, 1e-3}, {7, 800, 0.5e-3}, {7, 1200, 1e-3}}) {
    BodyDefinition definition = make_body(lobed_ball(lobes, triangles), thickness, neo_hookean(10e3));
    definition.fluid.initial_pressure = 10;
    Body body(definition, {}, quasi_static());
    body.settle();
    iterations += body.report().newton_iterations;
    factorisations += body.report().factorisations;
    EXPECT_GT(body.state().fluid_volume[0], 1.03 * body.model().rest_volume);
    EXPECT_FALSE(body.report().unstable);
  }
  std::printf("%d iterations, %d factorisations\n", iterations, factorisations);
  // Seen 605 and 1165, 77 and 121 of them from a first equilibrium that is not stable on; 62 and 163 more where nothing
  // is kept of solutions that are not found, 2 and 161 where what makes a matrix convex is always sought from the least
  // on, 136 and 536 with neither. With springs that do not lead on, and solutions with them that are sought exactly,
  // over 1631 iterations.
  EXPECT_LT(iterations, 640);
  EXPECT_LT(factorisations, 1240);
}

TEST(Settling, AWallThatBurstsIsNotTriedAgain) {
  BodyDefinition definition = make_body(lobed_ball(7, 500), 1e-3, neo_hookean(10e3));
  definition.fluid.initial_pressure = 2e3;  // balloons of that wall bear 600
  definition.fixed = {{.region = BelowRegion{.axis = 2, .at = -15e-3}}};
  SimulationOptions options = quasi_static();
  options.gravity = {0, 0, -9.81};
  CountedBody counted(definition, options);
  auto& [iterations, body] = counted;
  EXPECT_THROW(body.settle(), SimulationFailure);
  std::printf("%d iterations\n", iterations);
  // Seen 599; tried again carefully, and then with its weight in parts, 2561.
  EXPECT_LT(iterations, 1200);
}

TEST(Settling, AWallThatIsFilledPastWhatItBearsIsGivenUpAfterFewParts) {
  BodyDefinition definition = make_body(make_sphere(20e-3, 80), 1e-3, neo_hookean(20e3));
  definition.fluid.initial_pressure = 1100;
  CountedBody counted(definition);
  auto& [iterations, body] = counted;
  body.settle();
  iterations = 0;
  const std::string told = failure_of(body, {.load_factors = {}, .fluids = {{.pressure = 1400}}});
  std::printf("%d iterations\n", iterations);
  EXPECT_NE(told.find("it bursts: "), std::string::npos) << told;
  EXPECT_NEAR(pressure_told(told), borne_by_ball(), 0.02 * borne_by_ball()) << told;
  EXPECT_EQ(body.state().volume[0], body.state().fluid_volume[0]) << "the state before the step is left";
  // Seen 459; 5494 where the step is divided on once it is known what the wall bears, 42 184 where it is not asked and
  // parts that burst are divided on.
  EXPECT_LT(iterations, 2000);
}

TEST(Settling, ASheetUnderAPressureThatItDoesNotBearIsSaidToBurst) {
  BodyDefinition definition = make_body(make_disc(50e-3, 96), 1e-3, neo_hookean(20e3));
  definition.fluid.kind = FluidKind::kNone;
  definition.fixed = {{.region = BoundaryRegion{}}};
  // It bears 3.76 c1 h / a, 752 Pa.
  definition.loads = {{.kind = LoadKind::kFollowerPressure, .region = GroupRegion{"wall"}, .pressure = 1000}};
  CountedBody counted(definition);
  auto& [iterations, body] = counted;
  body.settle({0});
  for (int step = 1; step <= 7; ++step) body.advance({}, {}, 1, {.load_factors = {0.1 * step}, .fluids = {}});
  iterations = 0;
  const std::string told = failure_of(body, {.load_factors = {0.85}, .fluids = {}});
  std::printf("%d iterations\n", iterations);
  EXPECT_NE(told.find("it bursts: it grows without end, past 10 times its area"), std::string::npos) << told;
  // Seen 4000; followed to the end of its 40 000 otherwise.
  EXPECT_LT(iterations, 8000);
}

TEST(Settling, OneChamberOfSeveralThatIsFilledPastWhatItBearsIsGivenUpAfterFewParts) {
  SurfaceMesh balls = make_sphere(20e-3, 80);
  const SurfaceMesh second = make_sphere(20e-3, 80);
  for (const Eigen::Vector3i& triangle : second.triangles) {
    balls.triangles.push_back(triangle.array() + static_cast<int>(second.vertices.size()));
  }
  for (const Eigen::Vector3d& at : second.vertices) balls.vertices.push_back(at + Eigen::Vector3d(60e-3, 0, 0));
  BodyDefinition definition = make_body(balls, 1e-3, neo_hookean(20e3));
  definition.fluid.chambers = {{.name = "one", .inside = {0, 0, 0}}, {.name = "other", .inside = {60e-3, 0, 0}}};
  definition.fluid.initial_pressure = 1100;
  CountedBody counted(definition);
  auto& [iterations, body] = counted;
  body.settle();
  iterations = 0;
  const std::string told = failure_of(body, {.load_factors = {}, .fluids = {{}, {.pressure = 1400}}});
  std::printf("%d iterations\n", iterations);
  const double most = pressure_told(told, "the wall of its chamber `other`");
  EXPECT_NEAR(most, borne_by_ball(), 0.02 * borne_by_ball()) << told;
  EXPECT_LT(iterations, 2000) << "as with one chamber";
}

TEST(Settling, AShellThatIsDrainedBucklesWithoutStepsThatGainNothing) {
  BodyDefinition definition = make_body(make_sphere(20e-3, 320), 1e-3, neo_hookean(20e3));
  definition.model = WallModel::kShell;
  CountedBody counted(definition);
  auto& [iterations, body] = counted;
  body.settle();
  const double whole = body.state().volume[0];
  for (int step = 1; step <= 4; ++step) body.advance({}, {}, 0.1, filling(body, (1 - 0.04 * step) * whole));
  std::printf("%d iterations\n", iterations);
  // Seen 1264; 1506 where up to forty whole steps are taken that gain nothing.
  EXPECT_LT(iterations, 1330);
}

}  // namespace
}  // namespace thinwall
