#pragma once

#include <string>

#include "renderer/overlay/Overlay.hpp"
#include "renderer/overlay/Plate.hpp"

namespace thinwall {

/// The time of the frame, top right; gives the plate's left edge in pixels.
int draw_time(Image& image, const OverlayGrid& grid, double time, double duration);

/// A few words before `right` (pixels), left of the time, as "slow motion"; gives the plate's left edge in pixels.
int draw_badge(Image& image, const OverlayGrid& grid, const std::string& words, int right);

/// The same edge, without drawing.
int left_of_badge(const OverlayGrid& grid, const std::string& words, int right);

/// The title, top left, before `right` (pixels): the longer, the smaller, and cut with an ellipsis at last. Gives
/// whether a part of it is not shown.
bool draw_title(Image& image, const OverlayGrid& grid, const std::string& title, int right);

/// Where a caption may stand, in pixels.
struct CaptionSpace {
  int center = 0;
  int bottom = 0;
  int width = 0;
  int height = 0;
};

/// The caption: wraps, becomes smaller when long, and is cut with an ellipsis only when even that does not help. Gives
/// whether a part of it is not shown.
bool draw_caption(Image& image, const OverlayGrid& grid, const std::string& caption, const CaptionSpace& space);

}  // namespace thinwall
