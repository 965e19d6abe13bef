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

struct ForceUnit {
  double newton = 1;
  const char* name = "N";
};

/// The unit for forces that are expected to stay below `expected`, about: newton, below 0.1 N millinewton, below 0.1 mN
/// micronewton. Where `peak` has come to be 1000 of a small unit the next larger one, from 10 kN on kilonewton. It does
/// not become smaller while a force is small, so that the unit does not change whenever a tool begins to touch.
ForceUnit force_unit(double expected, double peak);

/// In that unit; as many decimals as make three digits of `peak`, at least what `newton` needs.
QuantityText force_quantity(double newton, double peak, double expected = 1);
/// Millimetres.
QuantityText depth_quantity(double metres);
/// Pascal, from 1 kPa on kilopascal, from 1 MPa on megapascal.
QuantityText pressure_quantity(double pascal);

}  // namespace thinwall
