#include "renderer/video/VideoProbe.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "renderer/image/PictureFailure.hpp"
#include "renderer/video/Program.hpp"
#include "renderer/video/VideoWriter.hpp"
#include "tests/renderer/image/TestFolder.hpp"
#include "tests/renderer/image/TestImages.hpp"

namespace thinwall {
namespace {

namespace files = std::filesystem;

constexpr ImageSize kProbedSize{64, 48};

/// With tracks and marks beside the video's, before and behind it in the file.
files::path recorded_in(const TestFolder& folder) {
  files::path path = folder / "a.mp4";
  VideoWriter writer(path, {.size = kProbedSize, .frames_per_second = 24000.0 / 1001.0});
  for (int i = 0; i < 31; ++i) writer.write(plain_image(kProbedSize, 30, 20, static_cast<std::uint8_t>(5 * i)));
  writer.finish({{0, 0.5, "Approach"}}, {{0.2, 0.9, "pressed"}});
  return path;
}

std::string told_of(const files::path& path) {
  try {
    probe_video(path);
  } catch (const PictureFailure& failure) {
    return failure.what();
  }
  return "";
}

TEST(VideoProbe, FindsWhatFfprobeFinds) {
  const TestFolder folder;
  const files::path path = recorded_in(folder);
  const VideoProbe found = probe_video(path);
  const auto asked = [&](const std::string& entry) {
    return std::stod(run_program({"ffprobe", "-v", "error", "-select_streams", "v:0", "-count_packets", "-show_entries",
                                  "stream=" + entry, "-of", "csv=p=0", path.string()})
                         .output);
  };
  EXPECT_EQ(found.size.width, asked("width"));
  EXPECT_EQ(found.size.height, asked("height"));
  EXPECT_EQ(static_cast<double>(found.frames), asked("nb_read_packets"));
  // It prints six digits.
  EXPECT_NEAR(found.duration, asked("duration"), 5e-7);
}

TEST(VideoProbe, AFileThatIsCutShortAnywhereIsNoWholeVideo) {
  const TestFolder folder;
  const files::path path = recorded_in(folder);
  for (auto left = files::file_size(path); left-- > 0;) {
    files::resize_file(path, left);
    EXPECT_NE(told_of(path), "") << left << " bytes of it";
  }
}

TEST(VideoProbe, SaysWhatIsWrongWithAFileThatHoldsNoVideo) {
  const TestFolder folder;
  EXPECT_NE(told_of(folder / "none.mp4").find("cannot be opened"), std::string::npos);
  std::ofstream(folder / "text.mp4") << "a text that is no list of boxes";
  EXPECT_NE(told_of(folder / "text.mp4").find("has a box of impossible size"), std::string::npos);
  std::ofstream(folder / "box.mp4") << std::string("\0\0\0\x08mdat", 8);
  EXPECT_NE(told_of(folder / "box.mp4").find("has no list of tracks"), std::string::npos);
}

}  // namespace
}  // namespace thinwall
