#pragma once

#include <optional>

#include "renderer/overlay/Overlay.hpp"
#include "renderer/overlay/Plate.hpp"

namespace thinwall {

/// Where a legend stands in a corner of `room`, the picture or a half of it: below title and time, or above panels and
/// what captions stand above them. Where an `inset` has that place, below or above the inset if there is room, else in
/// the corner beside: the middle is the action's.
Box legend_place(const OverlayGrid& grid, const Box& room, PictureCorner corner, const std::optional<Box>& inset);

/// What the colours of a data view mean: a bar of them with numbers beside it and the quantity's name and unit above.
void draw_legend(Image& image, const OverlayGrid& grid, const Legend& legend, const Box& place);

}  // namespace thinwall
