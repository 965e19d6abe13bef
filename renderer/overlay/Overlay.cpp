#include "renderer/overlay/Overlay.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "renderer/image/OverlayUnit.hpp"
#include "renderer/overlay/CaptionPlace.hpp"
#include "renderer/overlay/Font.hpp"
#include "renderer/overlay/GaugePlate.hpp"
#include "renderer/overlay/HalfCaptions.hpp"
#include "renderer/overlay/LegendPlate.hpp"
#include "renderer/overlay/Plate.hpp"
#include "renderer/overlay/PlotPlate.hpp"
#include "renderer/overlay/TextPlates.hpp"

namespace thinwall {
namespace {

using namespace plate_style;

double peak_of(const OverlayContent& content) {
  double peak = std::abs(content.force);
  assert(std::isfinite(peak));
  for (const ForceSample& sample : content.history) {
    assert(std::isfinite(sample.force) && std::isfinite(sample.time));
    peak = std::max(peak, std::abs(sample.force));
  }
  for (const ForceSample& sample : content.other_history) peak = std::max(peak, std::abs(sample.force));
  for (const ToolHistory& other : content.other_tools) {
    for (const ForceSample& sample : other.samples) peak = std::max(peak, std::abs(sample.force));
  }
  return peak;
}

/// The width in the middle between panels of these widths.
double width_between(const OverlayGrid& grid, double gauge, double plot) {
  const int center = grid.size.width / 2;
  return 2 * (center - grid.whole(kMargin) - std::max(gauge, plot));
}

/// Between gauge and plot where that is wide enough to read, else above them, and above an inset that stands there.
CaptionSpace caption_space(const OverlayGrid& grid, const OverlayContent& content, const std::optional<Box>& inset) {
  constexpr double kWidest = 800;
  const int margin = grid.whole(kMargin);
  const int center = grid.size.width / 2;
  const double gauge = content.shown.gauge ? grid.pixels(kGaugeWidth + kCaptionGap) : 0;
  const double plot = content.shown.force_plot ? grid.pixels(kPlotWidth + kCaptionGap) : 0;
  const double beside = width_between(grid, gauge, plot);
  const double whole = std::min(2.0 * (center - margin), grid.pixels(kWidest));
  const int bottom = grid.size.height - margin;
  if (gauge + plot == 0 || beside >= grid.pixels(kNarrowestCaption)) {
    return {center, bottom, static_cast<int>(std::min(beside, whole)), grid.whole(kPanelHeight)};
  }
  CaptionSpace above{center, bottom - grid.whole(kPanelHeight) - grid.whole(kCaptionGap), static_cast<int>(whole),
                     grid.whole(kCaptionHeight)};
  const Box place{center - whole / 2, static_cast<double>(above.bottom - above.height), whole,
                  static_cast<double>(above.height)};
  if (inset && place.overlaps(*inset)) above.bottom = static_cast<int>(inset->y - grid.pixels(kCaptionGap));
  return above;
}

/// Below the captions of halves that have its place, as in pictures that are higher than wide.
Box below_half_captions(const OverlayGrid& grid, Box place, const std::vector<Box>& captions) {
  for (const Box& caption : captions) {
    if (place.overlaps(caption)) place.y = std::ceil(caption.bottom() + grid.pixels(kCaptionGap));
  }
  return place;
}

/// Of two takes each in its half, where they are not of both.
std::vector<std::pair<const Legend*, Box>> placed_legends(const OverlayContent& content, const OverlayGrid& grid,
                                                          const std::optional<Box>& inset) {
  const double width = grid.size.width, height = grid.size.height;
  const bool have_halves = content.left_legend || content.legend_is_of_the_right;
  const double left_half = have_halves ? grid.size.width - grid.size.width / 2 : 0;
  const std::vector<Box> captions = half_caption_places(grid.size, content.half_captions, inset);
  std::vector<std::pair<const Legend*, Box>> placed;
  const auto add = [&](const std::optional<Legend>& legend, const Box& room) {
    if (!legend) return;
    const Box place = legend_place(grid, room, legend->corner, inset);
    placed.emplace_back(&*legend, below_half_captions(grid, place, captions));
  };
  add(content.legend, {left_half, 0, width - left_half, height});
  add(content.left_legend, {0, 0, left_half, height});
  return placed;
}

/// Gives the end of what is free for the title, which is one for all frames: its letters do not change with the badge.
int draw_time_and_badge(Image& image, const OverlayGrid& grid, const OverlayContent& content) {
  int time_end = image.size.width;
  if (content.shown.time) time_end = draw_time(image, grid, content.time, content.duration);
  const int badge_end = time_end - grid.whole(8);
  int end = time_end;
  for (const std::string& badge : content.badges_to_come) end = std::min(end, left_of_badge(grid, badge, badge_end));
  return content.badge.empty() ? end : std::min(end, draw_badge(image, grid, content.badge, badge_end));
}

}  // namespace

OverlayGrid::OverlayGrid(ImageSize picture) : size(picture) {
  // With some room between the panels; letters would be larger than their panels are meant for with less.
  constexpr double kNarrowestWidth = 2 * kMargin + kGaugeWidth + kPlotWidth + 154;
  unit = std::min(overlay_unit(picture), picture.width / kNarrowestWidth);
}

int OverlayGrid::whole(double units) const {
  return std::max(1, static_cast<int>(std::lround(pixels(units))));
}

bool captions_stand_above_panels(ImageSize size) {
  const OverlayGrid grid(size);
  const double beside =
      width_between(grid, grid.pixels(kGaugeWidth + kCaptionGap), grid.pixels(kPlotWidth + kCaptionGap));
  return beside < grid.pixels(kNarrowestCaption);
}

double height_of_panels_and_captions(const OverlayGrid& grid) {
  const double panels = grid.pixels(kMargin + kPanelHeight);
  return captions_stand_above_panels(grid.size) ? panels + grid.pixels(kCaptionGap + kCaptionHeight) : panels;
}

Plate::Plate(const OverlayGrid& grid, ImageSize size) : Canvas(size) {
  const double edge = std::max(1.0, grid.unit);
  const double radius = grid.pixels(kRadius);
  const Box whole{0, 0, static_cast<double>(size.width), static_cast<double>(size.height)};
  const Box inner{edge / 2, edge / 2, size.width - edge, size.height - edge};
  fill_rounded(whole, radius, kFill);
  stroke_rounded(inner, radius - edge / 2, edge, kEdge);
}

std::vector<Box> places_of_legends(const OverlayContent& content, ImageSize size, const std::optional<Box>& inset) {
  const OverlayGrid grid(size);
  std::vector<Box> places;
  for (const auto& [legend, place] : placed_legends(content, grid, inset)) places.push_back(place);
  return places;
}

std::vector<std::string> draw_overlay(Image& image, const OverlayContent& content, const std::optional<Box>& inset) {
  const OverlayGrid grid(image.size);
  // Before the font is held, as the captions of halves are set for it.
  const auto legends = placed_legends(content, grid, inset);
  const FontUse use;
  const double peak = peak_of(content);
  const int end = draw_time_and_badge(image, grid, content);
  std::vector<std::string> cut;
  if (!content.title.empty() && draw_title(image, grid, content.title, end - grid.whole(kMargin))) {
    cut.push_back(content.title);
  }
  for (const auto& [legend, place] : legends) draw_legend(image, grid, *legend, place);
  if (content.shown.gauge) draw_gauge(image, grid, content, peak);
  if (content.shown.force_plot) draw_force_plot(image, grid, content, peak);
  if (content.shown.captions && !content.caption.empty() &&
      draw_caption(image, grid, content.caption, caption_space(grid, content, inset))) {
    cut.push_back(content.caption);
  }
  return cut;
}

}  // namespace thinwall
