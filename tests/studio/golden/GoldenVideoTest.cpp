#include <gtest/gtest.h>

#include <utility>

#include "renderer/image/PictureFailure.hpp"
#include "renderer/image/PngFile.hpp"
#include "renderer/video/Program.hpp"
#include "studio/golden/GoldenVideoComparison.hpp"
#include "tests/studio/golden/GoldenScene.hpp"

namespace thinwall {
namespace {

/// A scenario of 0.2 s with a golden of its video.
Scenario video_scene(Scenario scenario = golden_scene()) {
  scenario.record.frames_per_second = 50;
  scenario.goldens = {{.video = 3, .max = 8, .mean = 0.2, .drift = 0.001, .why = "rounding"}};
  return scenario;
}

class GoldenVideoTest : public ::testing::Test {
 protected:
  RecordedVideo recorded(const SourceFactory& sources = synthetic_source(), double gain = 1,
                         const Scenario& scenario = video_scene()) {
    return record_golden_video(scenario, 3, sources, flat_painters(gain), folder_ / "video");
  }
  void approve() { renew_golden_video(recorded(), goldens(), "someone", "it is right"); }
  VideoJudgement judge(const RecordedVideo& video) {
    return compare_with_golden_video("sheet", video_scene().goldens[0], video, goldens());
  }
  /// Replaces today's file by one that ffmpeg makes of it, and reads it as if the encoder had written it.
  RecordedVideo encoded_anew(const std::vector<std::string>& options) {
    const std::filesystem::path file = recorded().file;
    const std::filesystem::path changed = folder_ / "changed.mp4";
    std::vector<std::string> arguments = {"ffmpeg", "-v", "error", "-y", "-i", file};
    arguments.insert(arguments.end(), options.begin(), options.end());
    arguments.push_back(changed);
    const ProgramResult result = run_program(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    RecordedVideo video = recorded();
    std::filesystem::rename(changed, file);
    video.video.encoded = read_encoded_video(folder_ / "video", video.video);
    return video;
  }
  void expect_encoder(const RecordedVideo& video, const std::string& words) {
    const VideoJudgement judgement = judge(video);
    EXPECT_EQ(judgement.result.outcome, GoldenOutcome::kFailed) << words;
    ASSERT_TRUE(judgement.attribution);
    EXPECT_EQ(judgement.attribution->stage, ChangedStage::kEncoder);
    EXPECT_NE(judgement.attribution->sentence.find(words), std::string::npos) << judgement.attribution->sentence;
  }
  std::filesystem::path goldens() const { return folder_ / "goldens"; }

  TemporaryFolder folder_;
};

TEST_F(GoldenVideoTest, TheSameVideoIsOkFrameByFrame) {
  approve();
  const VideoJudgement judgement = judge(recorded());
  EXPECT_EQ(judgement.result.outcome, GoldenOutcome::kOk) << judgement.result.message;
  EXPECT_EQ(judgement.result.message, "11 frames are equal");
  EXPECT_FALSE(judgement.attribution);
}

TEST_F(GoldenVideoTest, KeepsPicturesFromTheFirstToTheLast) {
  approve();
  const std::optional<GoldenVideoApproval> approval = find_video_approval(goldens(), "flat painter 1.0");
  ASSERT_TRUE(approval);
  EXPECT_EQ(approval->video.kept, (std::vector<std::size_t>{0, 5, 10}));
  EXPECT_EQ(approval->pictures.size(), 3U);
  EXPECT_EQ(kept_frames(10, 1), (std::vector<std::size_t>{5}));
  EXPECT_EQ(kept_frames(2, 5), (std::vector<std::size_t>{0, 1}));
  EXPECT_TRUE(kept_frames(0, 5).empty());
}

TEST_F(GoldenVideoTest, ApprovingAgainLeavesNoPictureBehind) {
  approve();
  RecordedVideo other = recorded();
  other.video.kept = {4};
  other.pictures.resize(1);
  renew_golden_video(other, goldens(), "someone", "fewer");
  std::size_t pictures = 0;
  for (const auto& entry : std::filesystem::directory_iterator(goldens())) {
    pictures += entry.path().extension() == ".png" ? 1 : 0;
  }
  EXPECT_EQ(pictures, 1U);
}

TEST_F(GoldenVideoTest, AVideoThatHasLostOneOfItsFilesIsMissing) {
  for (const std::size_t file : {0U, 3U}) {
    approve();
    const std::string name = find_video_approval(goldens(), "flat painter 1.0")->files[file];
    std::filesystem::remove(goldens() / name);
    const GoldenResult result = judge(recorded()).result;
    EXPECT_EQ(result.outcome, GoldenOutcome::kGoldenMissing) << name;
    EXPECT_NE(result.message.find(name + " is missing; restore it from version control"), std::string::npos)
        << result.message;
  }
}

TEST_F(GoldenVideoTest, AVideoWhoseHistoryIsDamagedIsMissing) {
  for (const std::uintmax_t part : {0U, 2U, 3U}) {
    approve();
    const std::filesystem::path file = goldens() / find_video_approval(goldens(), "flat painter 1.0")->history;
    std::filesystem::resize_file(file, std::filesystem::file_size(file) * part / 4);
    const GoldenResult result = judge(recorded()).result;
    EXPECT_EQ(result.outcome, GoldenOutcome::kGoldenMissing) << part;
    EXPECT_EQ(result.message.find(file.string()), 0U) << result.message;
    EXPECT_NE(result.message.find("; restore it from version control, or approve anew"), std::string::npos);
  }
}

TEST_F(GoldenVideoTest, AKeptPictureThatIsNotThatOfItsFrameIsAnError) {
  approve();
  const std::string picture = find_video_approval(goldens(), "flat painter 1.0")->pictures[1];
  write_png(goldens() / picture, recorded(synthetic_source(), 1.2).pictures[1]);
  EXPECT_THROW(judge(recorded()), GoldenError);
}

TEST_F(GoldenVideoTest, WithoutAnApprovalTheGoldenIsMissing) {
  EXPECT_EQ(judge(recorded()).result.outcome, GoldenOutcome::kGoldenMissing);
}

TEST_F(GoldenVideoTest, ASimulationThatFailsHasNoResult) {
  approve();
  const GoldenResult result = judge(recorded(synthetic_source({.fail_at = 5}))).result;
  EXPECT_EQ(result.outcome, GoldenOutcome::kResultMissing);
  EXPECT_FALSE(result.cannot_be_made) << "the simulation has regressed";
}

TEST_F(GoldenVideoTest, AMissingDeviceIsASkip) {
  const RecordedVideo video = record_golden_video(
      video_scene(), 3, synthetic_source(),
      [](ImageSize) -> std::unique_ptr<Painter> { throw PictureFailure("no GPU here"); }, folder_ / "video");
  EXPECT_EQ(judge(video).result.outcome, GoldenOutcome::kSkipped);
}

TEST_F(GoldenVideoTest, ADiskThatHasNoRoomForTheVideoAloneIsNotTheEncoders) {
  approve();
  bool is_full = true;
  const RecordedVideo video = record_golden_video(
      video_scene(), 3, synthetic_source(),
      [&](ImageSize size) {
        if (size.width > 16 && std::exchange(is_full, false)) throw FileUnwritable("no space");
        return flat_painters(1)(size);
      },
      folder_ / "video");
  const GoldenResult result = judge(video).result;
  EXPECT_EQ(result.outcome, GoldenOutcome::kResultMissing) << result.message;
  EXPECT_TRUE(result.cannot_be_made);
  EXPECT_EQ(result.message, "no space");
}

TEST_F(GoldenVideoTest, AChangedSimulationIsTold) {
  approve();
  const VideoJudgement judgement = judge(recorded(synthetic_source({.depth = 0.005})));
  EXPECT_EQ(judgement.result.outcome, GoldenOutcome::kFailed);
  ASSERT_TRUE(judgement.attribution);
  EXPECT_EQ(judgement.attribution->stage, ChangedStage::kPhysics) << judgement.attribution->sentence;
}

TEST_F(GoldenVideoTest, AChangedSimulationIsToldAlsoWhereItEndsInTheSameState) {
  approve();
  RecordedVideo video = recorded(synthetic_source({.depth = 0.005}));
  video.video.state_digest = recorded().video.state_digest;
  const VideoJudgement judgement = judge(video);
  ASSERT_TRUE(judgement.attribution);
  EXPECT_EQ(judgement.attribution->stage, ChangedStage::kPhysics) << judgement.attribution->sentence;
}

TEST_F(GoldenVideoTest, AFileThatTheScenarioNamesIsBlamedBeforeTheEngine) {
  Scenario scenario = video_scene();
  scenario.resolved.insert(1, R"("surface": {"mesh": "organ.obj"}, )");
  scenario.file = folder_ / "scene.yaml";
  write_bytes(folder_ / "organ.obj", "v 0 0 0");
  renew_golden_video(recorded(synthetic_source(), 1, scenario), goldens(), "someone", "it is right");
  write_bytes(folder_ / "organ.obj", "v 0 0 1");
  const VideoJudgement judgement = judge(recorded(synthetic_source({.depth = 0.005}), 1, scenario));
  ASSERT_TRUE(judgement.attribution);
  const std::string& sentence = judgement.attribution->sentence;
  EXPECT_NE(sentence.find("organ.obj, which the scenario names, has changed"), std::string::npos) << sentence;
  EXPECT_EQ(sentence.find("so the engine has changed"), std::string::npos) << sentence;
}

TEST_F(GoldenVideoTest, ASecondTakeThatHasChangedAloneIsPhysicsToo) {
  const Scenario scene = video_scene(compared_scene());
  renew_golden_video(recorded(synthetic_pair({}, {.depth = 0.003}), 1, scene), goldens(), "someone", "it is right");
  const VideoJudgement judgement = judge(recorded(synthetic_pair({}, {.depth = 0.0036}), 1, scene));
  ASSERT_TRUE(judgement.attribution);
  EXPECT_EQ(judgement.attribution->stage, ChangedStage::kPhysics) << judgement.attribution->sentence;
  EXPECT_NE(judgement.result.state.verdict, StateVerdict::kEqual);
  EXPECT_NE(judgement.attribution->sentence.find("in the second take"), std::string::npos)
      << judgement.attribution->sentence;
}

TEST_F(GoldenVideoTest, TheCauseNamesTheFirstFrameAndTheMessageAllThatAreKept) {
  approve();
  const VideoJudgement judgement = judge(recorded(synthetic_source(), 1.2));
  ASSERT_TRUE(judgement.attribution);
  EXPECT_TRUE(judgement.attribution->sentence.ends_with("; and 3 more")) << judgement.attribution->sentence;
  EXPECT_NE(judgement.result.message.find("frame 10 at"), std::string::npos) << judgement.result.message;
}

TEST_F(GoldenVideoTest, AChangedRendererIsTold) {
  approve();
  const VideoJudgement judgement = judge(recorded(synthetic_source(), 1.2));
  ASSERT_TRUE(judgement.attribution);
  EXPECT_EQ(judgement.attribution->stage, ChangedStage::kRenderer) << judgement.attribution->sentence;
  EXPECT_EQ(judgement.result.different_frames.size(), 11U);
}

TEST_F(GoldenVideoTest, AFrameBetweenTheKeptOnesIsJudgedByItsParts) {
  approve();
  RecordedVideo video = recorded();
  video.video.frames[3].hash = "another";
  EXPECT_EQ(judge(video).result.outcome, GoldenOutcome::kOk) << "the same means: nobody sees it";
  video.video.frames[3].squares.replace(0, 2, "ff");
  const VideoJudgement judgement = judge(video);
  EXPECT_EQ(judgement.result.outcome, GoldenOutcome::kFailed);
  EXPECT_NE(judgement.result.message.find("frame 3 at 0.060 s: a twelfth of it differs"), std::string::npos)
      << judgement.result.message;
}

TEST_F(GoldenVideoTest, AFrameThatIsMissingBeforeTheEncoderIsNamed) {
  approve();
  RecordedVideo video = recorded();
  video.video.frames.erase(video.video.frames.begin() + 4);
  const VideoJudgement judgement = judge(video);
  EXPECT_EQ(judgement.result.outcome, GoldenOutcome::kFailed);
  EXPECT_NE(judgement.result.message.find("10 frames instead of 11: frame 4 is missing"), std::string::npos)
      << judgement.result.message;
}

/// Today's video, whose scenario has one more value.
class ChangedScenarioVideoTest : public GoldenVideoTest {
 protected:
  void SetUp() override { approve(); }
  Attribution attribution_with(const std::string& member, RecordedVideo video) {
    video.video.resolved.insert(1, member + ", ");
    return judge(video).attribution.value_or(Attribution{});
  }
  /// With frames more at the end than the golden has.
  RecordedVideo longer() {
    RecordedVideo video = recorded();
    video.video.frames.insert(video.video.frames.end(), 5, video.video.frames.back());
    video.video.scene_hash = "of all these frames";
    return video;
  }
};

TEST_F(ChangedScenarioVideoTest, FreezesSlowMotionAndCardsAreOfItsTiming) {
  for (const std::string part : {R"("freezes": [{"at": 0.2, "for": 0.1}])", R"("slow_motion": [{"speed": 0.5}])",
                                 R"("title_card": {"title": "a"})", R"("end_card": {"title": "a"})"}) {
    const Attribution attribution = attribution_with(R"("teaching": {)" + part + "}", longer());
    EXPECT_EQ(attribution.stage, ChangedStage::kTiming) << part;
    const std::string key = part.substr(1, part.find(':') - 2);
    EXPECT_EQ(attribution.sentence.rfind("timing of the video changed, states identical: teaching." + key, 0), 0U)
        << attribution.sentence;
    EXPECT_NE(attribution.sentence.find("16 frames instead of 11: frames 11 to 15 at the end are new"),
              std::string::npos)
        << attribution.sentence;
  }
}

TEST_F(ChangedScenarioVideoTest, AScenarioThatLastsLongerIsOfItsTimingWhateverStateItEndsIn) {
  RecordedVideo video = longer();
  video.video.state_digest = "another";
  const Attribution attribution = attribution_with(R"("timeline": [{"wait": {"for": 0.1}}])", video);
  EXPECT_EQ(attribution.stage, ChangedStage::kTiming);
  EXPECT_EQ(attribution.sentence.rfind("timing of the video changed, states identical: timeline[1] {wait: {for: 0.1 s}}"
                                       ", which was not there; 16 frames instead of 11",
                                       0),
            0U)
      << attribution.sentence;
}

TEST_F(ChangedScenarioVideoTest, MarksOnWallsAreOfTheLook) {
  const Attribution attribution =
      attribution_with(R"("teaching": {"highlights": [{"radius": 0.005}]})", recorded(synthetic_source(), 1.2));
  EXPECT_EQ(attribution.stage, ChangedStage::kLook);
  EXPECT_EQ(attribution.sentence.rfind("look changed, states identical: teaching.highlights[1] {", 0), 0U)
      << attribution.sentence;
}

TEST_F(ChangedScenarioVideoTest, ASecondTakeThatHasComeIsOfTheLook) {
  RecordedVideo video = recorded(synthetic_pair({}, {.depth = 0.003}), 1.2, video_scene(compared_scene()));
  const Attribution attribution = attribution_with(R"("title": "A")", video);
  EXPECT_EQ(attribution.stage, ChangedStage::kLook);
  EXPECT_EQ(attribution.sentence.rfind("look changed, states identical: comparison {captions: ", 0), 0U)
      << attribution.sentence;
}

TEST_F(ChangedScenarioVideoTest, AToolThatIsDrawnOtherwiseIsNotTheRenderers) {
  const Attribution attribution =
      attribution_with(R"("tools": {"probe": {"kind": "sphere", "radius": 0.005}})", recorded(synthetic_source(), 1.2));
  EXPECT_EQ(attribution.sentence.rfind("pictures changed, states identical; the scenario has changed: tools.probe", 0),
            0U)
      << attribution.sentence;
}

TEST_F(ChangedScenarioVideoTest, ACurveOfMorePointsIsToldByTheTimeStep) {
  RecordedVideo video = recorded();
  video.video.state_digest = "another";  // as it counts the steps
  video.video.frames[3] = {.hash = "another", .squares = std::string(72, 'f')};
  const Attribution attribution = attribution_with(R"("simulation": {"time_step": 0.01})", video);
  EXPECT_EQ(attribution.stage, ChangedStage::kOverlay);
  EXPECT_EQ(attribution.sentence.rfind("overlay changed, the pictures below are identical; the scenario has changed: "
                                       "simulation.time_step 10 ms",
                                       0),
            0U)
      << attribution.sentence;
}

TEST_F(GoldenVideoTest, ACaptionThatHasChangedIsTheOverlays) {
  approve();
  RecordedVideo video = recorded();
  video.video.captions.replace(video.video.captions.find("Pressing"), 8, "Presing");
  const VideoJudgement judgement = judge(video);
  ASSERT_TRUE(judgement.attribution);
  EXPECT_EQ(judgement.attribution->stage, ChangedStage::kOverlay);
  EXPECT_NE(judgement.attribution->sentence.find("\"Presing\" instead of \"Pressing\""), std::string::npos)
      << judgement.attribution->sentence;
}

TEST_F(GoldenVideoTest, ChaptersThatTheScenarioNamesOtherwiseAreNotTheEncoders) {
  approve();
  RecordedVideo video = recorded();
  video.video.encoded.chapters = "0.000000,0.200000,Anatomie";
  expect_encoder(video, "chapters: \"0.000000,0.200000,Anatomie\"");
  video.video.resolved.insert(1, R"("title": "Anatomie", )");
  const VideoJudgement judgement = judge(video);
  ASSERT_TRUE(judgement.attribution);
  EXPECT_EQ(judgement.attribution->stage, ChangedStage::kOverlay);
  EXPECT_NE(judgement.attribution->sentence.find("overlay changed: title \"Anatomie\", which was not there; chapters:"),
            std::string::npos)
      << judgement.attribution->sentence;
}

TEST_F(GoldenVideoTest, AFrameThatTheEncoderDroppedIsTheEncoders) {
  approve();
  expect_encoder(encoded_anew({"-vf", "select=not(eq(n\\,4)),setpts=N/50/TB", "-c:v", "libx264", "-c:s", "copy"}),
                 "the file holds 10 frames of 11");
}

TEST_F(GoldenVideoTest, AWrongColorRangeIsTheEncoders) {
  approve();
  expect_encoder(encoded_anew({"-map", "0", "-c", "copy", "-bsf:v", "h264_metadata=video_full_range_flag=1"}),
                 "the file is tagged \"h264 yuvj420p pc");
}

TEST_F(GoldenVideoTest, ColorsThatAreConvertedByAnotherRuleButTaggedAlikeAreTheEncoders) {
  approve();
  expect_encoder(encoded_anew({"-map",
                               "0:v",
                               "-map",
                               "0:s?",
                               "-map_chapters",
                               "0",
                               "-vf",
                               "scale=in_color_matrix=bt709:out_color_matrix=smpte170m,setparams=colorspace=bt709",
                               "-c:v",
                               "libx264",
                               "-crf",
                               "12",
                               "-colorspace",
                               "bt709",
                               "-color_primaries",
                               "bt709",
                               "-color_trc",
                               "bt709",
                               "-color_range",
                               "tv",
                               "-c:s",
                               "copy"}),
                 "the decoded pixels differ");
}

TEST_F(GoldenVideoTest, AnEncoderThatFailsIsTold) {
  approve();
  RecordedVideo video = recorded();
  video.encoder_failure = "ffmpeg ended with 1";
  expect_encoder(video, "there is no video: ffmpeg ended with 1");
}

TEST_F(GoldenVideoTest, AnotherVersionOfTheEncoderIsJudgedByWhatItLoses) {
  approve();
  RecordedVideo video = recorded();
  video.video.encoded.program = "another";
  video.video.encoded.decoded = "another";
  EXPECT_EQ(judge(video).result.outcome, GoldenOutcome::kOk);
  video.video.encoded.loss += 3;
  expect_encoder(video, "the encoder loses");
}

TEST_F(GoldenVideoTest, ABrokenApprovalIsAnError) {
  approve();
  for (const auto& entry : std::filesystem::directory_iterator(goldens())) {
    if (entry.path().extension() == ".json") write_bytes(entry.path(), "{\"driver\": [");
  }
  EXPECT_THROW(judge(recorded()), GoldenError);
}

TEST_F(GoldenVideoTest, AnApprovalThatKeepsAFrameThatIsNotThereIsAnError) {
  approve();
  const std::filesystem::path file = goldens() / find_video_approval(goldens(), "flat painter 1.0")->files.back();
  const std::string whole = file_bytes(file);
  for (const std::string frame : {"11", "-1", "1e300"}) {
    const std::string kept = "\"frame\": 10,";
    write_bytes(file, std::string(whole).replace(whole.find(kept), kept.size(), "\"frame\": " + frame + ","));
    EXPECT_THROW(judge(recorded()), GoldenError) << frame;
  }
}

TEST_F(GoldenVideoTest, AFolderInThePlaceOfAnApprovalIsAnError) {
  approve();
  const std::filesystem::path file = goldens() / find_video_approval(goldens(), "flat painter 1.0")->files.back();
  std::filesystem::remove(file);
  std::filesystem::create_directory(file);
  EXPECT_THROW(judge(recorded()), GoldenError);
}

TEST_F(GoldenVideoTest, AScenarioIsJudgedByItsVideoAlone) {
  GoldenScene scene;
  GoldenRunOptions options = scene.options(synthetic_source(), view_painters());
  options.videos = folder_ / "videos";
  const auto judged = judge_scenarios({video_scene()}, options, [](const JudgedScenario&) {});
  ASSERT_EQ(judged.front().results.size(), 1U);
  EXPECT_EQ(judged.front().results[0].outcome, GoldenOutcome::kGoldenMissing);
  EXPECT_EQ(moment_name(judged.front().results[0]), "the video");
  ASSERT_TRUE(judged.front().video);
  EXPECT_EQ(judged.front().video->video.frames.size(), 11U);
}

TEST_F(GoldenVideoTest, TheFramesOfAVideoStayToBeLookedAtUnlessItIsGood) {
  const GoldenScene scene;
  GoldenRunOptions options = scene.options(synthetic_source(), view_painters());
  options.videos = folder_ / "videos";
  const auto judged = [&] { return judge_scenarios({video_scene()}, options, [](const JudgedScenario&) {}).front(); };
  const JudgedScenario missing = judged();
  ASSERT_EQ(missing.results[0].outcome, GoldenOutcome::kGoldenMissing);
  EXPECT_TRUE(std::filesystem::exists(missing.video->file));
  renew_golden_video(*missing.video, scene.folder(), "someone", "it is right");
  options.cache = folder_ / "unchanged.json";
  for (const bool is_known : {false, true}) {
    std::filesystem::create_directories(options.videos / "sheet/frames");
    const JudgedScenario good = judged();
    ASSERT_EQ(good.results[0].outcome, GoldenOutcome::kOk);
    EXPECT_EQ(good.from_cache, is_known);
    EXPECT_FALSE(std::filesystem::exists(options.videos)) << is_known;
  }
}

}  // namespace
}  // namespace thinwall
