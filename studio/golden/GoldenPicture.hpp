#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "renderer/image/Image.hpp"
#include "renderer/overlay/Overlay.hpp"
#include "studio/golden/GoldenHistory.hpp"
#include "studio/record/Moment.hpp"
#include "studio/recorder/Painter.hpp"
#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// Starts the simulation of a scenario.
using SourceFactory = std::function<std::unique_ptr<MomentSource>(const Scenario&)>;

/// The picture of a scenario at a time of its `golden:` list, as it is today.
struct GoldenPicture {
  double at = 0;                // seconds
  std::string missing;          // why there is none; empty when there is one
  bool cannot_be_made = false;  // whether `missing` is of the device, not of the simulation
  Image image;
  Moment moment;                         // what it shows
  std::string state_digest;              // of the first step that reaches `at`
  std::string second_state_digest = {};  // likewise of the take that it is compared with; empty when there is none
  Image scene = {};                      // the picture without overlays
  std::string scene_hash = {};           // of that
  bool is_annotated = false;             // whether labels, arrows or a card are over the tissue
  OverlayContent overlay = {};           // what is written over it
  Shot shot = {};                        // what sees it
  GoldenHistory history = {};            // of the steps up to `at`
};

struct GoldenPictures {
  std::string no_device;  // why nothing could be drawn here; empty when something could
  std::string driver;
  std::vector<GoldenPicture> pictures;  // in the order of the list; one without content for a video
};

/// Pictures are made smaller than a recording's, at most 640 pixels wide: small enough to be kept, large enough to see.
ImageSize golden_size(ImageSize recorded);

/// Simulates up to the last time asked for and draws only these times.
GoldenPictures golden_pictures(const Scenario& scenario, const SourceFactory& sources, const PainterFactory& painters);

}  // namespace thinwall
