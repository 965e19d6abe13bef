#pragma once

#include <string>

#include "renderer/overlay/Canvas.hpp"

namespace thinwall {

/// The colour of a tool's phase on all pictures; words that are no phase are grey.
Color phase_color(const std::string& phase);

/// The word as shown: with a capital letter.
std::string phase_label(const std::string& phase);

}  // namespace thinwall
