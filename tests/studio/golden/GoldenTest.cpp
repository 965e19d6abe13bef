#include <gtest/gtest.h>

#include "renderer/image/PictureFailure.hpp"
#include "renderer/image/PngFile.hpp"
#include "studio/golden/GoldenComparison.hpp"
#include "studio/golden/GoldenRenewal.hpp"
#include "tests/studio/FlatPainter.hpp"
#include "tests/studio/SyntheticRun.hpp"
#include "tests/studio/TemporaryFolder.hpp"

namespace thinwall {
namespace {

Scenario example() {
  Scenario scenario;
  scenario.name = "sheet";
  scenario.title = "A sheet";
  scenario.resolved = "{}";
  scenario.record.size = {.width = 96, .height = 64};
  scenario.goldens = {{.at = 0.1, .max = 8, .mean = 0.2, .why = "rounding"}};
  return scenario;
}

SourceFactory synthetic(SyntheticRunOptions options = {}) {
  return [options](const Scenario&) { return std::make_unique<SyntheticRun>(options); };
}

GoldenPictures today(const SourceFactory& sources = synthetic(), const PainterFactory& painters = flat_painters()) {
  return golden_pictures(example(), sources, painters);
}

class GoldenTest : public ::testing::Test {
 protected:
  void approve(const std::string& driver = "flat painter 1.0") {
    renew_golden(example(), today().pictures[0], driver, folder_.path(), "someone", "it is right");
  }
  GoldenResult compare(const GoldenPictures& pictures) {
    return compare_with_golden("sheet", example().goldens[0], pictures.pictures[0], pictures.driver, folder_.path());
  }
  /// A file that is damaged is told with what helps.
  void expect_cure() {
    try {
      compare(today());
      FAIL() << "nothing is thrown";
    } catch (const GoldenError& error) {
      EXPECT_NE(std::string(error.what()).find("restore it from version control"), std::string::npos) << error.what();
    }
  }

  TemporaryFolder folder_;
};

TEST_F(GoldenTest, TheSamePictureIsOkByItsBytes) {
  approve();
  const GoldenResult result = compare(today());
  EXPECT_EQ(result.outcome, GoldenOutcome::kOk);
  EXPECT_EQ(result.rung, "bytes");
  EXPECT_EQ(result.state.verdict, StateVerdict::kEqual);
}

TEST_F(GoldenTest, AGoldenThatHasLostWhatTellsLaterWhatHasChangedIsMissing) {
  for (const char* end : {".state.h5", ".history.csv"}) {
    approve();
    const std::filesystem::path lost = folder_.path() / (golden_stem(0.1, "flat painter 1.0") + end);
    std::filesystem::remove(lost);
    const GoldenResult result = compare(today());
    EXPECT_EQ(result.outcome, GoldenOutcome::kGoldenMissing) << end;
    EXPECT_NE(result.message.find("the picture is good, but"), std::string::npos) << result.message;
    EXPECT_NE(result.message.find(lost.string() + " is missing; restore it from version control"), std::string::npos)
        << result.message;
  }
}

TEST_F(GoldenTest, AHistoryThatIsDamagedOrCutShortIsLost) {
  approve();
  const std::filesystem::path file = folder_.path() / read_approvals(folder_.path())[0].history;
  const std::string whole = file_bytes(file);
  const std::string without_its_end = whole.substr(0, whole.rfind('\n', whole.rfind("\n18,")) + 1);
  for (const std::string& left :
       {std::string(), std::string("no history"), whole.substr(0, whole.size() - 30), without_its_end}) {
    write_bytes(file, left);
    const GoldenResult result = compare(today());
    EXPECT_EQ(result.outcome, GoldenOutcome::kGoldenMissing) << left;
    EXPECT_NE(result.message.find(file.string()), std::string::npos) << result.message;
    EXPECT_NE(result.message.find("restore it from version control"), std::string::npos) << result.message;
  }
}

TEST_F(GoldenTest, AStateThatCannotBeReadIsToldThoughThePictureIsGood) {
  approve();
  std::filesystem::resize_file(folder_.path() / read_approvals(folder_.path())[0].state, 3000);
  const GoldenResult result = compare(today());
  EXPECT_EQ(result.outcome, GoldenOutcome::kGoldenMissing);
  EXPECT_NE(result.message.find("restore it from version control"), std::string::npos) << result.message;
}

TEST_F(GoldenTest, AFolderInThePlaceOfAnApprovalIsAnError) {
  std::filesystem::create_directory(folder_.path() / "approval.json");
  expect_cure();
}

TEST_F(GoldenTest, AStateThatCannotBeWrittenLeavesNoPartOfIt) {
  std::filesystem::create_directories(folder_.path() / (golden_stem(0.1, "flat painter 1.0") + ".state.h5"));
  EXPECT_ANY_THROW(approve());
  for (const auto& entry : std::filesystem::directory_iterator(folder_.path())) {
    EXPECT_EQ(entry.path().string().find(".unfinished"), std::string::npos) << entry.path();
  }
}

TEST_F(GoldenTest, APictureThatFailsIsToldWithTheHistoryThatIsLost) {
  approve();
  std::filesystem::remove(folder_.path() / read_approvals(folder_.path())[0].history);
  const GoldenResult result = compare(today(synthetic(), flat_painters(1.2)));
  EXPECT_EQ(result.outcome, GoldenOutcome::kFailed);
  EXPECT_NE(result.message.find(".history.csv is missing"), std::string::npos) << result.message;
}

TEST_F(GoldenTest, APictureThatIsNotTheApprovedOneIsTold) {
  approve();
  const std::filesystem::path file = folder_.path() / read_approvals(folder_.path())[0].image;
  write_png(file, today(synthetic(), flat_painters(1.2)).pictures[0].image);
  try {
    compare(today());
    FAIL() << "nothing is thrown";
  } catch (const GoldenError& error) {
    EXPECT_EQ(std::string(error.what()).rfind(file.string() + ": is not the picture that was approved", 0), 0U)
        << error.what();
  }
}

TEST_F(GoldenTest, AnApprovalOfAnEarlierVersionKeptNoHashOfItsPicture) {
  approve();
  std::vector<GoldenApproval> approvals = read_approvals(folder_.path());
  EXPECT_FALSE(approvals[0].picture_hash.empty());
  approvals[0].picture_hash.clear();
  write_approvals(folder_.path(), approvals);
  EXPECT_EQ(compare(today()).outcome, GoldenOutcome::kOk);
}

TEST_F(GoldenTest, ASmallDifferenceIsOkByTolerance) {
  approve();
  GoldenPictures pictures = today();
  pictures.pictures[0].image.pixels[100] ^= 4;
  const GoldenResult result = compare(pictures);
  EXPECT_EQ(result.outcome, GoldenOutcome::kOk);
  EXPECT_EQ(result.rung, "pixels");
  EXPECT_EQ(result.difference.largest, 4);
}

TEST_F(GoldenTest, OnePixelAboveTheLargestDifferenceFails) {
  approve();
  GoldenPictures pictures = today();
  pictures.pictures[0].image.pixels[100] ^= 16;
  const GoldenResult result = compare(pictures);
  EXPECT_EQ(result.outcome, GoldenOutcome::kFailed);
  EXPECT_EQ(
      result.message,
      "largest difference 16 (allowed 8), mean 0.0008681 (allowed 0.2), drift 3.726e-05 (allowed 1); the state is "
      "the same to the last bit");
  EXPECT_FALSE(result.details.empty());
}

TEST_F(GoldenTest, ADifferenceThatIsSmallEverywhereFailsByItsMean) {
  approve();
  GoldenPictures pictures = today();
  for (std::uint8_t& level : pictures.pictures[0].image.pixels) level ^= 1;
  const GoldenResult result = compare(pictures);
  EXPECT_EQ(result.outcome, GoldenOutcome::kFailed);
  EXPECT_EQ(result.difference.largest, 1);
}

TEST_F(GoldenTest, AGainThatIsBelowTheMeanFailsByItsDrift) {
  approve();
  GoldenDefinition definition = example().goldens[0];
  definition.mean = 5;
  GoldenPictures pictures = today();
  for (std::uint8_t& level : pictures.pictures[0].image.pixels) ++level;
  const auto outcome = [&](double drift) {
    definition.drift = drift;
    return compare_with_golden("sheet", definition, pictures.pictures[0], pictures.driver, folder_.path()).outcome;
  };
  EXPECT_EQ(outcome(0.05), GoldenOutcome::kOk);
  EXPECT_EQ(outcome(0.001), GoldenOutcome::kFailed);
}

TEST_F(GoldenTest, EachLimitOfAScenarioIsHeld) {
  approve();
  GoldenPictures pictures = today();
  Image& image = pictures.pictures[0].image;
  for (std::size_t i = 0; i < 600; ++i) image.pixels[i] ^= 64;
  const auto judged = [&](GoldenDefinition definition) {
    definition.at = 0.1;
    definition.max = 255;
    definition.mean = 255;
    return compare_with_golden("sheet", definition, pictures.pictures[0], pictures.driver, folder_.path());
  };
  EXPECT_EQ(judged({}).outcome, GoldenOutcome::kOk);
  const GoldenResult failing = judged({.failing = 0.01});
  EXPECT_EQ(failing.outcome, GoldenOutcome::kFailed);
  EXPECT_NEAR(*failing.failing, 200.0 / (96 * 64), 1e-9);
  EXPECT_EQ(judged({.failing = 0.04}).outcome, GoldenOutcome::kOk);
  EXPECT_EQ(judged({.failing = 0, .level = 64}).outcome, GoldenOutcome::kOk);
  EXPECT_EQ(judged({.similarity = 0.999}).rung, "structure");
  EXPECT_EQ(judged({.similarity = 0.999}).outcome, GoldenOutcome::kFailed);
  EXPECT_EQ(judged({.flip = 0.001}).rung, "flip");
  EXPECT_EQ(judged({.flip = 0.001}).outcome, GoldenOutcome::kFailed);
  EXPECT_EQ(judged({.flip = 0.5}).outcome, GoldenOutcome::kOk);
}

TEST_F(GoldenTest, AChangedRendererIsTold) {
  approve();
  const GoldenResult result = compare(today(synthetic(), flat_painters(1.2)));
  EXPECT_EQ(result.outcome, GoldenOutcome::kFailed);
  EXPECT_EQ(result.state.verdict, StateVerdict::kEqual);
  EXPECT_TRUE(result.message.ends_with("the state is the same to the last bit")) << result.message;
}

TEST_F(GoldenTest, AChangedSimulationIsTold) {
  approve();
  // Another number of steps up to the same moment has another digest, and the sheet is dented more deeply.
  const GoldenResult result = compare(today(synthetic({.time_step = 0.0025, .steps = 81, .depth = 0.006})));
  EXPECT_EQ(result.outcome, GoldenOutcome::kFailed);
  EXPECT_EQ(result.state.verdict, StateVerdict::kChanged);
  EXPECT_NE(result.message.find("vertex 40 of organ has moved by 2 mm"), std::string::npos) << result.message;
}

TEST_F(GoldenTest, ADriverThatIsNotKnownIsComparedByToleranceAndSaysSo) {
  approve("another painter 0.9");
  const GoldenResult result = compare(today());
  EXPECT_EQ(result.outcome, GoldenOutcome::kOk);
  EXPECT_NE(result.message.find("approved on another driver (another painter 0.9)"), std::string::npos)
      << result.message;
}

TEST_F(GoldenTest, AnotherDriverMayRoundOtherwiseAndDrawSinglePixelsOfEdgesOtherwise) {
  Scenario scenario = example();
  scenario.record.size = {.width = 320, .height = 240};
  scenario.goldens[0].mean = 0.01;
  const GoldenPictures approved = golden_pictures(scenario, synthetic(), flat_painters());
  const auto outcome = [&](const char* driver, std::size_t rounded, std::size_t stray) {
    renew_golden(scenario, approved.pictures[0], driver, folder_ / driver, "someone", "it is right");
    GoldenPicture picture = approved.pictures[0];
    for (std::size_t i = 0; i < rounded; ++i) picture.image.pixels[9 * i] ^= 1;
    for (std::size_t i = 0; i < stray; ++i) picture.image.pixels[30 * i + 1] ^= 64;
    return compare_with_golden("sheet", scenario.goldens[0], picture, approved.driver, folder_ / driver).outcome;
  };
  // Of 76 800 pixels 3 are 4e-5, 4 more than 5e-5; of 230 400 levels 20 000 are 0.087, 24 000 more than 0.1.
  EXPECT_EQ(outcome("another painter 0.9", 20000, 3), GoldenOutcome::kOk);
  EXPECT_EQ(outcome("another painter 0.9", 20000, 4), GoldenOutcome::kFailed);
  EXPECT_EQ(outcome("another painter 0.9", 24000, 0), GoldenOutcome::kFailed);
  scenario.goldens[0].max = 0;
  EXPECT_EQ(outcome("another painter 0.9", 20000, 3), GoldenOutcome::kOk) << "rounding is none of the stray pixels";
  EXPECT_EQ(outcome("flat painter 1.0", 0, 1), GoldenOutcome::kFailed);
  EXPECT_EQ(outcome("flat painter 1.0", 20000, 0), GoldenOutcome::kFailed);
}

TEST_F(GoldenTest, EachDriverHasItsOwnGolden) {
  approve("another painter 0.9");
  approve();
  const std::vector<GoldenApproval> approvals = read_approvals(folder_.path());
  ASSERT_EQ(approvals.size(), 2U);
  EXPECT_NE(approvals[0].image, approvals[1].image);
  EXPECT_EQ(compare(today()).golden_driver, "flat painter 1.0");
}

TEST_F(GoldenTest, ApprovingAgainReplacesTheApproval) {
  approve();
  renew_golden(example(), today(synthetic(), flat_painters(1.2)).pictures[0], "flat painter 1.0", folder_.path(),
               "someone else", "brighter");
  const std::vector<GoldenApproval> approvals = read_approvals(folder_.path());
  ASSERT_EQ(approvals.size(), 1U);
  EXPECT_EQ(approvals[0].who, "someone else");
  EXPECT_EQ(approvals[0].why, "brighter");
  EXPECT_EQ(compare(today(synthetic(), flat_painters(1.2))).outcome, GoldenOutcome::kOk);
}

TEST_F(GoldenTest, MomentsThatAreCloseHaveFilesOfTheirOwn) {
  EXPECT_NE(golden_stem(12.341, "flat painter 1.0"), golden_stem(12.344, "flat painter 1.0"));
  EXPECT_EQ(golden_stem(0.25, "flat painter 1.0").substr(0, 9), "at_0.25s.");
}

TEST_F(GoldenTest, FilesOfTheApprovalBeforeThatHadOtherNamesGo) {
  approve();
  std::vector<GoldenApproval> approvals = read_approvals(folder_.path());
  std::filesystem::rename(folder_ / approvals[0].image, folder_ / "at_0.10s.png");
  approvals[0].image = "at_0.10s.png";
  write_approvals(folder_.path(), approvals);
  approve();
  EXPECT_FALSE(std::filesystem::exists(folder_ / "at_0.10s.png"));
  EXPECT_EQ(compare(today()).outcome, GoldenOutcome::kOk);
}

TEST_F(GoldenTest, AnotherSizeFails) {
  approve();
  GoldenPictures pictures = today();
  pictures.pictures[0].image = FlatPainter({.width = 90, .height = 64}).paint({}, {});
  const GoldenResult result = compare(pictures);
  EXPECT_EQ(result.outcome, GoldenOutcome::kFailed);
  EXPECT_NE(result.message.find("90 x 64 pixels instead of 96 x 64"), std::string::npos) << result.message;
}

TEST_F(GoldenTest, WithoutAnApprovalTheGoldenIsMissing) {
  EXPECT_EQ(compare(today()).outcome, GoldenOutcome::kGoldenMissing);
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path())) << "a comparison wrote something";
}

TEST_F(GoldenTest, AnApprovalWhosePictureIsGoneIsMissing) {
  approve();
  std::filesystem::remove(folder_ / read_approvals(folder_.path())[0].image);
  EXPECT_EQ(compare(today()).outcome, GoldenOutcome::kGoldenMissing);
}

TEST_F(GoldenTest, AScenarioThatEndsEarlyHasNoResult) {
  approve();
  const GoldenResult result = compare(today(synthetic({.steps = 11})));
  EXPECT_EQ(result.outcome, GoldenOutcome::kResultMissing);
  EXPECT_EQ(result.message, "the scenario ends at 0.05 s");
}

TEST_F(GoldenTest, ASimulationThatFailsHasNoResult) {
  approve();
  const GoldenResult result = compare(today(synthetic({.fail_at = 5})));
  EXPECT_EQ(result.outcome, GoldenOutcome::kResultMissing);
  EXPECT_EQ(result.message, "step 5 cannot be saved");
}

TEST_F(GoldenTest, AMissingDeviceIsSaidAndNothingIsCompared) {
  const GoldenPictures pictures = golden_pictures(
      example(), synthetic(), [](ImageSize) -> std::unique_ptr<Painter> { throw PictureFailure("no GPU here"); });
  EXPECT_EQ(pictures.no_device, "no GPU here");
}

TEST_F(GoldenTest, ABrokenApprovalIsAnError) {
  write_bytes(folder_ / "approval.json", "{\"goldens\": [");
  expect_cure();
}

TEST_F(GoldenTest, AnApprovalOfAnotherVersionOrWithoutAListIsToldWithWhatHelps) {
  for (const char* text : {R"({"approval_version": 7})", R"({"approval_version": 1, "goldens": {}})"}) {
    write_bytes(folder_ / "approval.json", text);
    expect_cure();
  }
}

TEST_F(GoldenTest, ABrokenGoldenPictureIsAnError) {
  approve();
  write_bytes(folder_ / read_approvals(folder_.path())[0].image, "no picture");
  expect_cure();
}

TEST(GoldenPictureTest, SimulatesNoFurtherThanTheLastTime) {
  Scenario scenario = example();
  scenario.goldens = {{.at = 0.1}, {.at = 0.02}};
  // A step after the last time would fail.
  const GoldenPictures pictures = golden_pictures(scenario, synthetic({.fail_at = 21}), flat_painters());
  ASSERT_EQ(pictures.pictures.size(), 2U);
  EXPECT_EQ(pictures.pictures[0].missing, "");
  EXPECT_EQ(pictures.pictures[1].missing, "");
  EXPECT_DOUBLE_EQ(pictures.pictures[0].moment.snapshot.time, 0.1);
  EXPECT_DOUBLE_EQ(pictures.pictures[1].moment.snapshot.time, 0.02);
}

TEST(GoldenPictureTest, LargeRecordingsAreMadeSmaller) {
  EXPECT_EQ(golden_size({.width = 1280, .height = 720}), (ImageSize{.width = 640, .height = 360}));
  EXPECT_EQ(golden_size({.width = 320, .height = 240}), (ImageSize{.width = 320, .height = 240}));
}

TEST(GoldenLimitsTest, BetweenDriversThoseOfTheScenarioHoldWhereTheyAllowMore) {
  const GoldenDefinition strict{.max = 2, .mean = 0.01, .drift = 1e-4}, loose{.max = 20, .mean = 0.5, .drift = 0.01};
  EXPECT_EQ(with_limits_between(strict, "llvmpipe", "llvmpipe").mean, 0.01);
  const GoldenDefinition widened = with_limits_between(strict, "llvmpipe", "other");
  EXPECT_EQ(widened.mean, 0.1);
  EXPECT_EQ(widened.drift, 0.002);
  EXPECT_EQ(widened.failing, 5e-5);
  EXPECT_EQ(widened.level, 8);
  const GoldenDefinition kept = with_limits_between(loose, "llvmpipe", "other");
  EXPECT_EQ(kept.mean, 0.5);
  EXPECT_EQ(kept.drift, 0.01);
  EXPECT_EQ(kept.level, 20);
}

}  // namespace
}  // namespace thinwall
