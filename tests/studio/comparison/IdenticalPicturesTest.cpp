#include "studio/comparison/IdenticalPictures.hpp"

#include <gtest/gtest.h>

#include "tests/studio/comparison/MediaFiles.hpp"

namespace thinwall {
namespace {

class IdenticalPicturesTest : public ::testing::Test {
 protected:
  void SetUp() override { write_png(folder_ / "a.png", shaded_image(kMediaSize)); }
  /// Of a file with these bytes and its copy.
  std::optional<ImageSize> of(const std::string& bytes) {
    write_bytes(folder_ / "b.png", bytes);
    write_bytes(folder_ / "c.png", bytes);
    return identical_pictures(folder_ / "b.png", folder_ / "c.png");
  }

  TemporaryFolder folder_;
};

TEST_F(IdenticalPicturesTest, WholePicturesOfTheSameBytesNeedNoDecoding) {
  EXPECT_EQ(of(file_bytes(folder_ / "a.png")), kMediaSize);
}

TEST_F(IdenticalPicturesTest, OtherBytesAreLookedAt) {
  write_png(folder_ / "other.png", shaded_image(kMediaSize, 1));
  EXPECT_FALSE(identical_pictures(folder_ / "a.png", folder_ / "other.png"));
  EXPECT_FALSE(identical_pictures(folder_ / "a.png", folder_ / "none.png"));
  EXPECT_FALSE(identical_pictures(folder_.path(), folder_.path()));
}

TEST_F(IdenticalPicturesTest, FilesThatAreCutShortOrDamagedAreLookedAt) {
  const std::string whole = file_bytes(folder_ / "a.png");
  EXPECT_FALSE(of(""));
  EXPECT_FALSE(of("hello"));
  for (const double part : {0.1, 0.5, 0.99}) {
    EXPECT_FALSE(of(whole.substr(0, static_cast<std::size_t>(part * static_cast<double>(whole.size())))));
  }
  for (const std::size_t at : {std::size_t{18}, whole.size() / 2, whole.size() - 3}) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 1);
    EXPECT_FALSE(of(damaged)) << at;
  }
  EXPECT_FALSE(of(whole + "more"));
}

TEST_F(IdenticalPicturesTest, AnimationsAreLookedAt) {
  write_video(folder_ / "a.mkv", {0, 1});
  convert(folder_ / "a.mkv", {"-f", "apng"}, folder_ / "animated.png");
  EXPECT_FALSE(identical_pictures(folder_ / "animated.png", folder_ / "animated.png"));
}

}  // namespace
}  // namespace thinwall
