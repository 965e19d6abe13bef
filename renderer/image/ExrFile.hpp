#pragma once

#include <cstdint>
#include <vector>

#include "renderer/image/Layer.hpp"

namespace thinwall {

/// Numbers as OpenEXR, 32-bit floats without loss: one channel is called Y, of three or two the channels are R, G and
/// B. Equal layers give equal bytes. Throws PictureFailure, also when a number is not finite.
std::vector<std::uint8_t> encode_exr(const FloatLayer& layer);

}  // namespace thinwall
