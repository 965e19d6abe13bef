// Incisions that come back to where they began.

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "engine/mesh/MeshTopology.hpp"
#include "studio/director/ScenarioRun.hpp"

namespace thinwall {
namespace {

/// An octagon around a radius of 3 mm, and an eighth of it again, in a sheet with edges of 3.3 mm whose lips hardly
/// open.
Scenario octagon() {
  BodyScenario sheet{.name = "skin",
                     .surface = ShapeSource{.shape = Shape::kSheet, .length = 0.04, .width = 0.04, .triangles = 300},
                     .thickness = {.standard = 1e-3},
                     .material = {.law = find_wall_law("neo_hookean"), .parameters = {100e3}}};
  sheet.toughness = Field<double>{.standard = 10};
  sheet.fluid.kind = FluidKind::kNone;
  sheet.prestretch = {.standard = {.first = 1.02, .second = 1.02}};
  sheet.fixed = {{.region = BoundaryRegion{}}};
  InciseClip incise{.tool = "blade",
                    .body = "skin",
                    .direction = -Eigen::Vector3d::UnitZ(),
                    .depth = 1e-4,
                    .speed = 0.05,
                    .standoff = 1e-3};
  // Once round, and the first side again, of which the blade is a hair outside.
  constexpr std::array<std::array<double, 2>, 8> kCorners = {{{2.819e-3, 1.026e-3},
                                                              {1.268e-3, 2.719e-3},
                                                              {-1.026e-3, 2.819e-3},
                                                              {-2.719e-3, 1.268e-3},
                                                              {-2.819e-3, -1.026e-3},
                                                              {-1.268e-3, -2.719e-3},
                                                              {1.026e-3, -2.819e-3},
                                                              {2.719e-3, -1.268e-3}}};
  for (std::size_t k = 0; k <= kCorners.size() + 1; ++k) {
    const auto& [x, y] = kCorners[k % kCorners.size()];
    incise.path.emplace_back(x, y, 0);
  }
  Scenario scenario{.name = "test", .title = "test"};
  scenario.bodies = {sheet};
  scenario.tools = {{.name = "blade", .kind = ToolKind::kScalpel, .length = 0.01, .width = 1e-3, .thickness = 2e-4}};
  scenario.timeline = {{.action = incise}};
  scenario.simulation = {.analysis = Analysis::kQuasiStatic, .time_step = 0.01};
  return scenario;
}

TEST(ClosedCut, FreesThePieceAlsoWhereTheBladeCrossesItsFirstLipsBesideTheirEnd) {
  ScenarioRun run(octagon());
  while (run.step()) continue;
  const SnapshotTopology& topology = *run.snapshot().surfaces.at(0).topology;
  std::vector<Eigen::Vector3i> triangles;
  for (const auto& t : topology.triangles) triangles.emplace_back(t[0], t[1], t[2]);
  EXPECT_EQ(pieces_of(static_cast<int>(topology.rest_positions.size()), triangles).component_count, 2);
}

}  // namespace
}  // namespace thinwall
