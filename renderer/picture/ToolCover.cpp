#include "renderer/picture/ToolCover.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "renderer/picture/MapBlur.hpp"
#include "renderer/shape/ScreenArea.hpp"

namespace thinwall {
namespace {

constexpr std::size_t kSide = ToolCover::kResolution;
constexpr std::array<float, 2> kNothing{std::numeric_limits<float>::max(), std::numeric_limits<float>::lowest()};

/// The binomial 1 4 6 4 1, of variance 1. With steps twice as wide each time it adds four times as much, so that
/// kSpreads are the roots of 1, 5, 21 and 85.
constexpr std::array<float, 3> kWeights{6.0F / 16, 4.0F / 16, 1.0F / 16};

/// How much less a wider blur counts for the depth, wherever a narrower one tells it.
constexpr float kFadeOfWider = 1.0F / 32;

/// Texels by which the middle of a tool lies before where the light leaves it at most: of a shaft along the light its
/// end throws the shadow that is seen.
constexpr double kDeepestMiddle = 6;

/// Of less than this part of a texel depth is not told.
constexpr float kLeastWeight = 1e-9F;

}  // namespace

double ToolCover::texels_over_depth(const std::array<float, 16>& shadow_matrix) {
  const auto growth = [&](std::size_t axis) {  // over metres
    return std::hypot(shadow_matrix[axis], shadow_matrix[4 + axis], shadow_matrix[8 + axis]);
  };
  return kResolution * std::sqrt(growth(0) * growth(1)) / growth(2);
}

ToolCover::ToolCover() {
  for (std::size_t end = 0; end < 2; ++end) met_[end].resize(std::size_t{kFine} * kFine, kNothing[end]);
  for (std::vector<float>* plane : {&covered_, &covered_depths_, &memory_, &weights_, &depths_}) {
    plane->resize(kSide * kSide);
  }
  taken_.resize(4 * kSide * kSide);
}

void ToolCover::clear() {
  for (std::size_t end = 0; end < 2; ++end) {
    for (int row = first_row_; row < end_row_; ++row) {
      std::fill_n(met_[end].begin() + std::ptrdiff_t{kFine} * row, kFine, kNothing[end]);
    }
  }
  first_row_ = kFine;
  end_row_ = 0;
}

void ToolCover::lay(std::span<const ToolVertex> vertices, std::span<const std::uint32_t> corners,
                    const std::array<float, 16>& shadow_matrix) {
  clear();
  seen_.resize(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const ClipPlace place = clip_place(vertices[i].position, shadow_matrix);
    seen_[i] = {kFine * place[0], kFine * place[1], place[2]};
  }
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    const std::array<MapCorner, 3> triangle{seen_[corners[i]], seen_[corners[i + 1]], seen_[corners[i + 2]]};
    const bool faces_away = turn_of(triangle) < 0;
    float* met = met_[faces_away ? 1 : 0].data();
    for_spans(triangle, kFine, [&](const MapSpan& span) {
      first_row_ = std::min(first_row_, span.row);
      end_row_ = std::max(end_row_, span.row + 1);
      float* row = met + std::ptrdiff_t{kFine} * span.row;
      for (int x = span.first; x < span.end; ++x) {
        const auto depth = static_cast<float>(span.value + (x - span.first) * span.step);
        row[x] = faces_away ? std::max(row[x], depth) : std::min(row[x], depth);
      }
    });
  }
  shrink(static_cast<float>(kDeepestMiddle / texels_over_depth(shadow_matrix)));
  blur();
}

/// The mean of each texel's parts. `deepest`: depth by which the middle lies before the end at most.
void ToolCover::shrink(float deepest) {
  constexpr float kPart = 1.0F / (kParts * kParts);
  std::ranges::fill(covered_, 0.0F);
  std::ranges::fill(covered_depths_, 0.0F);
  for (int row = first_row_; row < end_row_; ++row) {
    const std::ptrdiff_t start = std::ptrdiff_t{kFine} * row;
    const float *first = met_[0].data() + start, *last = met_[1].data() + start;
    const std::size_t texels = kSide * static_cast<std::size_t>(row / kParts);
    for (std::size_t i = 0; i < kFine; ++i) {
      if (first[i] > last[i]) continue;
      const std::size_t texel = texels + i / kParts;
      covered_[texel] += kPart;
      covered_depths_[texel] += kPart * (last[i] - std::min(0.5F * (last[i] - first[i]), deepest));
    }
  }
}

void ToolCover::blur() {
  std::ranges::fill(weights_, 0.0F);
  std::ranges::fill(depths_, 0.0F);
  float counts = 1;
  for (std::size_t width = 0; width < kSpreads.size(); ++width, counts *= kFadeOfWider) {
    const std::size_t apart = std::size_t{1} << width;
    for (std::vector<float>* plane : {&covered_, &covered_depths_}) {
      blur_map<kSide>(*plane, kWeights, apart, memory_);
    }
    for (std::size_t i = 0; i < kSide * kSide; ++i) {
      taken_[4 * i + width] = byte_of(std::min(covered_[i], 1.0F));
      weights_[i] += counts * covered_[i];
      depths_[i] += counts * covered_depths_[i];
    }
  }
  for (std::size_t i = 0; i < kSide * kSide; ++i) {
    depths_[i] = weights_[i] > kLeastWeight ? depths_[i] / weights_[i] : 1.0F;
  }
}

}  // namespace thinwall
