#pragma once

#include <map>
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

/// Kinds of tissue by the names of bodies, as a resolved scenario tells; none of bodies of takes that name none.
std::map<std::string, std::string> tissue_kinds(const std::string& resolved);

}  // namespace thinwall
