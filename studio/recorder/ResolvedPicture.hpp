#pragma once

#include <string>

#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// What of a scenario decides how its pictures look.
struct PictureSettings {
  ViewDefinition view;
  OverlayChoice overlays;
  RecordOptions record;
  Teaching teaching = {};
};

PictureSettings picture_settings(const Scenario& scenario);

/// The same from a resolved scenario, as a take keeps it. Throws TakeError when it lacks something or is no JSON.
PictureSettings picture_settings(const std::string& resolved);

}  // namespace thinwall
