#include <gtest/gtest.h>
#include <sys/mount.h>

#include <cstdint>
#include <fstream>

#include "renderer/image/PictureFailure.hpp"
#include "renderer/video/VideoWriter.hpp"
#include "tests/renderer/image/TestImages.hpp"
#include "tests/renderer/video/FakeProgram.hpp"

namespace thinwall {
namespace {

namespace files = std::filesystem;

constexpr ImageSize kSize{64, 48};

/// What is said when ten frames are recorded; empty when all goes well.
std::string failure_of_recording(const files::path& path, const std::vector<Image>& frames) {
  try {
    VideoWriter writer(path, {.size = frames.front().size});
    for (const Image& frame : frames) writer.write(frame);
    writer.finish({}, {});
  } catch (const PictureFailure& failure) {
    return failure.what();
  }
  return "";
}

std::vector<Image> ten_frames() {
  return std::vector<Image>(10, patterned_image(kSize));
}

std::string beginning(const files::path& path) {
  return "cannot record " + path.string() + ": ";
}

TEST(VideoFailure, OddSizesAreRefusedWithTheNextEvenOne) {
  const TestFolder folder;
  const files::path path = folder / "a.mp4";
  EXPECT_EQ(failure_of_recording(path, {plain_image({65, 48}, 0, 0, 0)}),
            beginning(path) + "a video's width and height must be even, not 65x48; choose 64x48");
  EXPECT_EQ(folder.file_count(), 0u);
}

TEST(VideoFailure, MissingFolderIsRefusedBeforeTheFirstFrame) {
  const TestFolder folder;
  const files::path path = folder / "none/a.mp4";
  try {
    VideoWriter writer(path, {.size = kSize});
    FAIL();
  } catch (const PictureFailure& failure) {
    EXPECT_EQ(failure.what(), beginning(path) + "No such file or directory; make the folder first or choose another");
  }
}

TEST(VideoFailure, MissingProgramIsNamedBeforeTheFirstFrame) {
  const TestFolder folder;
  const files::path path = folder / "a.mp4";
  const SearchPath empty(folder.path().string());
  try {
    VideoWriter writer(path, {.size = kSize});
    FAIL();
  } catch (const PictureFailure& failure) {
    EXPECT_EQ(failure.what(), beginning(path) +
                                  "cannot start the program ffmpeg: No such file or directory; install it (on Debian: "
                                  "apt-get install ffmpeg)");
  }
  EXPECT_EQ(folder.file_count(), 0u);
}

TEST(VideoFailure, MissingEncoderIsReportedInItsWordsWithTheCure) {
  const TestFolder folder;
  const FakeProgram ffmpeg(folder, "ffmpeg", "echo \"Unknown encoder 'libx264'\" >&2; exit 1");
  const files::path path = folder / "a.mp4";
  const std::string message = failure_of_recording(path, std::vector<Image>(400, patterned_image(kSize)));
  EXPECT_NE(message.find("(exit code 1): Unknown encoder 'libx264'; install an ffmpeg that has the encoder libx264"),
            std::string::npos)
      << message;
  EXPECT_EQ(folder.file_count(), 1u);  // the folder of the fake program
}

TEST(VideoFailure, EncoderThatDiesMidwayLeavesNothing) {
  const TestFolder folder;
  const FakeProgram ffmpeg(folder, "ffmpeg", "head -c 20000 >/dev/null; kill -9 $$");
  const std::string message = failure_of_recording(folder / "a.mp4", std::vector<Image>(400, patterned_image(kSize)));
  EXPECT_NE(message.find("(signal 9): it says nothing"), std::string::npos) << message;
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST(VideoFailure, FramesLostWithoutAnyErrorAreNoticed) {
  const TestFolder folder;
  // Takes all frames, encodes three of them and reports success.
  const FakeProgram ffmpeg(
      folder, "ffmpeg",
      "case \"$*\" in *rawvideo*) { head -c 13824; cat >/dev/null <&3; } 3<&0 | \"$REAL\" \"$@\" ;; "
      "*) exec \"$REAL\" \"$@\" ;; esac");
  const std::string message = failure_of_recording(folder / "a.mp4", ten_frames());
  EXPECT_NE(message.find("ffmpeg wrote 3 of 10 frames, 0.100000 of 0.333333 s, though it reported success"),
            std::string::npos)
      << message;
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST(VideoFailure, AProgramThatDoesNothingIsNoSuccess) {
  const TestFolder folder;
  const FakeProgram ffmpeg(folder, "ffmpeg", "cat >/dev/null; exit 0");
  EXPECT_NE(failure_of_recording(folder / "a.mp4", ten_frames()).find("ffmpeg reported success, but the video "),
            std::string::npos);
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST(VideoFailure, NoFramesAreNoVideo) {
  const TestFolder folder;
  VideoWriter writer(folder / "a.mp4", {.size = kSize});
  EXPECT_THROW(writer.finish({}, {}), PictureFailure);
  EXPECT_EQ(folder.file_count(), 0u);
}

TEST(VideoFailure, AnOlderVideoDoesNotPassForTheNewOne) {
  const TestFolder folder;
  std::ofstream(folder / "a.mp4") << "older";
  const FakeProgram ffmpeg(folder, "ffmpeg", "exit 1");
  EXPECT_NE(failure_of_recording(folder / "a.mp4", ten_frames()), "");
  EXPECT_FALSE(files::exists(folder / "a.mp4"));
}

TEST(VideoFailure, FullDiskIsReportedWithTheCure) {
  const TestFolder folder;
  if (mount("none", folder.path().c_str(), "tmpfs", 0, "size=64k") != 0) {
    GTEST_SKIP() << "only root may mount the small disk that this needs";
  }
  std::vector<Image> frames;
  for (int i = 0; i < 30; ++i) {  // noise, which cannot be compressed
    frames.push_back(patterned_image({320, 240}));
    unsigned state = 12345u + static_cast<unsigned>(i);
    for (std::uint8_t& level : frames.back().pixels) {
      state = state * 1664525u + 1013904223u;
      level = static_cast<std::uint8_t>(state >> 24);
    }
  }
  const std::string message = failure_of_recording(folder / "a.mp4", frames);
  const std::size_t left = folder.file_count();
  umount(folder.path().c_str());
  EXPECT_NE(message.find("No space left on device"), std::string::npos) << message;
  EXPECT_NE(message.find("; free some space or choose a folder on another disk"), std::string::npos) << message;
  EXPECT_EQ(left, 0u);
}

/// A recording that no encoder makes small; what is said of it, empty when all goes well.
std::string failure_of_noise(const files::path& path) {
  constexpr ImageSize kNoiseSize{320, 240};
  std::uint32_t state = 1;
  try {
    VideoWriter writer(path, {.size = kNoiseSize});
    for (int frame = 0; frame < 20; ++frame) {
      Image image = plain_image(kNoiseSize, 0, 0, 0);
      for (auto& level : image.pixels) level = static_cast<std::uint8_t>((state = 1664525 * state + 1013904223) >> 24);
      writer.write(image);
    }
    writer.finish({}, {{.begin = 0, .end = 0.5, .text = "Pressing"}});
  } catch (const FileUnwritable& failure) {
    return failure.what();
  }
  return "";
}

TEST(VideoFailure, ADiskThatIsFullBeforeTheFileIsFinishedIsTold) {
  const TestFolder folder;
  ASSERT_EQ(failure_of_noise(folder / "whole.mp4"), "");
  const std::uintmax_t whole = files::file_size(folder / "whole.mp4");
  files::create_directory(folder / "disk");
  for (const int percent : {120, 150, 180}) {
    const std::string size = "size=" + std::to_string(whole * static_cast<unsigned>(percent) / 100);
    if (mount("tmpfs", (folder / "disk").c_str(), "tmpfs", 0, size.c_str()) != 0) {
      GTEST_SKIP() << "only root can make a small disk to fill";
    }
    const std::string failure = failure_of_noise(folder / "disk/a.mp4");
    const bool is_empty = files::is_empty(folder / "disk");
    umount((folder / "disk").c_str());
    EXPECT_NE(failure.find("No space left on device"), std::string::npos) << percent << ": " << failure;
    EXPECT_NE(failure.find("cannot record "), std::string::npos) << failure;
    EXPECT_TRUE(is_empty) << percent;
  }
}

}  // namespace
}  // namespace thinwall
