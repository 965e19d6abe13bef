#include "renderer/overlay/NumberText.hpp"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>

namespace thinwall {
namespace {

/// Decimals that show `value` with three digits, at least `fewest`, at most `most`.
int decimals_for(double value, int fewest, int most) {
  int decimals = 2;
  for (double limit = 10; std::abs(value) >= limit && decimals > fewest; limit *= 10) --decimals;
  for (double limit = 1; std::abs(value) < limit && decimals < most; limit /= 10) ++decimals;
  return decimals;
}

}  // namespace

std::string fixed_text(double value, int decimals) {
  assert(std::isfinite(value));
  char buffer[400];  // the largest double has 309 digits before the point
  const auto end = std::to_chars(buffer, buffer + sizeof(buffer), std::abs(value), std::chars_format::fixed, decimals);
  const std::string digits(buffer, end.ptr);
  const bool is_zero = digits.find_first_not_of("0.") == std::string::npos;
  return value < 0 && !is_zero ? "\u2212" + digits : digits;
}

ForceUnit force_unit(double expected, double peak) {
  if (expected < 1e-4 && peak < 1e-3) return {1e-6, "\u00b5N"};
  if (expected < 0.1 && peak < 1) return {1e-3, "mN"};
  return peak < 1e4 ? ForceUnit{1, "N"} : ForceUnit{1e3, "kN"};
}

QuantityText force_quantity(double newton, double peak, double expected) {
  const double largest = std::max(std::abs(newton), std::abs(peak));
  const ForceUnit unit = force_unit(expected, largest);
  const int fewest = unit.newton > 1 ? 0 : 1, most = unit.newton > 1 ? 2 : 3;
  return {fixed_text(newton / unit.newton, decimals_for(largest / unit.newton, fewest, most)), unit.name};
}

QuantityText depth_quantity(double metres) {
  const double millimetres = metres * 1e3;
  return {fixed_text(millimetres, decimals_for(millimetres, 0, 2)), "mm"};
}

QuantityText pressure_quantity(double pascal) {
  if (std::abs(pascal) >= 1e6) return {fixed_text(pascal / 1e6, decimals_for(pascal / 1e6, 0, 2)), "MPa"};
  if (std::abs(pascal) >= 1e3) return {fixed_text(pascal / 1e3, decimals_for(pascal / 1e3, 0, 2)), "kPa"};
  return {fixed_text(pascal, std::abs(pascal) >= 100 ? 0 : 1), "Pa"};
}

}  // namespace thinwall
