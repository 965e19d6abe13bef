#include "renderer/video/YuvFrame.hpp"

#include <cassert>
#include <cstddef>

namespace thinwall {
namespace {

// BT.709: luma = 0.2126 R + 0.7152 G + 0.0722 B, times 219/255 for the limited range;
// Cb = (B - luma) / 1.8556, Cr = (R - luma) / 1.5748, times 224/255. All in units of 2^-16, each chroma row summing to
// zero so that grey is exactly 128.
constexpr int kLuma[3] = {11966, 40254, 4064};
constexpr int kBlue[3] = {-6596, -22188, 28784};
constexpr int kRed[3] = {28784, -26145, -2639};
constexpr int kFilterBits = 3;  // the chroma filter's weights sum to 8

void write_luma(const std::uint8_t* rgb, int width, std::uint8_t* luma) {
  for (int x = 0; x < width; ++x, rgb += 3) {
    const int sum = kLuma[0] * rgb[0] + kLuma[1] * rgb[1] + kLuma[2] * rgb[2];
    luma[x] = static_cast<std::uint8_t>((sum + (16 << 16) + (1 << 15)) >> 16);
  }
}

/// Adds two rows into `sums`, whose first pixel repeats the row's first: the left neighbour of column 0.
void sum_rows(const std::uint8_t* upper, const std::uint8_t* lower, int width, std::uint16_t* sums) {
  for (int i = 0; i < 3 * width; ++i) sums[3 + i] = static_cast<std::uint16_t>(upper[i] + lower[i]);
  for (int channel = 0; channel < 3; ++channel) sums[channel] = sums[3 + channel];
}

void write_chroma(const std::uint16_t* sums, int half_width, std::uint8_t* blue, std::uint8_t* red) {
  constexpr int kOffset = (128 << (16 + kFilterBits)) + (1 << (15 + kFilterBits));
  for (int x = 0; x < half_width; ++x, sums += 6) {
    int color[3];
    for (int channel = 0; channel < 3; ++channel) {
      color[channel] = sums[channel] + 2 * sums[3 + channel] + sums[6 + channel];
    }
    const int cb = kBlue[0] * color[0] + kBlue[1] * color[1] + kBlue[2] * color[2];
    const int cr = kRed[0] * color[0] + kRed[1] * color[1] + kRed[2] * color[2];
    blue[x] = static_cast<std::uint8_t>((cb + kOffset) >> (16 + kFilterBits));
    red[x] = static_cast<std::uint8_t>((cr + kOffset) >> (16 + kFilterBits));
  }
}

}  // namespace

std::vector<std::uint8_t> yuv420_bt709(const Image& image) {
  const auto width = static_cast<std::size_t>(image.size.width);
  const auto height = static_cast<std::size_t>(image.size.height);
  assert(width % 2 == 0 && height % 2 == 0);
  std::vector<std::uint8_t> planes(width * height * 3 / 2);
  std::uint8_t* blue = planes.data() + width * height;
  std::uint8_t* red = blue + width * height / 4;
  std::vector<std::uint16_t> sums(3 * (width + 1));
  for (std::size_t y = 0; y < height; ++y) {
    write_luma(image.pixels.data() + 3 * width * y, image.size.width, planes.data() + width * y);
  }
  for (std::size_t y = 0; y < height / 2; ++y) {
    const std::uint8_t* upper = image.pixels.data() + 6 * width * y;
    sum_rows(upper, upper + 3 * width, image.size.width, sums.data());
    write_chroma(sums.data(), image.size.width / 2, blue + y * width / 2, red + y * width / 2);
  }
  return planes;
}

}  // namespace thinwall
