#pragma once

#include <cstdint>
#include <vector>

#include "renderer/image/Image.hpp"

namespace thinwall {

/// What may differ without a pixel failing.
struct PixelTolerance {
  int level = 0;  // 8-bit levels of its largest channel
  int shift = 0;  // pixels by which what a pixel shows may lie elsewhere in the other picture
};

struct FailingPixels {
  std::int64_t failing = 0;
  std::int64_t counted = 0;         // all but masked ones
  std::vector<std::uint8_t> where;  // (height x width), 1 where failing
  double fraction() const { return counted > 0 ? static_cast<double>(failing) / static_cast<double>(counted) : 0; }
};

/// A pixel passes when each picture has within `shift` pixels of it, in rows and columns, a pixel that differs from the
/// other's by no more than `level`. Both ways, so that a thin line that has vanished fails as one that has appeared.
/// `mask`, when not empty, is (height x width), zero where nothing counts. The sizes must be equal.
FailingPixels failing_pixels(const Image& first, const Image& second, const PixelTolerance& tolerance,
                             const std::vector<std::uint8_t>& mask = {});

/// 1 where a mask picture is lighter than half in its green channel: (height x width).
std::vector<std::uint8_t> mask_of(const Image& image);

/// The pictures' pixels, made equal where the mask is zero: in `second` the ones of `first`.
Image with_masked_pixels_of(const Image& second, const Image& first, const std::vector<std::uint8_t>& mask);

}  // namespace thinwall
