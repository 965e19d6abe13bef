#pragma once

#include <vector>

#include "renderer/image/FloatImage.hpp"
#include "renderer/image/Image.hpp"

namespace thinwall {

/// Pixels per degree of a picture seen from 0.7 m on a screen 0.7 m wide with 3840 pixels: what published figures use.
inline constexpr double kUsualPixelsPerDegree = 67.02064327658226;

struct FlipOptions {
  double pixels_per_degree = kUsualPixelsPerDegree;
  int threads = 0;  // 0: as many as there are cores
};

/// How different two pictures look to a person who flips between them. 0: no difference is seen, 1: the largest.
struct FlipResult {
  double mean = 0;
  double percentile_99 = 0;  // of the pixels' errors
  double largest = 0;
  std::vector<float> map = {};  // (height x width)
};

/// FLIP of 8-bit sRGB pictures (Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild: FLIP: A Difference
/// Evaluator for Alternating Images, Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020). The sizes must be equal.
/// Only squares that hold a difference or lie beside one are worked through; the others' errors are zero. The same to
/// the last bit for any number of threads.
FlipResult flip(const Image& reference, const Image& test, const FlipOptions& options = {});

/// HDR-FLIP of linear sRGB light (Andersson, Nilsson, Shirley, Akenine-Möller: Visualizing Errors in Rendered High
/// Dynamic Range Images, Eurographics Short Papers, 2021): the largest FLIP error over the exposures that the reference
/// asks for, tone-mapped by ACES. The sizes must be equal, each with three channels. A pixel that is not finite in one
/// picture only has error 1.
FlipResult flip_high_range(const FloatImage& reference, const FloatImage& test, const FlipOptions& options = {});

/// Exposures that HDR-FLIP looks at, as powers of two.
struct ExposureRange {
  double first = 0;
  double last = 0;
  int count = 2;
};

/// The brightest pixel, and the median one, come to 0.85 of the display's range.
ExposureRange exposure_range(const FloatImage& reference);

}  // namespace thinwall
