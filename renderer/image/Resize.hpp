#pragma once

#include "renderer/image/Image.hpp"

namespace thinwall {

/// The picture in another size by area average: each new pixel is the mean of what it covers, weighted by the covered
/// area, in sRGB levels, rounded to nearest. Exact in integers, so equal on every machine. Enlarging repeats pixels.
/// Both sizes must be positive.
Image resize(const Image& image, ImageSize size);

/// The largest size of the same shape that fits into `box`, at least 1 x 1.
ImageSize size_that_fits(ImageSize size, ImageSize box);

}  // namespace thinwall
