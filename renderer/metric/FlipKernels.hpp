#pragma once

#include "renderer/metric/SeparableFilter.hpp"

namespace thinwall {

/// The filters of FLIP for a picture of so many pixels per degree of the viewer's sight.
struct FlipKernels {
  Kernel achromatic;   // contrast sensitivity of the eye to brightness
  Kernel red_green;    // likewise to red against green
  Kernel blue_yellow;  // likewise to blue against yellow: the wider of two Gaussians
  Kernel blue_yellow_narrow;
  Kernel smooth;  // for edges and points: Gaussian, its first and its second derivative
  Kernel edge;
  Kernel point;
  int margin = 0;  // pixels around a pixel that take part in its error
};

/// Sections 4.1 and 4.2 of Andersson et al., FLIP: A Difference Evaluator for Alternating Images, 2020.
FlipKernels flip_kernels(double pixels_per_degree);

}  // namespace thinwall
