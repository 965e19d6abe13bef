#include "renderer/picture/FloorCover.hpp"

#include <cmath>
#include <limits>

#include "renderer/picture/MapBlur.hpp"

namespace thinwall {
namespace {

constexpr std::size_t kSide = FloorCover::kResolution;
constexpr float kNothing = std::numeric_limits<float>::infinity();

/// By the distance from the middle, of exp(-0.14 i^2) and exp(-0.15 i^2) the parts of their sums: the light from all
/// around is blurred widely, the key light's shadow narrowly.
constexpr std::size_t kTaps = 5;
constexpr std::array<std::array<float, kTaps>, 2> kWeights{
    {{0.2145297F, 0.1865031F, 0.1225413F, 0.0608522F, 0.0228385F},
     {0.2212901F, 0.1904661F, 0.1214466F, 0.0573673F, 0.0200750F}}};
constexpr std::array<std::size_t, 2> kApart{2, 1};  // texels between taps

/// How much of the light from all around is taken by what lies `height` above the floor, in units of the scene's size.
float taken_around(float height) {
  return std::exp(-7.0F * std::max(height, 0.0F));
}

}  // namespace

FloorCover::FloorCover() {
  lowest_.resize(std::size_t{kFine} * kFine, kNothing);
  shadowed_.resize(std::size_t{kFine} * kFine);
  for (std::vector<float>& plane : planes_) plane.resize(kSide * kSide);
  memory_.resize(kSide * kSide);
  pixels_.resize(2 * kSide * kSide);
}

void FloorCover::begin(const FloorMap& map, Vector3 toward_light) {
  constexpr double kHorizon = 0.05;
  map_ = map;
  has_shadow_ = toward_light.z > kHorizon;
  slant_ = has_shadow_ ? Vector3{toward_light.x / toward_light.z, toward_light.y / toward_light.z, 0} : Vector3{};
  for (int row = covered_.first_row; row < covered_.end_row; ++row) {
    const std::ptrdiff_t first = std::ptrdiff_t{kFine} * row;
    std::fill_n(lowest_.begin() + first, kFine, kNothing);
    std::fill_n(shadowed_.begin() + first, kFine, std::uint8_t{0});
  }
  covered_ = {};
}

void FloorCover::Window::add(const MapSpan& span) {
  first_row = std::min(first_row, span.row);
  end_row = std::max(end_row, span.row + 1);
  first = std::min(first, span.first);
  end = std::max(end, span.end);
}

FloorCover::Foot FloorCover::foot_of(const Float3& position) const {
  const Vector3 place = vector3(position);
  const double above = place.z - map_.height;
  const double texels = 0.5 * kFine / map_.half_width;
  const double x = place.x - map_.center.x, y = place.y - map_.center.y;
  const auto at = [&](double across, double along) {
    return MapCorner{0.5 * kFine + texels * across, 0.5 * kFine + texels * along, above / map_.size};
  };
  return {at(x, y), at(x - above * slant_.x, y - above * slant_.y)};
}

void FloorCover::lay(std::span<const std::uint32_t> corners, bool is_closed) {
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    const Foot &a = feet_[corners[i]], &b = feet_[corners[i + 1]], &c = feet_[corners[i + 2]];
    const std::array<MapCorner, 3> below{a.below, b.below, c.below}, along{a.along, b.along, c.along};
    if (!is_closed || turn_of(below) < 0) {
      for_spans(below, kFine, [&](const MapSpan& span) {
        covered_.add(span);
        float* row = lowest_.data() + std::size_t{kFine} * static_cast<std::size_t>(span.row);
        for (int x = span.first; x < span.end; ++x) {
          row[x] = std::min(row[x], static_cast<float>(span.value + (x - span.first) * span.step));
        }
      });
    }
    if (!has_shadow_ || (is_closed && !(turn_of(along) < 0))) continue;
    for_spans(along, kFine, [&](const MapSpan& span) {
      covered_.add(span);
      std::uint8_t* row = shadowed_.data() + std::size_t{kFine} * static_cast<std::size_t>(span.row);
      std::fill(row + span.first, row + span.end, std::uint8_t{1});
    });
  }
}

/// The mean of each texel's parts.
void FloorCover::shrink() {
  constexpr float kPart = 1.0F / (kParts * kParts);
  for (std::vector<float>& plane : planes_) std::ranges::fill(plane, 0.0F);
  for (int row = covered_.first_row; row < covered_.end_row; ++row) {
    const auto first = std::size_t{kFine} * static_cast<std::size_t>(row);
    const std::size_t texels = kSide * static_cast<std::size_t>(row / kParts);
    for (auto i = static_cast<std::size_t>(covered_.first); i < static_cast<std::size_t>(covered_.end); ++i) {
      const std::size_t texel = texels + i / kParts;
      if (lowest_[first + i] < kNothing) planes_[0][texel] += kPart * taken_around(lowest_[first + i]);
      planes_[1][texel] += kPart * shadowed_[first + i];
    }
  }
}

std::span<const std::uint8_t> FloorCover::blurred() {
  shrink();
  for (std::size_t channel = 0; channel < 2; ++channel) {
    blur_map<kSide>(planes_[channel], kWeights[channel], kApart[channel], memory_);
    for (std::size_t i = 0; i < kSide * kSide; ++i) {
      pixels_[2 * i + channel] = byte_of(planes_[channel][i]);
    }
  }
  return pixels_;
}

}  // namespace thinwall
