#pragma once

#include <cstdint>
#include <vector>

#include "renderer/image/Image.hpp"

namespace thinwall {

/// The picture as planar Y'CbCr 4:2:0 of ITU-R BT.709, limited range (luma 16 to 235, chroma 16 to 240): the luma
/// plane, then Cb, then Cr at half the size. Chroma samples sit on the left luma column and between two rows, as H.264
/// assumes by default: filtered (1 2 1)/4 across and (1 1)/2 down. Rounded to nearest in integers, so equal on every
/// machine; pure red, green, blue have luma 63, 173, 32. Width and height must be even.
///
/// Own code because ffmpeg's scale filter takes four times as long for the same and rounds worse.
std::vector<std::uint8_t> yuv420_bt709(const Image& image);

}  // namespace thinwall
