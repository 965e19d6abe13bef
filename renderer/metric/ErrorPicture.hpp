#pragma once

#include <vector>

#include "renderer/image/Image.hpp"

namespace thinwall {

/// Errors of pixels, 0 to 1 as FLIP gives them, as colours on the darkened picture: untouched where nothing is seen,
/// then blue over violet and red to yellow-white at 1. `errors` is (height x width).
Image error_picture(const Image& image, const std::vector<float>& errors);

}  // namespace thinwall
