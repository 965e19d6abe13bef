#include "studio/organs/BodyBuilder.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/mesh/MeshTopology.hpp"
#include "studio/organs/SpanWords.hpp"

namespace thinwall {
namespace {

BodyScenario hemisphere() {
  BodyScenario body;
  body.name = "organ";
  body.location = {"scene.yaml", 3, 3};
  body.surface_location = {"scene.yaml", 4, 14};
  body.surface = ShapeSource{.shape = Shape::kHemisphere, .radius = 0.02, .triangles = 64};
  body.thickness.standard = 1e-3;
  return body;
}

std::string refusal_of(const BodyScenario& body) {
  std::vector<std::string> notes;
  try {
    build_body(body, notes);
  } catch (const InputErrors& errors) {
    return errors.what();
  }
  return "accepted";
}

TEST(BodyBuilder, EveryShapeIsMadeAndTold) {
  for (const Shape shape : {Shape::kSphere, Shape::kHemisphere, Shape::kSemicylinder, Shape::kSheet, Shape::kDisc,
                            Shape::kCylinder, Shape::kAnnulus, Shape::kStrip}) {
    std::vector<std::string> notes;
    const SurfaceMesh mesh = make_surface(ShapeSource{.shape = shape, .triangles = 300}, {}, notes);
    EXPECT_GT(mesh.triangles.size(), 200u);
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_NE(notes[0].find("(300 wanted)"), std::string::npos);
  }
}

TEST(BodyBuilder, AShapeIsToldWithItsSizeAndDoubtedWhereNoOrganIsSoLarge) {
  const auto notes_of = [](double radius) {
    std::vector<std::string> notes;
    make_surface(ShapeSource{.shape = Shape::kSphere, .radius = radius, .triangles = 20}, {}, notes);
    return notes;
  };
  ASSERT_EQ(notes_of(25e-3).size(), 1U);
  EXPECT_NE(notes_of(25e-3)[0].find(" vertices, 44.7 x 42.5 x 50 mm"), std::string::npos) << notes_of(25e-3)[0];
  ASSERT_EQ(notes_of(25).size(), 2U);
  EXPECT_NE(notes_of(25)[1].find("is 50 m across, which no organ is"), std::string::npos) << notes_of(25)[1];
  EXPECT_EQ(notes_of(25e-6).size(), 2U);
}

TEST(BodyBuilder, ASurfaceIsTurnedAboutItsOwnOriginAndBroughtToItsPlaceBeforeRegionsAreLookedFor) {
  BodyScenario scenario = hemisphere();
  const SurfacePlacement placement{.at = {0.1, 0, -0.03}, .turned = Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX())};
  std::get<ShapeSource>(scenario.surface).placed = placement;
  // Its crown, which looked up, lies 20 mm below its base.
  scenario.fixed = {{.region = SphereRegion{.center = {0.1, 0, -0.05}, .radius = 1e-6}}};
  std::vector<std::string> notes;
  const BodyDefinition placed = build_body(scenario, notes), own = build_body(hemisphere(), notes);
  ASSERT_EQ(placed.mesh.vertices.size(), own.mesh.vertices.size());
  for (std::size_t v = 0; v < own.mesh.vertices.size(); ++v) {
    const Eigen::Vector3d& point = own.mesh.vertices[v];
    const Eigen::Vector3d place(0.1 + point.x(), -point.y(), -0.03 - point.z());
    EXPECT_LT((placed.mesh.vertices[v] - place).norm(),
              1e-15);  // coordinates of a tenth of a metre are rounded by 1e-17
  }
  EXPECT_EQ(vertices_in(placed.fixed[0].region, placed.mesh).size(), 1U);
}

TEST(BodyBuilder, ALoadOnEdgesNeedsBothEndsOfOne) {
  BodyScenario scenario = hemisphere();
  scenario.loads.resize(1);
  scenario.loads[0].load.kind = LoadKind::kDeadLineForce;
  scenario.loads[0].load.region = SphereRegion{.center = {0, 0, 0.02}, .radius = 1e-3};
  EXPECT_NE(
      refusal_of(scenario).find("bodies.organ.loads[1].region: holds a vertex of the surface, but no edge with both"),
      std::string::npos)
      << refusal_of(scenario);
  scenario.loads[0].load.region = GroupRegion{"base"};
  EXPECT_EQ(refusal_of(scenario), "accepted");
}

TEST(BodyBuilder, WallAndFluidAreHandedOn) {
  BodyScenario scenario = hemisphere();
  scenario.density = 1100;
  scenario.prestretch.standard = {.first = 1.2, .second = 1.2};
  scenario.fluid.initial_pressure = 500;
  scenario.fixed = {{.region = GroupRegion{"base"}}};
  std::vector<std::string> notes;
  const BodyDefinition body = build_body(scenario, notes);
  EXPECT_EQ(body.name, "organ");
  EXPECT_EQ(body.mesh.vertices.size(), 41u);
  EXPECT_EQ(body.thickness, std::vector<double>(64, 1e-3));
  EXPECT_EQ(body.density, 1100);
  EXPECT_EQ(body.prestretch.at(0).first, 1.2);
  EXPECT_EQ(body.prestretch.at(0).second, 1.2);
  EXPECT_EQ(body.fluid.initial_pressure, 500);
  EXPECT_EQ(body.fixed.size(), 1u);
}

TEST(BodyBuilder, LaterThicknessRegionWins) {
  BodyScenario scenario = hemisphere();
  scenario.thickness.regions = {{AboveRegion{2, 0.01}, 2e-3}, {AboveRegion{2, 0.018}, 3e-3}};
  std::vector<std::string> notes;
  const BodyDefinition body = build_body(scenario, notes);
  EXPECT_EQ(std::count(body.thickness.begin(), body.thickness.end(), 3e-3), 4);
  EXPECT_GT(std::count(body.thickness.begin(), body.thickness.end(), 2e-3), 10);
  EXPECT_GT(std::count(body.thickness.begin(), body.thickness.end(), 1e-3), 10);
}

TEST(BodyBuilder, AWallThickerThanTwiceTheOrganIsRefused) {
  BodyScenario scenario = hemisphere();
  scenario.thickness.standard = 1;
  scenario.thickness.location = {"scene.yaml", 6, 18};
  EXPECT_EQ(refusal_of(scenario),
            "scene.yaml:6:18: error: bodies.organ.wall.thickness: 1000 mm is more than twice the surface's extent, 40 "
            "mm; set the unit of either right");
  scenario.thickness.standard = 0.079;
  EXPECT_EQ(refusal_of(scenario), "accepted");
}

TEST(BodyBuilder, ChambersWhosePointsNameNoPartOfTheirOwnAreTold) {
  BodyScenario scenario = hemisphere();
  scenario.fluid.chambers = {{"bulb", {0, 0, 0.01}}, {"neck", {0, 0, 0.03}}};
  scenario.chamber_locations = {{"scene.yaml", 9, 20}, {"scene.yaml", 10, 20}};
  EXPECT_EQ(
      refusal_of(scenario),
      "scene.yaml:10:20: error: bodies.organ.contents.chambers.neck.at: chamber `neck`: its point lies in no closed "
      "part; move it into the part that is meant");
  scenario.fluid.chambers[1].inside = {0, 0, 0.005};
  EXPECT_EQ(
      refusal_of(scenario),
      "scene.yaml:10:20: error: bodies.organ.contents.chambers.neck.at: chambers `bulb` and `neck`: their points lie "
      "in the same closed part; move it into the part that is meant");
  scenario.fluid.chambers.pop_back();
  EXPECT_EQ(refusal_of(scenario), "accepted");
}

TEST(SpanWords, TellBothEndsApartHoweverFarOffTheyLie) {
  const Eigen::Vector3d corner(1000, -1000, 1000);
  const Eigen::AlignedBox3d far(corner, corner + Eigen::Vector3d(0.0632, 0.08, 0));
  EXPECT_EQ(span_words(far), "x 1000000 ... 1000063.2, y -1000000 ... -999920, z 1000000 ... 1000000 mm");
  const Eigen::AlignedBox3d near(Eigen::Vector3d(-0.0371849, 0, 0.02), Eigen::Vector3d(0.02, 1e-5, 0.05));
  EXPECT_EQ(span_words(near), "x -37.18 ... 20, y 0 ... 0.01, z 20 ... 50 mm");
}

TEST(BodyBuilder, RegionsThatHoldNothingAreAllTold) {
  BodyScenario scenario = hemisphere();
  scenario.thickness.regions = {{GroupRegion{"bace"}, 2e-3, {"scene.yaml", 8, 11}},
                                {BelowRegion{2, -1}, 3e-3, {"scene.yaml", 9, 11}}};
  scenario.fixed = {{.region = GroupRegion{"ends"}}, {.region = SphereRegion{{1, 0, 0}, 0.1}}};
  scenario.fixed_locations = {{"scene.yaml", 12, 9}, {"scene.yaml", 13, 9}};
  EXPECT_EQ(
      refusal_of(scenario),
      "scene.yaml:8:11: error: bodies.organ.wall.thickness.regions[1].in: the surface has no group `bace`, did you "
      "mean `base`?; it has `base`, `wall`\n"
      "scene.yaml:9:11: error: bodies.organ.wall.thickness.regions[2].in: holds no wall triangle of the surface, "
      "which spans x -20 ... 20, y -20 ... 20, z 0 ... 20 mm\n"
      "scene.yaml:12:9: error: bodies.organ.fixed[1].region: the surface has no group `ends`; it has `base`, `wall`\n"
      "scene.yaml:13:9: error: bodies.organ.fixed[2].region: holds no vertex of the surface, which spans x -20 ... "
      "20, y -20 ... 20, z 0 ... 20 mm");
}

TEST(BodyBuilder, BoundaryOfAClosedWallIsEmptyAndTold) {
  BodyScenario scenario = hemisphere();
  scenario.surface = ShapeSource{.shape = Shape::kSphere};
  scenario.fixed = {{.region = BoundaryRegion{}}};
  EXPECT_EQ(refusal_of(scenario),
            "scene.yaml:3:3: error: bodies.organ.fixed[1].region: holds no vertex: the wall has no open edges");
}

TEST(BodyBuilder, BoundaryWithoutTrianglesIsToldAsSuch) {
  BodyScenario scenario = hemisphere();
  scenario.surface = ShapeSource{.shape = Shape::kDisc, .radius = 0.02, .triangles = 300};
  scenario.fluid.kind = FluidKind::kNone;
  scenario.thickness.regions = {{BoundaryRegion{}, 2e-3, {"scene.yaml", 8, 11}}};
  const std::string told = refusal_of(scenario);
  EXPECT_NE(told.find("holds no wall triangle: none has all three corners on open edges; take `plane`"),
            std::string::npos)
      << told;
}

TEST(BodyBuilder, FluidInAnOpenShapeIsRefusedAndNoneIsAccepted) {
  BodyScenario scenario = hemisphere();
  scenario.surface = ShapeSource{.shape = Shape::kDisc, .radius = 0.02, .triangles = 6};
  EXPECT_EQ(
      refusal_of(scenario),
      "scene.yaml:4:14: error: bodies.organ.surface: shape `disc`: the fluid needs a closed surface, but this has 6 "
      "open edges around 1 hole: (20, 0, 0) to (10, 17.3205, 0), (20, 0, 0) to (10, -17.3205, 0), (10, 17.3205, 0) "
      "to (-10, 17.3205, 0) and 3 more, in mm; close the surface, or say `contents: { fluid: none }`");
  scenario.fluid.kind = FluidKind::kNone;
  EXPECT_EQ(refusal_of(scenario), "accepted");
}

TEST(BodyBuilder, AnnulusWithoutBreadthIsRefused) {
  BodyScenario scenario = hemisphere();
  scenario.surface = ShapeSource{.shape = Shape::kAnnulus, .radius = 0.01, .inner_radius = 0.01};
  EXPECT_EQ(
      refusal_of(scenario),
      "scene.yaml:4:14: error: bodies.organ.surface: inner_radius is 10 mm, but must be below the radius of 10 mm");
}

TEST(BodyBuilder, FibresLieAlongOneDirectionOrDifferByRegion) {
  BodyScenario scenario = hemisphere();
  std::vector<std::string> notes;
  EXPECT_TRUE(build_body(scenario, notes).fibres.empty());
  scenario.fibres = Field<Eigen::Vector3d>{.standard = {1, 2, 0.5}};
  EXPECT_EQ(build_body(scenario, notes).fibres, std::vector<Eigen::Vector3d>{Eigen::Vector3d(1, 2, 0.5)});
  scenario.fibres->regions = {{.region = AboveRegion{.axis = 2, .at = 0.01}, .value = {0, 1, 0.1}}};
  const BodyDefinition body = build_body(scenario, notes);
  ASSERT_EQ(body.fibres.size(), body.mesh.triangles.size());
  EXPECT_EQ(std::count(body.fibres.begin(), body.fibres.end(), Eigen::Vector3d(0, 1, 0.1)),
            static_cast<std::ptrdiff_t>(triangles_in(scenario.fibres->regions[0].region, body.mesh).size()));
}

TEST(BodyBuilder, ParametersOfTheLawDifferByRegion) {
  BodyScenario scenario = hemisphere();
  scenario.material = {.law = find_wall_law("mooney_rivlin"), .parameters = {0, 1e3}};
  scenario.parameter_fields = {
      {.index = 0,
       .path = "c1",
       .values = {.standard = 5e3, .regions = {{.region = AboveRegion{.axis = 2, .at = 0.01}, .value = 7e3}}}}};
  std::vector<std::string> notes;
  const BodyDefinition body = build_body(scenario, notes);
  ASSERT_EQ(body.materials.size(), 64u);
  const std::vector<int> above = triangles_in(AboveRegion{.axis = 2, .at = 0.01}, body.mesh);
  for (int t = 0; t < 64; ++t) {
    const double c1 = std::count(above.begin(), above.end(), t) == 1 ? 7e3 : 5e3;
    EXPECT_EQ(body.materials[t].parameters, (std::vector<double>{c1, 1e3}));
  }
}

TEST(BodyBuilder, ParametersThatDoNotGoTogetherSomewhereAreRefusedWithThePlace) {
  BodyScenario scenario = hemisphere();
  scenario.material = {.law = find_wall_law("fung"), .parameters = {1e3, 1, 1, 0, 1}};
  scenario.material_location = {"scene.yaml", 7, 17};
  scenario.fibres = Field<Eigen::Vector3d>{.standard = {1, 2, 0.5}};
  scenario.parameter_fields = {
      {.index = 3,
       .path = "a3",
       .values = {.standard = 0.5, .regions = {{.region = AboveRegion{.axis = 2, .at = 0.01}, .value = 2}}}}};
  const std::string refusal = refusal_of(scenario);
  EXPECT_TRUE(refusal.starts_with("scene.yaml:7:17: error: bodies.organ.wall.material: at [")) << refusal;
  EXPECT_TRUE(refusal.ends_with("mm: the energy falls with some strains: choose a3 with a square below a1 a2"))
      << refusal;
}

TEST(BodyBuilder, ToughnessIsNoneOrOneOrDiffersByRegion) {
  BodyScenario scenario = hemisphere();
  std::vector<std::string> notes;
  EXPECT_TRUE(build_body(scenario, notes).toughness.empty());
  scenario.toughness = Field<double>{.standard = 400};
  EXPECT_EQ(build_body(scenario, notes).toughness, std::vector<double>{400});
  scenario.toughness->regions = {{.region = AboveRegion{.axis = 2, .at = 0.01}, .value = 200}};
  const BodyDefinition body = build_body(scenario, notes);
  const std::vector<int> above = triangles_in(AboveRegion{.axis = 2, .at = 0.01}, body.mesh);
  ASSERT_EQ(body.toughness.size(), body.mesh.triangles.size());
  EXPECT_EQ(std::ranges::count(body.toughness, 200.0), static_cast<int>(above.size()));
  EXPECT_EQ(std::ranges::count(body.toughness, 400.0), static_cast<int>(body.toughness.size() - above.size()));
}

TEST(BodyBuilder, PrestretchDiffersByRegionAndLiesInTheWall) {
  BodyScenario scenario = hemisphere();
  scenario.surface = ShapeSource{.shape = Shape::kSheet, .triangles = 32};
  scenario.fluid.kind = FluidKind::kNone;
  scenario.prestretch.standard = {.first = 1.1, .second = 1.1};
  scenario.prestretch.regions = {{.region = AboveRegion{.axis = 0, .at = 0},
                                  .value = {.along = {0, 1, 0}, .first = 1.3, .second = 1},
                                  .location = {"scene.yaml", 9, 24}}};
  std::vector<std::string> notes;
  const BodyDefinition body = build_body(scenario, notes);
  ASSERT_EQ(body.prestretch.size(), body.mesh.triangles.size());
  const std::vector<int> right = triangles_in(AboveRegion{.axis = 0, .at = 0}, body.mesh);
  for (int t = 0; t < static_cast<int>(body.prestretch.size()); ++t) {
    EXPECT_EQ(body.prestretch[t].second, std::count(right.begin(), right.end(), t) == 1 ? 1 : 1.1);
  }
  scenario.prestretch.regions[0].value.along = {0, 0, 1};
  const std::string refusal = refusal_of(scenario);
  EXPECT_TRUE(
      refusal.starts_with("scene.yaml:9:24: error: bodies.organ.wall.prestretch: its directions stand perpendicular"))
      << refusal;
}

TEST(BodyBuilder, FibresThatStandOnTheWallAreRefusedWithThePlaceAndTheCure) {
  BodyScenario scenario = hemisphere();
  scenario.surface = ShapeSource{.shape = Shape::kSheet, .triangles = 32};
  scenario.fluid.kind = FluidKind::kNone;
  scenario.fibres = Field<Eigen::Vector3d>{.standard = {0, 0, 1}, .location = {"scene.yaml", 9, 24}};
  const std::string refusal = refusal_of(scenario);
  EXPECT_NE(refusal.find("scene.yaml:9:24"), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("perpendicular to the wall at ["), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("`regions`"), std::string::npos) << refusal;
}

}  // namespace
}  // namespace thinwall
