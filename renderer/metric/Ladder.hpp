#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "renderer/image/ImageDifference.hpp"
#include "renderer/metric/Drift.hpp"
#include "renderer/metric/Flip.hpp"
#include "renderer/metric/PixelTolerance.hpp"
#include "renderer/metric/StructuralSimilarity.hpp"

namespace thinwall {

/// What two pictures may differ by. Where nothing is set they must be equal.
struct PictureLimits {
  std::optional<double> largest = {};    // 8-bit levels, of any pixel's largest channel
  std::optional<double> mean = {};       // 8-bit levels, over all pixels and channels
  std::optional<double> drift = {};      // change of a colour's mean level, relative to the first picture's
  std::optional<double> failing = {};    // fraction of pixels that `tolerance` does not excuse
  PixelTolerance tolerance = {};         // for `failing`
  std::optional<double> structure = {};  // the least mean of structural similarity
  std::optional<double> flip = {};       // the largest mean of FLIP
  std::optional<double> flip_99 = {};    // the largest 99th percentile of FLIP
  bool any() const { return largest || mean || drift || failing || structure || flip || flip_99; }
};

/// Figures that are wanted whether or not a limit needs them.
struct WantedFigures {
  bool structure = false;
  bool flip = false;
};

struct PictureOptions {
  PictureLimits limits;
  WantedFigures wanted;
  std::vector<std::uint8_t> mask;  // (height x width), zero where nothing counts; empty: all counts
  FlipOptions flip;
};

/// What was found, as far up the ladder as was needed.
struct PictureComparison {
  bool within = true;
  std::string rung;     // that decided: "bytes", "size", "pixels", "structure", "flip"
  std::string verdict;  // one line
  ImageDifference difference;
  Drift drift;
  std::optional<FailingPixels> failing;
  std::optional<StructuralSimilarity> structure;
  std::optional<FlipResult> flip;
};

/// Compares by the cheapest figures first: equal bytes, size, levels, drift and failing pixels, structural similarity,
/// FLIP. A limit that is exceeded ends the climb, but for figures that are wanted.
PictureComparison climb_ladder(const Image& first, const Image& second, const PictureOptions& options = {});

}  // namespace thinwall
