#include "renderer/image/Resize.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <limits>

namespace thinwall {
namespace {

/// What one new pixel covers along one axis, in units of 1 / (new count) of an old pixel.
struct Cover {
  std::size_t first = 0;
  std::vector<std::uint32_t> weights;  // of old pixels first, first + 1, ...; their sum is the old count
};

std::vector<Cover> covers(int old_count, int new_count) {
  std::vector<Cover> result(static_cast<std::size_t>(new_count));
  for (std::int64_t i = 0; i < new_count; ++i) {
    const std::int64_t begin = i * old_count;
    const std::int64_t end = begin + old_count;
    Cover& cover = result[static_cast<std::size_t>(i)];
    cover.first = static_cast<std::size_t>(begin / new_count);
    for (auto old = static_cast<std::int64_t>(cover.first); old * new_count < end; ++old) {
      const std::int64_t weight = std::min(end, (old + 1) * new_count) - std::max(begin, old * new_count);
      cover.weights.push_back(static_cast<std::uint32_t>(weight));
    }
  }
  return result;
}

template <typename Sum>
void add_row(const std::uint8_t* __restrict row, Sum weight, Sum* __restrict sums, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) sums[k] += weight * row[k];
}

/// Levels of one new row: `sums` are those over the old rows that it covers, each level times the old height.
template <typename Sum>
void level_row(const Sum* sums, const std::vector<Cover>& columns, Sum area, std::uint8_t* levels) {
  const double over_area = 1 / static_cast<double>(area);
  for (const Cover& column : columns) {
    std::array<Sum, 3> level{};
    const Sum* pixel = sums + 3 * column.first;
    for (const Sum weight : column.weights) {
      for (std::size_t channel = 0; channel < 3; ++channel) level[channel] += weight * pixel[channel];
      pixel += 3;
    }
    for (const Sum sum : level) {
      // The product is a quotient's whole part, or by one too high or too low.
      const Sum rounded = sum + area / 2;
      auto quotient = static_cast<Sum>(static_cast<std::int64_t>(static_cast<double>(rounded) * over_area));
      if (quotient * area > rounded) --quotient;
      if (rounded - quotient * area >= area) ++quotient;
      *levels++ = static_cast<std::uint8_t>(quotient);
    }
  }
}

/// `Sum` holds 256 times the old picture's area.
template <typename Sum>
Image averaged(const Image& image, ImageSize size) {
  const std::vector<Cover> columns = covers(image.size.width, size.width);
  const std::vector<Cover> rows = covers(image.size.height, size.height);
  const auto area = static_cast<Sum>(image.size.width) * static_cast<Sum>(image.size.height);
  const std::size_t stride = static_cast<std::size_t>(size.width) * 3;
  const std::size_t old_stride = static_cast<std::size_t>(image.size.width) * 3;
  Image result{.size = size, .pixels = std::vector<std::uint8_t>(stride * static_cast<std::size_t>(size.height))};
  std::vector<Sum> sums(old_stride);
  for (std::size_t y = 0; y < rows.size(); ++y) {
    std::ranges::fill(sums, Sum{0});
    for (std::size_t i = 0; i < rows[y].weights.size(); ++i) {
      const std::uint8_t* row = image.pixels.data() + (rows[y].first + i) * old_stride;
      add_row<Sum>(row, rows[y].weights[i], sums.data(), old_stride);
    }
    level_row<Sum>(sums.data(), columns, area, result.pixels.data() + y * stride);
  }
  return result;
}

}  // namespace

Image resize(const Image& image, ImageSize size) {
  assert(image.size.width > 0 && image.size.height > 0 && size.width > 0 && size.height > 0);
  if (image.size == size) return image;
  constexpr std::int64_t kMostPixels = std::numeric_limits<std::uint32_t>::max() / 256;
  const bool is_small = static_cast<std::int64_t>(image.size.width) * image.size.height <= kMostPixels;
  return is_small ? averaged<std::uint32_t>(image, size) : averaged<std::uint64_t>(image, size);
}

ImageSize size_that_fits(ImageSize size, ImageSize box) {
  const std::int64_t by_width = static_cast<std::int64_t>(size.height) * box.width / size.width;
  if (by_width <= box.height) return {box.width, std::max(1, static_cast<int>(by_width))};
  const std::int64_t by_height = static_cast<std::int64_t>(size.width) * box.height / size.height;
  return {std::max(1, static_cast<int>(by_height)), box.height};
}

}  // namespace thinwall
