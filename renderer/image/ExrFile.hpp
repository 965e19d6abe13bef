#pragma once

#include <cstdint>
#include <vector>

#include "renderer/image/Layer.hpp"

namespace thinwall {

/// How numbers are kept: as they are, or as halves, to one part in 2048, which compress much better.
enum class ExrNumbers { kFloat, kHalf };

/// Numbers as OpenEXR: one channel is called Y, of three the channels are R, G and B. Equal layers give equal bytes.
/// Throws PictureFailure, also when a number is not finite.
std::vector<std::uint8_t> encode_exr(const FloatLayer& layer, ExrNumbers numbers = ExrNumbers::kFloat);

}  // namespace thinwall
