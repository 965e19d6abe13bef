#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "renderer/image/ExrFile.hpp"
#include "renderer/image/PngFile.hpp"
#include "renderer/image/WholeFile.hpp"
#include "tests/renderer/image/TestFolder.hpp"

namespace thinwall {
namespace {

constexpr ImageSize kSize = {.width = 5, .height = 3};

/// The rows of a PNG file as libpng itself reads them, low byte first.
std::vector<std::uint8_t> rows_of(const std::vector<std::uint8_t>& bytes, int expected_depth, int expected_color) {
  struct Source {
    const std::vector<std::uint8_t>& bytes;
    std::size_t place = 0;
  } source{bytes};
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_read_fn(png, &source, [](png_structp reader, png_bytep to, std::size_t count) {
    auto* from = static_cast<Source*>(png_get_io_ptr(reader));
    std::memcpy(to, from->bytes.data() + from->place, count);
    from->place += count;
  });
  png_read_info(png, info);
  EXPECT_EQ(png_get_bit_depth(png, info), expected_depth);
  EXPECT_EQ(png_get_color_type(png, info), expected_color);
  EXPECT_EQ(png_get_valid(png, info, PNG_INFO_sRGB), 0U) << "readers might convert the numbers";
  if (expected_depth == 16) png_set_swap(png);
  png_read_update_info(png, info);
  const std::size_t stride = png_get_rowbytes(png, info);
  std::vector<std::uint8_t> rows(stride * png_get_image_height(png, info));
  for (std::size_t row = 0; row < png_get_image_height(png, info); ++row) {
    png_read_row(png, rows.data() + row * stride, nullptr);
  }
  png_destroy_read_struct(&png, &info, nullptr);
  return rows;
}

TEST(LayerFilesTest, WordsComeBackFromPngAsTheyWere) {
  WordLayer layer{.size = kSize, .channels = 3, .values = {}};
  for (int i = 0; i < 45; ++i) layer.values.push_back(static_cast<std::uint16_t>(1459 * i));
  const std::vector<std::uint8_t> rows = rows_of(encode_layer_png(layer), 16, PNG_COLOR_TYPE_RGB);
  ASSERT_EQ(rows.size(), 2 * layer.values.size());
  EXPECT_EQ(std::memcmp(rows.data(), layer.values.data(), rows.size()), 0);
}

TEST(LayerFilesTest, BytesComeBackFromPngAsTheyWere) {
  ByteLayer layer{.size = kSize, .channels = 1, .values = {}};
  for (int i = 0; i < 15; ++i) layer.values.push_back(static_cast<std::uint8_t>(17 * i));
  EXPECT_EQ(rows_of(encode_layer_png(layer), 8, PNG_COLOR_TYPE_GRAY), layer.values);
}

/// (height x width x names) as the library itself reads them.
std::vector<float> read_exr(const std::vector<std::uint8_t>& bytes, const std::vector<std::string>& names) {
  const TestFolder folder;
  const auto file = folder.path() / "layer.exr";
  write_whole_file(file, std::span(bytes));
  Imf::InputFile input(file.c_str(), 0);
  std::size_t channels = 0;
  for (auto channel = input.header().channels().begin(); channel != input.header().channels().end(); ++channel) {
    ++channels;
  }
  EXPECT_EQ(channels, names.size());
  std::vector<float> values(15 * names.size());
  Imf::FrameBuffer frame;
  const std::size_t step = sizeof(float) * names.size();
  for (std::size_t k = 0; k < names.size(); ++k) {
    frame.insert(names[k], Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data() + k), step, 5 * step));
  }
  input.setFrameBuffer(frame);
  input.readPixels(0, 2);
  return values;
}

TEST(LayerFilesTest, FloatsComeBackFromExrToTheLastBit) {
  FloatLayer gray{.size = kSize, .channels = 1, .values = {}};
  for (int i = 0; i < 15; ++i) gray.values.push_back(static_cast<float>(std::exp(3 * i - 20)) / 3);
  EXPECT_EQ(read_exr(encode_exr(gray), {"Y"}), gray.values);
  FloatLayer vectors{.size = kSize, .channels = 3, .values = {}};
  for (int i = 0; i < 45; ++i) vectors.values.push_back(static_cast<float>(i - 20) / 7);
  EXPECT_EQ(read_exr(encode_exr(vectors), {"R", "G", "B"}), vectors.values);
  EXPECT_EQ(encode_exr(vectors), encode_exr(vectors));
}

TEST(LayerFilesTest, HalvesComeBackToOnePartIn2048) {
  FloatLayer layer{.size = kSize, .channels = 3, .values = {}};
  for (int i = 0; i < 45; ++i) layer.values.push_back(static_cast<float>(std::sin(i)));
  const std::vector<float> values = read_exr(encode_exr(layer, ExrNumbers::kHalf), {"R", "G", "B"});
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_NEAR(values[i], layer.values[i], std::abs(layer.values[i]) / 2048 + 1e-7);
  }
}

TEST(LayerFilesTest, WhatIsNoNumberComesIntoNoFile) {
  FloatLayer layer{.size = kSize, .channels = 1, .values = std::vector<float>(15, 1.0F)};
  layer.values[7] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(encode_exr(layer), PictureFailure);
  layer.values[7] = std::numeric_limits<float>::infinity();
  EXPECT_THROW(encode_exr(layer), PictureFailure);
}

}  // namespace
}  // namespace thinwall
