#include "renderer/overlay/Typesetting.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>

namespace thinwall {
namespace {

constexpr std::string_view kNoBreakSpace = "\u00a0", kWordJoiner = "\u2060", kSquared = "\u00b2", kCubed = "\u00b3";

bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// Whether a unit stands at the beginning: letters that are one, with nothing but a power or another unit after them.
bool begins_with_unit(std::string_view text) {
  constexpr std::array<std::string_view, 27> kUnits = {"m",  "mm", "cm", "um",  "s",   "ms", "min", "h",  "N",
                                                       "mN", "kN", "Pa", "kPa", "MPa", "J",  "mJ",  "kJ", "l",
                                                       "ml", "g",  "mg", "kg",  "deg", "Hz", "W",   "mW", "mmHg"};
  if (text.starts_with("%")) return true;
  const auto end = std::ranges::find_if_not(text, is_letter);
  const std::string_view word = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  return std::ranges::find(kUnits, word) != kUnits.end() && (end == text.end() || !is_digit(*end));
}

}  // namespace

std::string typeset(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char before = i > 0 ? text[i - 1] : ' ', next = i + 1 < text.size() ? text[i + 1] : ' ';
    const bool ends_there = i + 2 >= text.size() || (!is_letter(text[i + 2]) && !is_digit(text[i + 2]));
    if (text[i] == '^' && is_letter(before) && (next == '2' || next == '3') && ends_there) {
      result += next == '2' ? kSquared : kCubed;
      ++i;
    } else if (text[i] == ' ' && is_digit(before) && begins_with_unit(text.substr(i + 1))) {
      result += kNoBreakSpace;
    } else {
      result += text[i];
      if (text[i] == '/' && is_letter(before) && begins_with_unit(text.substr(i + 1))) result += kWordJoiner;
    }
  }
  return result;
}

}  // namespace thinwall
