#pragma once

#include "renderer/image/Image.hpp"
#include "renderer/overlay/Canvas.hpp"

namespace thinwall {

/// The look that all plates of an overlay share. Lengths are in units of 1/720 of the picture's height (more in small,
/// fewer in narrow pictures), see `OverlayGrid::unit`.
namespace plate_style {
inline constexpr Color kFill{0.035, 0.05, 0.07, 0.64};
inline constexpr Color kEdge{1, 1, 1, 0.10};
inline constexpr Color kText{0.97, 0.98, 0.99};
inline constexpr Color kFaintText{0.74, 0.78, 0.82};
inline constexpr Color kGridLine{1, 1, 1, 0.13};
inline constexpr Color kCurve{0.40, 0.82, 0.92};
inline constexpr Color kOtherCurve{1.0, 0.70, 0.30};  // of a take that is compared
inline constexpr double kMargin = 26;                 // from the picture's edge
inline constexpr double kPadding = 15;                // inside a plate
inline constexpr double kRadius = 10;                 // of its corners
inline constexpr double kSmallText = 13.5;
// So small that in a wide picture they stand beside the round one of an endoscope.
inline constexpr double kPanelHeight = 148;
inline constexpr double kGaugeWidth = 244;
inline constexpr double kPlotWidth = 256;
inline constexpr double kCaptionGap = 22;         // from panels
inline constexpr double kNarrowestCaption = 420;  // that is read with ease
inline constexpr double kCaptionHeight = 90;      // above panels
}  // namespace plate_style

/// Where things stand in a picture.
struct OverlayGrid {
  ImageSize size;
  double unit = 1;  // pixels

  explicit OverlayGrid(ImageSize picture);
  double pixels(double units) const { return unit * units; }
  /// Whole pixels, at least one.
  int whole(double units) const;
};

/// Pixels at the bottom of a picture that panels take, and captions where these stand above them for want of width.
double height_of_panels_and_captions(const OverlayGrid& grid);

/// A canvas with the plate's ground already on it.
class Plate : public Canvas {
 public:
  Plate(const OverlayGrid& grid, ImageSize size);
};

}  // namespace thinwall
