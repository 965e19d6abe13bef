#include "studio/director/HiddenParts.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace thinwall {
namespace {

using Eigen::Vector3d;

BodyScenario ball(const std::string& name, double radius, const Vector3d& at) {
  const SurfacePlacement placed{.at = at};
  return {.name = name, .surface = ShapeSource{.radius = radius, .triangles = 320, .placed = placed}};
}

Clip pressed(const std::string& body, const Vector3d& at, const Vector3d& direction) {
  return {.action = PalpateClip{.tool = "probe", .body = body, .at = at, .direction = direction}};
}

/// A ball that is pressed from -x, beside a larger one that stands at +y of the place.
Scenario two_balls() {
  return {.bodies = {ball("small", 0.01, Vector3d::Zero()), ball("large", 0.02, {-0.02, 0.035, 0})},
          .tools = {{.name = "probe", .kind = ToolKind::kSphere, .radius = 2e-3}},
          .timeline = {pressed("small", {-0.01, 0, 0}, Vector3d::UnitX())}};
}

const Vector3d kFromPlusY = Vector3d(0.6, -0.8, 0), kFromMinusY = Vector3d(0.6, 0.8, 0);

TEST(HiddenParts, TellWhatStandsInTheWay) {
  const std::array facings{kFromPlusY, kFromMinusY, Vector3d(-1, 0, 0)};
  EXPECT_EQ(hidden_parts(two_balls(), facings), (std::vector<double>{1, 0, 1})) << "the last: behind the ball itself";
}

TEST(HiddenParts, AreThoseOfAllPlacesThatToolsComeUpon) {
  Scenario scenario = two_balls();
  scenario.timeline.push_back(pressed("small", {0, -0.01, 0}, Vector3d::UnitY()));
  const std::array facings{kFromPlusY, kFromMinusY};
  EXPECT_EQ(hidden_parts(scenario, facings), (std::vector<double>{1, 0}));
  scenario.timeline.push_back(pressed("large", {-0.04, 0.035, 0}, Vector3d::UnitX()));
  EXPECT_DOUBLE_EQ(hidden_parts(scenario, facings)[0], 2.0 / 3);
}

TEST(HiddenParts, AreNoneBehindSceneryOrWhereNothingIsMet) {
  const std::array facings{kFromPlusY};
  Scenario scenario = two_balls();
  scenario.bodies[1].fixed = {{.region = WholeRegion{}}};
  EXPECT_EQ(hidden_parts(scenario, facings)[0], 0);
  Scenario missed = two_balls();
  missed.timeline = {pressed("small", {-0.01, 0, 0.1}, Vector3d::UnitX())};
  EXPECT_EQ(hidden_parts(missed, facings)[0], 0);
  missed.bodies[0].surface = MeshFileSource{.file = "missing.obj"};
  EXPECT_EQ(hidden_parts(missed, facings)[0], 0);
}

}  // namespace
}  // namespace thinwall
