// Clips whose wall is no longer where the script aims: an earlier cut gapes there.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "engine/mesh/Shapes.hpp"
#include "studio/director/BodyExtent.hpp"
#include "studio/director/KeptWay.hpp"
#include "studio/director/ScenarioRun.hpp"
#include "studio/scenario/InputError.hpp"

namespace thinwall {
namespace {

const Eigen::Vector3d kDown = -Eigen::Vector3d::UnitZ();
const ToolDefinition kShortBlade = {
    .name = "blade", .kind = ToolKind::kScalpel, .length = 0.012, .width = 0.003, .thickness = 4e-4};
const ToolDefinition kNeedle = {.name = "needle", .kind = ToolKind::kNeedle, .length = 0.06, .radius = 0.0003};

PierceClip needle_clip(const std::string& body, double depth) {
  PierceClip clip;
  clip.tool = "needle";
  clip.body = body;
  clip.at = {0, 0, 0.03};
  clip.direction = kDown;
  clip.depth = depth;
  clip.speed = 0.1;
  clip.standoff = 0.004;
  return clip;
}

BodyScenario kept_wall(const std::string& name, const ShapeSource& shape) {
  BodyScenario body{.name = name,
                    .surface = shape,
                    .thickness = {.standard = 1e-3},
                    .material = {.law = find_wall_law("neo_hookean"), .parameters = {40e3}}};
  body.toughness = Field<double>{.standard = 50};
  return body;
}

/// A sheet stretched by a tenth, held at its border.
BodyScenario skin() {
  BodyScenario body = kept_wall("skin", {.shape = Shape::kSheet, .length = 0.04, .width = 0.04, .triangles = 400});
  body.fluid.kind = FluidKind::kNone;
  body.prestretch = {.standard = {.first = 1.1, .second = 1.1}};
  body.fixed = {{.region = BoundaryRegion{}}};
  return body;
}

InciseClip cut_across(const std::string& body, double height) {
  return {.tool = "blade",
          .body = body,
          .path = {{-0.007, 0.0002, height}, {0.007, 0.0002, height}},
          .depth = 0.002,
          .speed = 0.2,
          .standoff = 0.002};
}

/// The cut that gapes, then `next` into it.
Scenario opened_skin(const std::vector<Clip>& next) {
  Scenario scenario{.name = "test", .title = "test"};
  scenario.bodies = {skin()};
  scenario.tools = {kShortBlade, kNeedle};
  scenario.timeline = {{.action = cut_across("skin", 0)}};
  for (const Clip& clip : next) scenario.timeline.push_back(clip);
  scenario.simulation = {.analysis = Analysis::kDynamic, .time_step = 0.01};
  return scenario;
}

bool tells(const std::vector<std::string>& warnings, const std::string& words) {
  for (const std::string& warning : warnings) {
    if (warning.find(words) != std::string::npos) return true;
  }
  return false;
}

TEST(KeptWay, ANeedleIntoAGapingCutGoesWhereTheScriptSaysAndTouchesNothing) {
  ScenarioRun run(opened_skin({{.action = needle_clip("skin", 0.01)}}));
  double deepest = 0, lowest = 0;
  while (run.step()) {
    const ToolRecord& needle = run.record().tools[1];
    deepest = std::max(deepest, needle.depth);
    lowest = std::min(lowest, needle.position.z());
    EXPECT_EQ(needle.force.norm(), 0) << "at " << run.time();
  }
  EXPECT_NEAR(deepest, 0.01, 1e-12) << "counted from where the wall was";
  EXPECT_NEAR(lowest, -0.01, 1e-9);
  EXPECT_TRUE(tells(run.warnings(), "timeline[2]: from ")) << "the reader is told";
  EXPECT_TRUE(tells(run.warnings(), "misses body `skin`"));
}

TEST(KeptWay, ALineThatMissesTheWallFromTheBeginningStaysAnError) {
  Clip clip{.action = needle_clip("skin", 0.01)};
  std::get<PierceClip>(clip.action).at = {0.1, 0, 0.03};
  EXPECT_THROW(ScenarioRun run(opened_skin({clip})), InputErrors);
}

TEST(KeptWay, ABladeWhoseFirstPointLiesOverAGapingCutGoesOnToTheWallBehind) {
  InciseClip across = cut_across("skin", 0);
  across.path = {{0.0002, 0.0002, 0}, {0.0002, 0.012, 0}};
  across.direction = kDown;
  across.withdraw = true;
  ScenarioRun run(opened_skin({{.action = across}}));
  while (run.step()) {
  }
  EXPECT_TRUE(tells(run.warnings(), "does not meet body `skin` along `direction`"));
  const BodyRecord& body = run.record().bodies[0];
  EXPECT_GT(body.cut_length, 0.014 + 0.004) << "the second cut counts too";
  EXPECT_LT(body.cut_length, 0.014 + 0.012 + 0.001);
}

/// A ball of 720 triangles without those whose middle lies less than `radius` beside the axis z on the upper side.
struct OpenedBall {
  SurfaceMesh mesh = make_sphere(0.02, 720);
  std::vector<Eigen::Vector3i> triangles;
  Eigen::VectorXd position{3 * mesh.vertices.size()};

  explicit OpenedBall(double radius) {
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) position.segment<3>(3 * v) = mesh.vertices[v];
    for (const Eigen::Vector3i& t : mesh.triangles) {
      const Eigen::Vector3d middle = (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3;
      if (middle.z() < 0 || middle.head<2>().norm() > radius) triangles.push_back(t);
    }
  }
  SurfaceView view() const { return {.triangles = triangles, .position = position, .open = false}; }
};

TEST(KeptWay, DepthCountsFromWhereTheWallWasWhenNothingComesBefore) {
  const OpenedBall whole(0), opened(0.01);
  const PiercingPlan first = plan_piercing(needle_clip("ball", 0.012), kNeedle, whole.view(), {});
  const auto kept = kept_way(first, kNeedle, opened.view());
  ASSERT_TRUE(kept.has_value());
  EXPECT_EQ(std::get<PiercingPlan>(*kept).begin.tip, first.begin.tip);
  EXPECT_EQ(std::get<PiercingPlan>(*kept).to_contact, first.to_contact) << "and not from the wall on the far side";
}

TEST(KeptWay, DepthCountsFromALipThatComesBeforeTheWallThatWas) {
  const ToolDefinition ball = {.name = "ball", .kind = ToolKind::kSphere, .radius = 0.008};  // wider than the opening
  OpenedBall risen(0.003);
  for (Eigen::Index v = 0; v < risen.position.size() / 3; ++v) risen.position[3 * v + 2] += 0.0035;
  const PalpationPlan first = plan_palpation(needle_clip("ball", 0.012), ball, OpenedBall(0).view(), {});
  ASSERT_FALSE(first_entry(risen.view(), first.begin.tip, kDown)) << "the line meets no wall from outside";
  const auto kept = kept_way(first, ball, risen.view());
  ASSERT_TRUE(kept.has_value());
  const auto& plan = std::get<PalpationPlan>(*kept);
  EXPECT_EQ(plan.to_contact, *travel_to_contact(risen.view(), ball, first.begin, kDown));
  EXPECT_LT(plan.to_contact, first.to_contact);
}

TEST(KeptWay, AToolThatWouldBeginInTheWallBeginsFartherBackAndTouchesNothingThere) {
  const OpenedBall small(0);
  OpenedBall large(0);
  large.position *= 2;
  const PiercingPlan first = plan_piercing(needle_clip("ball", 0.012), kNeedle, small.view(), {});
  const auto kept = kept_way(first, kNeedle, large.view());
  ASSERT_TRUE(kept.has_value());
  const auto& plan = std::get<PiercingPlan>(*kept);
  EXPECT_GT(plan.begin.tip.z(), 0.04) << "outside of the ball, which has grown over the old stand-off";
  EXPECT_NEAR(plan.begin.tip.z() - plan.to_contact, 0.04, 2e-4) << "first contact is the wall that is there";
}

TEST(KeptWay, AToolThatWouldBeginWithinAWallThatGapesBeforeItBeginsOutside) {
  const ToolDefinition point = {.name = "needle", .kind = ToolKind::kPoint};
  const OpenedBall small(0);
  OpenedBall gaping(0.01);
  gaping.position *= 2;
  const PalpationPlan first = plan_palpation(needle_clip("ball", 0.012), point, small.view(), {});
  ASSERT_TRUE(is_inside(gaping.view(), first.begin.tip));
  ASSERT_FALSE(first_entry(gaping.view(), first.begin.tip, kDown)) << "no wall is met there, ahead or behind";
  const auto kept = kept_way(first, point, gaping.view());
  ASSERT_TRUE(kept.has_value());
  EXPECT_FALSE(is_inside(gaping.view(), std::get<PalpationPlan>(*kept).begin.tip));
}

TEST(KeptWay, ABladeThatBeginsFartherBackGoesToTheSameDepthAndFollowsNoLineOnTheWall) {
  const OpenedBall small(0);
  OpenedBall large(0);
  large.position *= 1.3;
  InciseClip clip = cut_across("ball", 0.02);
  clip.marked = true;
  const IncisionPlan first = plan_incision(clip, kShortBlade, small.view(), {});
  const auto kept = kept_way(first, kShortBlade, large.view());
  ASSERT_TRUE(kept.has_value());
  const auto& plan = std::get<IncisionPlan>(*kept);
  EXPECT_GT(plan.begin.tip.z(), 0.026);
  EXPECT_FALSE(plan.clip.marked);
  const auto in_depth = [](const IncisionPlan& one) {
    return one.at((one.clip.standoff + one.clip.depth) / one.clip.speed).pose.tip;
  };
  EXPECT_LT((plan.at(0).pose.tip - plan.begin.tip).norm(), 1e-12);
  EXPECT_LT((in_depth(plan) - in_depth(first)).norm(), 1e-12);
}

TEST(KeptWay, AWaitHasNone) {
  EXPECT_FALSE(kept_way(WaitClip{.duration = 1}, kNeedle, OpenedBall(0).view()).has_value());
}

}  // namespace
}  // namespace thinwall
