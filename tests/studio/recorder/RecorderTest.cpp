#include "studio/recorder/Recorder.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "renderer/image/ImageHash.hpp"
#include "renderer/image/PictureFailure.hpp"
#include "renderer/image/PngFile.hpp"
#include "renderer/overlay/Overlay.hpp"
#include "renderer/video/VideoProbe.hpp"
#include "studio/recorder/FrameComposer.hpp"
#include "studio/recorder/Interruption.hpp"
#include "studio/recorder/RecordCsv.hpp"
#include "studio/take/TakeReader.hpp"
#include "tests/studio/FlatPainter.hpp"
#include "tests/studio/SyntheticRun.hpp"
#include "tests/studio/TemporaryFolder.hpp"

namespace thinwall {
namespace {

constexpr ImageSize kSize = {.width = 96, .height = 64};

RecordingPlan plan_for(const std::filesystem::path& folder) {
  return {.folder = folder,
          .description = {.name = "sheet", .title = "A sheet", .resolved = R"({"thinwall":1})"},
          .overlays = {},
          .size = kSize,
          .video = false};
}

std::vector<std::string> names_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

bool any_looks_finished(const std::filesystem::path& folder) {
  for (const std::string& name : names_in(folder)) {
    if (name.find(".unfinished") == std::string::npos) return true;
  }
  return false;
}

TEST(RecorderTest, LeavesEachFileOfTheContract) {
  const TemporaryFolder folder;
  SyntheticRun run;
  RecordingPlan plan = plan_for(folder.path());
  plan.video = true;
  plan.frames = true;
  plan.surfaces = true;
  const RecordingReport report = record(run, plan, flat_painters());
  EXPECT_EQ(names_in(folder.path()),
            (std::vector<std::string>{"body.csv", "captions.vtt", "contact_sheet.png", "energies.png", "forces.csv",
                                      "forces.png", "frames", "poster.png", "surfaces", "take.h5", "video.mp4"}));
  EXPECT_EQ(report.failure, "");
  EXPECT_EQ(report.steps, 41U);
  EXPECT_DOUBLE_EQ(report.simulated, 0.2);
  EXPECT_EQ(report.driver, "flat painter 1.0");
  EXPECT_TRUE(report.encoder.starts_with("ffmpeg version ")) << report.encoder;
  EXPECT_EQ(report.warnings, run.warnings());
  EXPECT_EQ(report.frame_hashes.size(), 7U);
  const VideoProbe video = probe_video(folder / "video.mp4");
  EXPECT_EQ(video.frames, 7);
  EXPECT_EQ(names_in(folder / "frames").size(), 7U);
  EXPECT_EQ(names_in(folder / "surfaces").size(), 8U);
  EXPECT_TRUE(TakeReader(folder / "take.h5").ending().complete);
}

TEST(RecorderTest, AFrameIsWhatTheComposerGivesAtItsTime) {
  const TemporaryFolder folder;
  SyntheticRun run;
  const RecordingReport report = record(run, plan_for(folder.path()), flat_painters());
  EXPECT_EQ(report.encoder, "");
  FrameComposer composer("A sheet", {});
  for (std::size_t step = 0; !composer.reaches(5 / 30.0); ++step) composer.add(run.moment(step));
  const Frame frame = composer.compose(5 / 30.0);
  FlatPainter painter(kSize);
  EXPECT_EQ(report.frame_hashes.at(5), image_hash(finished_picture(frame, painter)));
}

TEST(RecorderTest, FramesFromTheTakeAreThoseOfTheRun) {
  const TemporaryFolder folder;
  SyntheticRun run;
  const RecordingReport live = record(run, plan_for(folder / "run"), flat_painters());
  const TakeReader take(folder / "run" / "take.h5");
  TakeSource source(take);
  RecordingPlan plan = plan_for(folder / "again");
  plan.records = false;
  const RecordingReport again = record(source, plan, flat_painters());
  EXPECT_EQ(again.frame_hashes, live.frame_hashes);
  EXPECT_FALSE(std::filesystem::exists(folder / "again" / "take.h5"));
}

TEST(RecorderTest, AFreezeHoldsThePictureAndCardsComeBeforeAndAfter) {
  const TemporaryFolder folder;
  SyntheticRun plain, taught;
  const RecordingReport as_it_is = record(plain, plan_for(folder / "plain"), flat_painters());
  RecordingPlan plan = plan_for(folder / "taught");
  plan.teaching.freezes = {{.at = 0.1, .duration = 0.5}};
  plan.teaching.title_card = CardScenario{.title = "Begin", .text = "", .duration = 1};
  plan.teaching.end_card = CardScenario{.title = "End", .text = "", .duration = 1};
  const RecordingReport report = record(taught, plan, flat_painters());
  // 30 frames of the title, 7 of the run with 15 more while it stands still; the last of the run begins the second of
  // the end card.
  ASSERT_EQ(report.frame_hashes.size(), 30U + 7U + 15U + 29U);
  EXPECT_NE(report.frame_hashes[0], as_it_is.frame_hashes[0]) << "the title card";
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(report.frame_hashes[30 + i], as_it_is.frame_hashes[i]);
  for (std::size_t i = 34; i < 48; ++i) EXPECT_EQ(report.frame_hashes[i], report.frame_hashes[33]) << i;
  for (std::size_t i = 4; i < 7; ++i) EXPECT_EQ(report.frame_hashes[45 + i], as_it_is.frame_hashes[i]);
  EXPECT_NE(report.frame_hashes.back(), as_it_is.frame_hashes.back()) << "the end card";
}

TEST(RecorderTest, ALongTitleLeavesTheBadgeRoomBeforeItIsThere) {
  const TemporaryFolder folder;
  SyntheticRun plain, taught;
  RecordingPlan plan = plan_for(folder / "plain");
  plan.size = {640, 360};
  plan.description.title =
      "A title that reaches to the time of the frame where nothing else has to stand between the two of them";
  const RecordingReport as_it_is = record(plain, plan, flat_painters());
  plan.folder = folder / "taught";
  plan.teaching.freezes = {{.at = 0.1, .duration = 0.5}};
  const RecordingReport report = record(taught, plan, flat_painters());
  EXPECT_NE(report.frame_hashes[0], as_it_is.frame_hashes[0]);
}

TEST(RecorderTest, TheSameRunGivesTheSameFiles) {
  const TemporaryFolder folder;
  for (const char* name : {"one", "two"}) {
    SyntheticRun run;
    RecordingPlan plan = plan_for(folder / name);
    plan.video = true;
    record(run, plan, flat_painters());
  }
  for (const char* file : {"take.h5", "forces.csv", "body.csv", "poster.png", "captions.vtt", "video.mp4"}) {
    EXPECT_TRUE(file_bytes(folder / "one" / file) == file_bytes(folder / "two" / file)) << file;
    EXPECT_FALSE(file_bytes(folder / "one" / file).empty()) << file;
  }
}

TEST(RecorderTest, ThePosterIsTheFrameWithTheLargestForce) {
  const TemporaryFolder folder;
  SyntheticRun run;
  const RecordingReport report = record(run, plan_for(folder.path()), flat_painters());
  EXPECT_DOUBLE_EQ(report.poster_time, 0.1);
  EXPECT_EQ(image_hash(read_png(folder / "poster.png")), report.frame_hashes.at(3));
}

TEST(RecorderTest, CsvHasARowPerStepAndTool) {
  const TemporaryFolder folder;
  SyntheticRun run;
  RecordingPlan plan = plan_for(folder.path());
  plan.pictures = false;
  record(run, plan, flat_painters());
  std::string expected = forces_csv_header() + '\n';
  for (std::size_t step = 0; step < 41; ++step) expected += forces_csv_rows(run.moment(step).record);
  EXPECT_EQ(file_bytes(folder / "forces.csv"), expected);
}

TEST(RecorderTest, WithoutPicturesNothingIsPainted) {
  const TemporaryFolder folder;
  SyntheticRun run;
  RecordingPlan plan = plan_for(folder.path());
  plan.pictures = false;
  plan.surfaces = true;
  const RecordingReport report =
      record(run, plan, [](ImageSize) -> std::unique_ptr<Painter> { throw std::logic_error("a painter was made"); });
  EXPECT_EQ(report.driver, "");
  EXPECT_EQ(names_in(folder.path()), (std::vector<std::string>{"body.csv", "captions.vtt", "energies.png", "forces.csv",
                                                               "forces.png", "surfaces", "take.h5"}));
}

TEST(RecorderTest, AFailedSimulationLeavesWhatItReachedWhole) {
  const TemporaryFolder folder;
  SyntheticRun run({.fail_at = 25});
  RecordingPlan plan = plan_for(folder.path());
  plan.video = true;
  const RecordingReport report = record(run, plan, flat_painters());
  EXPECT_EQ(report.failure, "step 25 cannot be saved");
  EXPECT_EQ(report.steps, 25U);
  const TakeReader take(folder / "take.h5");
  EXPECT_FALSE(take.ending().complete);
  EXPECT_EQ(take.times().size(), 25U);
  EXPECT_EQ(probe_video(folder / "video.mp4").frames, 4);
}

TEST(RecorderTest, AMissingDeviceStopsAllAndLeavesNothingThatLooksWhole) {
  const TemporaryFolder folder;
  SyntheticRun run({.steps = 100'000});
  const auto no_device = [](ImageSize) -> std::unique_ptr<Painter> { throw PictureFailure("no device"); };
  EXPECT_THROW(record(run, plan_for(folder.path()), no_device), PictureFailure);
  EXPECT_FALSE(any_looks_finished(folder.path()));
}

TEST(RecorderTest, AMissingDeviceLeavesTheEarlierRecording) {
  const TemporaryFolder folder;
  write_bytes(folder / "take.h5", "of an earlier run");
  SyntheticRun run({.steps = 100'000});
  const auto no_device = [](ImageSize) -> std::unique_ptr<Painter> {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    throw PictureFailure("no device");
  };
  try {
    record(run, plan_for(folder.path()), no_device);
    FAIL() << "went on";
  } catch (const PictureFailure& failure) {
    EXPECT_STREQ(failure.what(), "no device");
  }
  EXPECT_EQ(file_bytes(folder / "take.h5"), "of an earlier run");
}

class FailingPainter final : public Painter {
 public:
  Image paint(const Snapshot& snapshot, const Shot& shot) override {
    if (snapshot.time > 0.1) throw PictureFailure("the driver is gone");
    return flat_.paint(snapshot, shot);
  }
  std::string driver() const override { return "failing"; }

 private:
  FlatPainter flat_{kSize};
};

TEST(RecorderTest, APainterThatFailsMidwayStopsAll) {
  const TemporaryFolder folder;
  SyntheticRun run({.steps = 100'000});
  RecordingPlan plan = plan_for(folder.path());
  plan.video = true;
  plan.frames = true;
  try {
    record(run, plan, [](ImageSize) { return std::make_unique<FailingPainter>(); });
    FAIL() << "went on";
  } catch (const PictureFailure& failure) {
    EXPECT_STREQ(failure.what(), "the driver is gone");
  }
  EXPECT_FALSE(any_looks_finished(folder.path()));
}

TEST(RecorderTest, AnEarlierRecordingDoesNotMixWithTheNext) {
  const TemporaryFolder folder;
  RecordingPlan plan = plan_for(folder.path());
  plan.frames = true;
  SyntheticRun first;
  record(first, plan, flat_painters());
  write_bytes(folder / "notes.txt", "mine");
  plan.pictures = false;
  SyntheticRun second;
  record(second, plan, flat_painters());
  EXPECT_EQ(names_in(folder.path()), (std::vector<std::string>{"body.csv", "captions.vtt", "energies.png", "forces.csv",
                                                               "forces.png", "notes.txt", "take.h5"}));
}

class WrongScenario final : public MomentSource {
 public:
  std::optional<Moment> next() override { throw std::invalid_argument("the line misses the body"); }
  std::vector<std::string> warnings() const override { return {}; }
  std::string state_digest() const override { return ""; }
};

TEST(RecorderTest, WhatAKilledRecordingLeftOfItsVideoGoesWithTheNextOne) {
  const TemporaryFolder folder;
  for (const char* name :
       {"video.unfinished.recording.mp4", "video.unfinished.captions.vtt", "video.unfinished.chapters.txt"}) {
    write_bytes(folder / name, "what it had");
  }
  SyntheticRun run;
  record(run, plan_for(folder.path()), flat_painters());  // without a video
  for (const std::string& name : names_in(folder.path())) {
    EXPECT_EQ(name.find(".unfinished"), std::string::npos) << name;
  }
}

TEST(RecorderTest, AScenarioThatTurnsOutWrongLeavesTheEarlierRecording) {
  const TemporaryFolder folder;
  RecordingPlan plan = plan_for(folder.path());
  plan.video = true;
  plan.frames = true;
  SyntheticRun run;
  record(run, plan, flat_painters());
  const std::vector<std::string> before = names_in(folder.path());
  WrongScenario wrong;
  EXPECT_THROW(record(wrong, plan, flat_painters()), std::invalid_argument);
  EXPECT_EQ(names_in(folder.path()), before);
}

TEST(RecorderTest, ASimulationThatFailsAtOnceIsRecordedAsSuch) {
  const TemporaryFolder folder;
  SyntheticRun run({.fail_at = 1});
  static_cast<void>(run.next());
  RecordingPlan plan = plan_for(folder.path());
  plan.video = true;
  const RecordingReport report = record(run, plan, flat_painters());
  EXPECT_EQ(report.failure, "step 1 cannot be saved");
  EXPECT_EQ(report.steps, 0U);
  EXPECT_TRUE(TakeReader(folder / "take.h5").times().empty());
  EXPECT_FALSE(std::filesystem::exists(folder / "video.mp4"));
}

TEST(RecorderTest, AFolderOfFramesWithOtherFilesIsNotTouched) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "frames");
  write_bytes(folder / "frames" / "holiday.png", "mine");
  SyntheticRun run;
  EXPECT_THROW(record(run, plan_for(folder.path()), flat_painters()), PictureFailure);
  EXPECT_EQ(file_bytes(folder / "frames" / "holiday.png"), "mine");
}

TEST(RecorderTest, AFolderThatCannotBeMadeIsReported) {
  const TemporaryFolder folder;
  write_bytes(folder / "file", "");
  SyntheticRun run;
  EXPECT_THROW(record(run, plan_for(folder / "file" / "out"), flat_painters()), PictureFailure);
}

/// Raises a signal at a step, as a user would.
class SignalledRun final : public MomentSource {
 public:
  explicit SignalledRun(int signal) : run_({.steps = 100'000}), signal_(signal) {}
  std::optional<Moment> next() override {
    if (++steps_ == 30) kill(getpid(), signal_);
    return run_.next();
  }
  std::vector<std::string> warnings() const override { return {}; }
  std::string state_digest() const override { return ""; }

 private:
  SyntheticRun run_;
  int signal_;
  int steps_ = 0;
};

void run_and_exit_as_interrupted(const std::filesystem::path& folder, int signal) {
  note_interruptions();
  SignalledRun run(signal);
  RecordingPlan plan = plan_for(folder);
  plan.video = true;
  try {
    record(run, plan, flat_painters());
  } catch (const Interrupted& interrupted) {
    std::exit(any_looks_finished(folder) ? 1 : interrupted.exit_code());
  }
  std::exit(2);
}

TEST(RecorderDeathTest, AnInterruptEndsWith130AndATerminateSignalWith143) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const TemporaryFolder folder;
  EXPECT_EXIT(run_and_exit_as_interrupted(folder / "a", SIGINT), ::testing::ExitedWithCode(130), "");
  EXPECT_EXIT(run_and_exit_as_interrupted(folder / "b", SIGTERM), ::testing::ExitedWithCode(143), "");
}

}  // namespace
}  // namespace thinwall
