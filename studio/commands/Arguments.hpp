#pragma once

#include <string>
#include <utility>
#include <vector>

#include "renderer/image/Image.hpp"
#include "renderer/look/DataView.hpp"
#include "studio/schema/Quantity.hpp"

namespace thinwall {

using Overrides = std::vector<std::pair<std::string, std::string>>;

/// `--set name=value` as name and value. Throws UsageError.
Overrides parse_overrides(const std::vector<std::string>& texts);

/// `1280x720`; even sides from 16 to 8192, as videos need them. Throws UsageError.
ImageSize parse_size(const std::string& text);

/// `1.5 s`, `300 ms`, or a bare number of seconds; seconds, not negative. Throws UsageError, which begins with `option`
/// (`--at `) and the text.
double parse_time(const std::string& option, const std::string& text);

/// As parse_time, for how long something lasts: above 0.
double parse_duration(const std::string& option, const std::string& text);

/// All quantities that `--data` can show, parted by commas.
std::string data_words();

/// Such a quantity by its word. Throws UsageError.
DataQuantity parse_data_quantity(const std::string& text);

/// `linear` or `root`. Throws UsageError.
DataScale parse_data_scale(const std::string& text);

/// `20 kPa`, `2 mm`, `0.3` as what `option` says of the colours of data. Throws UsageError.
Quantity parse_data_end(const std::string& option, const std::string& text);

}  // namespace thinwall
