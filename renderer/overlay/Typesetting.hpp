#pragma once

#include <string>
#include <string_view>

namespace thinwall {

/// A text as it is set: powers of units raised (m^2 as m²), and no line ends between a number and its unit or within
/// one. `text` is valid UTF-8.
std::string typeset(std::string_view text);

}  // namespace thinwall
