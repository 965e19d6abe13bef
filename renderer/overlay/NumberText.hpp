#pragma once

#include <string>

namespace thinwall {

/// A number with its unit as shown on pictures.
struct QuantityText {
  std::string number;
  std::string unit;
  std::string text() const { return number + " " + unit; }
};

/// With `decimals` digits behind the point and a true minus sign; what rounds to zero has no sign. The same in every
/// locale. The value must be finite.
std::string fixed_text(double value, int decimals);

/// Newton, from 10 kN on kilonewton; as many decimals as make three digits of `peak`, at least what `value` needs.
QuantityText force_quantity(double newton, double peak);
/// Millimetres.
QuantityText depth_quantity(double metres);
/// Pascal, from 1 kPa on kilopascal, from 1 MPa on megapascal.
QuantityText pressure_quantity(double pascal);

}  // namespace thinwall
