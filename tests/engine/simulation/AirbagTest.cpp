// The square airbag of Contri and Schrefler 1988: two square sheets of 1.2 m diagonal, joined at their edges, blown up.
// By symmetry an eighth of it is here: a quarter of one sheet, whose outer edges stay in the middle plane.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "engine/mesh/Shapes.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

constexpr double kSide = 0.6 / 1.4142135623730951;  // metres, of the quarter
constexpr double kPressure = 5e3;                   // pascal

BodyDefinition quarter_of_the_airbag(int triangles) {
  BodyDefinition body = make_body(make_sheet(kSide, kSide, triangles), 0.6e-3, st_venant_kirchhoff(588e6, 0.4));
  body.fluid.kind = FluidKind::kNone;
  body.tension_field = true;
  const double half = 0.5 * kSide, within = 1e-9;
  body.fixed = {{.region = PlaneRegion{0, -half, within}, .axes = {true, false, false}},
                {.region = PlaneRegion{1, -half, within}, .axes = {false, true, false}},
                {.region = PlaneRegion{0, half, within}, .axes = {false, false, true}},
                {.region = PlaneRegion{1, half, within}, .axes = {false, false, true}}};
  body.loads = {{.kind = LoadKind::kFollowerPressure, .region = GroupRegion{"wall"}, .pressure = kPressure}};
  return body;
}

/// How far the centre of the airbag rises, metres.
double rise(int triangles) {
  const BodyDefinition definition = quarter_of_the_airbag(triangles);
  int centre = 0;
  for (std::size_t v = 0; v < definition.mesh.vertices.size(); ++v) {
    const Eigen::Vector3d& at = definition.mesh.vertices[v];
    if (at.x() + at.y() < -kSide + 1e-9) centre = static_cast<int>(v);
  }
  SimulationOptions options = quasi_static();
  options.tolerance = 1e-7;
  Body body(definition, {}, options);
  body.settle({1});
  std::printf("%zu triangles: the centre rises %.2f mm\n", definition.mesh.triangles.size(),
              1e3 * body.state().equilibrium.position[3 * centre + 2]);
  return body.state().equilibrium.position[3 * centre + 2];
}

TEST(Airbag, RisesAsFarAsOthersFound) {
  // Later authors with wrinkling models found 217 mm.
  EXPECT_NEAR(rise(128), 0.217, 0.03 * 0.217);
}

}  // namespace
}  // namespace thinwall
