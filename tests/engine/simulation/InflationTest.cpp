// Inflation of a thin spherical balloon by its volume, against the closed form of rubber elasticity.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <ostream>

#include "engine/mesh/Shapes.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

constexpr double kRadius = 30e-3, kThickness = 0.5e-3;  // metres

struct Balloon {
  const char* name;
  double c1, c2;  // pascal
};

void PrintTo(const Balloon& balloon, std::ostream* out) {
  *out << balloon.name;
}

/// p = 4 h / R (l^-1 - l^-7) (c1 + c2 l^2) (Adkins and Rivlin 1952), R the radius of the sphere that the mesh
/// approximates.
double exact_pressure(const Balloon& balloon, double stretch) {
  return 4 * kThickness / kRadius * (1 / stretch - std::pow(stretch, -7)) *
         (balloon.c1 + balloon.c2 * stretch * stretch);
}

Body make_balloon(const Balloon& balloon, int triangles) {
  const Material material = balloon.c2 == 0 ? neo_hookean(2 * balloon.c1) : mooney_rivlin(balloon.c1, balloon.c2);
  Body body(make_body(make_sphere(kRadius, triangles), kThickness, material), {}, quasi_static());
  body.settle();
  return body;
}

void inflate(Body& body, double stretch) {
  body.advance({}, {}, 1, filling(body, body.model().rest_volume * std::pow(stretch, 3)));
}

/// (largest - smallest distance of a vertex from the centre) / their mean.
double out_of_roundness(const Body& body) {
  const Eigen::VectorXd& position = body.state().equilibrium.position;
  double least = 1e9, most = 0, sum = 0;
  for (int v = 0; v < body.model().vertices(); ++v) {
    const double radius = position.segment<3>(3 * v).norm();
    least = std::min(least, radius);
    most = std::max(most, radius);
    sum += radius;
  }
  return (most - least) * body.model().vertices() / sum;
}

const std::vector<double>& stretches() {
  static const std::vector<double> all = {1.01, 1.05, 1.1, 1.2, 1.3, 1.35, 1.383, 1.42, 1.5, 1.75, 2, 2.5, 3};
  return all;
}

class Inflation : public testing::TestWithParam<Balloon> {};

TEST_P(Inflation, PressureFollowsTheClosedFormFromSmallStretchThroughTheLimitPointToThree) {
  const Balloon balloon = GetParam();
  Body body = make_balloon(balloon, 1280);
  double worst = 0;
  std::printf("%s\nstretch  pressure Pa  exact Pa  error %%  out of roundness %%  iterations\n", balloon.name);
  for (const double stretch : stretches()) {
    inflate(body, stretch);
    const double pressure = body.state().equilibrium.pressure[0], exact = exact_pressure(balloon, stretch);
    const double error = pressure / exact - 1, roundness = out_of_roundness(body);
    std::printf("%7.3f  %11.4f  %8.4f  %7.3f  %18.3f  %d\n", stretch, pressure, exact, 100 * error, 100 * roundness,
                body.report().newton_iterations);
    worst = std::max(worst, std::abs(error));
    EXPECT_NEAR(std::pow(body.state().volume[0] / body.model().rest_volume, 1.0 / 3), stretch, 1e-11);
    EXPECT_EQ(body.report().halvings, 0) << stretch;
    EXPECT_EQ(body.report().shifted_iterations, 0) << stretch;
  }
  EXPECT_LT(worst, 5e-3);
  // The error is that of the polyhedron's size: a mesh that inflates evenly has p = h A W'(l) / (3 V l^2), so 3 V / A
  // stands for its radius. What is left beside that is the unevenness of the mesh; 2e-4 seen.
  const double polyhedron = 3 * body.model().rest_volume / body.model().rest_area;
  EXPECT_NEAR(body.state().equilibrium.pressure[0] * polyhedron / kRadius, exact_pressure(balloon, stretches().back()),
              1e-3 * exact_pressure(balloon, stretches().back()));
}

TEST_P(Inflation, ErrorFallsWithTheSquareOfTheEdgeLength) {
  const Balloon balloon = GetParam();
  for (const double stretch : {1.2, 2.0}) {
    std::array<double, 3> error{};
    for (int level = 0; level < 3; ++level) {
      Body body = make_balloon(balloon, 320 << (2 * level));
      inflate(body, 1.1);
      if (stretch > 1.5) inflate(body, 1.5);
      inflate(body, stretch);
      error[level] = body.state().equilibrium.pressure[0] / exact_pressure(balloon, stretch) - 1;
      std::printf("%s, stretch %.1f, %d triangles: error %.4f %%, out of roundness %.4f %%\n", balloon.name, stretch,
                  320 << (2 * level), 100 * error[level], 100 * out_of_roundness(body));
    }
    EXPECT_NEAR(error[0] / error[1], 4, 0.1) << stretch;
    EXPECT_NEAR(error[1] / error[2], 4, 0.1) << stretch;
  }
}

TEST_P(Inflation, WorkOfFillingIsTheEnergyStoredInTheWall) {
  // The trapezoidal rule over small steps; what it misses is booked as numerical and small.
  Body body = make_balloon(GetParam(), 320);
  for (int k = 1; k <= 40; ++k) inflate(body, 1 + 0.025 * k);
  const EnergyBooks& books = body.state().books;
  EXPECT_LT(std::abs(books.imbalance()), 1e-9 * books.elastic);
  EXPECT_LT(std::abs(books.numerical), 1e-3 * books.elastic);
}

INSTANTIATE_TEST_SUITE_P(Rubbers, Inflation,
                         testing::Values(Balloon{"neo-Hookean", 20e3, 0}, Balloon{"Mooney-Rivlin", 16e3, 2e3}),
                         [](const auto& each) { return each.param.c2 == 0 ? "NeoHookean" : "MooneyRivlin"; });

}  // namespace
}  // namespace thinwall
