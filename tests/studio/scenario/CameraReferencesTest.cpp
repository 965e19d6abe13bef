#include "studio/scenario/CameraReferences.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "studio/scenario/LoadScenario.hpp"
#include "tests/studio/scenario/CheckedText.hpp"

namespace thinwall {
namespace {

TEST(CameraReferences, ALeftOutToolIsTheOnlyOne) {
  CheckedValue root = checked_scenario("camera: { follow: {} }\n");
  std::erase_if(root.find("tools")->members, [](const CheckedMember& tool) { return tool.key == "edge"; });
  Diagnostics diagnostics;
  camera_references(root, diagnostics);
  EXPECT_TRUE(diagnostics.errors.empty());
  EXPECT_EQ(root.at("camera").at("follow").at("tool").text, "probe");
}

TEST(CameraReferences, AScenarioKeepsItsCamerasMovesAndCuts) {
  const Scenario scenario = load_scenario(scenario_test_folder() / "valid/everything.yaml", {});
  EXPECT_EQ(scenario.view.camera.lens, (LensDistortion{.k1 = -0.2, .k2 = 0.05, .p1 = 0.001, .p2 = -0.001, .k3 = 0.01}));
  EXPECT_TRUE(scenario.view.camera.auto_exposure);
  EXPECT_EQ(scenario.view.camera.noise, 1.5);
  EXPECT_EQ(scenario.view.camera.seed, 7U);
  EXPECT_EQ(scenario.view.camera.aperture, 0.0008);
  EXPECT_EQ(scenario.view.camera.focus, 0.06);
  const CameraDefinition& close = scenario.view.cameras.at("close");
  EXPECT_EQ(close.kind, CameraKind::kEndoscope);
  EXPECT_EQ(close.lamp, 0.8);
  ASSERT_EQ(close.keyframes.size(), 2U);
  EXPECT_EQ(close.keyframes[0].target, (Double3{0, 0, 0}));
  EXPECT_NEAR(*close.keyframes[0].field_of_view, 50 * std::numbers::pi / 180, 1e-15);
  EXPECT_EQ(close.keyframes[1].position, (Double3{0, 0.05, 0.05}));
  EXPECT_FALSE(close.keyframes[1].target);
  EXPECT_EQ(close.keyframes[1].ease, CameraEase::kLinear);
  ASSERT_TRUE(close.follow);
  EXPECT_EQ(close.follow->smoothing, 0.3);
  EXPECT_FALSE(close.follow->travels);
  ASSERT_EQ(close.push_ins.size(), 1U);
  EXPECT_EQ(close.push_ins[0].factor, 0.5);
  ASSERT_EQ(scenario.view.cuts.size(), 2U);
  EXPECT_EQ(scenario.view.cuts[0].inset, "main");
  EXPECT_EQ(scenario.view.cuts[0].corner, PictureCorner::kLowerLeft);
  EXPECT_EQ(scenario.view.cuts[1].beside, "close");
  EXPECT_FALSE(scenario.view.cuts[1].corner) << "which is chosen by what the pictures show";
}

}  // namespace
}  // namespace thinwall
