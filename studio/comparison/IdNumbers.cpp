#include "studio/comparison/IdNumbers.hpp"

#include <cstddef>
#include <cstdint>

namespace thinwall {
namespace {

constexpr std::uint16_t kOpaque = 65535;
constexpr std::uint16_t kStep = 257;  // of 16 bits for each level of 8

DeepImage of_16_bits(const MediaFile& file) {
  return file.deep ? *file.deep : deepened(file.image);
}

bool is_grey(const DeepImage& image) {
  const auto& values = image.values;
  for (std::size_t i = 0; i < values.size(); i += 4) {
    if (values[i] != values[i + 1] || values[i] != values[i + 2] || values[i + 3] != kOpaque) return false;
  }
  return true;
}

bool has_colors_of_8_bits(const DeepImage& image) {
  for (std::size_t i = 0; i < image.values.size(); ++i) {
    if (i % 4 != 3 && image.values[i] % kStep != 0) return false;
  }
  return true;
}

FloatImage numbers_of_grey(const DeepImage& image, std::uint16_t step) {
  FloatImage ids{.size = image.size, .channels = 1, .values = {}};
  for (std::size_t i = 0; i < image.values.size(); i += 4)
    ids.values.push_back(static_cast<float>(image.values[i] / step));
  return ids;
}

FloatImage numbers_of_colors(const Image& image) {
  FloatImage ids{.size = image.size, .channels = 1, .values = {}};
  for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
    ids.values.push_back(static_cast<float>(image.pixels[i] + 256 * image.pixels[i + 1] + 65536 * image.pixels[i + 2]));
  }
  return ids;
}

}  // namespace

std::optional<std::pair<FloatImage, FloatImage>> id_numbers(const MediaFile& first, const MediaFile& second) {
  const DeepImage one = of_16_bits(first);
  const DeepImage two = of_16_bits(second);
  if (is_grey(one) && is_grey(two)) {
    const std::uint16_t step = first.deep || second.deep ? 1 : kStep;
    return std::pair(numbers_of_grey(one, step), numbers_of_grey(two, step));
  }
  if (!has_colors_of_8_bits(one) || !has_colors_of_8_bits(two)) return std::nullopt;
  return std::pair(numbers_of_colors(first.image), numbers_of_colors(second.image));
}

}  // namespace thinwall
