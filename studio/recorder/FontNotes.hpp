#pragma once

#include <string>
#include <vector>

#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// A sentence for each text of a scenario that pictures cannot show as it is written, for want of letters in the font.
std::vector<std::string> font_notes(const Scenario& scenario);

}  // namespace thinwall
