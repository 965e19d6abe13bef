// Incisions from the scenario to the records: what the blade does, what it costs, and what stays in balance.

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include "studio/director/ScenarioRun.hpp"

namespace thinwall {
namespace {

const ToolDefinition kBlade = {
    .name = "blade", .kind = ToolKind::kScalpel, .length = 0.012, .width = 0.003, .thickness = 4e-4};
constexpr double kToughness = 150;   // joule / metre^2
constexpr double kThickness = 1e-3;  // metres

BodyScenario wall(const std::string& name, const ShapeSource& shape) {
  BodyScenario body{.name = name,
                    .surface = shape,
                    .thickness = {.standard = kThickness},
                    .material = {.law = find_wall_law("neo_hookean"), .parameters = {40e3}}};
  body.toughness = Field<double>{.standard = kToughness};
  return body;
}

Scenario scenario_of(const BodyScenario& body) {
  Scenario scenario{.name = "test", .title = "test"};
  scenario.bodies = {body};
  scenario.tools = {kBlade};
  scenario.simulation = {.analysis = Analysis::kDynamic, .time_step = 0.01};
  return scenario;
}

/// A sheet stretched by `stretch` both ways, and a straight cut of 14 mm in the middle.
Scenario sheet_scenario(double stretch) {
  BodyScenario sheet = wall("skin", {.shape = Shape::kSheet, .length = 0.04, .width = 0.04, .triangles = 600});
  sheet.fluid.kind = FluidKind::kNone;
  sheet.prestretch = {.standard = {.first = stretch, .second = stretch}};
  sheet.fixed = {{.region = BoundaryRegion{}}};
  Scenario scenario = scenario_of(sheet);
  scenario.timeline = {{.action = InciseClip{.tool = "blade",
                                             .body = "skin",
                                             .path = {{-0.007, 0.0005, 0}, {0.007, -0.0005, 0}},
                                             .direction = -Eigen::Vector3d::UnitZ(),
                                             .depth = 0.003,
                                             .speed = 0.02,
                                             .hold = 0.05,
                                             .standoff = 0.002}}};
  return scenario;
}

/// A filled ball, held below, and a cut over its top.
Scenario ball_scenario() {
  BodyScenario ball = wall("ball", {.shape = Shape::kSphere, .radius = 0.02, .triangles = 720});
  ball.fluid.initial_pressure = 800;
  ball.fixed = {{.region = BelowRegion{.axis = 2, .at = -0.01}}};
  Scenario scenario = scenario_of(ball);
  scenario.timeline = {{.action = InciseClip{.tool = "blade",
                                             .body = "ball",
                                             .path = {{-0.006, 0, 0.02}, {0.006, 0, 0.02}},
                                             .depth = 0.003,
                                             .speed = 0.03,
                                             .standoff = 0.002}}};
  return scenario;
}

double stored(const BodyRecord& body) {
  return body.elastic + body.bending + body.kinetic + body.fluid + body.gravity + body.contact;
}

double spent(const BodyRecord& body) {
  return body.viscous + body.friction + body.leak + body.fracture + body.jump + body.numerical;
}

/// Stored and spent energy is the work put in, to 0.5 % of the largest of the terms so far.
void expect_closed_books(const BodyRecord& body, double& largest) {
  for (const double term : {body.elastic, body.fracture, body.leak, body.tool_work, body.script_work}) {
    largest = std::max(largest, std::abs(term));
  }
  EXPECT_LT(std::abs(stored(body) + spent(body) - body.tool_work - body.script_work), 5e-3 * largest);
}

TEST(Incision, TheWallDentsThenIsCutAlongThePathAndCostsWhatItsToughnessAsks) {
  ScenarioRun run(sheet_scenario(1.02));
  const std::size_t uncut = run.snapshot().surfaces.at(0).positions.size();
  std::map<std::string, int> steps_in_phase;
  double largest = 0, longest = 0, dent = 0, drag = 0;
  while (run.step()) {
    const ToolRecord& tool = run.record().tools.at(0);
    const BodyRecord& body = run.record().bodies.at(0);
    ++steps_in_phase[tool.phase];
    expect_closed_books(body, largest);
    EXPECT_GE(body.cut_length, longest) << "at " << run.time();
    longest = body.cut_length;
    if (tool.phase == "contact") {
      EXPECT_EQ(body.cut_length, 0);
      dent = std::max(dent, tool.force.z());
    }
    if (tool.phase == "cutting") drag = std::max(drag, -tool.force.x());
    if (tool.phase == "approach") {
      EXPECT_EQ(tool.force.norm(), 0);
    }
    EXPECT_EQ(run.snapshot().surfaces[0].positions.size(), run.snapshot().surfaces[0].topology->rest_positions.size());
  }
  for (const char* phase : {"approach", "contact", "cutting", "hold", "withdrawal"}) {
    EXPECT_GT(steps_in_phase[phase], 2) << phase;
  }
  EXPECT_GT(dent, 0.02) << "the blade is pushed back while the wall dents";
  // Drawn along, it feels what new area costs per length, and up to a tenth more while it is behind with that.
  EXPECT_GT(drag, 0.5 * kToughness * kThickness);
  EXPECT_LT(drag, 1.1 * kToughness * kThickness);
  // A cut that ends within the wall may stop short of its path by an edge of 1.6 mm.
  const double path = std::hypot(0.014, 0.001);
  EXPECT_NEAR(longest, path, 1.6e-3);
  const BodyRecord& body = run.record().bodies.at(0);
  EXPECT_NEAR(body.fracture, kToughness * kThickness * longest, 0.1 * kToughness * kThickness * path);
  EXPECT_GT(run.snapshot().surfaces[0].positions.size(), uncut + 8) << "lips have nodes of their own";
}

TEST(Incision, OverAnEarlierWoundThatGapesGoesStraightOnAndNotAroundTheBody) {
  BodyScenario ball = wall("ball", {.shape = Shape::kSphere, .radius = 0.02, .triangles = 720});
  ball.thickness = {.standard = 6e-4};
  ball.material.parameters = {60e3};
  ball.fluid.initial_pressure = 1000;
  ball.fixed = {{.region = BelowRegion{.axis = 2, .at = -0.015}}};
  Scenario scenario = scenario_of(ball);
  scenario.tools[0].length = 0.014;
  scenario.tools[0].friction = 0.1;
  scenario.simulation.time_step = 0.005;
  InciseClip incision{.tool = "blade", .body = "ball", .depth = 0.003, .speed = 0.04};
  incision.path = {{-0.008, 0, 0.025}, {0.008, 0, 0.025}};
  InciseClip crossing = incision;
  crossing.path = {{0, -0.008, 0.025}, {0, 0.008, 0.025}};
  crossing.direction = -Eigen::Vector3d::UnitZ();
  scenario.timeline = {{.action = incision}, {.action = crossing}};
  ScenarioRun run(scenario);
  while (run.step()) continue;
  // Twice 16 mm, of the wall as it is stretched by the pressure; beyond the wound the body measures 0.1 m around.
  EXPECT_GT(run.record().bodies.at(0).cut_length, 0.02);
  EXPECT_LT(run.record().bodies.at(0).cut_length, 0.036);
}

TEST(Incision, TheBladeStaysItsDepthBelowThePathAlongTheInwardNormal) {
  ScenarioRun run(ball_scenario());
  int cutting = 0;
  while (run.step() && run.record().tools.at(0).phase != "withdrawal") {
    const ToolRecord& tool = run.record().tools.at(0);
    if (tool.phase != "cutting") continue;
    ++cutting;
    // The ball under pressure is larger than at rest by less than a millimetre.
    EXPECT_NEAR(tool.position.norm(), 0.0175, 0.0006);
    const Double3 direction = run.snapshot().tools.at(0).direction;
    const Eigen::Vector3d inward = -tool.position.normalized();
    EXPECT_GT(inward.dot(Eigen::Vector3d(direction[0], direction[1], direction[2])), 0.995);
    EXPECT_NEAR(tool.depth, 0.003, 1e-4);
  }
  EXPECT_GT(cutting, 20);
}

TEST(Incision, OfAFilledBodyLetsTheFluidOutAndBooksAllOfIt) {
  Scenario scenario = ball_scenario();
  scenario.record.points = {{.name = "side", .body = "ball", .at = {0.014, 0.014, 0}}};
  ScenarioRun run(scenario);
  const double fluid = run.record().bodies.at(0).fluid_volume, pressure = run.record().bodies[0].pressure;
  const Eigen::Vector3d place = run.record().points.at(0).stress_free;
  double largest = 0;
  while (run.step()) {
    const BodyRecord& body = run.record().bodies.at(0);
    EXPECT_NEAR(body.fluid_volume + body.leaked, fluid, 1e-9 * fluid);
    EXPECT_LT((run.record().points.at(0).stress_free - place).norm(), 1e-12) << "a cut does not move what is followed";
    expect_closed_books(body, largest);
  }
  const BodyRecord& body = run.record().bodies.at(0);
  EXPECT_GT(body.leaked, 0.01 * fluid);
  EXPECT_LT(body.pressure, 0.7 * pressure);
  EXPECT_GT(body.open_area, 0);
  EXPECT_NEAR(body.cut_length, 0.0122, 2.6e-3);  // edges of 2.6 mm
}

TEST(Incision, OfATenseWallRunsAheadOfTheBladeAndSaysSo) {
  Scenario scenario = sheet_scenario(1.1);
  scenario.bodies[0].toughness = Field<double>{.standard = 20};
  ScenarioRun run(scenario);
  double largest = 0;
  while (run.step()) expect_closed_books(run.record().bodies.at(0), largest);
  const BodyRecord& body = run.record().bodies.at(0);
  EXPECT_GT(body.cut_length, 0.017) << "the path is 14 mm long";
  EXPECT_NEAR(body.fracture, 20 * kThickness * body.cut_length, 1e-3 * body.fracture);
  std::string all;
  for (const std::string& warning : run.warnings()) all += warning + "\n";
  EXPECT_NE(all.find("s on the cut of blade `blade` ran ahead, by "), std::string::npos) << all;
}

/// Where blades passed above walls, as a run tells it.
std::string notes_of_walls_below(const ScenarioRun& run) {
  std::string all;
  for (const std::string& warning : run.warnings()) {
    if (warning.find("passed above the wall") != std::string::npos) all += warning + "\n";
  }
  return all;
}

TEST(Incision, SaysThatTheWallHasGivenWayFromUnderTheBladeWhereAnOrganEmptiesAndNotOverAnOpenWound) {
  Scenario scenario = ball_scenario();
  BodyScenario& ball = scenario.bodies[0];
  ball.thickness = {.standard = 6e-4};
  ball.material.parameters = {60e3};
  ball.fluid.initial_pressure = 1000;
  ball.fixed = {{.region = BelowRegion{.axis = 2, .at = -0.015}}};
  auto& clip = std::get<InciseClip>(scenario.timeline[0].action);
  {
    // There and back, in its own wound.
    clip.path = {{-0.006, 0, 0.02}, {0.006, 0, 0.02}, {-0.004, 0, 0.02}};
    ScenarioRun run(scenario);
    while (run.step()) {
    }
    EXPECT_EQ(notes_of_walls_below(run), "");
  }
  constexpr double kLoop = 0.007;  // metres, radius
  clip.path.clear();
  for (int k = 0; k <= 12; ++k) {
    const double angle = 2 * std::numbers::pi * k / 12;
    clip.path.emplace_back(kLoop * std::cos(angle), kLoop * std::sin(angle), 0.02);
  }
  clip.speed = 0.04;
  std::get<ShapeSource>(ball.surface).triangles = 700;
  ball.toughness = Field<double>{.standard = 150};
  scenario.tools[0].length = 0.014;
  scenario.tools[0].friction = 0.1;
  scenario.simulation.time_step = 5e-3;
  clip.standoff = 0.005;
  ScenarioRun run(scenario);
  double most = 0, given_back = 0;  // joule
  while (run.step()) {
    const double fracture = run.record().bodies.at(0).fracture;
    most = std::max(most, fracture);
    given_back = std::max(given_back, most - fracture);
  }
  const std::string note = notes_of_walls_below(run);
  std::printf("%.3g m cut, %.3g of %.3g J given back; %s", run.record().bodies.at(0).cut_length, given_back, most,
              note.c_str());
  // Above the wall the blade pays for nothing that it does not cut; while it cuts it pays a part of an edge ahead.
  EXPECT_LT(given_back, 0.06 * most);
  EXPECT_LT(run.record().bodies.at(0).cut_length, 0.8 * 2 * std::numbers::pi * kLoop) << "or it is not the case meant";
  EXPECT_NE(note.find("body `ball`: from "), std::string::npos) << note;
  // Drawn on the wall the same loop is cut.
  clip.marked = true;
  ScenarioRun following(scenario);
  while (following.step()) continue;
  EXPECT_EQ(notes_of_walls_below(following), "");
  EXPECT_GT(following.record().bodies.at(0).cut_length, 0.95 * 2 * std::numbers::pi * kLoop);  // seen 1.03
}

TEST(Incision, CutsPathsThatAreShorterThanTheTrianglesAndTellsOfBladesThatCutNothing) {
  const auto note_of = [](double length, double& cut) {
    Scenario scenario = ball_scenario();
    std::get<ShapeSource>(scenario.bodies[0].surface).triangles = 320;  // edges of 6 mm
    std::get<InciseClip>(scenario.timeline[0].action).path = {{0, 0, 0.02}, {length, 0, 0.02}};
    ScenarioRun run(scenario);
    while (run.step()) {
    }
    cut = run.record().bodies.at(0).cut_length;
    std::string note;
    for (const std::string& warning : run.warnings()) {
      if (warning.find("cut nothing") != std::string::npos) note += warning;
    }
    return note;
  };
  double cut = 0;
  for (const double length : {0.002, 0.004, 0.006}) {
    SCOPED_TRACE(length);
    EXPECT_EQ(note_of(length, cut), "");
    EXPECT_NEAR(cut, length, 0.3 * length);
  }
  const std::string note = note_of(0.00005, cut);
  EXPECT_EQ(note.find("timeline[1]: blade `blade` has gone its whole path of 0."), 0U) << note;
  EXPECT_NE(note.find(" mm and cut nothing; body `ball` has triangles with edges of "), std::string::npos) << note;
  EXPECT_EQ(cut, 0);
}

TEST(Incision, TellsOfABladeThatCutsHardlyAnythingBesideABorderThatIsHeld) {
  const auto note_of = [](double beside) {
    Scenario scenario = sheet_scenario(1.05);
    std::get<InciseClip>(scenario.timeline[0].action).path = {{-0.015, beside, 0}, {0.015, beside, 0}};
    ScenarioRun run(scenario);
    while (run.step()) {
    }
    std::string note;
    for (const std::string& warning : run.warnings()) {
      if (warning.find("cut no more than") != std::string::npos) note += warning;
    }
    return note;
  };
  // The sheet is 40 mm wide, its triangles have edges of 2.5 mm.
  const std::string note = note_of(-0.0197);
  EXPECT_EQ(note.find("timeline[1]: blade `blade` has gone its whole path of 30 mm and cut no more than "), 0U) << note;
  EXPECT_EQ(note_of(-0.017), "");
}

TEST(Incision, GoesIntoABorderThatIsHeldAndFeelsWhatToughnessAsks) {
  Scenario scenario = sheet_scenario(1.1);
  auto& clip = std::get<InciseClip>(scenario.timeline[0].action);
  clip.path = {{0, -0.02, 0}, {0, 0, 0}};
  clip.speed = 0.04;
  ScenarioRun run(scenario);
  double strongest = 0;
  while (run.step()) strongest = std::max(strongest, run.record().tools.at(0).force.norm());
  const BodyRecord body = run.record().bodies.at(0);
  std::printf("%.3g N, %.3g m cut\n", strongest, body.cut_length);
  EXPECT_GT(body.cut_length, 0.018);
  EXPECT_NEAR(body.fracture, kToughness * kThickness * body.cut_length, 0.01 * body.fracture);
  // The dent beside the border asks for 0.38 N. What cannot make way bears any force: where it is felt, 1e5 N.
  EXPECT_LT(strongest, 5 * kToughness * kThickness);
}

TEST(Incision, CutsNothingAndFeelsNothingWhereItGoesBackInItsOwnWound) {
  Scenario scenario = sheet_scenario(1.1);
  auto& clip = std::get<InciseClip>(scenario.timeline[0].action);
  clip.path = {{-0.007, 0, 0}, {0.007, 0, 0}, {-0.005, 0, 0}};
  constexpr double kEdge = 1.6e-3;  // metres, of the triangles: so far it may still be beyond the tip
  ScenarioRun run(scenario);
  double last = -1, turned = 0, strongest = 0;  // metres, metres, newton
  while (run.step()) {
    const ToolRecord& tool = run.record().tools.at(0);
    if (tool.phase != "cutting") continue;
    const double x = tool.position.x();
    if (x < last) turned += last - x;
    last = x;
    if (turned > kEdge) strongest = std::max(strongest, tool.force.norm());
  }
  const BodyRecord body = run.record().bodies.at(0);
  std::printf("%.3g m cut, %.3g N on the way back\n", body.cut_length, strongest);
  EXPECT_GT(turned, 0.011);
  EXPECT_NEAR(body.cut_length, 0.014, 2e-3);
  EXPECT_EQ(strongest, 0);
  // What the dent had stored, and what the blade was ahead by when it turned: 12 % are seen.
  EXPECT_LT(std::abs(body.jump), 0.2 * body.fracture);
}

TEST(Incision, GoesOnIntoTheWallBesideItsWoundWhereItTurnsBackSharply) {
  Scenario scenario = sheet_scenario(1.1);
  auto& clip = std::get<InciseClip>(scenario.timeline[0].action);
  const double turn = 150 * std::numbers::pi / 180, arm = 0.012;
  const Eigen::Vector3d corner(0.006, 0, 0);
  clip.path = {{-0.006, 0, 0}, corner, corner + arm * Eigen::Vector3d(std::cos(turn), std::sin(turn), 0)};
  ScenarioRun run(scenario);
  while (run.step()) {
  }
  std::printf("%.3g m cut\n", run.record().bodies.at(0).cut_length);
  // 22.3 mm of 24 are seen: near the corner the wound gapes beside the first arm, and the blade is in it. Where it
  // passes through the wall instead, 11.8 mm.
  EXPECT_GT(run.record().bodies.at(0).cut_length, 1.7 * arm);
}

TEST(Incision, TwiceTheSameGivesTheSameDigest) {
  std::vector<std::string> digests;
  for (int k = 0; k < 2; ++k) {
    ScenarioRun run(sheet_scenario(1.05));
    while (run.time() < 0.5 && run.step()) {
    }
    digests.push_back(run.state_digest());
  }
  EXPECT_EQ(digests[0], digests[1]);
}

TEST(Incision, OfAFilledBodyIsTheSameOnProcessorsWithOtherCaches) {
  const std::ptrdiff_t first = Eigen::l1CacheSize(), second = Eigen::l2CacheSize(), third = Eigen::l3CacheSize();
  std::vector<std::string> digests;
  for (const int kilobytes : {32, 48}) {
    Eigen::setCpuCacheSizes(std::ptrdiff_t{1024} * kilobytes, second, third);
    ScenarioRun run(ball_scenario());
    while (run.step()) {
    }
    digests.push_back(run.state_digest());
  }
  Eigen::setCpuCacheSizes(first, second, third);
  EXPECT_EQ(digests[0], digests[1]);
}

TEST(Incision, ABladeThatStayedInIsTakenOutWhenItIsSetElsewhere) {
  Scenario scenario = sheet_scenario(1.02);
  std::get<InciseClip>(scenario.timeline[0].action).withdraw = false;
  Clip second = scenario.timeline[0];
  std::get<InciseClip>(second.action).path = {{-0.007, 0.01, 0}, {0.007, 0.01, 0}};
  scenario.timeline.push_back(second);
  ScenarioRun run(scenario);
  double between = 0;
  while (run.step()) {
    if (run.record().tools[0].phase == "contact") between = run.record().bodies[0].cut_length;
  }
  EXPECT_NEAR(between, 0.014, 1.6e-3);
  EXPECT_NEAR(run.record().bodies.at(0).cut_length, 0.028, 3.2e-3);
}

}  // namespace
}  // namespace thinwall
