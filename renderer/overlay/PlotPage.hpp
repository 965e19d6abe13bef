#pragma once

#include <string>

#include "renderer/image/Image.hpp"
#include "renderer/overlay/Chart.hpp"
#include "renderer/overlay/ForcePlotImage.hpp"

namespace thinwall {

/// Colours of text and of curves that are the sum of others.
inline constexpr Color kPageInk{0.10, 0.13, 0.17};
inline constexpr Color kFaintPageInk{0.38, 0.42, 0.47};

/// What an axis must show: grows from zero with what is included.
struct PlotRange {
  double lowest = 0;
  double highest = 0;

  void include(double value);
  /// Something to draw an axis over, also when there is nothing but roundoff.
  void widen();
};

/// A page of a plot: a title, a line that says what came out, and two charts, the left one the wider.
struct PlotPage {
  std::string title;
  std::string summary;
  Chart left;
  Chart right;
};

/// Length in pixels that text and lines of a page scale with.
double page_unit(ImageSize size);

/// Throws PictureFailure when the font is missing.
Image plot_page(const PlotPage& page, ImageSize size);

/// The phases of a tool as bands along time.
ChartBandRow phase_row(const ToolForces& tool, const std::string& name);

}  // namespace thinwall
