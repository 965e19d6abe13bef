#include "renderer/picture/FinePixels.hpp"

#include <algorithm>
#include <array>
#include <cstring>

namespace thinwall {
namespace {

/// Smaller steps between neighbours, in 8-bit levels, look smooth; dithering alone makes steps of one.
constexpr std::uint8_t kStep = 14;

/// Fluid that changes its pixel by less, in 8-bit levels, shows no slope.
constexpr std::uint8_t kFluidStep = 2;

/// Which channels of `a` and `b` differ by more than `step`, (count).
void find_steps(const std::uint8_t* __restrict a, const std::uint8_t* __restrict b, std::uint8_t step,
                std::uint8_t* __restrict steps, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint8_t first = a[i], second = b[i];
    const auto difference = static_cast<std::uint8_t>(first > second ? first - second : second - first);
    steps[i] = difference > step ? 1 : 0;
  }
}

/// Calls `mark` for the pixels, counted from 0, that have a step; most have none.
template <typename Mark>
void for_steps(std::span<const std::uint8_t> steps, const Mark& mark) {
  constexpr std::size_t kTogether = 32;
  for (std::size_t begin = 0; begin < steps.size(); begin += kTogether) {
    const std::size_t count = std::min(kTogether, steps.size() - begin);
    std::array<std::uint64_t, kTogether / 8> bytes{};
    std::memcpy(bytes.data(), steps.data() + begin, count);
    if ((bytes[0] | bytes[1] | bytes[2] | bytes[3]) == 0) continue;
    for (std::size_t i = begin; i < begin + count; ++i) {
      if (steps[i]) mark(i / 4);
    }
  }
}

/// Marks of a whole picture, (width x height).
std::vector<std::uint8_t> marks_of(std::span<const std::uint8_t> pixels, std::span<const std::uint8_t> bare,
                                   ImageSize size) {
  const auto width = static_cast<std::size_t>(size.width), height = static_cast<std::size_t>(size.height);
  std::vector<std::uint8_t> marks(width * height);
  std::vector<std::uint8_t> steps(4 * width);
  const auto compare = [&](std::size_t first, std::size_t second, std::size_t count) {
    find_steps(&pixels[4 * first], &pixels[4 * second], kStep, steps.data(), 4 * count);
    for_steps(std::span(steps).first(4 * count), [&](std::size_t pixel) {
      marks[first + pixel] = 1;
      marks[second + pixel] = 1;
    });
  };
  for (std::size_t row = 0; row < height; ++row) {
    const std::size_t first = row * width;
    if (width > 1) compare(first, first + 1, width - 1);
    if (row + 1 < height) compare(first, first + width, width);
    if (bare.empty()) continue;
    find_steps(&pixels[4 * first], &bare[4 * first], kFluidStep, steps.data(), 4 * width);
    for_steps(steps, [&](std::size_t pixel) { marks[first + pixel] = 1; });
  }
  return marks;
}

}  // namespace

FinePixels find_fine_pixels(std::span<const std::uint8_t> pixels, std::span<const std::uint8_t> bare, ImageSize size) {
  const std::vector<std::uint8_t> marks = marks_of(pixels, bare, size);
  int left = size.width, right = -1, bottom = size.height, top = -1;
  for (int row = 0; row < size.height; ++row) {
    const auto begin = marks.begin() + static_cast<std::ptrdiff_t>(row) * size.width, end = begin + size.width;
    const auto first = std::find(begin, end, std::uint8_t{1});
    if (first == end) continue;
    const auto last = std::find(std::make_reverse_iterator(end), std::make_reverse_iterator(begin), std::uint8_t{1});
    left = std::min(left, static_cast<int>(first - begin));
    right = std::max(right, static_cast<int>(last.base() - begin) - 1);
    bottom = std::min(bottom, row);
    top = row;
  }
  FinePixels fine;
  if (top < 0) return fine;
  left = std::max(left - 1, 0);
  bottom = std::max(bottom - 1, 0);
  fine.area = {left, bottom, right - left + 1, top - bottom + 1};
  for (int row = bottom; row <= top; ++row) {
    const auto begin = marks.begin() + static_cast<std::ptrdiff_t>(row) * size.width + left;
    fine.is_fine.insert(fine.is_fine.end(), begin, begin + fine.area.width);
  }
  fine.is_corner = fine.is_fine;
  const auto width = static_cast<std::size_t>(fine.area.width);
  for (std::size_t i = 0; i < fine.is_fine.size(); ++i) {
    if (!fine.is_fine[i]) continue;
    const bool is_first = i % width == 0;
    if (!is_first) fine.is_corner[i - 1] = 1;
    if (i < width) continue;
    fine.is_corner[i - width] = 1;
    if (!is_first) fine.is_corner[i - width - 1] = 1;
  }
  return fine;
}

std::vector<std::uint8_t> cut_out(std::span<const std::uint8_t> pixels, ImageSize size, const ScreenArea& area) {
  std::vector<std::uint8_t> part;
  part.reserve(4 * static_cast<std::size_t>(area.width) * static_cast<std::size_t>(area.height));
  for (int row = area.bottom; row < area.bottom + area.height; ++row) {
    const auto begin = pixels.begin() + 4 * (static_cast<std::ptrdiff_t>(row) * size.width + area.left);
    part.insert(part.end(), begin, begin + 4 * static_cast<std::ptrdiff_t>(area.width));
  }
  return part;
}

std::vector<std::uint8_t> with_corners(const FinePixels& fine, std::span<const std::uint8_t> middles,
                                       std::span<const std::uint8_t> corners) {
  std::vector<std::uint8_t> result(middles.begin(), middles.end());
  const auto width = static_cast<std::size_t>(fine.area.width);
  for (std::size_t i = 0; i < fine.is_fine.size(); ++i) {
    if (!fine.is_fine[i]) continue;
    const std::size_t left = i % width > 0 ? i - 1 : i;
    const std::size_t down = i >= width ? width : 0;
    for (std::size_t channel = 0; channel < 4; ++channel) {
      const auto at = [&](std::size_t pixel) { return unsigned{corners[4 * pixel + channel]}; };
      const unsigned sum = 4U * middles[4 * i + channel] + at(i) + at(left) + at(i - down) + at(left - down);
      result[4 * i + channel] = static_cast<std::uint8_t>((sum + 4) / 8);
    }
  }
  return result;
}

}  // namespace thinwall
