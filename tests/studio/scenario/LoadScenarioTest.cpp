#include "studio/scenario/LoadScenario.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <numbers>

#include "renderer/look/FluidLooks.hpp"
#include "renderer/look/OrganLooks.hpp"
#include "tests/studio/scenario/ScenarioTestTools.hpp"

namespace thinwall {
namespace {

const std::filesystem::path kValid = scenario_test_folder() / "valid";

std::string errors_of(const std::filesystem::path& file,
                      const std::vector<std::pair<std::string, std::string>>& overrides) {
  try {
    load_scenario(file, overrides);
  } catch (const InputErrors& errors) {
    return errors.what();
  }
  return "";
}

TEST(LoadScenario, ReadsTheExampleOfTheFormat) {
  const Scenario scenario = load_scenario(kValid / "contract.yaml", {});
  EXPECT_EQ(scenario.name, "contract");
  EXPECT_EQ(scenario.title, "Palpation of a fluid-filled hemisphere");
  ASSERT_EQ(scenario.bodies.size(), 1U);
  const BodyScenario& body = scenario.bodies[0];
  EXPECT_EQ(body.name, "organ");
  EXPECT_EQ(body.location.line, 6);
  EXPECT_EQ(body.surface_location.line, 7);
  EXPECT_EQ(std::get<ShapeSource>(body.surface).shape, Shape::kHemisphere);
  EXPECT_EQ(std::get<ShapeSource>(body.surface).triangles, 5120);
  EXPECT_EQ(body.thickness.standard, 0.001);
  EXPECT_EQ(body.material.law, find_wall_law("neo_hookean"));
  EXPECT_EQ(body.material.parameters, std::vector<double>{20000});
  EXPECT_EQ(body.fluid.kind, FluidKind::kIncompressible);
  EXPECT_EQ(body.fluid.initial_pressure, 0.0);
  ASSERT_EQ(body.fixed.size(), 2U);
  EXPECT_EQ(std::get<GroupRegion>(body.fixed[0].region).name, "base");
  EXPECT_EQ(body.fixed[1].axes, (std::array<bool, 3>{false, false, true}));
  EXPECT_EQ(body.fixed_locations[1].line, 17);
  ASSERT_EQ(scenario.timeline.size(), 3U);
  const PalpateClip& palpate = std::get<PalpateClip>(scenario.timeline[0].action);
  EXPECT_EQ(palpate.depth, 0.004);
  EXPECT_EQ(palpate.speed, 0.01);
  EXPECT_EQ(palpate.direction, Eigen::Vector3d(0, 0, -1));
  ASSERT_EQ(scenario.warnings.size(), 1U);
  EXPECT_TRUE(scenario.warnings[0].ends_with(
      "warning: timeline[1].palpate: the force of a bare point on a membrane falls with every refinement of the mesh; "
      "give `probe` a `radius` for one that does not"))
      << scenario.warnings[0];
}

TEST(LoadScenario, ReadsEveryKeyOfABody) {
  const Scenario scenario = load_scenario(kValid / "everything.yaml", {});
  const BodyScenario& bladder = scenario.bodies[0];
  EXPECT_EQ(std::get<MeshFileSource>(bladder.surface).file, kValid / "parts/tetrahedron.obj");
  EXPECT_EQ(std::get<MeshFileSource>(bladder.surface).unit, 0.03);
  EXPECT_TRUE(std::get<MeshFileSource>(bladder.surface).repair);
  EXPECT_EQ(std::get<MeshFileSource>(bladder.surface).edge_length, 0.004);
  ASSERT_EQ(bladder.thickness.regions.size(), 2U);
  EXPECT_EQ(std::get<SphereRegion>(bladder.thickness.regions[0].region).center, Eigen::Vector3d(0, 0, 0.02));
  EXPECT_EQ(std::get<BoxRegion>(bladder.thickness.regions[1].region).max, Eigen::Vector3d(0.01, 0.01, 0.01));
  EXPECT_EQ(bladder.thickness.regions[1].location.line, 20);
  EXPECT_EQ(bladder.density, 1100);
  EXPECT_EQ(bladder.material.parameters, (std::vector<double>{5000, 1000}));
  EXPECT_EQ(bladder.prestretch.standard.first, 1.05);
  EXPECT_EQ(bladder.fluid.initial_pressure, 2000.0);
  EXPECT_EQ(bladder.fluid.bulk_modulus, 2.2e9);
  EXPECT_EQ(std::get<PlaneRegion>(bladder.fixed[0].region).within, 0.0001);
  EXPECT_EQ(std::get<BelowRegion>(bladder.fixed[1].region).axis, 0);
  EXPECT_EQ(std::get<AboveRegion>(bladder.fixed[2].region).at, 0.001);
  ASSERT_TRUE(bladder.toughness);
  EXPECT_EQ(bladder.toughness->standard, 400);
  EXPECT_EQ(bladder.toughness->regions.at(0).value, 350);
  EXPECT_TRUE(bladder.fluid.leaks);
  EXPECT_EQ(bladder.fluid.discharge, 0.65);
  EXPECT_EQ(bladder.viscosity.at(1).time, 2.0);
  EXPECT_EQ(bladder.damping.stiffness_time, 1e-3);
  EXPECT_EQ(bladder.fluid.chambers.at(1).initial_pressure, 1000.0);
  EXPECT_EQ(bladder.fluid.orifices.at(0).to, 1);
  EXPECT_EQ(bladder.loads.at(0).over.at(2), std::pair(2.0, -0.5));
  const BodyScenario& cloth = scenario.bodies[1];
  EXPECT_EQ(std::get<ShapeSource>(cloth.surface).inner_radius, 0.005);
  const std::optional<SurfacePlacement>& placed = std::get<ShapeSource>(cloth.surface).placed;
  ASSERT_TRUE(placed);
  EXPECT_EQ(placed->at, Eigen::Vector3d(0, 0.02, 0));
  EXPECT_LT((placed->place_of({0.01, 0, 0}) - Eigen::Vector3d(0, 0.03, 0)).norm(), 1e-15);
  EXPECT_FALSE(std::get<MeshFileSource>(bladder.surface).placed);
  EXPECT_TRUE(std::holds_alternative<WholeRegion>(cloth.fixed[1].region));
  EXPECT_EQ(cloth.fluid.kind, FluidKind::kNone);
  EXPECT_FALSE(cloth.toughness);
  EXPECT_TRUE(std::holds_alternative<BoundaryRegion>(cloth.fixed[0].region));
  EXPECT_EQ(cloth.loads.at(1).load.kind, LoadKind::kDeadLineForce);
}

TEST(LoadScenario, ReadsEveryKeyOfTools) {
  const Scenario scenario = load_scenario(kValid / "everything.yaml", {});
  EXPECT_EQ(scenario.tools[1].kind, ToolKind::kLine);
  EXPECT_EQ(scenario.tools[1].length, 0.025);
  EXPECT_EQ(scenario.tools[2].radius, 0.002);
  EXPECT_EQ(scenario.tools[2].friction, 0.3);
  // A point with a radius is the ball of that radius in everything but its word.
  EXPECT_EQ(scenario.tools[3].kind, ToolKind::kSphere);
  EXPECT_EQ(scenario.tools[3].radius, 0.001);
  EXPECT_EQ(scenario.tools[3].friction, 0.2);
}

TEST(LoadScenario, ReadsEveryKeyOfClipsThatMoveTools) {
  const Scenario scenario = load_scenario(kValid / "everything.yaml", {});
  const Clip& first = scenario.timeline[0];
  EXPECT_EQ(first.caption, "Press by 4 mm");
  EXPECT_EQ(first.chapter, "Palpation");
  EXPECT_EQ(std::get<PalpateClip>(first.action).axis, Eigen::Vector3d(1, 0, 0));
  EXPECT_FALSE(std::get<PalpateClip>(first.action).withdraw);
  EXPECT_EQ(scenario.timeline[1].start, 30.0);
  EXPECT_EQ(std::get<MoveClip>(scenario.timeline[1].action).ease, Ease::kLinear);
  EXPECT_FALSE(std::get<MoveClip>(scenario.timeline[2].action).body);
  const GraspClip& grasp = std::get<GraspClip>(scenario.timeline[3].action);
  EXPECT_EQ(grasp.tool, "grip");
  EXPECT_EQ(grasp.axis, Eigen::Vector3d(0, 1, 0));
  EXPECT_EQ(grasp.depth, 4e-3);
  EXPECT_EQ(grasp.speed, 8e-3);
  EXPECT_EQ(grasp.standoff, 6e-3);
  EXPECT_EQ(grasp.to, 1e-3);
  EXPECT_EQ(grasp.grip, 0.4);
  EXPECT_EQ(grasp.duration, 1);
  EXPECT_EQ(std::get<ReleaseClip>(scenario.timeline[4].action).duration, 0.4);
}

TEST(LoadScenario, ReadsEveryKeyOfClipsThatCutFillAndWait) {
  const Scenario scenario = load_scenario(kValid / "everything.yaml", {});
  const PierceClip& pierce = std::get<PierceClip>(scenario.timeline[5].action);
  EXPECT_EQ(pierce.tool, "pin");
  EXPECT_EQ(pierce.axis, Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(pierce.depth, 12e-3);
  EXPECT_EQ(pierce.hold, 0.2);
  EXPECT_EQ(pierce.standoff, 6e-3);
  const InciseClip& incise = std::get<InciseClip>(scenario.timeline[6].action);
  EXPECT_EQ(incise.tool, "knife");
  EXPECT_EQ(incise.body, "bladder");
  ASSERT_EQ(incise.path.size(), 3U);
  EXPECT_EQ(incise.path[2], Eigen::Vector3d(5e-3, 5e-3, 20e-3));
  ASSERT_EQ(incise.path_locations.size(), 3U);
  EXPECT_EQ(incise.path_locations[1].column, 26);
  EXPECT_EQ(incise.direction, Eigen::Vector3d(0, 0, -1));
  EXPECT_EQ(incise.reach, 12e-3);
  EXPECT_EQ(incise.depth, 3e-3);
  EXPECT_EQ(incise.speed, 15e-3);
  EXPECT_EQ(incise.hold, 0.3);
  EXPECT_EQ(incise.standoff, 4e-3);
  EXPECT_FALSE(incise.withdraw);
  EXPECT_EQ(std::get<FillClip>(scenario.timeline[7].action).added, 5e-6);
  EXPECT_EQ(std::get<FillClip>(scenario.timeline[8].action).pressure, 500.0);
  EXPECT_EQ(std::get<WaitClip>(scenario.timeline[9].action).duration, 0.5);
}

TEST(LoadScenario, ReadsEveryKeyOfTheSimulationAndThePicture) {
  const Scenario scenario = load_scenario(kValid / "everything.yaml", {});
  EXPECT_EQ(scenario.title, "Everything at \"2 kPa\"");
  EXPECT_EQ(scenario.simulation.gravity.z(), -9.81);
  EXPECT_EQ(scenario.simulation.step_error, 1e-5);
  EXPECT_EQ(scenario.simulation.tolerance, 1e-6);
  EXPECT_EQ(scenario.simulation.analysis, Analysis::kQuasiStatic);
  EXPECT_EQ(scenario.view.camera.position, (Double3{0.08, 0, 0.05}));
  EXPECT_EQ(scenario.view.lights.fill, 0.8);
  EXPECT_EQ(scenario.view.look.bodies.at("bladder").wetness, 0.9);
  EXPECT_EQ(scenario.view.look.bodies.at("bladder").contents.clarity, find_fluid_look("blood")->clarity);
  EXPECT_EQ(scenario.view.look.bodies.at("bladder").bleeding, 0.4);
  EXPECT_EQ(scenario.view.look.bodies.at("bladder").clearness, find_organ_look("gallbladder")->clearness);
  EXPECT_EQ(scenario.view.look.bodies.at("cloth").color, TissueLook{}.color);
  EXPECT_EQ(scenario.view.look.data.value().scale, DataScale::kRoot);
  EXPECT_FALSE(scenario.overlays.gauge);
  EXPECT_TRUE(scenario.overlays.captions);
  EXPECT_EQ(scenario.record.size, (ImageSize{640, 480}));
  EXPECT_EQ(scenario.record.frames_per_second, 25);
  EXPECT_EQ(scenario.record.tier, Tier::kDraft);
  EXPECT_EQ(scenario.goldens[0].why, "the probe is at full depth");
  EXPECT_EQ(scenario.goldens[0].location.line, 154);
}

TEST(LoadScenario, ReadsWhatDiffersFromPlaceToPlaceOfAWall) {
  const Scenario scenario = load_scenario(kValid / "everything.yaml", {});
  const BodyScenario& rubber = scenario.bodies[2];
  ASSERT_EQ(rubber.parameter_fields.size(), 1U);
  const ParameterField& modulus = rubber.parameter_fields[0];
  EXPECT_EQ(modulus.index, 2U);
  EXPECT_EQ(modulus.path, "terms[2].modulus");
  EXPECT_EQ(modulus.values.standard, -10e3);
  EXPECT_EQ(modulus.values.regions.at(0).value, -20e3);
  EXPECT_EQ(rubber.material.parameters.at(3), -2);
  EXPECT_EQ(rubber.prestretch.standard.along, Eigen::Vector3d(0, 1, 0));
  EXPECT_EQ(rubber.prestretch.standard.first, 1.2);
  EXPECT_EQ(rubber.prestretch.standard.second, 1.05);
  const BodyScenario& skin = scenario.bodies[3];
  EXPECT_EQ(skin.prestretch.standard.second, 1.1);
  ASSERT_EQ(skin.prestretch.regions.size(), 2U);
  EXPECT_EQ(skin.prestretch.regions[0].value.first, 1.2);
  EXPECT_EQ(skin.prestretch.regions[1].value.second, 1);
  EXPECT_EQ(skin.prestretch.regions[1].location.line, 79);
}

TEST(LoadScenario, ReadsWhereTheNumbersOfAFieldStand) {
  const Scenario scenario = load_scenario(kValid / "everything.yaml", {});
  const BodyScenario& vessel = scenario.bodies[4];
  const FieldTable& thickness = vessel.thickness.table.value();
  EXPECT_EQ(thickness.file, kValid / "parts/wall.csv");
  EXPECT_EQ(thickness.columns, std::vector<std::string>{"thickness"});
  EXPECT_EQ(thickness.per, TablePer::kVertex);
  EXPECT_EQ(thickness.unit, 1e-4);
  EXPECT_EQ(thickness.range.minimum, 0);
  EXPECT_TRUE(thickness.range.minimum_excluded);
  EXPECT_EQ(vessel.thickness.location.line, 84);
  ASSERT_EQ(vessel.parameter_fields.size(), 4U);
  const FieldTable& shear_modulus = vessel.parameter_fields[0].values.table.value();
  EXPECT_TRUE(shear_modulus.file.empty());
  EXPECT_EQ(shear_modulus.columns, std::vector<std::string>{"stiffness"});
  EXPECT_FALSE(shear_modulus.per);
  EXPECT_EQ(shear_modulus.unit, 1e3);
  EXPECT_EQ(vessel.parameter_fields[1].values.table->per, TablePer::kFace);
  EXPECT_EQ(vessel.parameter_fields[2].values.table->unit, 1);
  EXPECT_DOUBLE_EQ(vessel.parameter_fields[3].values.table->unit, std::numbers::pi / 180);
  EXPECT_EQ(vessel.fibres->table->columns, (std::vector<std::string>{"fx", "fy", "fz"}));
  EXPECT_EQ(vessel.prestretch.table->columns.size(), 5U);
  EXPECT_EQ(vessel.prestretch.table->range.maximum, 10);
  const BodyScenario& vein = scenario.bodies[5];
  EXPECT_EQ(vein.fibres->table->file, kValid / "parts/wall.csv");
  EXPECT_EQ(vein.thickness.table->unit, 1e-3);
  EXPECT_TRUE(vein.thickness.table->range.minimum_excluded);
  EXPECT_EQ(vein.thickness.regions.at(0).value, 2e-3);
  EXPECT_EQ(vein.prestretch.table->columns, std::vector<std::string>{"stretch"});
  EXPECT_EQ(vein.prestretch.regions.at(0).value.second, 1.1);
}

TEST(LoadScenario, DefaultsAreThoseOfTheDefinitions) {
  const Scenario scenario = load_scenario(kValid / "minimal.yaml", {});
  EXPECT_EQ(scenario.title, "minimal");
  const BodyScenario& body = scenario.bodies[0];
  const ShapeSource shape;
  EXPECT_EQ(std::get<ShapeSource>(body.surface).radius, shape.radius);
  EXPECT_EQ(std::get<ShapeSource>(body.surface).triangles, shape.triangles);
  EXPECT_EQ(body.density, BodyScenario{}.density);
  EXPECT_EQ(body.prestretch.standard.second, 1);
  EXPECT_EQ(body.fluid.kind, FluidKind::kIncompressible);
  EXPECT_EQ(body.fluid.density, FluidDefinition{}.density);
  EXPECT_FALSE(body.fluid.initial_pressure);
  EXPECT_TRUE(body.fixed.empty());
  EXPECT_EQ(scenario.simulation.analysis, SimulationOptions{}.analysis);
  EXPECT_EQ(scenario.simulation.time_step, SimulationOptions{}.time_step);
  EXPECT_FALSE(scenario.view.camera.position);
  EXPECT_DOUBLE_EQ(scenario.view.camera.field_of_view, std::numbers::pi / 6);
  EXPECT_EQ(scenario.view.lights.key, LightsDefinition{}.key);
  EXPECT_EQ(scenario.view.look.background, LookDefinition{}.background);
  EXPECT_EQ(scenario.overlays.force_plot, OverlayChoice{}.force_plot);
  EXPECT_EQ(scenario.record.size, RecordOptions{}.size);
  EXPECT_EQ(scenario.record.frames_per_second, RecordOptions{}.frames_per_second);
  EXPECT_EQ(scenario.record.video, RecordOptions{}.video);
  EXPECT_EQ(scenario.record.tier, RecordOptions{}.tier);
}

TEST(LoadScenario, OverridesReplaceParameters) {
  const Scenario scenario = load_scenario(kValid / "contract.yaml", {{"depth", "3 mm"}});
  EXPECT_EQ(std::get<PalpateClip>(scenario.timeline[0].action).depth, 0.003);
  EXPECT_EQ(nlohmann::json::parse(scenario.resolved)["parameters"]["depth"], "3 mm");
}

TEST(LoadScenario, AWrongOverrideIsAnError) {
  const std::string file = (kValid / "contract.yaml").string();
  EXPECT_EQ(errors_of(file, {{"deepth", "3 mm"}}),
            file + ":3:1: error: `--set deepth=3 mm`: the scenario has no parameter `deepth`, did you mean `depth`?");
  EXPECT_EQ(errors_of(file, {{"depth", "3 kPa"}}),
            file +
                ":23:91: error: timeline[1].palpate.depth: expected a length (e.g. 4 mm), got 3 kPa, a pressure "
                "(`${depth}` is `3 kPa`)");
}

TEST(LoadScenario, TheResolvedScenarioHasSiNumbersAndDefaults) {
  const nlohmann::json resolved = nlohmann::json::parse(load_scenario(kValid / "contract.yaml", {}).resolved);
  EXPECT_EQ(resolved["bodies"]["organ"]["wall"]["thickness"], 0.001);
  EXPECT_EQ(resolved["timeline"][0]["palpate"]["standoff"], 0.005);
  EXPECT_EQ(resolved["record"]["size"][0], 1280);
  EXPECT_EQ(resolved["timeline"][1]["move"]["body"], "organ");
}

TEST(LoadScenario, TheResolvedScenarioDoesNotDependOnWhereItLies) {
  const std::filesystem::path elsewhere = std::filesystem::temp_directory_path() / "thinwall_load_scenario_test";
  std::filesystem::remove_all(elsewhere);
  std::filesystem::copy(kValid, elsewhere, std::filesystem::copy_options::recursive);
  const std::string here = load_scenario(kValid / "everything.yaml", {}).resolved;
  EXPECT_EQ(load_scenario(elsewhere / "everything.yaml", {}).resolved, here);
  EXPECT_EQ(nlohmann::json::parse(here)["bodies"]["bladder"]["surface"]["mesh"], "parts/tetrahedron.obj");
  std::filesystem::remove_all(elsewhere);
}

TEST(LoadScenario, WarningsHavePlacesToo) {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "thinwall_load_warning_test.yaml";
  std::ofstream(file) << read_file(kValid / "minimal.yaml") << "tools: { idle: {} }\n";
  const Scenario scenario = load_scenario(file, {});
  std::filesystem::remove(file);
  EXPECT_EQ(scenario.warnings,
            std::vector<std::string>{file.string() + ":6:10: warning: tools.idle: no clip uses this tool"});
}

TEST(LoadScenario, AFileThatCannotBeReadIsAnInputError) {
  EXPECT_EQ(errors_of("no/such/file.yaml", {}), "no/such/file.yaml:1:1: error: no such file");
  EXPECT_EQ(errors_of("/", {}), "/:1:1: error: this is a directory, not a file");
}

}  // namespace
}  // namespace thinwall
