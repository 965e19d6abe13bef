#pragma once

#include "renderer/image/Image.hpp"

namespace thinwall {

/// How alike two pictures are in structure: 1 is equal, 0 nothing in common, negative reversed.
struct StructuralSimilarity {
  double mean = 1;    // over all pixels
  double lowest = 1;  // of a pixel
};

/// SSIM of Wang, Bovik, Sheikh and Simoncelli (IEEE Transactions on Image Processing 13(4), 2004) on CIE L*, a*, b*: a
/// Gaussian window of 11 x 11 pixels with deviation 1.5, constants (0.01 R)^2 and (0.03 R)^2 with the range R = 100 for
/// each channel; a pixel's value is half that of L* and a quarter each of a* and b*. A picture continues beyond its
/// borders as its outermost pixels. The sizes must be equal. Squares without a difference are not worked through. The
/// same to the last bit for any number of threads (0: as many as there are cores).
StructuralSimilarity structural_similarity(const Image& first, const Image& second, int threads = 0);

}  // namespace thinwall
