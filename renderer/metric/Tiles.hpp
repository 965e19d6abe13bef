#pragma once

#include <functional>
#include <vector>

#include "renderer/image/Image.hpp"

namespace thinwall {

/// A rectangle of pixels: columns [left, right), rows [top, bottom).
struct PixelRegion {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;
  int width() const { return right - left; }
  int height() const { return bottom - top; }
};

/// Squares of `edge` pixels that cover the picture in reading order, cut off at its borders.
std::vector<PixelRegion> tiles_of(ImageSize size, int edge);

/// The region grown by `margin` pixels on all sides, within the picture.
PixelRegion grown(const PixelRegion& region, int margin, ImageSize size);

/// Whether any byte of the region differs. The sizes must be equal.
bool differs_in(const Image& first, const Image& second, const PixelRegion& region);

/// Calls `work` for each index below `count` from `threads` threads (0: as many as there are cores, eight at most).
/// Which thread takes an index is open, so results belong into a place of the index. An exception of `work` is passed
/// on.
void for_each_in_parallel(std::size_t count, const std::function<void(std::size_t)>& work, int threads = 0);

}  // namespace thinwall
