#include "studio/golden/GoldenCache.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

#include "studio/recorder/Interruption.hpp"
#include "tests/studio/golden/GoldenScene.hpp"

namespace thinwall {
namespace {

class GoldenCacheTest : public ::testing::Test {
 protected:
  void SetUp() override { scene_.approve(); }
  JudgedScenario judge(const Scenario& scenario, const std::string& program = "1",
                       const SourceFactory& sources = synthetic_source()) {
    GoldenRunOptions options = scene_.options(sources, view_painters());
    options.cache = scene_.temporary() / "cache.json";
    options.program = program;
    return std::move(judge_scenarios({scenario}, options, [](const JudgedScenario&) {}).front());
  }
  /// `scenario` or its second take names organ.obj, beside it.
  void expect_file_counts(Scenario scenario) {
    scenario.file = scene_.temporary() / "scene.yaml";
    judge(scenario);
    EXPECT_FALSE(judge(scenario).from_cache) << "a file that is not found is never taken as unchanged";
    write_bytes(scene_.temporary() / "organ.obj", "v 0 0 0");
    judge(scenario);
    EXPECT_TRUE(judge(scenario).from_cache);
    write_bytes(scene_.temporary() / "organ.obj", "v 0 0 1");
    EXPECT_FALSE(judge(scenario).from_cache);
  }

  GoldenScene scene_;
};

TEST_F(GoldenCacheTest, WhatWasGoodIsNotMadeAgain) {
  EXPECT_FALSE(judge(golden_scene()).from_cache);
  const JudgedScenario again = judge(golden_scene());
  EXPECT_TRUE(again.from_cache);
  EXPECT_EQ(again.results[0].outcome, GoldenOutcome::kOk);
  EXPECT_EQ(again.results[0].message, "equal");
}

TEST_F(GoldenCacheTest, AnotherProgramScenarioOrGoldenIsMadeAnew) {
  judge(golden_scene());
  EXPECT_FALSE(judge(golden_scene(), "2").from_cache);
  judge(golden_scene());
  EXPECT_FALSE(judge(golden_scene(1, "20001.0")).from_cache);
  judge(golden_scene());
  write_bytes(scene_.folder() / "approval.json", file_bytes(scene_.folder() / "approval.json") + " ");
  EXPECT_FALSE(judge(golden_scene()).from_cache);
}

TEST_F(GoldenCacheTest, AFileThatTheScenarioNamesCounts) {
  Scenario scenario = golden_scene();
  scenario.resolved = R"({"mesh": "organ.obj", "lights": {"key": 1}})";
  expect_file_counts(scenario);
}

TEST_F(GoldenCacheTest, AFileOfNumbersThatAMeshNamesCounts) {
  Scenario scenario = golden_scene();
  scenario.resolved = R"({"mesh": "organ.gltf", "lights": {"key": 1}})";
  scenario.file = scene_.temporary() / "scene.yaml";
  write_bytes(scene_.temporary() / "organ.gltf", R"({"buffers": [{"uri": "organ%20one.bin"}, {"uri": "data:,x"}]})");
  write_bytes(scene_.temporary() / "organ one.bin", "0 0 0");
  judge(scenario);
  EXPECT_TRUE(judge(scenario).from_cache);
  write_bytes(scene_.temporary() / "organ one.bin", "0 0 1");
  EXPECT_FALSE(judge(scenario).from_cache);
}

TEST_F(GoldenCacheTest, AFailureIsNeverRemembered) {
  judge(golden_scene());
  const SourceFactory deeper = synthetic_source({.depth = 0.006});
  EXPECT_EQ(judge(golden_scene(1, "2.0"), "1", deeper).results[0].outcome, GoldenOutcome::kFailed);
  EXPECT_EQ(judge(golden_scene(1, "2.0"), "1", deeper).results[0].outcome, GoldenOutcome::kFailed);
}

TEST_F(GoldenCacheTest, AFileThatOnlyTheSecondTakeNamesCounts) {
  Scenario scenario = golden_scene();
  auto second = std::make_shared<Scenario>(scenario);
  second->resolved = R"({"mesh": "organ.obj"})";
  scenario.comparison = {.second = second};
  expect_file_counts(scenario);
}

TEST_F(GoldenCacheTest, WhatIsMadeAnewLeavesWhatIsKnownOfOthers) {
  Scenario other = golden_scene();
  other.name = "other";
  std::filesystem::copy(scene_.folder(), scene_.folder().parent_path() / "other");
  judge(other);
  GoldenRunOptions options = scene_.options(synthetic_source(), view_painters());
  options.cache = scene_.temporary() / "cache.json";
  options.anew = true;
  judge_scenarios({golden_scene()}, options, [](const JudgedScenario&) {});
  EXPECT_TRUE(judge(other).from_cache);
}

TEST_F(GoldenCacheTest, WhatIsMadeAnewIsKeptForTheNextTime) {
  judge(golden_scene());
  GoldenRunOptions options = scene_.options(synthetic_source(), view_painters());
  options.cache = scene_.temporary() / "cache.json";
  options.anew = true;
  EXPECT_FALSE(judge_scenarios({golden_scene()}, options, [](const JudgedScenario&) {})[0].from_cache);
  EXPECT_TRUE(judge(golden_scene()).from_cache);
}

TEST_F(GoldenCacheTest, WhatIsGoodInAnotherProcessIsNotMadeHere) {
  const auto test_elsewhere = [&](const Scenario& scenario) {
    GoldenRunOptions options = scene_.options(synthetic_source(), view_painters());
    options.cache = scene_.temporary() / (scenario.name + ".json");
    judge_scenarios({scenario}, options, [](const JudgedScenario&) {});
    return *options.cache;
  };
  GoldenRunOptions options = scene_.options(
      [](const Scenario&) -> std::unique_ptr<MomentSource> { throw SimulationFailure("made here"); }, view_painters());
  options.cache = scene_.temporary() / "cache.json";
  options.jobs = 2;
  options.in_other_process = test_elsewhere;
  Scenario unapproved = golden_scene();
  unapproved.name = "unapproved";
  const auto all = judge_scenarios({golden_scene(), unapproved}, options, [](const JudgedScenario&) {});
  EXPECT_EQ(all[0].results[0].outcome, GoldenOutcome::kOk);
  EXPECT_FALSE(all[0].from_cache);
  EXPECT_EQ(all[1].results[0].message, "made here");
}

/// A terminate signal reaches this process alone, while another one finds all good.
void judge_and_exit_as_terminated(const GoldenScene& scene) {
  note_interruptions();
  GoldenRunOptions options = scene.options(synthetic_source(), view_painters());
  options.cache = scene.temporary() / "cache.json";
  options.jobs = 2;
  options.in_other_process = [&](const Scenario& scenario) {
    // A second one would end the process at once.
    if (scenario.name == "other") {
      kill(getpid(), SIGTERM);
      EXPECT_THROW(for (;;) throw_if_interrupted(), Interrupted);
    }
    return scene.temporary() / "good.json";
  };
  Scenario other = golden_scene();
  other.name = "other";
  try {
    judge_scenarios({golden_scene(), other}, options, [](const JudgedScenario&) { std::exit(1); });
  } catch (const Interrupted& interrupted) {
    std::exit(interrupted.exit_code());
  }
  std::exit(2);
}

TEST_F(GoldenCacheTest, ASignalWhileOtherProcessesLookEndsTheComparison) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  GoldenRunOptions options = scene_.options(synthetic_source(), view_painters());
  options.cache = scene_.temporary() / "good.json";
  judge_scenarios({golden_scene()}, options, [](const JudgedScenario&) {});
  EXPECT_EXIT(judge_and_exit_as_terminated(scene_), ::testing::ExitedWithCode(143), "");
}

TEST_F(GoldenCacheTest, ABrokenCacheIsNone) {
  judge(golden_scene());
  write_bytes(scene_.temporary() / "cache.json", "{\"sheet\": 3");
  EXPECT_FALSE(judge(golden_scene()).from_cache);
}

}  // namespace
}  // namespace thinwall
