#include "studio/director/ClipPlan.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "engine/mesh/Shapes.hpp"
#include "engine/tool/PoseBetween.hpp"
#include "studio/director/GraspPlan.hpp"
#include "studio/scenario/InputError.hpp"

namespace thinwall {
namespace {

/// A flat square of 80 mm in z = 0, seen from above as the outside.
struct Table {
  SurfaceMesh mesh = make_sheet(0.08, 0.08, 200);
  Eigen::VectorXd position;
  std::vector<double> thickness = std::vector<double>(mesh.triangles.size(), 0.002);  // (triangles), metres
  Table() : position(3 * mesh.vertices.size()) {
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) position.segment<3>(3 * v) = mesh.vertices[v];
  }
  SurfaceView view() const { return {.triangles = mesh.triangles, .position = position}; }
};

const Eigen::Vector3d kOrigin = Eigen::Vector3d::Zero();
const PalpateClip kClip = {.tool = "probe",
                           .body = "table",
                           .at = {0.003, 0.002, 0.5},
                           .direction = -Eigen::Vector3d::UnitZ(),
                           .depth = 0.004,
                           .speed = 0.01,
                           .hold = 0.5,
                           .standoff = 0.005};
const ToolDefinition kPoint = {.name = "probe", .kind = ToolKind::kPoint};

TEST(ClipPlan, APointStartsAtTheStandoffWhereverItsLineIsGiven) {
  const Table table;
  for (const double height : {-0.3, 0.0, 0.5}) {
    PalpateClip clip = kClip;
    clip.at.z() = height;
    const PalpationPlan plan = plan_palpation(clip, kPoint, table.view(), {});
    EXPECT_LT((plan.begin.tip - Eigen::Vector3d(0.003, 0.002, 0.005)).norm(), 1e-15);
    EXPECT_NEAR(plan.to_contact, 0.005, 1e-15);
  }
}

TEST(ClipPlan, ASphereThatComesObliquelyTouchesWithItsFlankFirst) {
  // Coming down at an angle a to the normal, its flank touches when the tip has still radius (1 - cos a) / cos a to go.
  const Table table;
  const double angle = std::numbers::pi / 6, radius = 0.004;
  PalpateClip clip = kClip;
  clip.direction = Eigen::Vector3d(std::sin(angle), 0, -std::cos(angle));
  clip.at = Eigen::Vector3d::Zero();
  const ToolDefinition sphere{.name = "probe", .kind = ToolKind::kSphere, .radius = radius};
  const PalpationPlan plan = plan_palpation(clip, sphere, table.view(), {});
  EXPECT_NEAR(plan.to_contact, clip.standoff - radius * (1 - std::cos(angle)) / std::cos(angle), 1e-12);
}

TEST(ClipPlan, APalpationGoesThroughItsPhasesAtItsSpeed) {
  const Table table;
  const PalpationPlan plan = plan_palpation(kClip, kPoint, table.view(), {});
  EXPECT_NEAR(plan.duration(), 0.9 + 0.5 + 0.9, 1e-12);
  struct Expected {
    double time;
    const char* phase;
    double depth, height;
  };
  for (const Expected& expected :
       {Expected{0, "approach", 0, 0.005}, Expected{0.4, "approach", 0, 0.001}, Expected{0.7, "contact", 0.002, -0.002},
        Expected{1.0, "hold", 0.004, -0.004}, Expected{1.6, "withdrawal", 0.002, -0.002},
        Expected{2.3, "withdrawal", 0, 0.005}, Expected{9, "withdrawal", 0, 0.005}}) {
    const ToolMoment moment = plan.at(expected.time);
    EXPECT_EQ(moment.phase, expected.phase) << expected.time;
    EXPECT_NEAR(moment.depth, expected.depth, 1e-12) << expected.time;
    EXPECT_NEAR(moment.pose.tip.z(), expected.height, 1e-12) << expected.time;
  }
}

TEST(ClipPlan, WithoutWithdrawalTheToolStaysDown) {
  const Table table;
  PalpateClip clip = kClip;
  clip.withdraw = false;
  const PalpationPlan plan = plan_palpation(clip, kPoint, table.view(), {});
  EXPECT_NEAR(plan.duration(), 1.4, 1e-12);
  EXPECT_NEAR(plan.at(5).depth, 0.004, 1e-15);
}

TEST(ClipPlan, ALineThatMissesTheBodyIsAnErrorWithPlaceAndCure) {
  const Table table;
  PalpateClip clip = kClip;
  clip.at.x() = 0.2;
  try {
    plan_palpation(clip, kPoint, table.view(), {.file = "a.yaml", .line = 7, .column = 5});
    FAIL() << "no error";
  } catch (const InputErrors& errors) {
    EXPECT_EQ(
        to_text(errors.diagnostics().at(0)),
        "a.yaml:7:5: error: palpate: the line of approach through at = [200, 2, 500] mm along direction = "
        "[0, 0, -1] misses body `table`, which spans x -40 ... 40, y -40 ... 40, z 0 ... 0 mm then; move `at` or turn "
        "`direction` so that the line meets its wall from outside");
  }
}

TEST(ClipPlan, AToolThatPassesBesideTheBodyIsAnErrorWithPlaceAndCure) {
  // The line meets a corner of the table, that both jaws pass.
  const Table table;
  PalpateClip clip = kClip;
  clip.at = {0.0399, 0.0399, 0.5};
  clip.axis = Eigen::Vector3d(1, 1, 0);
  const ToolDefinition forceps{
      .name = "probe", .kind = ToolKind::kForceps, .length = 0.03, .width = 0.004, .thickness = 0.002, .opening = 0.01};
  try {
    plan_palpation(clip, forceps, table.view(), {.file = "a.yaml", .line = 7, .column = 5});
    FAIL() << "no error";
  } catch (const InputErrors& errors) {
    EXPECT_EQ(to_text(errors.diagnostics().at(0)),
              "a.yaml:7:5: error: palpate: tool `probe` passes beside body `table`; move or turn its way so that it "
              "meets the wall");
  }
}

TEST(ClipPlan, ToolFrameFollowsTheDefaultAxes) {
  EXPECT_LT((make_pose(kOrigin, -Eigen::Vector3d::UnitZ(), {}).axis - Eigen::Vector3d::UnitY()).norm(), 1e-15);
  EXPECT_LT((make_pose(kOrigin, Eigen::Vector3d::UnitY(), {}).axis - Eigen::Vector3d::UnitX()).norm(), 1e-15)
      << "world x where the direction is parallel to y";
  const ToolPose oblique = make_pose(kOrigin, Eigen::Vector3d(0, 1, -1), Eigen::Vector3d(1, 1, 0));
  EXPECT_NEAR(oblique.axis.dot(oblique.direction), 0, 1e-15);
  EXPECT_NEAR(oblique.axis.norm(), 1, 1e-15);
}

TEST(ClipPlan, AMoveEasesFromRestToRestOrRunsEvenly) {
  MoveClip clip{.tool = "probe", .to = {0.01, 0, 0}, .duration = 2, .ease = Ease::kSmooth};
  const MovePlan smooth = plan_move(clip, {}, true);
  EXPECT_NEAR(smooth.at(0.02).pose.tip.x(), 0.01 * 3 * 1e-4, 1e-7) << "3 t^2 at first";
  EXPECT_NEAR(smooth.at(1).pose.tip.x(), 0.005, 1e-15);
  EXPECT_NEAR(smooth.at(5).pose.tip.x(), 0.01, 1e-15);
  clip.ease = Ease::kLinear;
  EXPECT_NEAR(plan_move(clip, {}, true).at(0.5).pose.tip.x(), 0.0025, 1e-15);
}

TEST(ClipPlan, AMoveByAWayEndsThatFarFromWhereItStarts) {
  MoveClip clip{.tool = "grip", .by = Eigen::Vector3d(0, 0.002, 0.01)};
  const ToolPose now{.tip = {0.001, 0, 0.016}, .direction = -Eigen::Vector3d::UnitZ()};
  const MovePlan lifted = plan_move(clip, now, false);
  EXPECT_LT((lifted.at(5).pose.tip - Eigen::Vector3d(0.001, 0.002, 0.026)).norm(), 1e-17);
  EXPECT_EQ(lifted.at(5).pose.direction, now.direction);
  clip.from = Eigen::Vector3d(0, 0, 0.1);
  EXPECT_LT((plan_move(clip, now, false).at(5).pose.tip - Eigen::Vector3d(0, 0.002, 0.11)).norm(), 1e-17);
  const ToolPose first = plan_move(clip, {}, true).at(0).pose;
  EXPECT_LT((first.direction - clip.by->normalized()).norm(), 1e-15) << "a tool's first move looks along its way";
}

TEST(ClipPlan, AToolsFirstMoveHasTheDirectionOfTheMotionThroughout) {
  const MoveClip clip{.tool = "probe", .to = {0.01, 0, 0}, .duration = 2};
  const MovePlan plan = plan_move(clip, {}, true);
  for (const double time : {0.0, 0.7, 2.0}) {
    EXPECT_LT((plan.at(time).pose.direction - Eigen::Vector3d::UnitX()).norm(), 1e-15) << time;
  }
}

TEST(ClipPlan, JawsReachOverTheRimOfAWallThatTheyComeToEdgeOn) {
  const Table table;
  const ToolDefinition forceps{.name = "grip", .kind = ToolKind::kForceps, .opening = 0.01};
  GraspClip clip{.tool = "grip",
                 .body = "table",
                 .at = {0, 0.003, 0.0009},
                 .direction = -Eigen::Vector3d::UnitX(),
                 .depth = 0.005,
                 .speed = 0.01,
                 .standoff = 0.004};
  const GraspPlan plan = plan_grasp(clip, forceps, table.view(), table.thickness, {});
  EXPECT_LT((plan.begin.tip - Eigen::Vector3d(0.044, 0.003, 0.0009)).norm(), 1e-12);
  EXPECT_NEAR(plan.at(0.9).pose.tip.x(), 0.035, 1e-12);
  clip.standoff = -0.004;
  EXPECT_NO_THROW(plan_grasp(clip, forceps, table.view(), table.thickness, {})) << "the wall lies between the jaws";
  clip.at.z() = 0.001;
  ToolDefinition narrow{.name = "grip", .kind = ToolKind::kForceps, .length = 0.03};
  narrow.width = 0.004;
  narrow.thickness = 0.002;
  narrow.opening = 0.001;
  EXPECT_THROW(plan_grasp(clip, narrow, table.view(), table.thickness, {}), InputErrors) << "it lies in a jaw";
  clip.at.z() = 0.0011;
  EXPECT_THROW(plan_grasp(clip, forceps, table.view(), table.thickness, {}), InputErrors) << "passes above it";
}

TEST(ClipPlan, JawsMeetTheRimOfAWallThatHangsDownBeforeTheWallBehindIt) {
  Table table;
  for (Eigen::Index at = 0; at < table.position.size(); at += 3) {
    table.position[at + 2] = -table.position[at] * table.position[at];  // 1.6 mm at the rim
  }
  const ToolDefinition forceps{.name = "grip", .kind = ToolKind::kForceps, .opening = 0.01};
  const GraspClip clip{.tool = "grip",
                       .body = "table",
                       .at = {0, 0.003, -0.0007},
                       .direction = -Eigen::Vector3d::UnitX(),
                       .depth = 0.005,
                       .standoff = 0.004};
  SurfaceView view = table.view();
  view.open = true;
  ASSERT_LT(first_entry(view, clip.at, clip.direction)->travel, -0.02) << "26.5 mm from the middle";
  EXPECT_NEAR(plan_grasp(clip, forceps, view, table.thickness, {}).begin.tip.x(), 0.044, 1e-12);
}

TEST(ClipPlan, JawsReachOverTheWallThenCloseAndOpenAgain) {
  const Table table;
  const ToolDefinition forceps{.name = "grip", .kind = ToolKind::kForceps, .opening = 0.01};
  const GraspClip clip{.tool = "grip",
                       .body = "table",
                       .at = {0.01, 0.02, 0.3},
                       .depth = 0.002,
                       .speed = 0.01,
                       .standoff = 0.004,
                       .to = 0.001,
                       .grip = 0.5,
                       .duration = 0.9};
  GraspPlan plan = plan_grasp(clip, forceps, table.view(), table.thickness, {});
  EXPECT_NEAR(plan.duration(), 0.6 + 0.9, 1e-12);
  plan.feel(0, 0.01, 0.1);
  EXPECT_FALSE(plan.lost) << "what it has not held it cannot lose";
  EXPECT_NEAR(plan.at(0.3).pose.tip.z(), 0.001, 1e-12);
  EXPECT_EQ(plan.at(0.3).pose.opening, 0.01);
  EXPECT_EQ(plan.at(0.3).phase, "approach");
  EXPECT_NEAR(plan.at(1.05).pose.tip.z(), -0.002, 1e-12);
  EXPECT_NEAR(plan.at(1.05).pose.opening, 0.0055, 1e-12);
  EXPECT_EQ(plan.at(1.05).phase, "hold");
  EXPECT_NEAR(plan.at(1.5).pose.opening, 0.001, 1e-12);
  plan.feel(0.4, 0.007, 1.1);
  plan.feel(0.5, 0.004, 1.2);
  plan.feel(0.9, 0.003, 1.3);
  EXPECT_NEAR(plan.at(1.5).pose.opening, 0.004, 1e-12);

  const ReleasePlan release = plan_release({.tool = "grip", .duration = 0.5}, forceps, plan.at(1.5).pose);
  EXPECT_NEAR(release.at(0.25).pose.opening, 0.007, 1e-12);
  EXPECT_EQ(release.at(0.5).pose.tip, plan.at(1.5).pose.tip);
}

TEST(ClipPlan, LaterMovesKeepTheAttitudeToTheLastBitUnlessTheClipGivesAnother) {
  const ToolPose now = make_pose({0, 0, 0}, {0, 0.6, -0.8}, Eigen::Vector3d(1, 0.3, 0));
  MoveClip clip{.tool = "grip", .to = {0, 0, 0.01}};
  for (const bool says_the_same : {false, true}) {
    if (says_the_same) clip.direction = now.direction;
    const MovePlan plan = plan_move(clip, now, false);
    for (const double time : {0.0, 0.3, 1.0}) {
      EXPECT_EQ(plan.at(time).pose.direction, now.direction);
      EXPECT_EQ(plan.at(time).pose.axis, now.axis);
    }
  }
}

/// Angle between two vectors, radians.
double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

TEST(ClipPlan, AMoveTurnsTheToolEvenlyAlongItsWayWithItsEase) {
  const ToolPose now = make_pose({0, 0, 0.02}, {0, 0, -1}, {});
  MoveClip clip{.tool = "rod",
                .to = {0, 0, 0.03},
                .direction = Eigen::Vector3d(std::sin(1.2), 0, -std::cos(1.2)),
                .duration = 2,
                .ease = Ease::kLinear};
  for (int k = 0; k <= 8; ++k) {
    const ToolPose pose = plan_move(clip, now, false).at(0.25 * k).pose;
    EXPECT_NEAR(angle_between(now.direction, pose.direction), 1.2 * k / 8, 1e-15) << k;
    EXPECT_LT((pose.axis - now.axis).norm(), 1e-15) << "the turn is about y'";
    EXPECT_NEAR(pose.tip.z(), 0.02 + 0.01 * k / 8, 1e-15);
  }
  clip.ease = Ease::kSmooth;
  EXPECT_NEAR(angle_between(now.direction, plan_move(clip, now, false).at(0.5).pose.direction), 1.2 * 5 / 32, 1e-15);
}

TEST(ClipPlan, ATurnOfDirectionAndAxisGoesAboutOneLineAndKeepsTheFrame) {
  const ToolPose now = make_pose({0, 0, 0}, {0.3, -0.2, -1}, Eigen::Vector3d(1, 0.4, 0));
  const MoveClip clip{.tool = "rod",
                      .to = {0, 0, 0},
                      .direction = Eigen::Vector3d(-1, 0.5, 0.7).normalized(),
                      .axis = Eigen::Vector3d(0.2, -1, 0.9),
                      .ease = Ease::kLinear};
  const MovePlan plan = plan_move(clip, now, false);
  const auto turn = [&](double from, double to) {
    return Eigen::AngleAxisd(Eigen::Matrix3d(frame_of(plan.at(to).pose) * frame_of(plan.at(from).pose).transpose()));
  };
  const Eigen::AngleAxisd whole = turn(0, 1);
  for (int k = 0; k < 10; ++k) {
    const Eigen::AngleAxisd part = turn(0.1 * k, 0.1 * (k + 1));
    EXPECT_NEAR(part.angle(), 0.1 * whole.angle(), 1e-14);
    EXPECT_LT((part.axis() - whole.axis()).norm(), 1e-13);
    const Eigen::Matrix3d frame = frame_of(plan.at(0.1 * k + 0.05).pose);
    EXPECT_LT((frame.transpose() * frame - Eigen::Matrix3d::Identity()).norm(), 1e-15);
  }
  EXPECT_EQ(plan.at(1).pose.direction, *clip.direction);
  EXPECT_NEAR(plan.at(1).pose.axis.dot(clip.axis->normalized()),
              std::sqrt(1 - std::pow(clip.axis->normalized().dot(*clip.direction), 2)), 1e-15);
}

TEST(ClipPlan, HalfATurnGoesAboutYOfTheToolInThePositiveSense) {
  const ToolPose now = make_pose({0, 0, 0}, {0, 0.6, -0.8}, Eigen::Vector3d(1, 0, 0));
  MoveClip clip{.tool = "rod", .to = {0, 0, 0}, .direction = -now.direction, .ease = Ease::kLinear};
  for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const ToolPose pose = plan_move(clip, now, false).at(part).pose;
    const Eigen::AngleAxisd turn(part * std::numbers::pi, now.axis);
    EXPECT_LT((pose.direction - turn * now.direction).norm(), 1e-15) << part;
    EXPECT_LT((pose.axis - now.axis).norm(), 1e-15) << part;
  }
  clip.axis = -now.axis;  // both: about x'
  const Eigen::Vector3d across = now.axis.cross(now.direction);
  EXPECT_LT((plan_move(clip, now, false).at(0.5).pose.direction -
             Eigen::AngleAxisd(std::numbers::pi / 2, across) * now.direction)
                .norm(),
            1e-15);
  clip.direction.reset();  // the axis alone: about z'
  EXPECT_LT((plan_move(clip, now, false).at(0.5).pose.axis -
             Eigen::AngleAxisd(std::numbers::pi / 2, now.direction) * now.axis)
                .norm(),
            1e-15);
}

TEST(ClipPlan, AToolThatIsSetElsewhereHasTheGivenAttitudeFromTheStart) {
  const ToolPose now = make_pose({0, 0, 0.03}, {0, 0, -1}, {});
  MoveClip clip{.tool = "plate",
                .from = Eigen::Vector3d(0, 0, -0.03),
                .to = {0, 0, -0.02},
                .direction = Eigen::Vector3d(0, 0, 1)};
  EXPECT_EQ(plan_move(clip, now, false).begin.direction, *clip.direction);
  clip.from = now.tip;
  EXPECT_EQ(plan_move(clip, now, false).begin.direction, now.direction);
}

TEST(ClipPlan, AnAxisAlongTheDirectionThatIsKeptIsRefused) {
  const ToolPose now = make_pose({0, 0, 0.03}, {0, 0, -1}, {});
  const MoveClip clip{.tool = "rod", .to = {0, 0, 0.02}, .axis = Eigen::Vector3d(0, 0, 2)};
  try {
    plan_move(clip, now, false, {.file = "a.yaml", .line = 7, .column = 5});
    FAIL() << "no error";
  } catch (const InputErrors& errors) {
    EXPECT_EQ(to_text(errors.diagnostics().at(0)),
              "a.yaml:7:5: error: move: the axis lies along the direction that tool `rod` has; give it a `direction` "
              "too, or another `axis`");
  }
}

}  // namespace
}  // namespace thinwall
