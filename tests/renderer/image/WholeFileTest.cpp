#include "renderer/image/WholeFile.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <filesystem>
#include <fstream>

#include "renderer/image/PictureFailure.hpp"
#include "tests/renderer/image/TestFolder.hpp"

namespace thinwall {
namespace {

std::string failure_of_writing(const std::filesystem::path& path, std::string_view text) {
  try {
    write_whole_file(path, text);
  } catch (const PictureFailure& failure) {
    return failure.what();
  }
  return "";
}

/// A disk that is full after `bytes` bytes, for the running process only.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : old_handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &old_limit_);
    const rlimit limit{bytes, old_limit_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &old_limit_);
    std::signal(SIGXFSZ, old_handler_);
  }

 private:
  rlimit old_limit_{};
  void (*old_handler_)(int);
};

TEST(WholeFile, WritesTheBytesAndLeavesNothingElse) {
  const TestFolder folder;
  write_whole_file(folder / "a.txt", std::string_view("first"));
  write_whole_file(folder / "a.txt", std::string_view("second"));
  EXPECT_EQ(bytes_of_file(folder / "a.txt"), "second");
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST(WholeFile, APipeStaysOneAndIsWrittenTo) {
  const TestFolder folder;
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  // Read and written from one end, so that neither waits for the other.
  const int pipe = ::open((folder / "pipe").c_str(), O_RDWR | O_CLOEXEC);
  ASSERT_GE(pipe, 0);
  write_whole_file(folder / "pipe", std::string_view("first"));
  std::array<char, 5> read = {};
  ASSERT_TRUE(std::filesystem::is_fifo(folder / "pipe")) << "nothing could be read";
  EXPECT_EQ(::read(pipe, read.data(), read.size()), 5);
  EXPECT_EQ(std::string_view(read.data(), read.size()), "first");
  ::close(pipe);
}

TEST(WholeFile, AFullDeviceIsToldOf) {
  const TestFolder folder;
  std::filesystem::create_symlink("/dev/full", folder / "full");
  EXPECT_NE(failure_of_writing(folder / "full", "first").find("No space left"), std::string::npos);
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "full"));
}

TEST(WholeFile, ReadsAllBytesAndNothingOfWhatIsNoFile) {
  const TestFolder folder;
  const std::string text("a\0b\r\n\xff", 6);
  write_whole_file(folder / "a", text);
  EXPECT_EQ(bytes_of_file(folder / "a"), text);
  EXPECT_EQ(as_numbers(text).back(), 255);
  EXPECT_EQ(bytes_of_file(folder / "none"), "");
  EXPECT_EQ(bytes_of_file(folder.path()), "");
}

TEST(WholeFile, UnfinishedNameCannotBeTakenForAWholeFile) {
  EXPECT_EQ(unfinished_name("out/video.mp4"), "out/video.unfinished.mp4");
  EXPECT_EQ(unfinished_name("plain"), "plain.unfinished");
}

TEST(WholeFile, TakesTheLeftoverOfAKilledRunAway) {
  const TestFolder folder;
  std::ofstream(folder / "a.unfinished.txt") << "a leftover that is longer";
  write_whole_file(folder / "a.txt", std::string_view("new"));
  EXPECT_EQ(bytes_of_file(folder / "a.txt"), "new");
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST(WholeFile, FullDiskKeepsTheOldFileAndSaysWhatHelps) {
  const TestFolder folder;
  write_whole_file(folder / "a.txt", std::string_view("old"));
  std::string message;
  {
    const FileSizeLimit limit(1000);
    message = failure_of_writing(folder / "a.txt", std::string(5000, 'x'));
  }
  EXPECT_EQ(message, "cannot write " + (folder / "a.txt").string() +
                         ": File too large; free some space or choose a folder on another disk");
  EXPECT_EQ(bytes_of_file(folder / "a.txt"), "old");
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST(WholeFile, MissingFolderIsNamedWithTheCure) {
  const TestFolder folder;
  EXPECT_EQ(failure_of_writing(folder / "none/a.txt", "x"),
            "cannot write " + (folder / "none/a.txt").string() +
                ": No such file or directory; make the folder first or choose another");
}

TEST(WholeFile, FolderOfThatNameIsKept) {
  const TestFolder folder;
  std::filesystem::create_directory(folder / "a.txt");
  EXPECT_EQ(
      failure_of_writing(folder / "a.txt", "x"),
      "cannot write " + (folder / "a.txt").string() + ": Is a directory; a folder has this name; choose another name");
  EXPECT_EQ(folder.file_count(), 1u);
}

}  // namespace
}  // namespace thinwall
