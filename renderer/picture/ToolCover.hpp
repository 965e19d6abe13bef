#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/picture/MapRaster.hpp"
#include "renderer/shape/ToolShape.hpp"

namespace thinwall {

/// What tools take of the light of a large lamp far away: a map of them as the lamp sees them, blurred by growing
/// widths. The farther a place lies behind them, the more of the lamp it sees past them and the wider the blur that
/// tells how much. Made by the processor, see for_spans.
class ToolCover {
 public:
  static constexpr int kResolution = 128;

  /// Standard deviations of the blurs, texels.
  static constexpr std::array<double, 4> kSpreads{1, 2.23607, 4.58258, 9.21954};

  /// How many texels the map is wide where it is as deep as from depth 0 to 1. `shadow_matrix`: as of lay().
  static double texels_over_depth(const std::array<float, 16>& shadow_matrix);

  ToolCover();

  /// Makes the map anew. `corners`: (3 x triangles), counter-clockwise from outside; they close volumes.
  /// `shadow_matrix`: world to map, 0 to 1 on every axis, of parallel rays.
  void lay(std::span<const ToolVertex> vertices, std::span<const std::uint32_t> corners,
           const std::array<float, 16>& shadow_matrix);

  /// (4 x width x height): of each blur the part of the light that is taken, 255 for the whole.
  std::span<const std::uint8_t> taken() const { return taken_; }

  /// (width x height): depth of the middle between where the light meets tools first and where it leaves them last, but
  /// close to the latter, 0 to 1 as of a shadow map; around tools as at their border, whose shadow is seen there, and 1
  /// where there are none.
  std::span<const float> depths() const { return depths_; }

 private:
  // As of FloorCover.
  static constexpr int kParts = 3;
  static constexpr int kFine = kParts * kResolution;

  void clear();
  void shrink(float deepest);
  void blur();

  std::vector<MapCorner> seen_;            // (vertices)
  std::array<std::vector<float>, 2> met_;  // (kFine x kFine), depths where light comes first and where it leaves last
  int first_row_ = kFine, end_row_ = 0;    // of those where anything covers, the second not with
  std::vector<float> covered_, covered_depths_;  // (width x height); the second times the first
  std::vector<float> memory_;                    // of blur_map
  std::vector<float> weights_;                   // (width x height), of the depths
  std::vector<std::uint8_t> taken_;
  std::vector<float> depths_;
};

}  // namespace thinwall
