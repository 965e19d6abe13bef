#pragma once

#include <string>
#include <utility>
#include <vector>

#include "renderer/image/Image.hpp"

namespace thinwall {

using Overrides = std::vector<std::pair<std::string, std::string>>;

/// `--set name=value` as name and value. Throws UsageError.
Overrides parse_overrides(const std::vector<std::string>& texts);

/// `1280x720`; even sides from 16 to 8192, as videos need them. Throws UsageError.
ImageSize parse_size(const std::string& text);

/// `1.5 s`, `300 ms`, or a bare number of seconds; seconds, not negative. Throws UsageError.
double parse_time(const std::string& text);

}  // namespace thinwall
