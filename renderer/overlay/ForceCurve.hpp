#pragma once

#include <vector>

#include "renderer/overlay/Axis.hpp"
#include "renderer/overlay/Canvas.hpp"

namespace thinwall {

struct PlotPoint {
  double x = 0;
  double y = 0;
};

/// The points of a curve in pixels of `area`: first, lowest, highest and last of each pixel column stand for the rest,
/// so that a long record costs no more than a short one and no peak is lost. The order stays.
std::vector<PlotPoint> curve_in_pixels(const std::vector<PlotPoint>& curve, const Axis& x, const Axis& y,
                                       const Box& area);

/// Appends the points to cairo's path.
void trace(const Canvas& canvas, const std::vector<PlotPoint>& points);

}  // namespace thinwall
