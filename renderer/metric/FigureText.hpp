#pragma once

#include <optional>
#include <string>

namespace thinwall {

enum class GoodFigure { kSmall, kLarge };

/// "mean 0.31 (allowed 0.2)", or of a figure that is to be large "SSIM 0.98 (needed 0.99)": four digits, or as many
/// more as it takes to stand on that side of the limit where it is; the limit has all of its own. `unit`, where there
/// is one, stands behind both.
std::string figure_text(const std::string& name, double value, std::optional<double> limit,
                        GoodFigure good = GoodFigure::kSmall, const std::string& unit = "");

}  // namespace thinwall
