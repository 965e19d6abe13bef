#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <string>

#include "engine/mesh/Shapes.hpp"
#include "studio/director/BodyExtent.hpp"
#include "studio/director/Plan.hpp"
#include "studio/scenario/InputError.hpp"

namespace thinwall {
namespace {

/// A body as clips look at it.
struct Subject {
  SurfaceMesh mesh;
  Eigen::VectorXd position;
  bool open = false;
  explicit Subject(SurfaceMesh the_mesh, bool is_open = false)
      : mesh(std::move(the_mesh)), position(3 * mesh.vertices.size()), open(is_open) {
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) position.segment<3>(3 * v) = mesh.vertices[v];
  }
  SurfaceView view() const { return {.triangles = mesh.triangles, .position = position, .open = open}; }
};

Subject table() {
  return Subject(make_sheet(0.08, 0.08, 800), true);
}
Subject ball() {
  return Subject(make_sphere(0.02, 1280));
}

const Eigen::Vector3d kDown = -Eigen::Vector3d::UnitZ();
const ToolDefinition kNeedle = {.name = "needle", .kind = ToolKind::kNeedle, .length = 0.04, .radius = 0.0005};
const ToolDefinition kPlannedBlade = {
    .name = "blade", .kind = ToolKind::kScalpel, .length = 0.02, .width = 0.006, .thickness = 0.0004};

PierceClip needle_clip() {
  PierceClip clip;
  clip.tool = "needle";
  clip.body = "ball";
  clip.depth = 0.012;
  clip.speed = 0.01;
  clip.hold = 1;
  return clip;
}

InciseClip straight_cut() {
  return {.tool = "blade",
          .body = "table",
          .path = {{-0.01, 0.002, 0.001}, {0.02, 0.002, -0.003}},
          .depth = 0.003,
          .speed = 0.015,
          .hold = 0.5,
          .standoff = 0.006};
}

template <typename Act>
std::string message_of(const Act& act) {
  try {
    act();
  } catch (const InputErrors& errors) {
    return to_text(errors.diagnostics().at(0));
  }
  return "no error";
}

const SourceLocation kPlace = {.file = "a.yaml", .line = 7, .column = 5};

TEST(PiercingPlan, GoesInAndBackAsAPalpationDoes) {
  const Subject body = ball();
  const PiercingPlan plan = plan_piercing(needle_clip(), kNeedle, body.view(), kPlace);
  const PalpationPlan press = plan_palpation(needle_clip(), kNeedle, body.view(), kPlace);
  EXPECT_EQ(plan.duration(), press.duration());
  for (int k = 0; k <= 50; ++k) {
    const double time = 0.02 * k * plan.duration();
    EXPECT_EQ(plan.at(time).pose.tip, press.at(time).pose.tip);
    EXPECT_EQ(plan.at(time).phase, press.at(time).phase);
    EXPECT_EQ(plan.at(time).depth, press.at(time).depth);
  }
}

TEST(PiercingPlan, TellsRuptureAndSlidingOnceTheyAreFelt) {
  const Subject body = ball();
  PiercingPlan plan = plan_piercing(needle_clip(), kNeedle, body.view(), kPlace);
  plan.feel_rupture(0.9);
  plan.feel_rupture(1.4);
  const auto phase = [&](double time) { return plan.at(time).phase; };
  EXPECT_EQ(phase(0.2), "approach");
  EXPECT_EQ(phase(0.895), "contact");
  EXPECT_EQ(phase(0.9), "rupture");
  EXPECT_EQ(phase(0.905), "sliding");
  EXPECT_EQ(phase(1.4), "rupture") << "the far wall";
  EXPECT_EQ(phase(1.6), "sliding");
  EXPECT_EQ(phase(2), "hold");
  EXPECT_EQ(phase(3.5), "withdrawal");
}

TEST(PiercingPlan, RefusesNeedlesThatAreTooThickOrTooShort) {
  const Subject body = ball();
  ToolDefinition thick = kNeedle;
  thick.radius = 0.021;
  thick.length = 0.2;
  EXPECT_EQ(message_of([&] { plan_piercing(needle_clip(), thick, body.view(), kPlace); }),
            "a.yaml:7:5: error: pierce: needle `needle` is 42 mm thick, and body `ball` is only 40 mm wide across its "
            "way; give it a smaller `radius`");
  ToolDefinition thin = kNeedle;
  thin.radius = 0.5e-6;
  const std::string thinner = message_of([&] { plan_piercing(needle_clip(), thin, body.view(), kPlace); });
  EXPECT_NE(thinner.find("needle `needle` is 0.001 mm thick, and the triangles that it meets have edges of 3.24 mm"),
            std::string::npos)
      << thinner;
  PierceClip deep = needle_clip();
  deep.depth = 0.05;
  EXPECT_EQ(message_of([&] { plan_piercing(deep, kNeedle, body.view(), kPlace); }),
            "a.yaml:7:5: error: pierce: `depth` = 50 mm is more than needle `needle` is long (40 mm); go less deep or "
            "give it a larger `length`");
  PierceClip inside = needle_clip();
  inside.standoff = 0;
  EXPECT_NE(
      message_of([&] { plan_piercing(inside, kNeedle, body.view(), kPlace); }).find("touches body `ball` already"),
      std::string::npos);
  PierceClip beside = needle_clip();
  beside.at = {0.03, 0, 0};
  EXPECT_NE(message_of([&] { plan_piercing(beside, kNeedle, body.view(), kPlace); }).find("pierce: the line of appro"),
            std::string::npos);
}

TEST(IncisionPlan, PressesInFollowsThePathAndGoesBack) {
  const Subject body = table();
  const IncisionPlan plan = plan_incision(straight_cut(), kPlannedBlade, body.view(), kPlace);
  EXPECT_NEAR(plan.path.length(), 0.03, 1e-15);
  EXPECT_NEAR(plan.to_contact, 0.006, 1e-12);
  EXPECT_NEAR(plan.duration(), 0.6 + 2 + 0.5 + 0.6, 1e-12);
  struct Expected {
    double time;
    const char* phase;
    double depth, x, z;
  };
  for (const Expected& expected :
       {Expected{0, "approach", 0, -0.01, 0.006}, Expected{0.2, "approach", 0, -0.01, 0.003},
        Expected{0.5, "contact", 0.0015, -0.01, -0.0015}, Expected{0.7, "cutting", 0.003, -0.0085, -0.003},
        Expected{1.6, "cutting", 0.003, 0.005, -0.003}, Expected{2.7, "hold", 0.003, 0.02, -0.003},
        Expected{3.2, "withdrawal", 0.0015, 0.02, -0.0015}, Expected{9, "withdrawal", 0, 0.02, 0.006}}) {
    const ToolMoment moment = plan.at(expected.time);
    EXPECT_EQ(moment.phase, expected.phase) << expected.time;
    EXPECT_NEAR(moment.depth, expected.depth, 1e-12) << expected.time;
    EXPECT_LT((moment.pose.tip - Eigen::Vector3d(expected.x, 0.002, expected.z)).norm(), 1e-12) << expected.time;
    EXPECT_LT((moment.pose.direction - kDown).norm(), 1e-15);
    EXPECT_LT((moment.pose.axis - Eigen::Vector3d::UnitX()).norm(), 1e-15) << "the edge leads along the path";
  }
  EXPECT_NEAR(plan.progress(1.6), 0.015, 1e-15);
}

TEST(IncisionPlan, LooksAheadOfItsEndStraightOnAndAsMuchDeeper) {
  const Subject body = table();
  const IncisionPlan plan = plan_incision(straight_cut(), kPlannedBlade, body.view(), kPlace);
  EXPECT_LT((plan.pose_ahead(0.03).tip - Eigen::Vector3d(0.02, 0.002, -0.003)).norm(), 1e-12);
  EXPECT_LT((plan.pose_ahead(0.034).tip - Eigen::Vector3d(0.024, 0.002, -0.007)).norm(), 1e-12);
}

TEST(PassedOver, IsMadeUpForByTheCutThatGoesOnAsFarAsThatReaches) {
  PassedOver passed{.length = 0.004, .cut = 0.01};
  passed.note_cut(0.01);
  EXPECT_EQ(passed.whole(), 0.004) << "nothing has been cut since";
  passed.note_cut(0.013);
  EXPECT_NEAR(passed.whole(), 0.001, 1e-15) << "3 mm of the 4";
  passed.length = 0.002;
  passed.note_cut(0.02);
  EXPECT_NEAR(passed.whole(), 0.001, 1e-15) << "7 mm make up for all of the 2";
}

TEST(IncisionPlan, TellsThatItCutsOnceTheBladeIsFeltToBeIn) {
  const Subject body = table();
  IncisionPlan plan = plan_incision(straight_cut(), kPlannedBlade, body.view(), kPlace);
  plan.feel_entry(0.48);
  plan.feel_entry(0.7);
  EXPECT_EQ(plan.at(0.47).phase, "contact");
  EXPECT_EQ(plan.at(0.5).phase, "cutting");
}

TEST(IncisionPlan, OnASphereTheTipRunsOnASmallerSphereAndLooksToTheMiddle) {
  const Subject body = ball();
  InciseClip clip = straight_cut();
  clip.path = {{-0.012, 0.003, 0.018}, {0.002, 0.001, 0.0199}, {0.013, 0.004, 0.016}};
  const IncisionPlan plan = plan_incision(clip, kPlannedBlade, body.view(), kPlace);
  for (int k = 0; k <= 200; ++k) {
    const ToolPose pose = plan.pose_below(0.005 * k * plan.path.length());
    // Facets with sides of 3 mm lie up to 0.08 mm within the sphere; the normals between their corners lean by little.
    EXPECT_NEAR(pose.tip.norm(), 0.017, 8e-5);
    EXPECT_LT((pose.direction + pose.tip.normalized()).norm(), 8e-3);
    EXPECT_NEAR(pose.axis.dot(pose.direction), 0, 1e-14);
    EXPECT_GT(pose.axis.x(), 0.6);
  }
}

TEST(IncisionPlan, PosesMoveAndTurnEvenlyAroundCorners) {
  const Subject body = table();
  InciseClip clip = straight_cut();
  clip.path = {{-0.02, 0, 0}, {0, 0, 0}, {0, 0.02, 0}, {0.02, 0.02, 0}};
  const IncisionPlan plan = plan_incision(clip, kPlannedBlade, body.view(), kPlace);
  const double step = 1e-4;  // metres
  for (double along = step; along < plan.path.length(); along += step) {
    const ToolPose before = plan.pose_below(along - step), now = plan.pose_below(along);
    EXPECT_LE((now.tip - before.tip).norm(), step * (1 + 1e-9));
    EXPECT_LE((now.axis - before.axis).norm(), 4 * step / 0.006 * (1 + 1e-9)) << along;
  }
  EXPECT_LT((plan.pose_below(0.02).axis - Eigen::Vector3d(1, 1, 0).normalized()).norm(), 0.1) << "half way round";
  EXPECT_LT((plan.pose_below(0.0235).axis - Eigen::Vector3d(0, 1, 0)).norm(), 1e-12) << "and round";
}

TEST(IncisionPlan, WhereThePathTurnsBackTheBladeGoesBackWithoutTurning) {
  const Subject body = table();
  InciseClip clip = straight_cut();
  clip.path = {{-0.02, 0, 0}, {0.01, 0, 0}, {-0.01, 0, 0}};
  const IncisionPlan plan = plan_incision(clip, kPlannedBlade, body.view(), kPlace);
  EXPECT_NEAR(plan.path.length(), 0.05, 1e-15);
  for (int k = 0; k <= 100; ++k) {
    EXPECT_LT((plan.pose_below(0.01 * k * 0.05).axis - Eigen::Vector3d::UnitX()).norm(), 1e-12) << k;
  }
}

TEST(IncisionPlan, FromBelowASheetItCutsUpwards) {
  const Subject body = table();
  InciseClip clip = straight_cut();
  clip.direction = Eigen::Vector3d::UnitZ();
  const IncisionPlan plan = plan_incision(clip, kPlannedBlade, body.view(), kPlace);
  EXPECT_LT((plan.begin.tip - Eigen::Vector3d(-0.01, 0.002, -0.006)).norm(), 1e-15);
  EXPECT_LT((plan.begin.direction - Eigen::Vector3d::UnitZ()).norm(), 1e-15);
}

TEST(IncisionPlan, RefusesPathsThatLeaveTheSurface) {
  const Subject body = ball();
  const SourceLocation point{.file = "a.yaml", .line = 9, .column = 11};
  InciseClip clip = straight_cut();
  clip.path = {{0, 0, 0.02}, {0.032, 0, 0}};
  clip.path_locations = {kPlace, point};
  const auto plan = [&] { plan_incision(clip, kPlannedBlade, body.view(), kPlace); };
  EXPECT_EQ(message_of(plan),
            "a.yaml:9:11: error: incise: path[2] = [32, 0, 0] mm lies 12 mm from body `table`, which spans x "
            "-20 ... 20, y -20 ... 20, z -20 ... 20 mm then, farther than `reach` = 10 mm; move the point to the wall "
            "or give a larger `reach`");
  clip.direction = kDown;
  EXPECT_EQ(message_of(plan),
            "a.yaml:9:11: error: incise: path[2] = [32, 0, 0] mm does not meet body `table` along `direction`; move "
            "the point or leave `direction` out");
  clip.direction.reset();
  clip.path[1] = {0, 0, -0.02};
  EXPECT_EQ(message_of(plan),
            "a.yaml:9:11: error: incise: path[1] and path[2] lie behind each other as seen along the wall's normal, so "
            "that no way from one to the other stands out; put a point between them");
  clip.path[1] = {0, 0, 0.024};
  EXPECT_EQ(message_of(plan),
            "a.yaml:7:5: error: incise: all points of `path` come to lie in one place of body `table`; a cut needs a "
            "length");
}

TEST(IncisionPlan, RefusesDepthsThatBladeOrBodyLack) {
  const Subject body = ball();
  InciseClip clip = straight_cut();
  clip.path = {{0, 0, 0.02}, {0.01, 0, 0.017}};
  clip.depth = 0.021;
  const auto plan = [&] { plan_incision(clip, kPlannedBlade, body.view(), kPlace); };
  EXPECT_EQ(message_of(plan),
            "a.yaml:7:5: error: incise: `depth` = 21 mm is more than blade `blade` is high (20 mm); cut less deep or "
            "give it a larger `length`");
  ToolDefinition sword = kPlannedBlade;
  sword.length = 0.1;
  clip.depth = 0.041;
  EXPECT_EQ(message_of([&] { plan_incision(clip, sword, body.view(), kPlace); }),
            "a.yaml:7:5: error: incise: `depth` = 41 mm is more than body `table` measures there (40 mm); cut less "
            "deep");
}

TEST(IncisionPlan, RefusesBladesThatWouldStartInsideOrTouchAlready) {
  // A tall tube seen from its own inside: its wall's normal leads across to the wall beyond.
  SurfaceMesh pipe = make_cylinder(0.01, 0.08, 1200);
  for (Eigen::Vector3i& triangle : pipe.triangles) std::swap(triangle[1], triangle[2]);
  SurfaceMesh shell = make_cylinder(0.02, 0.08, 2400);
  const int shift = static_cast<int>(pipe.vertices.size());
  pipe.vertices.insert(pipe.vertices.end(), shell.vertices.begin(), shell.vertices.end());
  for (const Eigen::Vector3i& triangle : shell.triangles) pipe.triangles.push_back(triangle.array() + shift);
  const Subject body(pipe);
  InciseClip clip = straight_cut();
  clip.path = {{0, 0.01, 0.0099}, {0, -0.01, 0.0099}};
  clip.standoff = 0.025;
  EXPECT_EQ(message_of([&] { plan_incision(clip, kPlannedBlade, body.view(), kPlace); }),
            "a.yaml:7:5: error: incise: 25 mm above path[1] blade `blade` would start inside body `table`; a smaller "
            "`standoff` or another first point lets it start outside");
  clip.standoff = 0.005;
  ToolDefinition wide = kPlannedBlade;
  wide.length = 0.03;
  EXPECT_NE(message_of([&] { plan_incision(clip, wide, body.view(), kPlace); }).find("touches body `table` already"),
            std::string::npos);
}

TEST(BodyExtent, MeasuresAndWindsAround) {
  const Subject body = ball();
  EXPECT_NEAR(extent_along(body.view(), Eigen::Vector3d::UnitZ()), 0.04, 1e-15);
  EXPECT_NEAR(winding_number(body.view(), {0.001, 0.002, 0.017}), 1, 1e-12);
  EXPECT_NEAR(winding_number(body.view(), {0.001, 0.002, 0.021}), 0, 1e-12);
}

TEST(CutPlans, TellWhatTheyAreAndHowDeep) {
  const Subject body = table();
  EXPECT_EQ(standard_caption({.action = straight_cut()}), "Incision: 3 mm deep at 15 mm/s");
  EXPECT_EQ(standard_caption({.action = needle_clip()}), "Piercing: 12 mm deep at 10 mm/s");
  EXPECT_EQ(tool_of({.action = straight_cut()}), "blade");
  const Plan plan = plan_incision(straight_cut(), kPlannedBlade, body.view(), kPlace);
  EXPECT_TRUE(knows_depth(plan));
  EXPECT_NEAR(duration_of(plan), 3.7, 1e-12);
  EXPECT_EQ(beginning_of(plan)->tip.z(), moment_of(plan, 0)->pose.tip.z());
}

}  // namespace
}  // namespace thinwall
