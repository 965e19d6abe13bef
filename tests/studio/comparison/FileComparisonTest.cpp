#include "studio/comparison/FileComparison.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "renderer/image/WholeFile.hpp"
#include "tests/studio/comparison/MediaFiles.hpp"

namespace thinwall {
namespace {

class FileComparisonTest : public ::testing::Test {
 protected:
  std::filesystem::path picture(const std::string& name, const Image& image) {
    write_png(folder_ / name, image);
    return folder_ / name;
  }
  std::filesystem::path video(const std::string& name, const std::vector<int>& shifts) {
    write_video(folder_ / name, shifts);
    return folder_ / name;
  }
  std::filesystem::path numbers(const std::string& name, const std::vector<float>& values, bool grey) {
    const int width = static_cast<int>(values.size()) / (grey ? 1 : 3);
    std::string bytes = std::string(grey ? "Pf" : "PF") + "\n" + std::to_string(width) + " 1\n-1.0\n";
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float));
    write_bytes(folder_ / name, bytes);
    return folder_ / name;
  }

  TemporaryFolder folder_;
  Image image_ = shaded_image(kMediaSize);
};

TEST_F(FileComparisonTest, OtherBytesWithTheSamePixelsAreEqual) {
  const auto first = picture("a.png", image_);
  write_png(folder_ / "b.png", image_, PngEffort::kSmall);
  ASSERT_NE(file_bytes(first), file_bytes(folder_ / "b.png"));
  EXPECT_EQ(compare_files(first, folder_ / "b.png").outcome, FileOutcome::kEqual);
}

TEST_F(FileComparisonTest, OneLevelIsADifferenceUnlessALimitAllowsIt) {
  Image changed = image_;
  changed.pixels[500] ^= 1;
  const auto first = picture("a.png", image_);
  const auto second = picture("b.png", changed);
  const FileComparison result = compare_files(first, second);
  EXPECT_EQ(result.outcome, FileOutcome::kDiffers);
  EXPECT_NE(result.details.find("difference 1"), std::string::npos) << result.details;
  FileComparisonOptions options;
  options.limits.largest = 1;
  EXPECT_EQ(compare_files(first, second, options).outcome, FileOutcome::kWithin);
}

TEST_F(FileComparisonTest, TransparencyAloneIsADifference) {
  const auto first = picture("a.png", tinted(image_, 99, 99, 99));
  convert(first, {"-vf", "format=rgba,colorchannelmixer=aa=0.5"}, folder_ / "b.png");
  const FileComparison result = compare_files(first, folder_ / "b.png");
  EXPECT_EQ(result.outcome, FileOutcome::kDiffers);
  EXPECT_NE(result.verdict.find("transparency"), std::string::npos) << result.verdict;
}

TEST_F(FileComparisonTest, AnUnreadableFileIsAnOutcomeOfItsOwn) {
  const auto first = picture("a.png", image_);
  const FileComparison result = compare_files(first, folder_ / "none.png");
  EXPECT_EQ(result.outcome, FileOutcome::kUnreadable);
  EXPECT_NE(result.verdict.find("none.png: no such file"), std::string::npos);
  write_bytes(folder_ / "broken.png", file_bytes(first).substr(0, 400));
  EXPECT_EQ(compare_files(folder_ / "broken.png", folder_ / "broken.png").outcome, FileOutcome::kUnreadable);
}

TEST_F(FileComparisonTest, AnotherSizeOrKindDiffers) {
  const auto first = picture("a.png", image_);
  EXPECT_EQ(compare_files(first, picture("b.png", shaded_image({96, 160}))).outcome, FileOutcome::kDiffers);
  const FileComparison kinds = compare_files(first, video("v.mkv", {0, 1}));
  EXPECT_EQ(kinds.outcome, FileOutcome::kDiffers);
  EXPECT_EQ(kinds.verdict, "a picture and a video cannot be equal");
}

TEST_F(FileComparisonTest, TheMaskTakesPlacesOut) {
  Image changed = image_;
  Image mask = image_;
  for (std::uint8_t& level : mask.pixels) level = 255;
  for (int i = 0; i < 300; ++i) changed.pixels[static_cast<std::size_t>(i)] ^= 64;
  const auto first = picture("a.png", image_);
  const auto second = picture("b.png", changed);
  FileComparisonOptions options;
  options.mask = picture("mask.png", mask);
  EXPECT_EQ(compare_files(first, second, options).outcome, FileOutcome::kDiffers);
  for (int i = 0; i < 300; ++i) mask.pixels[static_cast<std::size_t>(i)] = 0;
  options.mask = picture("mask.png", mask);
  EXPECT_EQ(compare_files(first, second, options).outcome, FileOutcome::kEqual);
  options.mask = picture("mask.png", shaded_image({3, 3}));
  EXPECT_THROW(compare_files(first, second, options), ImageUnreadable);
}

TEST_F(FileComparisonTest, WhatIsMaskedIsNotShownAsDifferent) {
  Image changed = image_;
  changed.pixels.front() ^= 64;
  changed.pixels.back() ^= 64;
  Image mask = tinted(image_, 255, 255, 255);
  const auto first = picture("a.png", image_);
  const auto second = picture("b.png", changed);
  FileComparisonOptions options{.wants_picture = true};
  options.mask = picture("mask.png", mask);
  const FileComparison whole = compare_files(first, second, options);
  for (std::size_t i = 0; i < 3; ++i) mask.pixels[i] = 0;
  options.mask = picture("mask.png", mask);
  const FileComparison part = compare_files(first, second, options);
  EXPECT_EQ(part.outcome, FileOutcome::kDiffers);
  const auto marks = [](const FileComparison& one) { return std::ranges::count(one.details, '#'); };
  EXPECT_EQ(marks(whole) - marks(part), 1) << part.details;
  ASSERT_TRUE(whole.heat && part.heat);
  EXPECT_NE(std::vector(whole.heat->pixels.begin(), whole.heat->pixels.begin() + 3),
            std::vector(part.heat->pixels.begin(), part.heat->pixels.begin() + 3));
}

TEST_F(FileComparisonTest, AMaskHidesNoSixteenBitsElsewhere) {
  convert(picture("a.png", image_), {"-pix_fmt", "rgb48be"}, folder_ / "fine.png");
  convert(folder_ / "fine.png", {"-vf", "format=gbrp16,lutrgb=r=val+3,format=rgb48be"}, folder_ / "other.png");
  ASSERT_EQ(compare_files(folder_ / "fine.png", folder_ / "other.png").outcome, FileOutcome::kDiffers);
  FileComparisonOptions options;
  options.mask = picture("mask.png", tinted(image_, 255, 255, 255));
  EXPECT_EQ(compare_files(folder_ / "fine.png", folder_ / "other.png", options).outcome, FileOutcome::kDiffers);
  options.mask = picture("mask.png", tinted(image_, 0, 0, 0));
  EXPECT_EQ(compare_files(folder_ / "fine.png", folder_ / "other.png", options).outcome, FileOutcome::kEqual);
}

TEST_F(FileComparisonTest, EqualVideosAreEqualWhateverTheirContainer) {
  const auto first = video("a.mkv", {0, 1, 2, 3, 4});
  convert(first, {"-c", "copy"}, folder_ / "b.nut");
  // This container keeps no tags of colours.
  const FileComparison result = compare_files(first, folder_ / "b.nut", {.pixels_only = true});
  EXPECT_EQ(result.outcome, FileOutcome::kEqual) << result.verdict;
  ASSERT_TRUE(result.video);
  EXPECT_EQ(result.video->equal_frames, 5U);
}

TEST_F(FileComparisonTest, AChangedFrameIsNamedWithItsTime) {
  const FileComparison result =
      compare_files(video("a.mkv", {0, 1, 2, 3, 4}), video("b.mkv", {0, 1, 2, 9, 4}), {.wants_picture = true});
  EXPECT_EQ(result.outcome, FileOutcome::kDiffers);
  ASSERT_TRUE(result.video);
  ASSERT_EQ(result.video->different.size(), 1U);
  EXPECT_EQ(result.video->different[0].frame, 3U);
  EXPECT_NEAR(result.video->different[0].time, 0.12, 1e-9);
  EXPECT_TRUE(result.heat);
}

TEST_F(FileComparisonTest, AFrameThatWasDroppedIsFound) {
  const FileComparison result = compare_files(video("a.mkv", {0, 1, 2, 3, 4, 5}), video("b.mkv", {0, 1, 3, 4, 5}));
  EXPECT_EQ(result.outcome, FileOutcome::kDiffers);
  EXPECT_NE(result.verdict.find("5 frames instead of 6: frame 2 is missing, all others are equal"), std::string::npos)
      << result.verdict;
  // No limit of pixels excuses another length.
  FileComparisonOptions options;
  options.limits.largest = 255;
  EXPECT_EQ(compare_files(folder_ / "a.mkv", folder_ / "b.mkv", options).outcome, FileOutcome::kDiffers);
}

TEST_F(FileComparisonTest, AnotherSpeedDiffersUnlessPixelsAloneCount) {
  const auto first = video("a.mkv", {0, 1, 2, 3});
  convert(first, {"-vf", "setpts=2*PTS", "-c:v", "ffv1"}, folder_ / "b.mkv");
  const FileComparison result = compare_files(first, folder_ / "b.mkv");
  EXPECT_EQ(result.outcome, FileOutcome::kDiffers);
  EXPECT_NE(result.verdict.find("frame 1 is shown at 0.0800 s instead of 0.0400 s"), std::string::npos)
      << result.verdict;
  EXPECT_EQ(compare_files(first, folder_ / "b.mkv", {.pixels_only = true}).outcome, FileOutcome::kEqual);
}

TEST_F(FileComparisonTest, CaptionsAndChaptersCount) {
  const auto record = [&](const std::string& name, const std::string& caption, const std::string& chapter) {
    VideoWriter writer(folder_ / name, {.size = kMediaSize, .frames_per_second = 25});
    for (int i = 0; i < 10; ++i) writer.write(shaded_image(kMediaSize, i));
    writer.finish({{0, 0.4, chapter}}, {{0, 0.4, caption}});
    return folder_ / name;
  };
  const auto first = record("a.mp4", "Pressing", "Palpation");
  EXPECT_EQ(compare_files(first, record("same.mp4", "Pressing", "Palpation")).outcome, FileOutcome::kEqual);
  EXPECT_NE(compare_files(first, record("b.mp4", "Presing", "Palpation")).verdict.find("the captions differ"),
            std::string::npos);
  EXPECT_NE(compare_files(first, record("c.mp4", "Pressing", "Incision")).verdict.find("the chapters differ"),
            std::string::npos);
}

TEST_F(FileComparisonTest, CanBeStoppedBetweenFrames) {
  const auto first = video("a.mkv", {0, 1, 2, 3});
  const auto second = video("b.mkv", {4, 5, 6, 7});
  int looks = 0;
  FileComparisonOptions options;
  options.between_frames = [&] {
    if (++looks == 3) throw std::runtime_error("stopped");
  };
  EXPECT_THROW(compare_files(first, second, options), std::runtime_error);
  EXPECT_EQ(looks, 3) << "before the file and two of its frames";
}

TEST_F(FileComparisonTest, AVideoCutShortIsUnreadable) {
  const auto first = video("a.mkv", {0, 1, 2, 3, 4, 5, 6, 7});
  std::filesystem::copy_file(first, folder_ / "b.mkv");
  cut_short(folder_ / "b.mkv", 0.6);
  EXPECT_EQ(compare_files(first, folder_ / "b.mkv").outcome, FileOutcome::kUnreadable);
}

TEST_F(FileComparisonTest, PicturesOfHighRangeAreComparedByHdrFlip) {
  const auto first = numbers("a.pfm", std::vector<float>(30, 0.5F), false);
  std::vector<float> brighter(30, 0.5F);
  brighter[4] = 40;
  const auto second = numbers("b.pfm", brighter, false);
  EXPECT_EQ(compare_files(first, first).outcome, FileOutcome::kEqual);
  const FileComparison result = compare_files(first, second);
  EXPECT_EQ(result.outcome, FileOutcome::kDiffers);
  ASSERT_TRUE(result.high_range);
  EXPECT_GT(result.high_range->mean, 0.01);
  FileComparisonOptions options;
  options.limits.flip = 1;
  EXPECT_EQ(compare_files(first, second, options).outcome, FileOutcome::kWithin);
  options.limits.largest = 255;
  const FileComparison judged = compare_files(first, second, options);
  EXPECT_EQ(judged.outcome, FileOutcome::kDiffers) << "no limit that does not apply is met";
  EXPECT_NE(judged.verdict.find("only --flip and --flip-99 can be limits"), std::string::npos) << judged.verdict;
}

TEST_F(FileComparisonTest, AMaskTakesPlacesOutOfNumbersToo) {
  std::vector<float> values(30, 0.5F);
  const auto first = numbers("a.pfm", values, true);
  values[4] = 40;
  const auto second = numbers("b.pfm", values, true);
  Image mask{.size = {30, 1}, .pixels = std::vector<std::uint8_t>(90, 255)};
  FileComparisonOptions options;
  options.mask = picture("mask.png", mask);
  EXPECT_EQ(compare_files(first, second, options).outcome, FileOutcome::kDiffers);
  std::fill_n(&mask.pixels[12], 3, std::uint8_t{0});
  options.mask = picture("mask.png", mask);
  EXPECT_EQ(compare_files(first, second, options).outcome, FileOutcome::kEqual);
  options.layer = LayerChoice{.kind = LayerKind::kDepth};
  EXPECT_EQ(compare_files(first, second, options).outcome, FileOutcome::kEqual);
  options.mask.reset();
  EXPECT_EQ(compare_files(first, second, options).outcome, FileOutcome::kDiffers);
}

TEST_F(FileComparisonTest, AVideoIsNoLayer) {
  const auto first = video("a.mkv", {0, 1});
  const FileComparison result = compare_files(first, first, {.layer = LayerChoice{.kind = LayerKind::kDepth}});
  EXPECT_EQ(result.outcome, FileOutcome::kUnreadable);
  EXPECT_NE(result.verdict.find("a layer of depth has to be a file"), std::string::npos) << result.verdict;
}

TEST_F(FileComparisonTest, LayersAreComparedByTheirOwnRules) {
  const auto first = numbers("a.pfm", {0.1F, 0.1F, 0.2F}, true);
  const auto second = numbers("b.pfm", {0.1F, 0.1002F, 0.2F}, true);
  FileComparisonOptions options;
  options.layer = LayerChoice{.kind = LayerKind::kDepth, .tolerance = {.difference = 1e-4}};
  const FileComparison result = compare_files(first, second, options);
  EXPECT_EQ(result.outcome, FileOutcome::kDiffers);
  EXPECT_EQ(result.kind, "depth");
  options.layer->tolerance.difference = 1e-3;
  EXPECT_EQ(compare_files(first, second, options).outcome, FileOutcome::kWithin);
}

TEST_F(FileComparisonTest, IdsAreTheNumbersOfTheFilesAlsoOf16Bits) {
  const auto ids = [&](const std::string& name, std::vector<std::uint16_t> values) {
    write_whole_file(folder_ / name,
                     encode_layer_png(WordLayer{.size = {3, 1}, .channels = 1, .values = std::move(values)}));
    return folder_ / name;
  };
  const auto shared = ids("a.png", {0, 1, 2});
  const FileComparisonOptions options{.layer = LayerChoice{.kind = LayerKind::kIds}};
  EXPECT_EQ(compare_files(shared, ids("b.png", {0, 1, 2}), options).outcome, FileOutcome::kEqual);
  const FileComparison other = compare_files(shared, ids("c.png", {0, 1, 1}), options);
  EXPECT_EQ(other.outcome, FileOutcome::kDiffers);
  EXPECT_NE(other.verdict.find("overlap 0.0000 of id 2; 1 pixels fail"), std::string::npos) << other.verdict;
  // Numbers that 8 bits would hold beside ones that they do not.
  EXPECT_EQ(compare_files(ids("d.png", {257, 514, 3}), ids("e.png", {257, 514, 257}), options).layer->failing, 1);
  convert(shared, {"-pix_fmt", "rgb48be", "-vf", "colorchannelmixer=rr=0.5"}, folder_ / "colors.png");
  const FileComparison colors = compare_files(shared, folder_ / "colors.png", options);
  EXPECT_EQ(colors.outcome, FileOutcome::kUnreadable) << colors.verdict;
}

TEST_F(FileComparisonTest, FlowThatIsKnownInOneOnlyDiffersAlsoWhereNothingMoves) {
  const auto still = numbers("a.pfm", {0, 0, 1, 1, 2, 1}, false);
  const FileComparisonOptions options{.layer = LayerChoice{.kind = LayerKind::kFlow}};
  const FileComparison result = compare_files(still, numbers("b.pfm", {0, 0, 0, 1, 2, 1}, false), options);
  EXPECT_EQ(result.outcome, FileOutcome::kDiffers);
  EXPECT_EQ(result.layer->only_in_one, 1);
  EXPECT_EQ(compare_files(still, numbers("c.pfm", {0, 0, 1, 1, 2, 1}, false), options).outcome, FileOutcome::kEqual);
  // A third channel that tells nothing, and one of another program.
  for (const float third : {0.0F, 0.5F}) {
    const auto first = numbers("d.pfm", {0, 0, third, 1, 2, third}, false);
    const auto second = numbers("e.pfm", {0, 3, third, 1, 2, third}, false);
    EXPECT_EQ(compare_files(first, second, options).layer->failing, 1) << third;
  }
}

TEST_F(FileComparisonTest, VerdictsNameTheLimitsThatFiguresWereHeldAgainst) {
  const auto verdict = [](const std::filesystem::path& first, const std::filesystem::path& second,
                          const FileComparisonOptions& options) {
    return compare_files(first, second, options).verdict;
  };
  FileComparisonOptions options;
  options.limits = {.largest = 1, .mean = 300};
  const std::string frames = verdict(video("a.mkv", {0, 1, 2}), video("b.mkv", {0, 1, 9}), options);
  EXPECT_NE(frames.find("worst frame 2 at 0.080 s: largest difference "), std::string::npos) << frames;
  EXPECT_NE(frames.find(" (allowed 1), mean "), std::string::npos) << frames;
  EXPECT_NE(frames.find(" (allowed 300)"), std::string::npos) << frames;
  options.limits = {.flip_99 = 0.25};
  std::vector<float> brighter(30, 0.5F);
  brighter[4] = 40;
  const auto even = numbers("a.pfm", std::vector<float>(30, 0.5F), false);
  const std::string range = verdict(even, numbers("b.pfm", brighter, false), options);
  EXPECT_NE(range.find("99th percentile "), std::string::npos) << range;
  EXPECT_NE(range.find(" (allowed 0.25), largest "), std::string::npos) << range;
  options = {.layer = LayerChoice{.kind = LayerKind::kDepth, .tolerance = {.difference = 0.125}, .failing = 0.2}};
  const std::string depth =
      verdict(numbers("c.pfm", {1, 1, 1, 1}, true), numbers("d.pfm", {1, 1, 1, 1.5F}, true), options);
  EXPECT_EQ(
      depth,
      "largest difference 0.5 m (allowed 0.125 m), mean 0.125 m; 1 pixels fail, a fraction of 0.25 (allowed 0.2), "
      "0 of them show something in one only; worst at (3, 0)");
}

TEST_F(FileComparisonTest, FoldersArePairedByTheirPaths) {
  for (const char* folder : {"one/deep", "two/deep"}) std::filesystem::create_directories(folder_ / folder);
  picture("one/a.png", image_);
  picture("two/a.png", image_);
  picture("one/deep/b.png", image_);
  picture("two/deep/b.png", shaded_image(kMediaSize, 1));
  picture("one/c.png", image_);
  picture("two/d.png", image_);
  picture("two/.hidden.png", image_);
  for (const char* folder : {"one", "two"}) std::filesystem::create_symlink("a.png", folder_ / folder / "link.png");
  const std::vector<FileComparison> results = compare_folders(folder_ / "one", folder_ / "two");
  ASSERT_EQ(results.size(), 5U) << "a link is a file of its own name";
  EXPECT_EQ(results[0].outcome, FileOutcome::kEqual);
  EXPECT_EQ(results[1].outcome, FileOutcome::kOnlyInFirst);
  EXPECT_EQ(results[2].outcome, FileOutcome::kOnlyInSecond);
  EXPECT_EQ(results[3].outcome, FileOutcome::kDiffers);
}

}  // namespace
}  // namespace thinwall
