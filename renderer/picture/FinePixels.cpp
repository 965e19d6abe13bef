#include "renderer/picture/FinePixels.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "renderer/image/AllProcessors.hpp"

namespace thinwall {
namespace {

/// Smaller steps between neighbours, in 8-bit levels, look smooth; dithering alone makes steps of one.
constexpr std::uint8_t kStep = 14;

/// Fluid that changes its pixel by less, in 8-bit levels, shows no slope.
constexpr std::uint8_t kFluidStep = 2;

/// Marks pixels of which a channel of `a` and `b` differs by more than `step`: (count), and (4 x count) for what is
/// found on the way.
THINWALL_FOR_ALL_PROCESSORS
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

THINWALL_FOR_ALL_PROCESSORS
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

/// Of the lower left pixel of an area among those of the picture.
std::size_t first_place(const ScreenArea& area, std::size_t width) {
  return static_cast<std::size_t>(area.bottom) * width + static_cast<std::size_t>(area.left);
}

/// Marks of what is within `area` of a picture, (area.width x area.height).
std::vector<std::uint8_t> marks_of(std::span<const std::uint8_t> picture, std::span<const std::uint8_t> bare,
                                   std::size_t picture_width, const ScreenArea& area) {
  const auto width = static_cast<std::size_t>(area.width), height = static_cast<std::size_t>(area.height);
  std::vector<std::uint8_t> marks(width * height), channels(4 * width), found(width);
  for (std::size_t row = 0; row < height; ++row) {
    const std::size_t first = row * width;
    const std::size_t place = first_place(area, picture_width) + row * picture_width;
    // With the pixel that many on, in the picture and among the marks.
    const auto compare = [&](std::size_t on, std::size_t mark_on, std::size_t count) {
      find_steps(&picture[4 * place], &picture[4 * (place + on)], kStep, channels.data(), found.data(), count);
      add_marks(found.data(), &marks[first], count);
      add_marks(found.data(), &marks[first + mark_on], count);
    };
    if (width > 1) compare(1, 1, width - 1);
    if (row + 1 < height) compare(picture_width, width, width);
    if (bare.empty()) continue;
    find_steps(&picture[4 * place], &bare[4 * place], kFluidStep, channels.data(), found.data(), width);
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

FinePixels find_fine_pixels(std::span<const std::uint8_t> picture, std::span<const std::uint8_t> bare, int width,
                            const ScreenArea& area) {
  const std::vector<std::uint8_t> marks = marks_of(picture, bare, static_cast<std::size_t>(width), area);
  FinePixels fine;
  const ScreenArea marked = area_of(marks, {area.width, area.height});
  if (marked.width == 0) return fine;
  const int left = std::max(marked.left - 1, 0), bottom = std::max(marked.bottom - 1, 0);
  fine.area = {area.left + left, area.bottom + bottom, marked.left + marked.width - left,
               marked.bottom + marked.height - bottom};
  for (int row = bottom; row < bottom + fine.area.height; ++row) {
    const auto begin = marks.begin() + static_cast<std::ptrdiff_t>(row) * area.width + left;
    fine.is_fine.insert(fine.is_fine.end(), begin, begin + fine.area.width);
  }
  fine.is_corner = fine.is_fine;
  const auto row_length = static_cast<std::size_t>(fine.area.width);
  for_set(fine.is_fine, [&](std::size_t i) {
    const bool is_first = i % row_length == 0;
    if (!is_first) fine.is_corner[i - 1] = 1;
    if (i < row_length) return;
    fine.is_corner[i - row_length] = 1;
    if (!is_first) fine.is_corner[i - row_length - 1] = 1;
  });
  return fine;
}

std::vector<std::uint8_t> with_backdrop(const FinePixels& fine, std::span<const std::uint8_t> picture,
                                        std::span<const std::uint8_t> backdrop, int width) {
  const auto picture_width = static_cast<std::size_t>(width), row_length = static_cast<std::size_t>(fine.area.width);
  const std::size_t first = first_place(fine.area, picture_width);
  std::vector<std::uint8_t> result;
  result.reserve(4 * fine.is_corner.size());
  for (int row = 0; row < fine.area.height; ++row) {
    const auto begin =
        picture.begin() + 4 * static_cast<std::ptrdiff_t>(first + picture_width * static_cast<std::size_t>(row));
    result.insert(result.end(), begin, begin + 4 * static_cast<std::ptrdiff_t>(row_length));
  }
  for_set(fine.is_corner, [&](std::size_t i) {
    std::memcpy(&result[4 * i], &backdrop[4 * (first + i / row_length * picture_width + i % row_length)], 4);
  });
  return result;
}

std::vector<std::uint32_t> at_corners(const FinePixels& fine, std::uint32_t corner, std::uint32_t other) {
  std::vector<std::uint32_t> numbers(fine.is_corner.size(), other);
  for_set(fine.is_corner, [&](std::size_t i) { numbers[i] = corner; });
  return numbers;
}

void add_corners(const FinePixels& fine, std::span<const std::uint8_t> corners, std::span<std::uint8_t> picture,
                 int width) {
  const auto picture_width = static_cast<std::size_t>(width), row_length = static_cast<std::size_t>(fine.area.width);
  const std::size_t first = first_place(fine.area, picture_width);
  for_set(fine.is_fine, [&](std::size_t i) {
    const std::size_t left = i % row_length > 0 ? i - 1 : i;
    const std::size_t down = i >= row_length ? row_length : 0;
    std::uint8_t* pixel = &picture[4 * (first + i / row_length * picture_width + i % row_length)];
    for (std::size_t channel = 0; channel < 4; ++channel) {
      const auto at = [&](std::size_t place) { return unsigned{corners[4 * place + channel]}; };
      const unsigned sum = 4U * pixel[channel] + at(i) + at(left) + at(i - down) + at(left - down);
      pixel[channel] = static_cast<std::uint8_t>((sum + 4) / 8);
    }
  });
}

}  // namespace thinwall
