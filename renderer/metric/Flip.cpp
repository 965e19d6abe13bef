#include "renderer/metric/Flip.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "renderer/metric/ColorSpace.hpp"
#include "renderer/metric/FlipTile.hpp"

namespace thinwall {
namespace {

std::size_t pixel_count(ImageSize size) {
  return static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
}

std::size_t pixel_index(ImageSize size, int x, int y) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(x);
}

LinearRow linear_rows(const Image& image) {
  return [&image](int y, int left, int count, float* to) {
    const std::array<float, 256>& levels = linear_levels();
    const std::uint8_t* from = &image.pixels[3 * pixel_index(image.size, left, y)];
    for (int x = 0; x < count; ++x) {
      to[x] = levels[from[3 * x]];
      to[count + x] = levels[from[3 * x + 1]];
      to[2 * count + x] = levels[from[3 * x + 2]];
    }
  };
}

// The filmic curve of the Academy's colour encoding system as fitted by Narkowicz, for light that is scaled by 0.6:
// (a x^2 + b x) / (c x^2 + d x + e).
constexpr double kToneScale = 0.6;
constexpr double kToneA = 2.51 * kToneScale * kToneScale;
constexpr double kToneB = 0.03 * kToneScale;
constexpr double kToneC = 2.43 * kToneScale * kToneScale;
constexpr double kToneD = 0.59 * kToneScale;
constexpr double kToneE = 0.14;

float tone_mapped(float light) {
  constexpr auto a = static_cast<float>(kToneA);
  constexpr auto b = static_cast<float>(kToneB);
  constexpr auto c = static_cast<float>(kToneC);
  constexpr auto d = static_cast<float>(kToneD);
  constexpr auto e = static_cast<float>(kToneE);
  const float square = light * light;
  return std::clamp((a * square + b * light) / (c * square + d * light + e), 0.0F, 1.0F);
}

bool is_finite_pixel(const FloatImage& image, std::size_t pixel) {
  return std::isfinite(image.values[3 * pixel]) && std::isfinite(image.values[3 * pixel + 1]) &&
         std::isfinite(image.values[3 * pixel + 2]);
}

LinearRow tone_mapped_rows(const FloatImage& image, float scale) {
  return [&image, scale](int y, int left, int count, float* to) {
    const float* from = &image.values[3 * pixel_index(image.size, left, y)];
    for (int x = 0; x < count; ++x) {
      for (int channel = 0; channel < 3; ++channel) {
        const float light = from[3 * x + channel] * scale;
        to[channel * count + x] = std::isfinite(light) ? tone_mapped(light) : 0.0F;
      }
    }
  };
}

/// Errors of the tiles that `wanted` names, the larger one where the map holds one already.
void add_errors(const LinearRow& reference, const LinearRow& test, ImageSize size, const FlipOptions& options,
                const std::function<bool(const PixelRegion&)>& wanted, std::vector<float>& map) {
  const FlipKernels kernels = flip_kernels(options.pixels_per_degree);
  std::vector<PixelRegion> tiles;
  for (const PixelRegion& tile : tiles_of(size, kFlipTile)) {
    if (wanted(grown(tile, kernels.margin, size))) tiles.push_back(tile);
  }
  for_each_in_parallel(
      tiles.size(),
      [&](std::size_t index) {
        thread_local FlipWorkspace workspace;
        thread_local std::vector<float> errors;
        const PixelRegion& tile = tiles[index];
        flip_tile(reference, test, size, tile, kernels, workspace, errors);
        for (int y = 0; y < tile.height(); ++y) {
          const float* from = &errors[static_cast<std::size_t>(y * tile.width())];
          float* to = &map[pixel_index(size, tile.left, tile.top + y)];
          for (int x = 0; x < tile.width(); ++x) to[x] = std::max(to[x], from[x]);
        }
      },
      options.threads);
}

FlipResult pooled(std::vector<float> map) {
  FlipResult result{.map = std::move(map)};
  double sum = 0;
  std::vector<float> errors;
  for (const float error : result.map) {
    if (error == 0) continue;
    sum += error;
    errors.push_back(error);
  }
  const std::size_t pixels = result.map.size();
  if (errors.empty()) return result;
  result.mean = sum / static_cast<double>(pixels);
  result.largest = *std::max_element(errors.begin(), errors.end());
  // The rank among all pixels, most of which may be zero.
  const auto rank = static_cast<std::size_t>(0.99 * static_cast<double>(pixels - 1));
  const std::size_t zeros = pixels - errors.size();
  if (rank >= zeros) {
    const auto place = errors.begin() + static_cast<std::ptrdiff_t>(rank - zeros);
    std::nth_element(errors.begin(), place, errors.end());
    result.percentile_99 = *place;
  }
  return result;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

}  // namespace

FlipResult flip(const Image& reference, const Image& test, const FlipOptions& options) {
  assert(reference.size == test.size);
  std::vector<float> map(pixel_count(reference.size), 0.0F);
  add_errors(
      linear_rows(reference), linear_rows(test), reference.size, options,
      [&](const PixelRegion& region) { return differs_in(reference, test, region); }, map);
  return pooled(std::move(map));
}

ExposureRange exposure_range(const FloatImage& reference) {
  std::vector<double> brightness;
  for (std::size_t pixel = 0; pixel < pixel_count(reference.size); ++pixel) {
    if (!is_finite_pixel(reference, pixel)) continue;
    double luminance = 0;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      luminance += rgb_to_xyz()[1][channel] * reference.values[3 * pixel + channel];
    }
    brightness.push_back(luminance);
  }
  if (brightness.empty()) return {};
  // Where the curve reaches 0.85: a quadratic equation, whose larger root is meant.
  constexpr double kReached = 0.85;
  const double a = kToneA - kReached * kToneC;
  const double b = kToneB - kReached * kToneD;
  const double c = -kReached * kToneE;
  const double root = (-b + std::sqrt(b * b - 4 * a * c)) / (2 * a);
  // A picture that is black has no exposure of its own.
  const auto exposure = [&](double luminance) { return luminance > 0 ? std::log2(root / luminance) : 0.0; };
  ExposureRange range{.first = exposure(*std::max_element(brightness.begin(), brightness.end()))};
  const double middle = median(std::move(brightness));
  range.last = middle > 0 ? exposure(middle) : range.first;
  range.count = std::max(2, static_cast<int>(std::ceil(range.last - range.first)));
  return range;
}

FlipResult flip_high_range(const FloatImage& reference, const FloatImage& test, const FlipOptions& options) {
  assert(reference.size == test.size && reference.channels == 3 && test.channels == 3);
  const ExposureRange range = exposure_range(reference);
  std::vector<float> map(pixel_count(reference.size), 0.0F);
  for (int i = 0; i < range.count; ++i) {
    const double exposure = range.first + i * (range.last - range.first) / (range.count - 1);
    const auto scale = static_cast<float>(std::exp2(exposure));
    add_errors(
        tone_mapped_rows(reference, scale), tone_mapped_rows(test, scale), reference.size, options,
        [](const PixelRegion&) { return true; }, map);
  }
  for (std::size_t pixel = 0; pixel < map.size(); ++pixel) {
    if (is_finite_pixel(reference, pixel) != is_finite_pixel(test, pixel)) map[pixel] = 1;
  }
  return pooled(std::move(map));
}

}  // namespace thinwall
