#include "studio/scenario/CameraPass.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "tests/studio/scenario/CheckedText.hpp"

namespace thinwall {
namespace {

using Eigen::Vector3d;

/// A scenario with one camera after the pass over these clips; cuts without direction go in as said.
CheckedValue turned(const std::vector<Clip>& timeline, const std::string& camera, const CameraQuestions& ask,
                    const Vector3d& gravity = Vector3d::Zero()) {
  CheckedValue root = checked_scenario("camera: " + camera + "\n");
  camera_pass(root, timeline, gravity, ask);
  return root;
}

/// Answers of bodies that hide nothing.
CameraQuestions goes_in(const Vector3d& inward) {
  return {.inward_along = [inward](const InciseClip&) { return inward; },
          .hidden_parts = [](std::span<const Vector3d> facings) { return std::vector<double>(facings.size(), 0); }};
}

std::optional<Vector3d> direction_of(const CheckedValue& root, const char* key) {
  const CheckedValue* value = root.at("camera").find(key);
  if (value == nullptr) return std::nullopt;
  return Vector3d(value->items[0].number, value->items[1].number, value->items[2].number);
}

std::optional<Vector3d> facing_of(const CheckedValue& root) {
  return direction_of(root, "facing");
}

/// Where the camera faces after the pass, for one palpation along a direction; nothing when the pass leaves it alone.
std::optional<Vector3d> facing(const Vector3d& direction, const std::string& camera = "{}") {
  const Clip clip{.action = PalpateClip{.direction = direction.normalized()}};
  return facing_of(turned({clip}, camera, goes_in(Vector3d::Zero())));
}

TEST(CameraPass, LeavesTheStandardViewToToolsThatPressDown) {
  EXPECT_FALSE(facing({0, 0, -1}));
  EXPECT_FALSE(facing({0.3, 0.2, -1}));
}

TEST(CameraPass, LooksWithToolsThatPressFromTheSide) {
  for (const Vector3d& direction : {Vector3d(0, -1, 0), Vector3d(1, 0, 0), Vector3d(-1, 1, 0)}) {
    const auto view = facing(direction);
    ASSERT_TRUE(view) << direction.transpose();
    EXPECT_NEAR(view->norm(), 1, 1e-12);
    EXPECT_GT(view->dot(direction.normalized()), 0.5) << direction.transpose();
    EXPECT_LT(view->z(), 0) << "seen from above";
  }
}

TEST(CameraPass, TurnsAllWithGravity) {
  // Where y is upwards what was +y is -z.
  const Vector3d gravity(0, -9.81, 0);
  const auto turned_over = [](const Vector3d& v) { return Vector3d(v.x(), v.z(), -v.y()); };
  for (const Vector3d& direction : {Vector3d(0, -1, 0), Vector3d(1, 0, 0), Vector3d(0.6, 0, 0.8), Vector3d(0, 0, -1)}) {
    for (const bool cuts : {false, true}) {
      const auto clip = [&](const Vector3d& along) {
        return cuts ? Clip{.action = InciseClip{.direction = along}} : Clip{.action = PalpateClip{.direction = along}};
      };
      const CameraQuestions ask = goes_in(Vector3d::Zero());
      const CheckedValue upright = turned({clip(direction)}, "{}", ask);
      const CheckedValue over = turned({clip(turned_over(direction))}, "{}", ask, gravity);
      EXPECT_FALSE(direction_of(upright, "up"));
      EXPECT_EQ(direction_of(over, "up"), Vector3d::UnitY());
      const auto facing = direction_of(upright, "facing"), facing_over = direction_of(over, "facing");
      ASSERT_EQ(facing.has_value(), facing_over.has_value()) << direction.transpose();
      if (!facing) continue;
      EXPECT_LT((*facing_over - turned_over(*facing)).norm(), 1e-12) << direction.transpose();
    }
  }
  const Clip press{.action = PalpateClip{.direction = {0, -1, 0}}};
  EXPECT_EQ(direction_of(turned({press}, "{ up: [1, 0, 0] }", goes_in(Vector3d::Zero()), gravity), "up"),
            Vector3d::UnitX());
  EXPECT_EQ(direction_of(turned({press}, "{ facing: [1, 0, 0] }", goes_in(Vector3d::Zero()), gravity), "up"),
            Vector3d::UnitY());
}

TEST(CameraPass, LooksOverTheShoulderFromWhichMoreIsSeen) {
  const Vector3d along(0, -1, 0);
  const Clip clip{.action = PalpateClip{.direction = along}};
  const auto facing_past = [&](double hidden_at_left, double hidden_at_right) {
    CameraQuestions ask = goes_in(Vector3d::Zero());
    ask.hidden_parts = [=](std::span<const Vector3d>) { return std::vector{hidden_at_left, hidden_at_right}; };
    return *facing_of(turned({clip}, "{}", ask));
  };
  const Vector3d usual = facing_past(0, 0), other = facing_past(1, 0.5);
  EXPECT_GT(usual.x(), 0) << "the standard side";
  EXPECT_LT((other - Vector3d(-usual.x(), usual.y(), usual.z())).norm(), 1e-12) << "the other one";
  EXPECT_EQ(facing_past(0.5, 1), usual);
  EXPECT_EQ(facing_past(1, 1), usual) << "where neither is better";
}

TEST(CameraPass, LooksUpAtToolsThatPressFromBelow) {
  ASSERT_TRUE(facing({0, 0, 1}));
  EXPECT_GT(facing({0, 0, 1})->z(), 0);
}

TEST(CameraPass, KeepsWhatTheScenarioSays) {
  EXPECT_FALSE(facing({0, 1, 0}, "{ position: [1 m, 0, 0] }"));
  EXPECT_EQ(*facing({0, 1, 0}, "{ facing: [0, 0, -1] }"), Vector3d(0, 0, -1));
}

/// Where the camera faces for a cut into a wall.
std::optional<Vector3d> facing_cut(const Vector3d& inward) {
  return facing_of(turned({{.action = InciseClip{}}}, "{}", goes_in(inward)));
}

/// How steeply the camera looks down on a cut, radians; zero: at the standard height.
double elevation(const Vector3d& inward, const std::string& camera = "{}") {
  const CheckedValue root = turned({{.action = InciseClip{}}}, camera, goes_in(inward));
  const CheckedValue* value = root.at("camera").find("elevation");
  return value != nullptr ? value->number : 0;
}

TEST(CameraPass, LooksIntoAWoundWhereverTheWallIsCut) {
  for (const Vector3d& inward : {Vector3d(1, 0, 0), Vector3d(0, -1, 0), Vector3d(0, 0, 1)}) {
    const auto view = facing_cut(inward);
    ASSERT_TRUE(view) << inward.transpose();
    EXPECT_NEAR(view->norm(), 1, 1e-12);
    EXPECT_NEAR(view->dot(inward), std::cos(std::numbers::pi / 6), 1e-12) << inward.transpose();
    EXPECT_TRUE(inward.z() != 0 || view->z() < 0) << "from above";
  }
  EXPECT_FALSE(facing_cut(Vector3d::Zero())) << "nothing tells where the inside is";
}

TEST(CameraPass, LooksSteeplyDownOntoAWoundThatIsCutFromAbove) {
  const Vector3d down(0, 0, -1);
  const double steep = 55 * std::numbers::pi / 180;
  EXPECT_DOUBLE_EQ(elevation(down), steep);
  EXPECT_DOUBLE_EQ(elevation(Vector3d(0.1, 0, -1).normalized()), steep);
  EXPECT_EQ(elevation(Vector3d::Zero()), 0) << "nothing tells from where it is cut";
  EXPECT_EQ(elevation(down, "{ position: [1 m, 0, 0] }"), 0);
  EXPECT_DOUBLE_EQ(elevation(down, "{ elevation: 20 deg }"), 20 * std::numbers::pi / 180);
}

TEST(CameraPass, BelievesTheDirectionThatACutHas) {
  const Clip clip{.action = InciseClip{.direction = Vector3d(1, 0, 0)}};
  const auto view = facing_of(turned({clip}, "{}", goes_in({0, 0, -1})));
  ASSERT_TRUE(view);
  EXPECT_GT(view->x(), 0.8);
}

TEST(CameraPass, AsksForNormalsOnlyWhereACameraStandsNowhere) {
  CheckedValue root = checked_scenario("camera: { position: [1 m, 0, 0] }\n");
  int asked = 0;
  const CameraQuestions count = {
      .inward_along = [&](const InciseClip&) { return ++asked, Vector3d(0, 0, -1); },
      .hidden_parts = [&](std::span<const Vector3d>) { return ++asked, std::vector<double>(2, 0.0); }};
  camera_pass(root, {{.action = InciseClip{}}}, Vector3d::Zero(), count);
  EXPECT_EQ(asked, 0) << "reading a mesh takes its time";
  root = checked_scenario("camera: { position: [1 m, 0, 0] }\ncameras: { other: {} }\n");
  camera_pass(root, {{.action = InciseClip{}}}, Vector3d::Zero(), count);
  EXPECT_EQ(asked, 1);
  EXPECT_NE(root.at("cameras").at("other").find("elevation"), nullptr);
}

}  // namespace
}  // namespace thinwall
