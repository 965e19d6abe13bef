#pragma once

#include <functional>
#include <vector>

#include "renderer/metric/FlipKernels.hpp"
#include "renderer/metric/Tiles.hpp"

namespace thinwall {

/// Writes linear sRGB of `count` pixels of row `y` from column `left` on, 0 to 1: red, green and blue one after the
/// other into (3 x count). All lie within the picture.
using LinearRow = std::function<void(int y, int left, int count, float* to)>;

/// Memory for one thread's tiles, kept from tile to tile.
struct FlipWorkspace {
  std::vector<float> row;          // (3 x width with margins)
  std::vector<float> opponent[3];  // (rows with margins x pitch): Y, X - Y, Y - Z, each relative to white
  std::vector<float> passed[3];    // (rows with margins x edge): after the pass along rows
  std::vector<float> filtered[4];  // (rows x edge): after both passes
  std::vector<float> color[2][3];  // (rows x edge): L, a, b after Hunt's adjustment, of reference and test
  std::vector<float> edges[2];     // (rows x edge): strength of edges
  std::vector<float> points[2];    // (rows x edge): strength of points
};

/// Edge of the squares in which a picture is worked through, pixels.
inline constexpr int kFlipTile = 128;

/// FLIP errors of a tile, 0 to 1, into (`region`.height x `region`.width). A picture continues beyond its borders as
/// its outermost pixels.
void flip_tile(const LinearRow& reference, const LinearRow& test, ImageSize size, const PixelRegion& region,
               const FlipKernels& kernels, FlipWorkspace& workspace, std::vector<float>& errors);

}  // namespace thinwall
