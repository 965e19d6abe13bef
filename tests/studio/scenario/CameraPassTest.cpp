#include "studio/scenario/CameraPass.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace thinwall
