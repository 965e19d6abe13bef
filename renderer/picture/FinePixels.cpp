#include "renderer/picture/FinePixels.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace thinwall {
namespace {

/// Smaller steps between neighbours, in 8-bit levels, look smooth; dithering alone makes steps of one.
constexpr std::uint8_t kStep = 14;

/// Fluid that changes its pixel by less, in 8-bit levels, shows no slope.
constexpr std::uint8_t kFluidStep = 2;

/// Marks pixels of which a channel of `a` and `b` differs by more than `step`: (count), and (4 x count) for what is
/// found on the way.
void find_steps(const std::uint8_t* __restrict a, const std::uint8_t* __restrict b, std::uint8_t step,
                std::uint8_t* __restrict channels, std::uint8_t* __restrict marks, std::size_t count) {
  for (std::size_t i = 0; i < 4 * count; ++i) {
    const std::uint8_t first = a[i], second = b[i];
    const auto difference = static_cast<std::uint8_t>(first > second ? first - second : second - first);
    channels[i] = difference > step ? 1 : 0;
  }
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t all;
    std::memcpy(&all, channels + 4 * i, sizeof(all));
    marks[i] = all != 0 ? 1 : 0;
  }
}

void add_marks(const std::uint8_t* __restrict marks, std::uint8_t* __restrict to, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) to[i] |= marks[i];
}

/// Calls `visit` for the places of bytes that are 1, in their order; most are 0, and none is anything else.
template <typename Visit>
void for_set(std::span<const std::uint8_t> bytes, const Visit& visit) {
  static_assert(std::endian::native == std::endian::little);
  constexpr std::size_t kWord = sizeof(std::uint64_t), kTogether = 4 * kWord;
  for (std::size_t begin = 0; begin < bytes.size(); begin += kTogether) {
    std::array<std::uint64_t, 4> words{};
    std::memcpy(words.data(), bytes.data() + begin, std::min(kTogether, bytes.size() - begin));
    if ((words[0] | words[1] | words[2] | words[3]) == 0) continue;
    for (std::size_t k = 0; k < words.size(); ++k) {
      for (std::uint64_t word = words[k]; word != 0; word &= word - 1) {
        visit(begin + kWord * k + static_cast<std::size_t>(std::countr_zero(word)) / 8);
      }
    }
  }
}

/// Marks of a whole picture, (width x height).
std::vector<std::uint8_t> marks_of(std::span<const std::uint8_t> pixels, std::span<const std::uint8_t> bare,
                                   ImageSize size) {
  const auto width = static_cast<std::size_t>(size.width), height = static_cast<std::size_t>(size.height);
  std::vector<std::uint8_t> marks(width * height), channels(4 * width), found(width);
  for (std::size_t row = 0; row < height; ++row) {
    const std::size_t first = row * width;
    // With the pixel that many on.
    const auto compare = [&](std::size_t on, std::size_t count) {
      find_steps(&pixels[4 * first], &pixels[4 * (first + on)], kStep, channels.data(), found.data(), count);
      add_marks(found.data(), &marks[first], count);
      add_marks(found.data(), &marks[first + on], count);
    };
    if (width > 1) compare(1, width - 1);
    if (row + 1 < height) compare(width, width);
    if (bare.empty()) continue;
    find_steps(&pixels[4 * first], &bare[4 * first], kFluidStep, channels.data(), found.data(), width);
    add_marks(found.data(), &marks[first], width);
  }
  return marks;
}

/// The smallest area around all marks.
ScreenArea area_of(std::span<const std::uint8_t> marks, ImageSize size) {
  const auto width = static_cast<std::size_t>(size.width), height = static_cast<std::size_t>(size.height);
  std::vector<std::uint8_t> columns(width);
  std::size_t bottom = height, top = 0;
  for (std::size_t row = 0; row < height; ++row) {
    const std::uint8_t* begin = &marks[row * width];
    if (std::memchr(begin, 1, width) == nullptr) continue;
    add_marks(begin, columns.data(), width);
    bottom = std::min(bottom, row);
    top = row;
  }
  if (bottom == height) return {};
  const auto left = std::ranges::find(columns, 1) - columns.begin();
  const auto right = columns.rend() - std::find(columns.rbegin(), columns.rend(), 1);
  return {static_cast<int>(left), static_cast<int>(bottom), static_cast<int>(right - left),
          static_cast<int>(top - bottom + 1)};
}

}  // namespace

FinePixels find_fine_pixels(std::span<const std::uint8_t> pixels, std::span<const std::uint8_t> bare, ImageSize size) {
  const std::vector<std::uint8_t> marks = marks_of(pixels, bare, size);
  FinePixels fine;
  const ScreenArea marked = area_of(marks, size);
  if (marked.width == 0) return fine;
  const int left = std::max(marked.left - 1, 0), bottom = std::max(marked.bottom - 1, 0);
  fine.area = {left, bottom, marked.left + marked.width - left, marked.bottom + marked.height - bottom};
  for (int row = bottom; row < bottom + fine.area.height; ++row) {
    const auto begin = marks.begin() + static_cast<std::ptrdiff_t>(row) * size.width + left;
    fine.is_fine.insert(fine.is_fine.end(), begin, begin + fine.area.width);
  }
  fine.is_corner = fine.is_fine;
  const auto width = static_cast<std::size_t>(fine.area.width);
  for_set(fine.is_fine, [&](std::size_t i) {
    const bool is_first = i % width == 0;
    if (!is_first) fine.is_corner[i - 1] = 1;
    if (i < width) return;
    fine.is_corner[i - width] = 1;
    if (!is_first) fine.is_corner[i - width - 1] = 1;
  });
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

std::vector<std::uint8_t> with_backdrop(const FinePixels& fine, std::span<const std::uint8_t> middles,
                                        std::span<const std::uint8_t> backdrop, ImageSize size) {
  std::vector<std::uint8_t> result(middles.begin(), middles.end());
  const auto width = static_cast<std::size_t>(fine.area.width), whole_width = static_cast<std::size_t>(size.width);
  const auto left = static_cast<std::size_t>(fine.area.left), bottom = static_cast<std::size_t>(fine.area.bottom);
  for_set(fine.is_corner, [&](std::size_t i) {
    std::memcpy(&result[4 * i], &backdrop[4 * ((bottom + i / width) * whole_width + left + i % width)], 4);
  });
  return result;
}

std::vector<std::uint32_t> at_corners(const FinePixels& fine, std::uint32_t corner, std::uint32_t other) {
  std::vector<std::uint32_t> numbers(fine.is_corner.size(), other);
  for_set(fine.is_corner, [&](std::size_t i) { numbers[i] = corner; });
  return numbers;
}

std::vector<std::uint8_t> with_corners(const FinePixels& fine, std::span<const std::uint8_t> middles,
                                       std::span<const std::uint8_t> corners) {
  std::vector<std::uint8_t> result(middles.begin(), middles.end());
  const auto width = static_cast<std::size_t>(fine.area.width);
  for_set(fine.is_fine, [&](std::size_t i) {
    const std::size_t left = i % width > 0 ? i - 1 : i;
    const std::size_t down = i >= width ? width : 0;
    for (std::size_t channel = 0; channel < 4; ++channel) {
      const auto at = [&](std::size_t pixel) { return unsigned{corners[4 * pixel + channel]}; };
      const unsigned sum = 4U * middles[4 * i + channel] + at(i) + at(left) + at(i - down) + at(left - down);
      result[4 * i + channel] = static_cast<std::uint8_t>((sum + 4) / 8);
    }
  });
  return result;
}

}  // namespace thinwall
