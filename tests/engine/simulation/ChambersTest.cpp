// Several chambers in one body, and the flow between them.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

TEST(Chambers, AreTheClosedPartsInTheOrderOfTheirNames) {
  Body body(two_balls(), {}, quasi_static());
  body.settle();
  ASSERT_EQ(body.model().chambers.size(), 2u);
  EXPECT_EQ(body.model().chambers[0].name, "large");
  EXPECT_GT(body.state().volume[0], 1.5 * body.state().volume[1]);
  EXPECT_NEAR(body.state().equilibrium.pressure[0], 600, 1e-9);
  EXPECT_NEAR(body.state().equilibrium.pressure[1], 200, 1e-9);
  EXPECT_LT((body.model().chambers[0].level - Eigen::Vector3d(kBallsApart, 0, 0)).norm(), 1e-12);
}

TEST(Chambers, WithoutNamesHaveThePressureOfTheContents) {
  BodyDefinition definition = two_balls();
  definition.fluid.chambers.clear();
  definition.fluid.initial_pressure = 250;
  Body body(definition, {}, quasi_static());
  body.settle();
  EXPECT_NEAR(body.state().equilibrium.pressure[0], 250, 1e-9);
  EXPECT_NEAR(body.state().equilibrium.pressure[1], 250, 1e-9);
}

TEST(Chambers, APointOutsideOrTwiceInsideIsRefused) {
  BodyDefinition definition = two_balls();
  definition.fluid.chambers[0].inside = {0, 0, 1};
  EXPECT_THROW(make_body_model(definition), std::invalid_argument);
  definition.fluid.chambers[0].inside = {0, 0, 1e-3};
  EXPECT_THROW(make_body_model(definition), std::invalid_argument);
}

TEST(Chambers, FillingOneLeavesTheOther) {
  Body body(two_balls(), {}, quasi_static());
  body.settle();
  const Eigen::VectorXd volume = body.state().fluid_volume;
  for (int step = 0; step < 3; ++step) {
    body.advance({}, {}, 0.1, {.load_factors = {}, .fluids = {{.added = 1e-6, .pressure = {}}}});
  }
  EXPECT_NEAR(body.state().fluid_volume[0] - volume[0], 3e-6, 1e-18);
  EXPECT_EQ(body.state().fluid_volume[1], volume[1]);
  EXPECT_NEAR(body.state().equilibrium.pressure[1], 200, 1e-6);
  EXPECT_NEAR(body.state().books.imbalance(), 0, 1e-10 * body.state().books.script_work);
}

TEST(Chambers, APressureToReachIsReachedAndTheVolumeFollows) {
  for (const FluidKind kind : {FluidKind::kIncompressible, FluidKind::kCompressible}) {
    BodyDefinition definition = two_balls();
    definition.fluid.kind = kind;
    definition.fluid.bulk_modulus = 100e3;
    Body body(definition, {}, quasi_static());
    body.settle();
    BodyInput input{.load_factors = {}, .fluids = {{}, {.added = 0, .pressure = 400}}};
    body.advance({}, {}, 0.1, input);
    EXPECT_NEAR(body.state().equilibrium.pressure[1], 400, 1e-9);
    body.advance({}, {}, 0.1);
    EXPECT_NEAR(body.state().equilibrium.pressure[1], 400, 1e-6);
    EXPECT_NEAR(body.state().books.imbalance(), 0, 1e-10 * body.state().books.script_work);
  }
}

/// Volume of the first chamber after 2 s of flow.
double volume_after_flow(FluidKind kind, int steps, double* imbalance = nullptr) {
  BodyDefinition definition = two_balls();
  definition.fluid.kind = kind;
  definition.fluid.bulk_modulus = 100e3;
  definition.fluid.orifices = {{.from = 0, .to = 1, .area = 2e-6}};
  Body body(definition, {}, quasi_static());
  body.settle();
  const double whole = body.state().fluid_volume.sum();
  for (int step = 0; step < steps; ++step) body.advance({}, {}, 2.0 / steps);
  EXPECT_NEAR(body.state().fluid_volume.sum(), whole, 1e-14 * whole);
  EXPECT_GT(body.state().books.viscous, 0);
  if (imbalance) *imbalance = body.state().books.imbalance() / body.state().books.script_work;
  return body.state().fluid_volume[0];
}

TEST(Chambers, ExchangeFluidToSecondOrderInTimeAndLoseNone) {
  for (const FluidKind kind : {FluidKind::kIncompressible, FluidKind::kCompressible}) {
    double imbalance = 1;
    const double fine = volume_after_flow(kind, 80, &imbalance);
    const double coarse = volume_after_flow(kind, 5) - fine, middle = volume_after_flow(kind, 10) - fine;
    std::printf("errors %.2e %.2e m^3\n", coarse, middle);
    EXPECT_GT(coarse / middle, 3.5);  // seen 4.05 and 5.0
    EXPECT_NEAR(imbalance, 0, 1e-10);
  }
}

TEST(Chambers, PressuresMeetAtOneLevelInTheEnd) {
  BodyDefinition definition = two_balls();
  definition.fixed = {{.region = BelowRegion{.axis = 2, .at = 0}}};
  definition.thickness.assign(definition.mesh.triangles.size(), 3e-3);  // bears the fluid without folds
  definition.fluid.chambers[1].initial_pressure = 400;
  for (std::size_t v = 162; v < definition.mesh.vertices.size(); ++v) definition.mesh.vertices[v].z() += 10e-3;
  definition.fluid.chambers[0].inside.z() += 10e-3;
  definition.fluid.orifices = {{.from = 0, .to = 1, .area = 20e-6}};
  SimulationOptions options = quasi_static();
  options.gravity = {0, 0, -9.81};
  Body body(definition, {}, options);
  body.settle();
  for (int step = 0; step < 200; ++step) body.advance({}, {}, 0.02);
  const Eigen::VectorXd& pressure = body.state().equilibrium.pressure;
  EXPECT_NEAR(pressure[1] - pressure[0], 1010 * 9.81 * 10e-3, 0.01);
}

}  // namespace
}  // namespace thinwall
