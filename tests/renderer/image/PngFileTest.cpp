#include "renderer/image/PngFile.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include <fstream>

#include "tests/renderer/image/TestFolder.hpp"
#include "tests/renderer/image/TestImages.hpp"

namespace thinwall {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::string failure_of_decoding(const Bytes& bytes) {
  try {
    decode_png(bytes, "a.png");
  } catch (const ImageUnreadable& failure) {
    return failure.what();
  }
  return "";
}

/// A PNG of any kind, written with libpng's own interface.
struct AnyPng {
  int color_type = PNG_COLOR_TYPE_RGB;
  int bit_depth = 8;
  int interlace = PNG_INTERLACE_NONE;
  std::vector<png_color> palette;
  std::vector<Bytes> rows;
  png_uint_32 width = 0;
  double gamma = 0;  // of the file; 0: none is named

  Bytes encode() const {
    Bytes bytes;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(
        png, &bytes,
        [](png_structp self, png_bytep data, std::size_t count) {
          auto* out = static_cast<Bytes*>(png_get_io_ptr(self));
          out->insert(out->end(), data, data + count);
        },
        [](png_structp) {});
    png_set_IHDR(png, info, width, static_cast<png_uint_32>(rows.size()), bit_depth, color_type, interlace,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (gamma != 0) png_set_gAMA(png, info, gamma);
    if (!palette.empty()) png_set_PLTE(png, info, palette.data(), static_cast<int>(palette.size()));
    std::vector<Bytes> copies = rows;
    std::vector<png_bytep> pointers;
    for (Bytes& row : copies) pointers.push_back(row.data());
    png_write_info(png, info);
    png_write_image(png, pointers.data());
    png_write_end(png, nullptr);
    png_destroy_write_struct(&png, &info);
    return bytes;
  }
};

std::uint32_t checksum(const Bytes& bytes, std::size_t begin, std::size_t end) {
  std::uint32_t sum = 0xffffffff;
  for (std::size_t i = begin; i < end; ++i) {
    sum ^= bytes[i];
    for (int bit = 0; bit < 8; ++bit) sum = (sum >> 1) ^ ((sum & 1) ? 0xedb88320u : 0u);
  }
  return ~sum;
}

constexpr std::size_t kHeaderBegin = 12;  // of type and data of the first chunk, which says the size
constexpr std::size_t kHeaderEnd = 29;

/// Claims another size in a file whose header checksum is right all the same.
Bytes with_claimed_size(Bytes bytes, std::uint32_t width, std::uint32_t height) {
  for (std::size_t i = 0; i < 4; ++i) {
    bytes[16 + i] = static_cast<std::uint8_t>(width >> (24 - 8 * i));
    bytes[20 + i] = static_cast<std::uint8_t>(height >> (24 - 8 * i));
  }
  const std::uint32_t sum = checksum(bytes, kHeaderBegin, kHeaderEnd);
  for (std::size_t i = 0; i < 4; ++i) bytes[kHeaderEnd + i] = static_cast<std::uint8_t>(sum >> (24 - 8 * i));
  return bytes;
}

TEST(PngFile, BothEffortsGiveThePixelsBack) {
  const Image image = patterned_image({67, 41});
  for (const PngEffort effort : {PngEffort::kFast, PngEffort::kSmall}) {
    const Image back = decode_png(encode_png(image, effort), "a.png");
    EXPECT_EQ(back.size, image.size);
    EXPECT_EQ(back.pixels, image.pixels);
  }
}

TEST(PngFile, SmallEffortIsSmaller) {
  Image image{.size = {200, 200}, .pixels = {}};  // a soft light, as in a rendered picture
  for (int i = 0; i < 200 * 200; ++i) {
    const int brightness = 255 - ((i % 200) * (i % 200) + (i / 200) * (i / 200)) / 400;
    for (const int share : {4, 2, 1}) image.pixels.push_back(static_cast<std::uint8_t>(brightness * share / 4));
  }
  EXPECT_LT(encode_png(image, PngEffort::kSmall).size(), encode_png(image, PngEffort::kFast).size());
}

TEST(PngFile, EqualPicturesGiveEqualBytes) {
  EXPECT_EQ(encode_png(patterned_image({33, 9})), encode_png(patterned_image({33, 9})));
}

TEST(PngFile, FileHoldsThePictureAndNothingElseIsLeft) {
  const TestFolder folder;
  const Image image = patterned_image({5, 3});
  write_png(folder / "a.png", image);
  EXPECT_EQ(read_png(folder / "a.png").pixels, image.pixels);
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST(PngFile, SixteenBitColoursAreScaledToEight) {
  const AnyPng png{.bit_depth = 16, .palette = {}, .rows = {{0xff, 0xff, 0x80, 0x80, 0, 0}}, .width = 1};
  EXPECT_EQ(decode_png(png.encode(), "a.png").pixels, (Bytes{255, 128, 0}));
}

TEST(PngFile, AGammaThatAPictureNamesChangesNoNumber) {
  // As in frames that ffmpeg takes from videos, whose numbers are those of the video.
  for (const double gamma : {0.51, 1.0, 1 / 2.2}) {
    const AnyPng png{.palette = {}, .rows = {{7, 100, 250}}, .width = 1, .gamma = gamma};
    EXPECT_EQ(decode_png(png.encode(), "a.png").pixels, (Bytes{7, 100, 250})) << gamma;
  }
}

TEST(PngFile, GreyBecomesThreeEqualChannels) {
  const AnyPng png{.color_type = PNG_COLOR_TYPE_GRAY, .palette = {}, .rows = {{7, 250}}, .width = 2};
  EXPECT_EQ(decode_png(png.encode(), "a.png").pixels, (Bytes{7, 7, 7, 250, 250, 250}));
}

TEST(PngFile, BlackAndWhiteOfOneBitIsRead) {
  const AnyPng png{.color_type = PNG_COLOR_TYPE_GRAY, .bit_depth = 1, .palette = {}, .rows = {{0x40}}, .width = 2};
  EXPECT_EQ(decode_png(png.encode(), "a.png").pixels, (Bytes{0, 0, 0, 255, 255, 255}));
}

TEST(PngFile, PaletteIsLookedUp) {
  const AnyPng png{
      .color_type = PNG_COLOR_TYPE_PALETTE, .palette = {{1, 2, 3}, {200, 100, 50}}, .rows = {{1, 0}}, .width = 2};
  EXPECT_EQ(decode_png(png.encode(), "a.png").pixels, (Bytes{200, 100, 50, 1, 2, 3}));
}

TEST(PngFile, AlphaIsLaidOverWhite) {
  const AnyPng png{
      .color_type = PNG_COLOR_TYPE_RGBA, .palette = {}, .rows = {{10, 20, 30, 255, 10, 20, 30, 0}}, .width = 2};
  EXPECT_EQ(decode_png(png.encode(), "a.png").pixels, (Bytes{10, 20, 30, 255, 255, 255}));
}

TEST(PngFile, InterlacedEqualsPlain) {
  AnyPng png{.palette = {}, .rows = {}, .width = 19};
  const Image image = patterned_image({19, 23});
  for (int y = 0; y < 23; ++y) png.rows.emplace_back(&image.pixels[57u * y], &image.pixels[57u * y] + 57);
  png.interlace = PNG_INTERLACE_ADAM7;
  EXPECT_EQ(decode_png(png.encode(), "a.png").pixels, image.pixels);
}

TEST(PngFile, EveryTruncationIsRefused) {
  const Bytes whole = encode_png(patterned_image({21, 13}));
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const std::string message = failure_of_decoding(Bytes(whole.begin(), whole.begin() + static_cast<long>(size)));
    ASSERT_FALSE(message.empty()) << size << " of " << whole.size() << " bytes were accepted";
    ASSERT_TRUE(message.starts_with("cannot read a.png: ")) << message;
  }
}

TEST(PngFile, AnEndMarkThatIsMissingIsToldAsSuch) {
  Bytes bytes = encode_png(patterned_image({21, 13}));
  bytes.push_back(0);
  EXPECT_EQ(failure_of_decoding(bytes), "") << "what stands behind the end mark does not count";
  bytes.erase(bytes.end() - 13, bytes.end());
  EXPECT_EQ(failure_of_decoding(bytes), "cannot read a.png: cut short (its end mark is missing)");
}

TEST(PngFile, EveryBrokenByteOfHeaderAndPixelsIsRefused) {
  const Bytes whole = encode_png(patterned_image({21, 13}));
  const auto mark = std::string(whole.begin(), whole.end()).find("IDAT");
  for (std::size_t i = 0; i < whole.size(); ++i) {
    if (i >= kHeaderEnd + 4 && i < mark) continue;  // the colour-space note: not needed for the pixels
    Bytes broken = whole;
    broken[i] ^= 0x10;
    ASSERT_FALSE(failure_of_decoding(broken).empty()) << "byte " << i;
  }
}

TEST(PngFile, ClaimedHugeSizeIsRefusedBeforeMemoryIsTaken) {
  const Bytes huge = with_claimed_size(encode_png(patterned_image({4, 4})), 900000, 900000);
  EXPECT_EQ(failure_of_decoding(huge), "cannot read a.png: 900000 x 900000 pixels are more than the 268435456 allowed");
  EXPECT_FALSE(failure_of_decoding(with_claimed_size(encode_png(patterned_image({4, 4})), 0, 4)).empty());
}

TEST(PngFile, OtherFilesAreNamedForWhatTheyAre) {
  const TestFolder folder;
  EXPECT_EQ(failure_of_decoding({}), "cannot read a.png: the file is empty");
  EXPECT_EQ(failure_of_decoding({0xff, 0xd8, 0xff, 0xe0}), "cannot read a.png: not a PNG picture; save it as PNG");
  const std::string pointer = "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n";
  EXPECT_NE(failure_of_decoding(Bytes(pointer.begin(), pointer.end())).find("`git lfs pull`"), std::string::npos);
  const auto failure_of = [](const std::filesystem::path& path) {
    try {
      read_png(path);
    } catch (const ImageUnreadable& failure) {
      return std::string(failure.what());
    }
    return std::string();
  };
  EXPECT_EQ(failure_of(folder / "none.png"), "cannot read " + (folder / "none.png").string() + ": no such file");
  EXPECT_EQ(failure_of(folder.path()), "cannot read " + folder.path().string() + ": it is a folder, not a picture");
}

}  // namespace
}  // namespace thinwall
