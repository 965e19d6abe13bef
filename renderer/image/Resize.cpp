#include "renderer/image/Resize.hpp"

#include <algorithm>
#include <cassert>
#include <cstdint>

namespace thinwall {
namespace {

/// What one new pixel covers along one axis, in units of 1 / (new count) of an old pixel.
struct Cover {
  int first = 0;
  std::vector<std::int64_t> weights;  // of old pixels first, first + 1, ...; their sum is the old count
};

std::vector<Cover> covers(int old_count, int new_count) {
  std::vector<Cover> result(static_cast<std::size_t>(new_count));
  for (std::int64_t i = 0; i < new_count; ++i) {
    const std::int64_t begin = i * old_count;
    const std::int64_t end = begin + old_count;
    Cover& cover = result[static_cast<std::size_t>(i)];
    cover.first = static_cast<int>(begin / new_count);
    for (std::int64_t old = cover.first; old * new_count < end; ++old) {
      cover.weights.push_back(std::min(end, (old + 1) * new_count) - std::max(begin, old * new_count));
    }
  }
  return result;
}

/// Sums over the columns of one row: (new width x 3), each the level times the old width.
void sum_columns(const std::uint8_t* row, const std::vector<Cover>& columns, std::vector<std::int64_t>& sums) {
  for (std::size_t x = 0; x < columns.size(); ++x) {
    std::int64_t sum[3] = {0, 0, 0};
    const std::uint8_t* pixel = row + static_cast<std::size_t>(columns[x].first) * 3;
    for (const std::int64_t weight : columns[x].weights) {
      for (int channel = 0; channel < 3; ++channel) sum[channel] += weight * pixel[channel];
      pixel += 3;
    }
    for (std::size_t channel = 0; channel < 3; ++channel) sums[3 * x + channel] = sum[channel];
  }
}

}  // namespace

Image resize(const Image& image, ImageSize size) {
  assert(image.size.width > 0 && image.size.height > 0 && size.width > 0 && size.height > 0);
  if (image.size == size) return image;
  const std::vector<Cover> columns = covers(image.size.width, size.width);
  const std::vector<Cover> rows = covers(image.size.height, size.height);
  const std::int64_t area = static_cast<std::int64_t>(image.size.width) * image.size.height;
  const std::size_t stride = static_cast<std::size_t>(size.width) * 3;
  Image result{.size = size, .pixels = std::vector<std::uint8_t>(stride * static_cast<std::size_t>(size.height))};
  std::vector<std::int64_t> row_sums(stride);
  std::vector<std::int64_t> sums(stride);
  for (std::size_t y = 0; y < rows.size(); ++y) {
    std::fill(sums.begin(), sums.end(), 0);
    for (std::size_t i = 0; i < rows[y].weights.size(); ++i) {
      const std::size_t old_row = static_cast<std::size_t>(rows[y].first) + i;
      sum_columns(image.pixels.data() + old_row * static_cast<std::size_t>(image.size.width) * 3, columns, row_sums);
      for (std::size_t k = 0; k < stride; ++k) sums[k] += rows[y].weights[i] * row_sums[k];
    }
    for (std::size_t k = 0; k < stride; ++k) {
      result.pixels[y * stride + k] = static_cast<std::uint8_t>((sums[k] + area / 2) / area);
    }
  }
  return result;
}

ImageSize size_that_fits(ImageSize size, ImageSize box) {
  const std::int64_t by_width = static_cast<std::int64_t>(size.height) * box.width / size.width;
  if (by_width <= box.height) return {box.width, std::max(1, static_cast<int>(by_width))};
  const std::int64_t by_height = static_cast<std::int64_t>(size.width) * box.height / size.height;
  return {std::max(1, static_cast<int>(by_height)), box.height};
}

}  // namespace thinwall
