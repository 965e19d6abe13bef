#include "studio/comparison/PictureFile.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/studio/comparison/MediaFiles.hpp"

namespace thinwall {
namespace {

class PictureFileTest : public ::testing::Test {
 protected:
  void SetUp() override { write_png(png(), image_); }
  std::filesystem::path png() const { return folder_ / "a.png"; }

  std::string refusal(const std::filesystem::path& path) {
    try {
      read_media(path);
    } catch (const ImageUnreadable& error) {
      return error.what();
    }
    return "";
  }
  void expect_refused(const std::filesystem::path& path, const std::string& words) {
    const std::string message = refusal(path);
    EXPECT_EQ(message.rfind("cannot read " + path.string() + ": ", 0), 0U) << message;
    EXPECT_NE(message.find(words), std::string::npos) << message;
  }

  TemporaryFolder folder_;
  Image image_ = shaded_image(kMediaSize);
};

TEST_F(PictureFileTest, LosslessFormatsGiveTheSamePixels) {
  for (const std::string name : {"b.bmp", "b.tiff", "b.ppm", "b.qoi"}) {
    convert(png(), {"-frames:v", "1"}, folder_ / name);
    const MediaFile file = read_media(folder_ / name);
    EXPECT_EQ(file.kind, MediaKind::kPicture) << name;
    EXPECT_EQ(file.image.pixels, image_.pixels) << name;
    EXPECT_FALSE(file.deep) << name;
  }
}

TEST_F(PictureFileTest, TransparencyThatHidesNothingChangesNothing) {
  convert(png(), {"-pix_fmt", "rgba"}, folder_ / "b.png");
  const MediaFile file = read_media(folder_ / "b.png");
  EXPECT_EQ(file.image.pixels, image_.pixels);
  EXPECT_FALSE(file.deep);
}

TEST_F(PictureFileTest, TransparencyIsKeptAndLaidOverWhite) {
  convert(png(), {"-vf", "format=rgba,colorchannelmixer=aa=0.5"}, folder_ / "b.png");
  const MediaFile file = read_media(folder_ / "b.png");
  ASSERT_TRUE(file.deep);
  const int half = file.deep->values[3];
  EXPECT_NEAR(half, 32768, 257);
  EXPECT_NEAR(file.image.pixels[0], (image_.pixels[0] + 255) / 2.0, 1.5);
}

TEST_F(PictureFileTest, SixteenBitsAreKept) {
  convert(png(), {"-pix_fmt", "rgb48be"}, folder_ / "b.png");
  const MediaFile file = read_media(folder_ / "b.png");
  EXPECT_EQ(file.kind, MediaKind::kPicture);
  EXPECT_EQ(file.image.size, kMediaSize);
}

TEST_F(PictureFileTest, GreyIsReadAsThreeEqualChannels) {
  convert(png(), {"-pix_fmt", "gray"}, folder_ / "b.png");
  const Image grey = read_media(folder_ / "b.png").image;
  EXPECT_EQ(grey.pixels[30], grey.pixels[31]);
  EXPECT_EQ(grey.pixels[30], grey.pixels[32]);
}

TEST_F(PictureFileTest, AJpegIsReadNearlyAsItWas) {
  convert(png(), {"-q:v", "1"}, folder_ / "b.jpg");
  const Image read = read_media(folder_ / "b.jpg").image;
  ASSERT_EQ(read.size, kMediaSize);
  double sum = 0;
  for (std::size_t i = 0; i < read.pixels.size(); ++i) sum += std::abs(read.pixels[i] - image_.pixels[i]);
  EXPECT_LT(sum / static_cast<double>(read.pixels.size()), 4);
}

TEST_F(PictureFileTest, AnAnimationIsAVideo) {
  write_video(folder_ / "a.mkv", {0, 1, 2, 3});
  convert(folder_ / "a.mkv", {}, folder_ / "a.gif");
  convert(folder_ / "a.mkv", {"-f", "apng"}, folder_ / "animated.png");
  for (const std::string name : {"a.mkv", "a.gif", "animated.png"}) {
    const MediaFile file = read_media(folder_ / name);
    EXPECT_EQ(file.kind, MediaKind::kVideo) << name;
    EXPECT_EQ(file.probe.times.size(), 4U) << name;
  }
}

TEST_F(PictureFileTest, NumbersOfHighRangeAreReadToTheLastBit) {
  const std::vector<float> rows = {1.5F, -2, 1e6F, 0.25F, 0, 3};  // PFM begins with the lowest row
  std::string bytes = "PF\n1 2\n-1.0\n";
  bytes.append(reinterpret_cast<const char*>(rows.data()), rows.size() * sizeof(float));
  write_bytes(folder_ / "a.pfm", bytes);
  const MediaFile file = read_media(folder_ / "a.pfm");
  EXPECT_EQ(file.kind, MediaKind::kHighRange);
  EXPECT_EQ(file.numbers.values, (std::vector<float>{0.25F, 0, 3, 1.5F, -2, 1e6F}));
}

TEST_F(PictureFileTest, FloatMapsThatMakeNoSenseAreRefused) {
  write_bytes(folder_ / "zero.pfm", "PF\n0 2\n-1.0\n");
  write_bytes(folder_ / "huge.pfm", "PF\n900000 900000\n-1.0\n");
  write_bytes(folder_ / "short.pfm", "Pf\n2 2\n-1.0\n1234");
  expect_refused(folder_ / "zero.pfm", "makes no sense");
  expect_refused(folder_ / "huge.pfm", "more pixels than are allowed");
  expect_refused(folder_ / "short.pfm", "cut short");
}

TEST_F(PictureFileTest, WhatIsNoPictureIsToldInWords) {
  write_bytes(folder_ / "empty.png", "");
  write_bytes(folder_ / "text.txt", "hello");
  write_bytes(folder_ / "sound.wav", "RIFF____WAVEfmt ");
  write_bytes(folder_ / "list.m3u8", "#EXTM3U\n#EXTINF:1,\n" + png().string() + "\n");
  expect_refused(folder_ / "none.png", "no such file");
  expect_refused(folder_.path(), "it is a folder");
  expect_refused(folder_ / "empty.png", "the file is empty");
  expect_refused(folder_ / "text.txt", "no picture or video");
  expect_refused(folder_ / "sound.wav", "no picture or video");
  expect_refused(folder_ / "list.m3u8", "no picture or video");
  EXPECT_EQ(refusal(folder_ / "text.txt").find("whitelist"), std::string::npos) << "a list of all formats helps nobody";
  expect_refused("/dev/null", "no regular file");
}

TEST_F(PictureFileTest, ATextThatIsCalledAPictureIsNone) {
  write_bytes(folder_ / "text.png", "hello, this is no picture at all\n");
  EXPECT_NE(refusal(folder_ / "text.png"), "");
}

TEST_F(PictureFileTest, ColorsOfPrintAreRefusedWithTheCure) {
  // A JPEG whose frame header names four colours, and a TIFF that says 5 under tag 262.
  write_bytes(folder_ / "print.jpg",
              std::string("\xff\xd8\xff\xc0\x00\x14\x08\x00\x10\x00\x10\x04\x01\x11\x00\x02", 16));
  write_bytes(folder_ / "print.tiff",
              std::string("II\x2a\x00\x08\x00\x00\x00\x01\x00\x06\x01\x03\x00\x01\x00\x00\x00\x05\x00\x00\x00", 22));
  expect_refused(folder_ / "print.jpg", "CMYK");
  expect_refused(folder_ / "print.tiff", "save it as RGB");
}

TEST_F(PictureFileTest, AnAnimatedWebpIsRefusedWithTheCure) {
  write_video(folder_ / "a.mkv", {0, 1, 2});
  convert(folder_ / "a.mkv", {}, folder_ / "animated.webp");
  expect_refused(folder_ / "animated.webp", "save it as GIF or animated PNG");
}

TEST_F(PictureFileTest, VideosCutShortAreRefused) {
  write_video(folder_ / "a.mkv", {0, 1, 2, 3});
  for (const double part : {0.3, 0.9}) {
    convert(folder_ / "a.mkv", {}, folder_ / "b.mp4");
    cut_short(folder_ / "b.mp4", part);
    EXPECT_NE(refusal(folder_ / "b.mp4"), "") << part;
  }
}

/// Header and data with right checksums, the sizes as told.
std::string png_of_size(std::uint32_t width, std::uint32_t height) {
  const auto big_endian = [](std::uint32_t number) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 0xff);
    return bytes;
  };
  const auto chunk = [&](const std::string& content) {
    std::uint32_t crc = 0xffffffff;
    for (const char letter : content) {
      crc ^= static_cast<std::uint8_t>(letter);
      for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc % 2 != 0 ? 0xedb88320U : 0U);
    }
    return big_endian(static_cast<std::uint32_t>(content.size() - 4)) + content + big_endian(~crc);
  };
  const std::string header = "IHDR" + big_endian(width) + big_endian(height) + std::string("\x08\x02\0\0\0", 5);
  const std::string data = std::string("IDAT\x78\x9c\x03\0\0\0\0\x01", 12);
  return "\x89PNG\r\n\x1a\n" + chunk(header) + chunk(data) + chunk("IEND");
}

TEST_F(PictureFileTest, PicturesOfNoSizeOrOfAHugeOneAreRefusedBeforeMemoryIsTaken) {
  write_bytes(folder_ / "zero.png", png_of_size(0, 10));
  write_bytes(folder_ / "huge.png", png_of_size(100000, 100000));
  write_bytes(folder_ / "lacking.png", png_of_size(64, 64));
  expect_refused(folder_ / "zero.png", "broken PNG picture");
  expect_refused(folder_ / "huge.png", "100000 x 100000 pixels are more than the");
  expect_refused(folder_ / "lacking.png", "broken PNG picture");
}

TEST_F(PictureFileTest, FilesCutShortAreRefused) {
  for (const std::string name : {"b.png", "b.jpg", "b.tiff", "b.bmp", "b.gif", "b.webp"}) {
    convert(png(), {"-frames:v", "1"}, folder_ / name);
    ASSERT_EQ(refusal(folder_ / name), "") << name;
    for (const double part : {0.9, 0.5, 0.1}) {
      cut_short(folder_ / name, part);
      EXPECT_NE(refusal(folder_ / name), "") << name << " cut to " << part;
    }
  }
}

/// Whatever the bytes, the answer is a picture or a refusal.
TEST_F(PictureFileTest, DamagedFilesNeverDoMoreThanBeRefused) {
  std::mt19937 random(7);
  for (const std::string name : {"b.png", "b.jpg", "b.gif", "b.tiff"}) {
    convert(png(), {"-frames:v", "1"}, folder_ / name);
    const std::string whole = file_bytes(folder_ / name);
    for (int trial = 0; trial < 6; ++trial) {
      std::string damaged = whole;
      for (int i = 0; i < 12; ++i) damaged[random() % damaged.size()] = static_cast<char>(random());
      write_bytes(folder_ / ("damaged_" + name), damaged);
      const std::string message = refusal(folder_ / ("damaged_" + name));
      EXPECT_TRUE(message.empty() || message.rfind("cannot read ", 0) == 0) << message;
    }
  }
}

}  // namespace
}  // namespace thinwall
