#include "studio/scenario/CameraPass.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "tests/studio/scenario/CheckedText.hpp"

namespace thinwall {
namespace {

/// Where the camera faces after the pass, for one palpation along a direction; nothing when the pass leaves it alone.
std::optional<Eigen::Vector3d> facing(const std::string& direction, const std::string& camera = "{}") {
  CheckedValue root =
      checked_scenario("timeline:\n  - palpate: { tool: probe, body: organ, depth: 1 mm, direction: " + direction +
                       " }\ncamera: " + camera + "\n");
  camera_pass(root);
  const CheckedValue* value = root.at("camera").find("facing");
  if (value == nullptr) return std::nullopt;
  return Eigen::Vector3d(value->items[0].number, value->items[1].number, value->items[2].number);
}

TEST(CameraPass, LeavesTheStandardViewToToolsThatPressDown) {
  EXPECT_FALSE(facing("[0, 0, -1]"));
  EXPECT_FALSE(facing("[0.3, 0.2, -1]"));
}

TEST(CameraPass, LooksWithToolsThatPressFromTheSide) {
  for (const auto& [text, direction] :
       {std::pair{"[0, -1, 0]", Eigen::Vector3d(0, -1, 0)}, std::pair{"[1, 0, 0]", Eigen::Vector3d(1, 0, 0)},
        std::pair{"[-1, 1, 0]", Eigen::Vector3d(-0.7, 0.7, 0)}}) {
    const auto view = facing(text);
    ASSERT_TRUE(view) << text;
    EXPECT_NEAR(view->norm(), 1, 1e-12);
    EXPECT_GT(view->dot(direction), 0.5) << text;
    EXPECT_LT(view->z(), 0) << "seen from above";
  }
}

TEST(CameraPass, LooksUpAtToolsThatPressFromBelow) {
  ASSERT_TRUE(facing("[0, 0, 1]"));
  EXPECT_GT(facing("[0, 0, 1]")->z(), 0);
}

TEST(CameraPass, KeepsWhatTheScenarioSays) {
  EXPECT_FALSE(facing("[0, 1, 0]", "{ position: [1 m, 0, 0] }"));
  EXPECT_EQ(*facing("[0, 1, 0]", "{ facing: [0, 0, -1] }"), Eigen::Vector3d(0, 0, -1));
}

CheckedValue after_cut(const std::string& shape, const std::string& path, const std::string& more,
                       const std::string& camera) {
  CheckedValue root = checked_scenario("timeline:\n  - incise: { tool: blade, body: organ, depth: 1 mm, path: " + path +
                                           more + " }\ncamera: " + camera + "\n",
                                       shape);
  camera_pass(root);
  return root;
}

/// Where the camera faces for a cut along a path in a body of a shape.
std::optional<Eigen::Vector3d> facing_cut(const std::string& shape, const std::string& path,
                                          const std::string& more = "") {
  const CheckedValue root = after_cut(shape, path, more, "{}");
  const CheckedValue* value = root.at("camera").find("facing");
  if (value == nullptr) return std::nullopt;
  return Eigen::Vector3d(value->items[0].number, value->items[1].number, value->items[2].number);
}

TEST(CameraPass, LooksIntoAWoundWhereverItIsCutInARoundShape) {
  const std::string ball = "{ shape: sphere, radius: 20 mm }";
  for (const auto& [path, inward] : {std::pair{"[[-20 mm, 8 mm, 0], [-20 mm, -8 mm, 0]]", Eigen::Vector3d(1, 0, 0)},
                                     std::pair{"[[8 mm, 20 mm, 0], [-8 mm, 20 mm, 0]]", Eigen::Vector3d(0, -1, 0)},
                                     std::pair{"[[-8 mm, 0, -20 mm], [8 mm, 0, -20 mm]]", Eigen::Vector3d(0, 0, 1)}}) {
    const auto view = facing_cut(ball, path);
    ASSERT_TRUE(view) << path;
    EXPECT_NEAR(view->norm(), 1, 1e-12);
    EXPECT_NEAR(view->dot(inward), std::cos(std::numbers::pi / 6), 1e-12) << path;
    EXPECT_TRUE(inward.z() != 0 || view->z() < 0) << "from above";
  }
}

TEST(CameraPass, LooksSteeplyDownOntoAWoundThatIsCutFromAbove) {
  const auto elevation = [](const std::string& shape, const std::string& more = "", const std::string& camera = "{}") {
    const CheckedValue root = after_cut(shape, "[[-8 mm, 0, 20 mm], [8 mm, 0, 20 mm]]", more, camera);
    const CheckedValue* value = root.at("camera").find("elevation");
    return value != nullptr ? value->number : 0;
  };
  const double steep = 55 * std::numbers::pi / 180;
  const std::string mesh = "{ mesh: organ.obj, unit: mm }";
  EXPECT_DOUBLE_EQ(elevation("{ shape: hemisphere, radius: 20 mm }"), steep);
  EXPECT_DOUBLE_EQ(elevation("{ shape: sheet, width: 40 mm, length: 40 mm }"), steep);
  EXPECT_DOUBLE_EQ(elevation(mesh, ", direction: [0.1, 0, -1]"), steep);
  EXPECT_EQ(elevation(mesh), 0) << "nothing tells from where it is cut";
  EXPECT_EQ(elevation(mesh, ", direction: [0, 0, -1]", "{ position: [1 m, 0, 0] }"), 0);
  EXPECT_DOUBLE_EQ(elevation("{ shape: hemisphere, radius: 20 mm }", "", "{ elevation: 20 deg }"),
                   20 * std::numbers::pi / 180);
}

TEST(CameraPass, KnowsWhereABladeGoesInByItsDirectionAlsoInAMesh) {
  const std::string path = "[[-20 mm, 8 mm, 0], [-20 mm, -8 mm, 0]]", mesh = "{ mesh: organ.obj, unit: mm }";
  const auto view = facing_cut(mesh, path, ", direction: [1, 0, 0]");
  ASSERT_TRUE(view);
  EXPECT_GT(view->x(), 0.8);
  EXPECT_FALSE(facing_cut(mesh, path)) << "nothing tells where the inside is";
}

}  // namespace
}  // namespace thinwall
