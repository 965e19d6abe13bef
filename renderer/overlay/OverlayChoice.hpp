#pragma once

#include <string_view>

namespace thinwall {

/// Which overlays are written over a picture.
struct OverlayChoice {
  bool force_plot = true;
  bool gauge = true;
  bool captions = true;
  bool time = true;
  bool operator==(const OverlayChoice&) const = default;
};

/// What a scenario says of an overlay, and what its documentation does.
struct OverlayRow {
  std::string_view key;
  bool OverlayChoice::*is_shown;
  std::string_view documentation;
};

/// In the order of the scenario's format.
inline constexpr OverlayRow kOverlayRows[] = {
    {"force_plot", &OverlayChoice::force_plot, "force over time, a line for each tool that has touched"},
    {"gauge", &OverlayChoice::gauge, "force, depth and pressure of the moment"},
    {"captions", &OverlayChoice::captions, "captions of the clips"},
    {"time", &OverlayChoice::time, "time of the scenario"},
};

}  // namespace thinwall
