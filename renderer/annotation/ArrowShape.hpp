#pragma once

#include "renderer/annotation/LabelLayout.hpp"
#include "renderer/overlay/Canvas.hpp"

namespace thinwall {

/// A flat arrow from tail to tip with a dark outline; `width` in pixels, of its shaft. Short ones are all head.
void draw_arrow(const Canvas& canvas, PixelPoint tail, PixelPoint tip, double width, Color color);

}  // namespace thinwall
