#include "studio/golden/PicturesForLooking.hpp"

#include <gtest/gtest.h>

#include "renderer/image/Folder.hpp"
#include "renderer/image/WholeFile.hpp"
#include "tests/studio/golden/GoldenScene.hpp"

namespace thinwall {
namespace {

class PicturesForLookingTest : public ::testing::Test {
 protected:
  void SetUp() override { scene_.approve(); }
  /// Keeps what a test of the scenario leaves to be looked at.
  void test(const Scenario& scenario, double gain = 1) {
    const JudgedScenario judged = scene_.judge(scenario, synthetic_source(), view_painters(gain));
    PicturesForLooking pictures(folder());
    pictures.keep(judged, 0, scene_.folder());
    pictures.remove_others();
  }
  std::filesystem::path folder() const { return scene_.temporary().path() / "out"; }
  bool has(const std::string& name) const { return std::filesystem::exists(folder() / name); }

  GoldenScene scene_;
};

TEST_F(PicturesForLookingTest, TodaysPictureAndTheDifferenceOfAFailureAreKept) {
  test(golden_scene(), 1.2);
  EXPECT_TRUE(has("at_0.1s.today.png"));
  EXPECT_TRUE(has("at_0.1s.difference.png"));
}

TEST_F(PicturesForLookingTest, WhatAnEarlierTestHasLeftIsRemoved) {
  test(golden_scene(1.2));
  ASSERT_TRUE(has("at_0.1s.golden_look.png"));
  test(golden_scene(), 1.2);
  EXPECT_TRUE(has("at_0.1s.today.png"));
  EXPECT_FALSE(has("at_0.1s.golden_look.png"));
}

TEST_F(PicturesForLookingTest, OfAGoodTestNothingIsLeft) {
  test(golden_scene(), 1.2);
  test(golden_scene());
  EXPECT_FALSE(std::filesystem::exists(folder()));
}

TEST_F(PicturesForLookingTest, FilesOfOthersStay) {
  make_folder(folder());
  write_whole_file(folder() / "at_the_table.png", "a picture of someone");
  test(golden_scene());
  EXPECT_TRUE(has("at_the_table.png"));
}

}  // namespace
}  // namespace thinwall
