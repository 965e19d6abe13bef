#pragma once

#include <array>
#include <optional>
#include <vector>

#include "renderer/overlay/Canvas.hpp"

namespace thinwall {

using PixelPoint = std::array<double, 2>;  // from the upper left, y down

/// A label that wants a place. Lengths in pixels.
struct LabelWish {
  PixelPoint anchor = {};  // what it points at
  double width = 0;        // of its plate
  double height = 0;
  bool on_the_left = false;  // of what it points at
};

/// Where labels may be and what they should keep clear of.
struct LabelRoom {
  Box bounds = {};                         // labels stay inside
  std::vector<PixelPoint> obstacles = {};  // of organ and tools
  double gap = 8;                          // pixels, between labels
  double distance = 24;                    // pixels, between a label and what it should keep clear of
  std::optional<Box> taken = {};           // by another picture, at the left or right of the bounds
};

/// Places for labels, in their order: on each side one below the other in the order given, each as near to the height
/// of its anchor as the others allow (least squares), and beside the obstacles at its height; where the bounds leave no
/// room beside them, over them. On the side of what is taken they stand above or below it, where there is more room,
/// and beside it when they are too many; on the other side beside it. Moves steadily when anchors and obstacles do, so
/// labels do not jump from frame to frame.
std::vector<Box> lay_out_labels(const std::vector<LabelWish>& wishes, const LabelRoom& room);

}  // namespace thinwall
