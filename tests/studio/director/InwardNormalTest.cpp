#include "studio/director/InwardNormal.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <numbers>

#include "studio/scenario/LoadScenario.hpp"
#include "tests/studio/TemporaryFolder.hpp"

namespace thinwall {
namespace {

using Eigen::Vector3d;

InciseClip cut_along(const Vector3d& from, const Vector3d& to) {
  return {.path = {from, to}, .path_locations = {{}, {}}};
}

TEST(InwardNormal, PointsIntoAShapeWhereverItStands) {
  const SurfacePlacement aside{.at = Vector3d(0.05, 0, 0)};
  const BodyScenario ball{.surface = ShapeSource{.radius = 0.02, .triangles = 1280, .placed = aside}};
  const Vector3d on_top = inward_normal(ball, cut_along({0.045, 0, 0.02}, {0.055, 0, 0.02}));
  EXPECT_NEAR(on_top.norm(), 1, 1e-12);
  EXPECT_LT(on_top.z(), -0.99) << "about its own middle, not that of the coordinates";
  EXPECT_GT(inward_normal(ball, cut_along({0.03, -0.005, 0}, {0.03, 0.005, 0})).x(), 0.99);
}

TEST(InwardNormal, IsThatOfAMesh) {
  const BodyScenario organ{
      .surface = MeshFileSource{.file = std::string(THINWALL_SOURCE_DIR) + "/scenes/organs/gallbladder_light.obj",
                                .unit = 1e-3}};
  EXPECT_LT(inward_normal(organ, cut_along({0, 0, 0.016}, {0.02, 0, 0.016})).z(), -0.9);
  EXPECT_GT(inward_normal(organ, cut_along({0, -0.016, 0}, {0.02, -0.016, 0})).y(), 0.7);
}

TEST(InwardNormal, GoesIntoASheetFromItsOuterSide) {
  const BodyScenario sheet{.surface = ShapeSource{.shape = Shape::kSheet, .length = 0.04, .width = 0.04},
                           .fluid = {.kind = FluidKind::kNone}};
  EXPECT_LT((inward_normal(sheet, cut_along({-0.01, 0, 0}, {0.01, 0, 0})) - Vector3d(0, 0, -1)).norm(), 1e-12);
}

TEST(InwardNormal, IsZeroWhereThereIsNoSuchPath) {
  const BodyScenario ball{.surface = ShapeSource{.radius = 0.02, .triangles = 320}};
  EXPECT_TRUE(inward_normal(ball, cut_along({0, 0, 0.05}, {0.01, 0, 0.05})).isZero()) << "out of reach";
  const BodyScenario missing{.surface = MeshFileSource{.file = "missing.obj"}};
  EXPECT_TRUE(inward_normal(missing, cut_along({0, 0, 0.02}, {0.01, 0, 0.02})).isZero());
}

TEST(InwardNormal, TurnsTheCameraOfAScenarioThatCutsAMesh) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "cut.yaml";
  std::ofstream(file)
      << "thinwall: 1\n"
         "bodies:\n"
         "  organ:\n"
         "    surface: { mesh: " THINWALL_SOURCE_DIR
         "/scenes/organs/gallbladder_light.obj, unit: mm }\n"
         "    wall:\n"
         "      thickness: 2 mm\n"
         "      toughness: 0.4 kJ/m^2\n"
         "      material: { law: neo_hookean, shear_modulus: 20 kPa }\n"
         "tools: { blade: { kind: scalpel, length: 8 mm } }\n"
         "timeline:\n"
         "  - incise: { tool: blade, body: organ, path: [[0, 0, 16 mm], [20 mm, 0, 16 mm]], depth: 3 mm }\n";
  EXPECT_FALSE(load_scenario(file, {}).view.camera.elevation) << "reads no mesh by itself";
  const Scenario seen = load_scenario(file, {}, {.inward_normal = inward_normal});
  ASSERT_TRUE(seen.view.camera.elevation);
  EXPECT_DOUBLE_EQ(*seen.view.camera.elevation, 55 * std::numbers::pi / 180);
}

}  // namespace
}  // namespace thinwall
