#include "renderer/video/VideoWriter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

#include "renderer/video/Program.hpp"
#include "renderer/video/VideoProbe.hpp"
#include "tests/renderer/image/TestFolder.hpp"
#include "tests/renderer/image/TestImages.hpp"

namespace thinwall {
namespace {

namespace files = std::filesystem;

constexpr ImageSize kVideoSize{64, 48};

/// A box that moves over a soft background.
Image frame_number(int number) {
  Image image = plain_image(kVideoSize, 30, 20, 25);
  for (int y = 10; y < 30; ++y) {
    for (int x = number % 40; x < number % 40 + 20; ++x) {
      image.pixels[static_cast<std::size_t>(3 * (y * kVideoSize.width + x))] = static_cast<std::uint8_t>(120 + x);
    }
  }
  return image;
}

void record(const files::path& path, int frames, double rate = 30, const std::vector<VideoChapter>& chapters = {},
            const std::vector<VideoCaption>& captions = {}) {
  VideoWriter writer(path, {.size = kVideoSize, .frames_per_second = rate});
  for (int i = 0; i < frames; ++i) writer.write(frame_number(i));
  writer.finish(chapters, captions);
}

std::string bytes_of(const files::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// What ffprobe prints for `entries` of the first track of a kind.
std::string probe(const files::path& path, const std::string& track, const std::string& entries) {
  return run_program({"ffprobe", "-v", "error", "-select_streams", track, "-show_entries", entries, "-of",
                      "default=noprint_wrappers=1:nokey=1", path.string()})
      .output;
}

/// The first frame as it comes out of the decoder: planes of luma, Cb, Cr.
std::string decoded_planes(const files::path& path) {
  return run_program({"ffmpeg", "-v", "error", "-i", path.string(), "-frames:v", "1", "-f", "rawvideo", "-pix_fmt",
                      "yuv420p", "pipe:1"})
      .output;
}

TEST(VideoWriter, HasEveryFrameAndTheExactDuration) {
  const TestFolder folder;
  record(folder / "a.mp4", 45);
  const VideoProbe found = probe_video(folder / "a.mp4");
  EXPECT_EQ(found.frames, 45);
  EXPECT_EQ(found.size, kVideoSize);
  EXPECT_DOUBLE_EQ(found.duration, 1.5);
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST(VideoWriter, FrameTimesAreConstantAtAnyRate) {
  const TestFolder folder;
  for (const double rate : {30.0, 24000.0 / 1001.0, 29.97}) {
    record(folder / "a.mp4", 20, rate);
    std::istringstream durations(probe(folder / "a.mp4", "v", "packet=duration"));
    std::vector<int> ticks{std::istream_iterator<int>(durations), {}};
    ASSERT_EQ(ticks.size(), 20u) << rate;
    EXPECT_EQ(std::count(ticks.begin(), ticks.end(), ticks.front()), 20) << rate;
    EXPECT_EQ(probe(folder / "a.mp4", "v", "stream=r_frame_rate"),
              probe(folder / "a.mp4", "v", "stream=avg_frame_rate"))
        << rate;
  }
}

TEST(VideoWriter, FirstFrameIsAtTimeZero) {
  const TestFolder folder;
  record(folder / "a.mp4", 10);
  EXPECT_EQ(std::stod(probe(folder / "a.mp4", "v", "stream=start_time")), 0);
}

TEST(VideoWriter, PureColoursAreDecodedWithTheLumaOfBt709) {
  const TestFolder folder;
  const struct {
    int color[3];
    int luma;
  } cases[] = {{{255, 0, 0}, 63}, {{0, 255, 0}, 173}, {{0, 0, 255}, 32}};
  for (const auto& [color, luma] : cases) {
    VideoWriter writer(folder / "a.mp4", {.size = kVideoSize});
    const auto level = [&](int channel) { return static_cast<std::uint8_t>(color[channel]); };
    writer.write(plain_image(kVideoSize, level(0), level(1), level(2)));
    writer.finish({}, {});
    const std::string planes = decoded_planes(folder / "a.mp4");
    ASSERT_EQ(planes.size(), 64u * 48u * 3u / 2u);
    // A plain picture passes this encoder unchanged.
    EXPECT_EQ(static_cast<unsigned char>(planes[64 * 24 + 32]), luma);
  }
}

TEST(VideoWriter, ColoursAreTagged) {
  const TestFolder folder;
  record(folder / "a.mp4", 3);
  EXPECT_EQ(
      probe(folder / "a.mp4", "v", "stream=codec_name,pix_fmt,color_range,color_space,color_transfer,color_primaries"),
      "h264\nyuv420p\ntv\nbt709\nbt709\nbt709\n");
}

TEST(VideoWriter, ChaptersKeepTimesAndTitles) {
  const TestFolder folder;
  record(folder / "a.mp4", 60, 30, {{0, 0.5, "Approach"}, {0.5, 2, "Hold; 50 % = all #1 \\"}});
  const std::string found = run_program({"ffprobe", "-v", "error", "-show_chapters", "-of",
                                         "compact=nokey=1:print_section=0", (folder / "a.mp4").string()})
                                .output;
  EXPECT_NE(found.find("|0.000000|500|0.500000|Approach\n"), std::string::npos) << found;
  EXPECT_NE(found.find("|0.500000|2000|2.000000|Hold; 50 % = all #1 \\"), std::string::npos) << found;
}

TEST(VideoWriter, CaptionsAreATrackThatIsOffUntilAskedFor) {
  const TestFolder folder;
  record(folder / "a.mp4", 60, 30, {}, {{0.5, 1.5, "p < 5 kPa & rising"}});
  EXPECT_EQ(probe(folder / "a.mp4", "s:0", "stream=codec_name:stream_disposition=default"), "mov_text\n0\n");
  const std::string text =
      run_program({"ffmpeg", "-v", "error", "-i", (folder / "a.mp4").string(), "-map", "0:s", "-f", "srt", "-"}).output;
  EXPECT_EQ(text, "1\n00:00:00,500 --> 00:00:01,500\np < 5 kPa & rising\n\n");
}

TEST(VideoWriter, ACaptionGoesOnOnceAShorterOneHasEnded) {
  const TestFolder folder;
  record(folder / "a.mp4", 60, 30, {}, {{0, 2, "long"}, {0.5, 1, "short"}});
  const std::string text =
      run_program({"ffmpeg", "-v", "error", "-i", (folder / "a.mp4").string(), "-map", "0:s", "-f", "srt", "-"}).output;
  EXPECT_NE(text.find("00:00:01,000 --> 00:00:02,000\nlong\n"), std::string::npos) << text;
}

TEST(VideoWriter, SameFramesGiveTheSameBytes) {
  const TestFolder folder;
  for (const char* name : {"a.mp4", "b.mp4"}) record(folder / name, 40, 30, {{0, 1, "All"}}, {{0, 1, "Text"}});
  EXPECT_EQ(bytes_of(folder / "a.mp4"), bytes_of(folder / "b.mp4"));
}

TEST(VideoWriter, IndexStandsBeforeTheFrames) {
  const TestFolder folder;
  record(folder / "a.mp4", 5);
  const std::string bytes = bytes_of(folder / "a.mp4");
  EXPECT_LT(bytes.find("moov"), bytes.find("mdat"));
}

TEST(VideoWriter, NamesWithSpecialCharactersAreKept) {
  const TestFolder folder;
  record(folder / "-y a: 50 % \"b\".mp4", 3);
  EXPECT_TRUE(files::exists(folder / "-y a: 50 % \"b\".mp4"));
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST(VideoWriter, UnfinishedLeavesNothing) {
  const TestFolder folder;
  {
    VideoWriter writer(folder / "a.mp4", {.size = kVideoSize});
    for (int i = 0; i < 5; ++i) writer.write(frame_number(i));
    EXPECT_GT(folder.file_count(), 0u);
  }
  EXPECT_EQ(folder.file_count(), 0u);
}

}  // namespace
}  // namespace thinwall
