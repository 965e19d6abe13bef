#pragma once

#include <array>
#include <string_view>
#include <utility>

namespace thinwall {

/// How the colours of a data view go with its numbers.
enum class DataScale {
  kLinear,
  kRoot  // with the square root of the place in the range: more colours for the low end
};

/// In the words of the scenario format.
inline constexpr std::array<std::pair<std::string_view, DataScale>, 2> kDataScales = {
    {{"linear", DataScale::kLinear}, {"root", DataScale::kRoot}}};

/// The scale of that word, or nullptr.
const DataScale* find_data_scale(std::string_view word);

/// The place among the colours, 0 to 1, of a number's place in the range, from 0 to 1 (clamped).
double color_place(double place, DataScale scale);

}  // namespace thinwall
