#include "engine/haptics/LocalModel.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

#include "engine/mesh/Shapes.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

constexpr double kReach = 6e-3;  // metres

/// A hemisphere that a tool has pressed to a pose.
std::unique_ptr<Body> pressed(const ToolDefinition& tool, const ToolPose& pose) {
  auto body = std::make_unique<Body>(pressurised_hemisphere(576, 500), std::vector{tool}, quasi_static());
  body->settle();
  ToolPose begin = pose;
  begin.tip.z() = 26e-3;
  move(*body, begin, pose.tip, 8, 0.01);
  return body;
}

LocalModel model_of(Body& body, const ToolPose& pose, LocalModelMaker maker = {kReach, 1e-5}) {
  LocalModel model;
  maker.make(body.respond(0, std::vector{pose}, 0.01, kReach), 0, false, model);
  return model;
}

/// Force of the full solution after a further motion.
Eigen::Vector3d full_force(const ToolDefinition& tool, const ToolPose& pose, const ToolPose& further) {
  const auto body = pressed(tool, pose);
  body->advance(std::vector{pose}, std::vector{further}, 0.01);
  return body->state().contacts[0].force;
}

class LocalModelTest : public ::testing::TestWithParam<ToolDefinition> {};

TEST_P(LocalModelTest, GivesTheForceOfTheEquilibriumThatItWasFoundAt) {
  const ToolPose pose = pose_at({2e-3, 1e-3, 17e-3});
  const auto body = pressed(GetParam(), pose);
  const Eigen::Vector3d full = body->state().contacts[0].force;
  ASSERT_GT(full.norm(), 1e-3);
  EXPECT_LT((model_of(*body, pose).force_at(pose) - full).norm(), 1e-6 * full.norm());
}

TEST_P(LocalModelTest, EqualsTheFullSolutionToFirstOrder) {
  const ToolPose pose = pose_at({2e-3, 1e-3, 17e-3});
  const auto body = pressed(GetParam(), pose);
  const LocalModel model = model_of(*body, pose);
  const double step = 1e-6;  // metres: the second order is then some thousandths of the first
  for (const Eigen::Vector3d& way : {Eigen::Vector3d(0, 0, -step), Eigen::Vector3d(0, 0, step),
                                     Eigen::Vector3d(step, 0, 0), Eigen::Vector3d(0, step, 0)}) {
    ToolPose further = pose;
    further.tip += way;
    const Eigen::Vector3d change = full_force(GetParam(), pose, further) - body->state().contacts[0].force;
    const Eigen::Vector3d expected = model.force_at(further) - model.force_at(pose);
    EXPECT_LT((expected - change).norm(), 0.01 * change.norm()) << way.transpose() << ": " << change.transpose();
  }
}

INSTANTIATE_TEST_SUITE_P(
    Tools, LocalModelTest,
    ::testing::Values(sphere_tool(5e-3), point_tool(),
                      ToolDefinition{.name = "capsule", .kind = ToolKind::kCapsule, .length = 14e-3, .radius = 4e-3}),
    [](const auto& tool) { return tool.param.name + std::to_string(tool.index); });

TEST(LocalModelTest, ATurnOfTheToolIsAnsweredToFirstOrder) {
  const ToolDefinition capsule{.name = "capsule", .kind = ToolKind::kCapsule, .length = 14e-3, .radius = 4e-3};
  const ToolPose pose = pose_at({2e-3, 1e-3, 17e-3});
  const auto body = pressed(capsule, pose);
  const LocalModel model = model_of(*body, pose);
  ToolPose turned = pose;
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1e-4, Eigen::Vector3d(1, 0.5, 0).normalized()).toRotationMatrix();
  turned.direction = turn * pose.direction;
  turned.axis = turn * pose.axis;
  const Eigen::Vector3d change = full_force(capsule, pose, turned) - body->state().contacts[0].force;
  EXPECT_LT((model.force_at(turned) - model.force_at(pose) - change).norm(), 0.02 * change.norm());
}

TEST(LocalModelTest, LetsGoOfAToolThatLeaves) {
  const ToolPose pose = pose_at({2e-3, 1e-3, 17e-3});
  const auto body = pressed(sphere_tool(5e-3), pose);
  const LocalModel model = model_of(*body, pose);
  ToolPose away = pose;
  double before = model.force_at(pose).norm();
  for (int k = 1; k <= 40; ++k) {
    away.tip.z() = pose.tip.z() + 0.5e-3 * k;
    const double force = model.force_at(away).norm();
    EXPECT_LE(force, before + 1e-12);
    before = force;
  }
  EXPECT_EQ(before, 0);
}

TEST(LocalModelTest, FeelsTheWallAheadWhereItBegins) {
  Body body(pressurised_hemisphere(576, 500), {sphere_tool(5e-3)}, quasi_static());
  body.settle();
  const ToolPose pose = pose_at({0, 0, 24e-3});
  const LocalModel model = model_of(body, pose);
  ASSERT_LT(model.response.ahead.gap, 4e-3);
  ASSERT_GT(model.response.ahead.gap, 1e-4);
  ToolPose near = pose, in = pose;
  near.tip.z() -= 0.99 * model.response.ahead.gap;
  in.tip.z() -= model.response.ahead.gap + 1e-4;
  EXPECT_TRUE(model.force_at(near).isZero());
  const Eigen::Vector3d force = model.force_at(in);
  EXPECT_GT(force.z(), 0);
  EXPECT_NEAR(force.norm(), 1e-4 * model.response.ahead.stiffness, 1e-9);
  // The first place that is met gives way as the full solution has it while it is the only one.
  body.advance(std::vector{pose}, std::vector{near}, 0.01);
  ToolPose further = near;
  further.tip.z() = in.tip.z() + 0.9e-4;
  body.advance(std::vector{near}, std::vector{further}, 0.01);
  const double full = body.state().contacts[0].force.norm();
  EXPECT_NEAR(model.force_at(further).norm(), full, 0.1 * full);
}

TEST(LocalModelTest, TheSecantMeetsTheForceFoundBeforeAndGoesOnAlongTheWay) {
  const ToolDefinition tool = sphere_tool(5e-3);
  const ToolPose first = pose_at({2e-3, 1e-3, 17.5e-3}), second = pose_at({2e-3, 1e-3, 17e-3});
  const auto body = pressed(tool, first);
  const Eigen::Vector3d force = body->state().contacts[0].force;
  LocalModelMaker maker(kReach, 1e-5);
  LocalModel model;
  maker.make(body->respond(0, std::vector{first}, 0.01, kReach), 0, false, model);
  body->advance(std::vector{first}, std::vector{second}, 0.01);
  maker.make(body->respond(0, std::vector{second}, 0.01, kReach), 0.01, false, model);
  const double first_order = (model_of(*body, second).force_at(first) - force).norm();
  EXPECT_GT(first_order, 1e-3 * force.norm());
  EXPECT_LT((model.force_at(first) - force).norm(), 1e-6 * force.norm());
  // As far again the curvature of the force is all that is missed, and no more than that of the way before.
  ToolPose further = second;
  further.tip += second.tip - first.tip;
  const Eigen::Vector3d full = full_force(tool, second, further);
  EXPECT_LT((model.force_at(further) - full).norm(), 0.05 * full.norm());
}

TEST(LocalModelTest, AfterAShortWayTheSecantIsThatOfTheLongerWayBefore) {
  const ToolDefinition tool = sphere_tool(5e-3);
  const ToolPose first = pose_at({2e-3, 1e-3, 17.5e-3});
  const auto body = pressed(tool, first);
  const Eigen::Vector3d force = body->state().contacts[0].force;
  LocalModelMaker maker(kReach, 3e-4);
  LocalModel model;
  maker.make(body->respond(0, std::vector{first}, 0.01, kReach), 0, false, model);
  ToolPose before = first;
  for (const double depth : {4e-4, 5e-4}) {
    ToolPose pose = first;
    pose.tip.z() -= depth;
    body->advance(std::vector{before}, std::vector{pose}, 0.01);
    maker.make(body->respond(0, std::vector{pose}, 0.01, kReach), 0.01, false, model);
    EXPECT_LT((model.force_at(first) - force).norm(), 1e-6 * force.norm()) << depth;
    before = pose;
  }
}

/// A hemisphere into which a ball is pressed, and along which it is dragged, in long steps as the solver behind a hand
/// makes them.
struct Dragged {
  int iterations = 0, shifted = 0, divisions = 0;
  ToolResponse response;

  Dragged(double tolerance, bool extrapolates, double way) {
    BodyDefinition definition = make_body(make_hemisphere(25e-3, 2500), 1.5e-3, neo_hookean(30e3));
    definition.fluid.initial_pressure = 400;
    definition.fixed = {fixed_group("base")};
    Body body(definition, {sphere_tool(6e-3)},
              {.analysis = Analysis::kQuasiStatic, .tolerance = tolerance, .extrapolates = extrapolates});
    body.settle();
    const double step = 5e-4;  // metres
    ToolPose pose = move(body, pose_at({-8e-3, 1e-3, 24.5e-3}), {-8e-3, 1e-3, 19.5e-3}, 10, 5e-3);
    const int steps = static_cast<int>(std::lround(way / step));
    pose = move(body, pose, pose.tip + Eigen::Vector3d(way, 0, 0), steps, 5e-3, [&](const ToolPose&) {
      iterations += body.report().newton_iterations;
      shifted += body.report().shifted_iterations;
      divisions += body.report().halvings + body.report().refinements;
    });
    response = body.respond(0, std::vector{pose}, 5e-3, kReach);
  }

  Eigen::Matrix3d stiffness() const {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const SiteResponse& site : response.sites) {
      sum += site.normal * site.force_by_motion.head<3>() + site.force * site.normal_by_motion.leftCols<3>();
    }
    return sum;
  }
};

TEST(LocalModelTest, TheFactorOfTheLastStepTellsTheSameAnswerAsOneOfItsOwn) {
  const Dragged plain(1e-9, false, 5e-3), reused(1e-4, true, 5e-3);
  // The last step went some micrometres on a ball of 6 mm: a thousandth of the curvature.
  EXPECT_LT((reused.stiffness() - plain.stiffness()).norm(), 0.01 * plain.stiffness().norm());
  EXPECT_LT((reused.response.force - plain.response.force).norm(), 1e-3 * plain.response.force.norm());
}

TEST(LocalModelTest, PlacesThatComeToBearAndLetGoLeadNoStepAstray) {
  const Dragged dragged(1e-4, true, 20e-3);
  EXPECT_EQ(dragged.divisions, 0);
  EXPECT_LE(dragged.iterations, 4 * 40);
  EXPECT_EQ(dragged.shifted, 0);
}

/// Newton / metre, largest of the answers that a ball gets that goes into a hemisphere and out of it by uneven steps.
double largest_stiffness(unsigned seed) {
  BodyDefinition definition = make_body(make_hemisphere(25e-3, 1024), 1.5e-3, neo_hookean(30e3));
  definition.fluid.initial_pressure = 400;
  definition.fixed = {fixed_group("base")};
  Body body(definition, {sphere_tool(6e-3)},
            {.analysis = Analysis::kQuasiStatic, .tolerance = 1e-3, .extrapolates = true});
  body.settle();
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> step(0.02e-3, 0.2e-3);
  ToolPose pose = pose_at({2e-3, 1e-3, 25e-3});
  double largest = 0;
  for (const double sense : {-1.0, 1.0}) {
    for (double way = 0; way < 4e-3;) {
      ToolPose next = pose;
      const double length = step(random);
      next.tip.z() += sense * length;
      way += length;
      body.advance(std::vector{pose}, std::vector{next}, 1e-3);
      pose = next;
      Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero();
      for (const SiteResponse& site : body.respond(0, std::vector{pose}, 1e-3, kReach).sites) {
        stiffness += site.normal * site.force_by_motion.head<3>();
      }
      largest = std::max(largest, stiffness.norm());
    }
  }
  return largest;
}

TEST(LocalModelTest, PlacesThatBearNothingAnyMoreDoNotHoldTheWallInItsAnswer) {
  // 41 seen; 920 to 2 690 where a place that has just let go is taken for a spring, as at these steps.
  for (const unsigned seed : {18U, 141U, 162U}) EXPECT_LT(largest_stiffness(seed), 60) << seed;
}

TEST(LocalModelTest, AStepThatBeginsWhereTheAnswerLeadsEndsInTheSameEquilibrium) {
  const ToolDefinition tool = sphere_tool(5e-3);
  const ToolPose pose = pose_at({2e-3, 1e-3, 17e-3});
  ToolPose further = pose;
  further.tip += Eigen::Vector3d(3e-4, 0, -5e-4);
  const auto led = pressed(tool, pose);
  led->respond(0, std::vector{pose}, 0.01, kReach);
  led->advance(std::vector{pose}, std::vector{further}, 0.01);
  const Eigen::Vector3d full = full_force(tool, pose, further);
  EXPECT_LT((led->state().contacts[0].force - full).norm(), 1e-6 * full.norm());
}

TEST(LocalModelTest, AToolThatGoesOnIntoABodyInMotionFeelsTheWallFollow) {
  const double step = 1e-3, way = 5e-5;  // 50 mm/s
  for (const ToolDefinition& tool : {point_tool(), sphere_tool(5e-3)}) {
    Body body(pressurised_hemisphere(256, 400), {tool}, {.analysis = Analysis::kDynamic});
    body.settle();
    ToolPose pose = move(body, pose_at({0, 1e-3, 21.5e-3}), {0, 1e-3, 17e-3}, 90, step);
    const Eigen::Vector3d before = body.state().contacts[0].force;
    LocalModel model;
    LocalModelMaker(kReach, 1e-5).make(body.respond(0, std::vector{pose}, step, kReach), 0, false, model);
    pose = move(body, pose, pose.tip - Eigen::Vector3d(0, 0, 6 * way), 6, step);
    const Eigen::Vector3d felt = model.force_at(pose), full = body.state().contacts[0].force;
    ASSERT_GT((full - before).norm(), 0.05 * full.norm());
    // The wall swings a little on its way. Seen: 0.015; 0.7 and more where it was taken to be thrown.
    EXPECT_LT((felt - full).norm(), 0.05 * full.norm())
        << tool.name << ": " << felt.transpose() << ", " << full.transpose();
  }
}

}  // namespace
}  // namespace thinwall
