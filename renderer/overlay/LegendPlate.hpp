#pragma once

#include <optional>

#include "renderer/overlay/Overlay.hpp"
#include "renderer/overlay/Plate.hpp"

namespace thinwall {

/// Where a legend stands: at the right, below the time. Where an `inset` has that place, below the inset if there is
/// room above the panels, else at the left, below the title: the middle is the action's.
Box legend_place(const OverlayGrid& grid, const std::optional<Box>& inset);

/// At the right of the left half.
Box left_legend_place(const OverlayGrid& grid);

/// What the colours of a data view mean: a bar of them with numbers beside it and the quantity's name and unit above.
void draw_legend(Image& image, const OverlayGrid& grid, const Legend& legend, const Box& place);

}  // namespace thinwall
