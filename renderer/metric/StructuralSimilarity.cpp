#include "renderer/metric/StructuralSimilarity.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "renderer/metric/ColorSpace.hpp"
#include "renderer/metric/Lanes.hpp"
#include "renderer/metric/SeparableFilter.hpp"
#include "renderer/metric/Tiles.hpp"

namespace thinwall {
namespace {

using lanes::Lanes;

constexpr int kTile = 128;
constexpr int kRadius = 5;
constexpr int kPitch = kTile + 2 * kRadius + 6;  // a multiple of the lanes
static_assert(kPitch % lanes::kCount == 0);
constexpr float kRange = 100;
constexpr float kFirst = 0.01F * kRange * 0.01F * kRange;
constexpr float kSecond = 0.03F * kRange * 0.03F * kRange;
constexpr double kWeights[3] = {0.5, 0.25, 0.25};

Kernel window() {
  Kernel kernel;
  double sum = 0;
  const auto weight = [](int k) { return std::exp(-0.5 * k * k / (1.5 * 1.5)); };
  for (int k = -kRadius; k <= kRadius; ++k) sum += weight(k);
  for (int k = 0; k <= kRadius; ++k) kernel.weights.push_back(static_cast<float>(weight(k) / sum));
  return kernel;
}

/// Linear sRGB to L*, a*, b* in place.
THINWALL_FOR_ALL_PROCESSORS
void to_lab(float* red, float* green, float* blue, int count, const float (&matrix)[3][3]) {
  for (int x = 0; x < count; x += lanes::kCount) {
    Lanes r;
    Lanes g;
    Lanes b;
    lanes::load(r, red + x);
    lanes::load(g, green + x);
    lanes::load(b, blue + x);
    Lanes f[3];
    for (int c = 0; c < 3; ++c) {
      const Lanes t = matrix[c][0] * r + matrix[c][1] * g + matrix[c][2] * b;
      Lanes root = t < 1e-4F ? t * 0.0F + 1e-4F : t;
      lanes::cube_root(root);
      f[c] = t > 0.008856451679F ? root : t * 7.787037037F + 0.1379310345F;
    }
    lanes::store(116.0F * f[1] - 16.0F, red + x);
    lanes::store(500.0F * (f[0] - f[1]), green + x);
    lanes::store(200.0F * (f[1] - f[2]), blue + x);
  }
}

using Plane = std::vector<float>;

/// L*, a*, b* of a tile with its margins: (rows x kPitch) each.
struct LabTile {
  Plane planes[3];
};

LabTile lab_tile(const Image& image, const PixelRegion& region) {
  float matrix[3][3];
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t c = 0; c < 3; ++c) {
      matrix[row][c] = static_cast<float>(rgb_to_xyz()[row][c] / white_xyz()[row]);
    }
  }
  const std::array<float, 256>& levels = linear_levels();
  LabTile tile;
  const int rows = region.height() + 2 * kRadius;
  for (Plane& plane : tile.planes) plane.resize(static_cast<std::size_t>(rows) * kPitch);
  for (int row = 0; row < rows; ++row) {
    const int y = std::clamp(region.top - kRadius + row, 0, image.size.height - 1);
    const auto start = static_cast<std::size_t>(row) * kPitch;
    for (int column = 0; column < kPitch; ++column) {
      const int x = std::clamp(region.left - kRadius + column, 0, image.size.width - 1);
      const std::size_t pixel =
          3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.size.width) + static_cast<std::size_t>(x));
      for (std::size_t c = 0; c < 3; ++c) {
        tile.planes[c][start + static_cast<std::size_t>(column)] = levels[image.pixels[pixel + c]];
      }
    }
    to_lab(&tile.planes[0][start], &tile.planes[1][start], &tile.planes[2][start], kPitch, matrix);
  }
  return tile;
}

/// (rows x kTile), the window's mean around each pixel of the tile.
Plane smoothed(const Plane& plane, const Kernel& kernel, int rows) {
  Plane passed(static_cast<std::size_t>(rows + 2 * kRadius) * kTile);
  filter({.from = plane.data() + kRadius,
          .pitch = kPitch,
          .stride = 1,
          .to = passed.data(),
          .width = kTile,
          .rows = rows + 2 * kRadius},
         kernel);
  Plane result(static_cast<std::size_t>(rows) * kTile);
  filter({.from = passed.data() + static_cast<std::ptrdiff_t>(kRadius) * kTile,
          .pitch = kTile,
          .stride = kTile,
          .to = result.data(),
          .width = kTile,
          .rows = rows},
         kernel);
  return result;
}

Plane product(const Plane& a, const Plane& b) {
  Plane result(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) result[i] = a[i] * b[i];
  return result;
}

/// The similarity of a channel around each pixel: (rows x kTile).
Plane similarity(const Plane& a, const Plane& b, const Kernel& kernel, int rows) {
  const Plane mean_a = smoothed(a, kernel, rows);
  const Plane mean_b = smoothed(b, kernel, rows);
  const Plane square_a = smoothed(product(a, a), kernel, rows);
  const Plane square_b = smoothed(product(b, b), kernel, rows);
  const Plane mixed = smoothed(product(a, b), kernel, rows);
  Plane result(mean_a.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    const float means = mean_a[i] * mean_b[i];
    const float mean_squares = mean_a[i] * mean_a[i] + mean_b[i] * mean_b[i];
    const float variances = square_a[i] + square_b[i] - mean_squares;
    result[i] =
        (2 * means + kFirst) * (2 * (mixed[i] - means) + kSecond) / ((mean_squares + kFirst) * (variances + kSecond));
  }
  return result;
}

struct TileSum {
  double loss = 0;  // 1 - similarity, summed over the tile's pixels
  double lowest = 1;
};

TileSum judge_tile(const Image& first, const Image& second, const PixelRegion& region, const Kernel& kernel) {
  const LabTile a = lab_tile(first, region);
  const LabTile b = lab_tile(second, region);
  Plane channels[3];
  for (std::size_t c = 0; c < 3; ++c) channels[c] = similarity(a.planes[c], b.planes[c], kernel, region.height());
  TileSum sum;
  for (int y = 0; y < region.height(); ++y) {
    for (int x = 0; x < region.width(); ++x) {
      const auto at = static_cast<std::size_t>(y * kTile + x);
      double value = 0;
      for (std::size_t c = 0; c < 3; ++c) value += kWeights[c] * channels[c][at];
      sum.loss += 1 - value;
      sum.lowest = std::min(sum.lowest, value);
    }
  }
  return sum;
}

}  // namespace

StructuralSimilarity structural_similarity(const Image& first, const Image& second, int threads) {
  assert(first.size == second.size);
  const Kernel kernel = window();
  std::vector<PixelRegion> tiles;
  for (const PixelRegion& tile : tiles_of(first.size, kTile)) {
    if (differs_in(first, second, grown(tile, kRadius, first.size))) tiles.push_back(tile);
  }
  std::vector<TileSum> sums(tiles.size());
  for_each_in_parallel(
      tiles.size(), [&](std::size_t i) { sums[i] = judge_tile(first, second, tiles[i], kernel); }, threads);
  StructuralSimilarity result;
  double loss = 0;
  for (const TileSum& sum : sums) {
    loss += sum.loss;
    result.lowest = std::min(result.lowest, sum.lowest);
  }
  result.mean = 1 - loss / (static_cast<double>(first.size.width) * first.size.height);
  return result;
}

}  // namespace thinwall
