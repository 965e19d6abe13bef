#include "renderer/metric/FigureText.hpp"

#include <charconv>

namespace thinwall {
namespace {

/// At most `digits` digits, as short as can be; all that the value has where they are 0.
std::string number(double value, int digits = 0) {
  char text[64];
  char* const end = text + sizeof(text);
  return {text, digits > 0 ? std::to_chars(text, end, value, std::chars_format::general, digits).ptr
                           : std::to_chars(text, end, value).ptr};
}

double read_number(const std::string& text) {
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

std::string figure_beside(double value, std::optional<double> limit) {
  constexpr int kDigits = 4, kAllDigits = 17;
  for (int digits = kDigits; digits < kAllDigits; ++digits) {
    std::string text = number(value, digits);
    if (!limit || (read_number(text) <=> *limit) == (value <=> *limit)) return text;
  }
  return number(value);
}

}  // namespace

std::string figure_text(const std::string& name, double value, std::optional<double> limit, GoodFigure good,
                        const std::string& unit) {
  const std::string behind = unit.empty() ? "" : " " + unit;
  const std::string text = name + " " + figure_beside(value, limit) + behind;
  if (!limit) return text;
  return text + (good == GoodFigure::kSmall ? " (allowed " : " (needed ") + number(*limit) + behind + ")";
}

}  // namespace thinwall
