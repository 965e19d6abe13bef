#pragma once

#include <array>
#include <vector>

#include "renderer/overlay/Canvas.hpp"

namespace thinwall {

using PixelPoint = std::array<double, 2>;  // from the upper left, y down

/// Where a label stands to the walls.
enum class LabelPlace { kAbove, kBeside, kBelow };

/// A label that wants a place. Lengths in pixels.
struct LabelWish {
  PixelPoint anchor = {};  // what it points at
  double width = 0;        // of its plate
  double height = 0;
  bool on_the_left = false;  // of what it points at
  bool upwards = true;       // where it would cover its anchor it stands above it, else below
  LabelPlace place = LabelPlace::kBeside;
};

/// Where labels may be and what they should keep clear of.
struct LabelRoom {
  Box bounds = {};                         // labels stay inside
  std::vector<PixelPoint> obstacles = {};  // of organ and tools
  double gap = 8;                          // pixels, between labels
  double distance = 24;                    // pixels, between a label and what it should keep clear of
  std::vector<Box> taken = {};             // by other pictures and a legend, at the left or right of the bounds
  std::vector<PixelPoint> tools = {};      // of the obstacles, what labels above and below the walls keep clear of too
  double walls_top = 0;                    // of all walls
  double walls_bottom = 0;
};

/// Places for labels, in their order: on each side one below the other in the order given, each as near to the height
/// of its anchor as the others allow (least squares), and beside the obstacles at its height; where the bounds leave no
/// room beside them, over them, above or below its anchor, on the other side of it than it wishes where that leaves
/// more anchors of its side free. On the side of a picture, which is wider than high, they stand above or below it,
/// where there is more room, and beside it when they are too many; on the other side, and where a legend is, which is
/// higher than wide, beside it. Those above and below the walls stand in rows there. Moves steadily when anchors and
/// obstacles do, so labels do not jump from frame to frame, but where one would cover an anchor.
std::vector<Box> lay_out_labels(const std::vector<LabelWish>& wishes, const LabelRoom& room);

/// Whether the bounds leave room for a label above or below the walls, on that side of them that is not far from its
/// anchor, or beside them at the height of its anchor.
bool has_room(const LabelWish& wish, const LabelRoom& room, LabelPlace place);

/// Beside the walls where the bounds leave room for it at the height of its anchor; else above or below them, on the
/// side that is nearer to its anchor and has room; beside where neither has, or both are far.
LabelPlace roomy_place(const LabelWish& wish, const LabelRoom& room);

}  // namespace thinwall
