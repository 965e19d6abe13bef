#pragma once

#include "renderer/annotation/LabelLayout.hpp"
#include "renderer/overlay/Canvas.hpp"

namespace thinwall {

/// A flat arrow from tail to tip with a dark outline; `width` in pixels, of its shaft. Short ones are all head.
void draw_arrow(const Canvas& canvas, PixelPoint tail, PixelPoint tip, double width, Color color);

/// The same arrow seen along itself, at `place`: a ring with its tip as a dot, or where it goes away from the viewer
/// its feathers as a cross.
void draw_arrow_end_on(const Canvas& canvas, PixelPoint place, double width, bool towards_viewer, Color color);

}  // namespace thinwall
