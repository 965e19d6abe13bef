// Coulomb's friction between tools and walls, against closed forms and balances.

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "engine/mesh/Shapes.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

/// A sheet of 40 mm by 40 mm, stretched by 1.3 both ways and held at its rim.
BodyDefinition stretched_sheet(int triangles) {
  BodyDefinition body = make_body(make_sheet(40e-3, 40e-3, triangles), 1e-3, neo_hookean(20e3));
  body.fluid.kind = FluidKind::kNone;
  body.prestretch = {{.first = 1.3, .second = 1.3}};
  body.fixed = {{.region = BoundaryRegion{}}};
  return body;
}

ToolDefinition rough(ToolDefinition tool, double friction) {
  tool.friction = friction;
  return tool;
}

constexpr double kBall = 40e-3;    // metres, radius: the patch is a fifteenth of it, so that all normals are nearly one
constexpr double kDepth = 0.3e-3;  // metres

/// A sheet with a rough ball pressed in at a place of it.
Body pressed_sheet(int triangles, double friction, const Eigen::Vector2d& at, ToolPose& pose) {
  Body body(stretched_sheet(triangles), {rough(sphere_tool(kBall), friction)}, quasi_static());
  body.settle();
  pose = move(body, pose_at({at.x(), at.y(), 1e-6}), {at.x(), at.y(), -kDepth}, 5, 1);
  return body;
}

Eigen::Vector3d tool_force(const Body& body) {
  return body.state().contacts[0].force;
}

/// Mean force over the last two thirds of a drag.
Eigen::Vector3d mean_drag(Body& body, ToolPose& pose, const Eigen::Vector3d& way, int steps) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int step = 0;
  pose = move(body, pose, pose.tip + way, steps, 1, [&](const ToolPose&) {
    if (++step > steps / 3) sum += tool_force(body);
  });
  return sum;
}

TEST(Friction, OfASlidingBallIsTheCoefficientTimesTheNormalForceOnEveryMesh) {
  for (const auto& [triangles, mu] : {std::pair(1024, 0.3), std::pair(4096, 0.3), std::pair(1024, 0.1)}) {
    ToolPose pose;
    Body body = pressed_sheet(triangles, mu, {-1e-3, 0}, pose);
    const Eigen::Vector3d force = mean_drag(body, pose, {3e-3, 0, 0}, 24);
    std::printf("%d triangles, friction %.1f: ratio %.5f, aside %.1e\n", triangles, mu, -force.x() / force.z(),
                force.y() / force.z());
    EXPECT_NEAR(-force.x() / force.z(), mu, 0.01 * mu);
    EXPECT_NEAR(force.y() / force.z(), 0, 1e-3 * mu);
  }
}

TEST(Friction, PointsAgainstTheMotionWhateverItsDirection) {
  ToolPose pose;
  Body body = pressed_sheet(1024, 0.3, {-1e-3, -0.5e-3}, pose);
  const Eigen::Vector3d way(3e-3 * std::cos(0.6), 3e-3 * std::sin(0.6), 0);
  const Eigen::Vector3d force = mean_drag(body, pose, way, 24);
  const Eigen::Vector3d across = way.normalized().cross(Eigen::Vector3d::UnitZ());
  EXPECT_NEAR(-force.dot(way.normalized()) / force.z(), 0.3, 0.01 * 0.3);
  // The pattern of the triangles pulls a coarse patch aside by up to half a percent of the normal force.
  EXPECT_NEAR(force.dot(across) / force.z(), 0, 0.01);
  const Eigen::Vector3d back = mean_drag(body, pose, -way, 24);
  EXPECT_NEAR(back.dot(way.normalized()) / back.z(), 0.3, 0.01 * 0.3);
}

TEST(Friction, ThatSticksTakesTheWallAlongAndGivesBackWhatItTook) {
  ToolPose pose;
  Body body = pressed_sheet(1024, 0.8, {0, 0}, pose);
  const Eigen::VectorXd before = body.state().equilibrium.position;
  const Eigen::Vector3d force = tool_force(body);
  const double limit = 0.8 * force.z(), way = 20e-6;
  pose = move(body, pose, pose.tip + Eigen::Vector3d(way, 0, 0), 5, 1);
  // The middle vertex is under the ball.
  int middle = 0;
  for (int v = 0; v < body.model().vertices(); ++v) {
    if (before.segment<2>(3 * v).norm() < before.segment<2>(3 * middle).norm()) middle = v;
  }
  EXPECT_NEAR(body.state().equilibrium.position[3 * middle] - before[3 * middle], way, 0.02 * way);
  const double drag = -tool_force(body).x();
  std::printf("sticking drag %.3f of the limit\n", drag / limit);
  EXPECT_GT(drag, 0.05 * limit);
  EXPECT_LT(drag, 0.9 * limit);
  // Held for long it does not creep, and moved back it gives back all.
  pose = move(body, pose, pose.tip, 50, 1);
  EXPECT_NEAR(-tool_force(body).x(), drag, 1e-6 * drag);
  move(body, pose, pose.tip - Eigen::Vector3d(way, 0, 0), 5, 1);
  EXPECT_LT((tool_force(body) - force).norm(), 0.02 * drag);
}

/// A strip along x, stretched along it, over a capsule across it.
TEST(Friction, OfATurningRodUnderAStripIsThatOfARopeOnAPost) {
  BodyDefinition strip = make_body(make_sheet(60e-3, 6e-3, 1600), 1e-3, neo_hookean(20e3));
  strip.fluid.kind = FluidKind::kNone;
  strip.prestretch = {{.first = 1.4, .second = 1 / std::sqrt(1.4)}};
  const FixedRegion left{.region = PlaneRegion{.axis = 0, .at = -30e-3}},
      right{.region = PlaneRegion{.axis = 0, .at = 30e-3}};
  strip.fixed = {left, right};
  ToolDefinition rod = rough(sphere_tool(8e-3), 0.25);
  rod.kind = ToolKind::kCapsule;
  rod.length = 40e-3;
  Body body(strip, {rod}, quasi_static());
  body.settle();
  ToolPose pose = move(body, pose_at({0, 0, 1e-6}), {0, 0, -15e-3}, 15, 1);
  // Turned about its own axis, whose middle is a radius behind the tip.
  const Eigen::Vector3d center = pose.tip - rod.radius * pose.direction;
  std::array<ToolPose, 1> from = {pose};
  for (int step = 0; step < 30; ++step) {
    std::array<ToolPose, 1> to = from;
    to[0].direction = (Eigen::AngleAxisd(0.02, pose.axis) * from[0].direction).normalized();
    to[0].tip = center + rod.radius * to[0].direction;
    body.advance(from, to, 1);
    from = to;
  }
  const Eigen::VectorXd forces = internal_forces(body);
  std::array<Eigen::Vector3d, 2> ends = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  for (int v = 0; v < body.model().vertices(); ++v) {
    if (body.model().fixed[3 * v]) ends[body.model().rest_position[3 * v] > 0] += forces.segment<3>(3 * v);
  }
  const double wrap = std::numbers::pi - std::acos(ends[0].dot(ends[1]) / ends[0].norm() / ends[1].norm());
  const double ratio = std::max(ends[0].norm(), ends[1].norm()) / std::min(ends[0].norm(), ends[1].norm());
  std::printf("wrapped by %.3f: ratio %.5f, of a rope %.5f\n", wrap, ratio, std::exp(0.25 * wrap));
  EXPECT_NEAR(std::log(ratio), 0.25 * wrap, 0.01 * 0.25 * wrap);
}

TEST(Friction, OfASpinningBallHasTheTorqueOfAnEvenPressure) {
  // A membrane of even tension lies on a ball with even pressure: torque = 2/3 of friction times force times radius.
  ToolPose pose;
  Body body = pressed_sheet(4096, 0.3, {0, 0}, pose);
  std::array<ToolPose, 1> from = {pose};
  for (int step = 0; step < 10; ++step) {
    std::array<ToolPose, 1> to = from;
    to[0].axis = Eigen::AngleAxisd(0.02, Eigen::Vector3d::UnitZ()) * from[0].axis;
    body.advance(from, to, 1);
    from = to;
  }
  const ToolContact& contact = body.state().solid_contacts[0];
  const double radius = std::sqrt(contact.area / std::numbers::pi);
  const double torque = 2.0 / 3 * 0.3 * contact.force.z() * radius;
  std::printf("torque %.4e N m, of even pressure %.4e\n", -contact.moment.z(), torque);
  EXPECT_NEAR(-contact.moment.z(), torque, 0.05 * torque);
}

TEST(Friction, BooksOfASlidingBallCloseAndChargeFrictionWithTheWork) {
  for (const Analysis analysis : {Analysis::kQuasiStatic, Analysis::kDynamic}) {
    SimulationOptions options;
    options.analysis = analysis;
    Body body(stretched_sheet(1024), {rough(sphere_tool(5e-3), 0.3)}, options);
    body.settle();
    double worst = 0, largest = 0;
    const auto note = [&](const ToolPose&) {
      const EnergyBooks& books = body.state().books;
      worst = std::max(worst, std::abs(books.imbalance()));
      largest = std::max({largest, books.tool_work, books.friction, books.elastic - books.script_work});
    };
    ToolPose pose = move(body, pose_at({-4e-3, 0, 1e-6}), {-4e-3, 0, -1e-3}, 10, 5e-3, note);
    pose = move(body, pose, {-2e-3, 0, -1e-3}, 20, 5e-3, note);
    const EnergyBooks before = body.state().books;
    pose = move(body, pose, {2e-3, 0, -1e-3}, 40, 5e-3, note);
    const EnergyBooks after = body.state().books;
    pose = move(body, pose, {-2e-3, 0, -1e-3}, 40, 5e-3, note);
    move(body, pose, {-2e-3, 0, 1e-3}, 20, 5e-3, note);
    const double work = after.tool_work - before.tool_work, friction = after.friction - before.friction;
    std::printf("work %.3e J, friction %.3e, numerical %.1e, all numerical %.1e, imbalance %.1e of the largest\n", work,
                friction, after.numerical - before.numerical, body.state().books.numerical, worst / largest);
    EXPECT_GT(friction, 2e-5);
    EXPECT_NEAR(friction, work, 0.02 * work);
    EXPECT_LT(worst, 1e-9 * largest);
    EXPECT_LT(std::abs(after.numerical - before.numerical), 0.01 * work);
  }
}

TEST(Friction, UnderAPlateWhoseLoadGoesToAndFroBetweenItsEdgesIsFoundWhereTheWallRests) {
  // Which of two mirrored places at the plate's rims bears the load, friction that is a little different elsewhere
  // decides anew each time, while the wall moves by less than a thousandth of an edge.
  BodyDefinition ball = make_body(make_sphere(20e-3, 180), 0.970352e-3, mooney_rivlin(8722.41, 2180.6));
  ball.fluid.kind = FluidKind::kCompressible;
  ball.fluid.bulk_modulus = 138837;
  ToolDefinition plate = rough({.name = "plate", .kind = ToolKind::kPlate}, 0.53208);
  plate.length = 14.6721662e-3;
  plate.width = 12.4795861e-3;
  plate.thickness = 2.63886966e-3;
  Body body(ball, {plate}, quasi_static());
  body.settle();
  const Eigen::Vector3d aim(-1.3945e-3, 0.314572e-3, 0);
  const auto travel =
      travel_to_contact(body.surface(), plate, pose_at(aim + Eigen::Vector3d(0, 0, 80e-3)), -Eigen::Vector3d::UnitZ());
  ASSERT_TRUE(travel);
  const Eigen::Vector3d start = aim + Eigen::Vector3d(0, 0, 80e-3 - *travel + 0.5e-3);
  move(body, pose_at(start), start - Eigen::Vector3d(0, 0, 3e-3), 3, 1);
  const Eigen::Vector3d force = tool_force(body);
  EXPECT_GT(force.z(), 0);
  EXPECT_LE(force.head<2>().norm(), 0.53208 * force.z());
}

/// Rough jaws of 6 mm go 5 mm beyond the crown of a ball whose triangles are as long as they are wide, and close on it
/// in steps of a millimetre, so many of them. Each step is to be found within so many iterations.
void close_jaws_on_a_ball(int steps, int most_iterations) {
  BodyDefinition ball = make_body(make_sphere(25e-3, 320), 2e-3, mooney_rivlin(8e3, 2e3));
  ball.fluid.initial_pressure = 300;
  ball.fixed = {{.region = BelowRegion{.axis = 2, .at = -15e-3}}};
  ToolDefinition jaws = rough({.name = "jaws", .kind = ToolKind::kForceps}, 0.5);
  jaws.length = 30e-3;
  jaws.width = 6e-3;
  jaws.thickness = 1.5e-3;
  jaws.opening = 10e-3;
  Body body(ball, {jaws}, quasi_static());
  body.settle();
  ToolPose pose = pose_at({0.7e-3, 0.3e-3, 37e-3});
  pose.opening = jaws.opening;
  pose = move(body, pose, pose.tip - Eigen::Vector3d(0, 0, 16e-3), 8, 0.05);
  pose = move(body, pose, {pose.tip.x(), pose.tip.y(), 20e-3}, 1, 0.05);
  for (int step = 1; step <= steps; ++step) {
    ToolPose next = pose;
    next.opening = jaws.opening - 0.95e-3 * step;
    body.advance({&pose, 1}, {&next, 1}, 0.05);
    std::printf("jaws %.2f mm apart: %d iterations\n", 1e3 * next.opening, body.report().newton_iterations);
    EXPECT_LE(body.report().newton_iterations, most_iterations);
    EXPECT_LT((support_force(body) - tool_force(body)).norm(), 1e-6 * largest_single_force(body));
    pose = next;
  }
}

TEST(Friction, OfAWallThatHasSnappedIsFoundFromWhereItIsThen) {
  // 421 iterations at most; 1 467 where each revision of the friction let it snap again from where the step began,
  // under forces of where it had come to.
  close_jaws_on_a_ball(3, 800);
}

TEST(Friction, OfAWallThatRollsToAndFroOnACornerSettles) {
  // 1 446 iterations at most; 3 575 where normals that turned back went all the way from one solution to the next.
  close_jaws_on_a_ball(10, 2200);
}

TEST(Friction, OfJawsThatHoldATautShellByAFewCornersIsFound) {
  // A few places at the jaws' tips bear all. What friction at one of them changes by, the others answer by more, so
  // that it goes to and fro where each solution is given what the last one asked for, or half of the way there. 477
  // iterations at most; so found, more than ten thousand.
  BodyDefinition sheet = make_body(make_sheet(60e-3, 60e-3, 300), 1.5e-3, neo_hookean(40e3));
  sheet.model = WallModel::kShell;
  sheet.fluid.kind = FluidKind::kNone;
  sheet.prestretch = {{.first = 1.05, .second = 1.05}};
  sheet.damping.mass_rate = 100;
  sheet.fixed = {{.region = BoundaryRegion{}}};
  ToolDefinition jaws = rough({.name = "jaws", .kind = ToolKind::kForceps}, 1.5);
  jaws.length = 30e-3;
  jaws.width = 5e-3;
  jaws.thickness = 1.5e-3;
  jaws.opening = 10e-3;
  SimulationOptions options;
  options.analysis = Analysis::kDynamic;
  Body body(sheet, {jaws}, options);
  body.settle();
  ToolPose pose = pose_at({0, 0, 1e-3});
  pose.opening = jaws.opening;
  pose = move(body, pose, {0, 0, -4e-3}, 17, 0.01);
  for (int step = 1; step <= 45; ++step) {
    ToolPose next = pose;
    next.opening = jaws.opening - 0.07e-3 * step;
    body.advance({&pose, 1}, {&next, 1}, 0.01);
    std::printf("jaws %.2f mm apart: %d iterations\n", 1e3 * next.opening, body.report().newton_iterations);
    EXPECT_LE(body.report().newton_iterations, 1000);
    const EnergyBooks& books = body.state().books;
    EXPECT_LT(std::abs(books.imbalance()), 1e-9 * books.largest());
    pose = next;
  }
}

TEST(Friction, VanishesWithItsCoefficient) {
  const auto drag = [](double friction) {
    ToolPose pose;
    Body body = pressed_sheet(256, friction, {-1e-3, 0.3e-3}, pose);
    move(body, pose, {1e-3, 0, -kDepth}, 6, 1);
    return body.state();
  };
  const BodyState smooth = drag(0), nearly = drag(1e-9);
  EXPECT_TRUE(smooth.friction[0].empty());
  EXPECT_EQ(smooth.books.friction, 0);
  EXPECT_LT((smooth.contacts[0].force - nearly.contacts[0].force).norm(), 1e-8 * smooth.contacts[0].force.norm());
}

TEST(Friction, DoesNotDependOnTheNumberOfThreads) {
  std::vector<Eigen::VectorXd> positions;
  for (const std::size_t threads : {1, 2, 5}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    ToolPose pose;
    Body body = pressed_sheet(1024, 0.3, {-1e-3, 0}, pose);
    move(body, pose, pose.tip + Eigen::Vector3d(1e-3, 2e-4, 0), 4, 1);
    positions.push_back(body.state().equilibrium.position);
  }
  EXPECT_EQ(positions[0], positions[1]);
  EXPECT_EQ(positions[0], positions[2]);
}

}  // namespace
}  // namespace thinwall
