#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "renderer/image/Image.hpp"
#include "renderer/image/PictureCorner.hpp"
#include "renderer/look/DataScale.hpp"
#include "renderer/overlay/Box.hpp"
#include "renderer/overlay/OverlayChoice.hpp"

namespace thinwall {

struct ForceSample {
  double time = 0;   // seconds
  double force = 0;  // newton, magnitude of what the tissue does to the tool
};

/// The force of one of several tools.
struct ToolHistory {
  std::string tool;
  std::size_t number = 0;            // among all tools, which its colour goes by
  std::vector<ForceSample> samples;  // ascending in time
};

/// What the colours of a data view mean.
struct Legend {
  std::string title;
  std::string unit;  // SI
  double from = 0;   // in `unit`, of the first colour
  double to = 1;     // in `unit`, of the last colour
  DataScale scale = DataScale::kLinear;
  bool goes_on_below = false;  // the first colour also stands for less
  bool goes_on_above = false;  // the last colour also stands for more
  PictureCorner corner = PictureCorner::kUpperRight;

  bool operator==(const Legend&) const = default;
};

/// What is written over a picture. A pure function of the take up to the frame's time.
struct OverlayContent {
  double time = 0;      // seconds
  double duration = 0;  // seconds, planned length of the whole
  std::string title;
  std::string badge = {};                        // how the time runs, "slow motion"; empty: as it does
  std::vector<std::string> badges_to_come = {};  // in other frames; the title leaves them room in this one, too
  std::string caption;                           // empty: none
  std::string phase;                             // of the tool
  std::string tool;
  double force = 0;                             // newton
  double expected_force = 1;                    // newton, by which the unit of forces is chosen: see force_unit()
  double depth = 0;                             // metres
  std::optional<double> pressure = 0;           // pascal; none where no body has contents
  std::string pressurized_body = {};            // whose pressure that is; empty: only one body has contents
  std::vector<ForceSample> history;             // ascending in time, up to `time`
  std::vector<ForceSample> other_history = {};  // of a take that this one is compared with; empty: none
  std::size_t tool_number = 0;                  // of `tool` among all tools
  std::vector<ToolHistory> other_tools = {};    // that have touched, too, in order of their numbers
  OverlayChoice shown = {};
  std::optional<Legend> legend = {};       // of two takes that of the right one, or of both
  std::optional<Legend> left_legend = {};  // of the left one of two takes, where the right one has another or none
  bool legend_is_of_the_right = false;     // half alone, of two takes of which the left one has another legend or none
  std::array<std::string, 2> half_captions = {};  // of two takes side by side, see HalfCaptions.hpp; empty: none
};

/// Draws on the processor in one pinned font, so the bytes depend neither on the graphics driver nor on the machine's
/// fonts. Scales with the picture's height, in narrow pictures with its width. All numbers must be finite. Long texts
/// wrap, become smaller, and are cut with an ellipsis at last. An `inset` that has their place is left
/// free by legend and caption, captions of halves, which are not drawn here, by legends. Gives the texts of which a
/// part is not shown. Throws PictureFailure when the font is missing.
std::vector<std::string> draw_overlay(Image& image, const OverlayContent& content,
                                      const std::optional<Box>& inset = {});

/// Where draw_overlay puts the legends in a picture of `size`, that of the right or of both halves first.
std::vector<Box> places_of_legends(const OverlayContent& content, ImageSize size, const std::optional<Box>& inset);

}  // namespace thinwall
