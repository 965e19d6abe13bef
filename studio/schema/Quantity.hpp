#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace thinwall {

/// Exponents of the base units metre, kilogram, second and radian. An angle has a dimension of its own here, so that
/// `30` is never taken for 30 radians.
struct Dimension {
  int length = 0;
  int mass = 0;
  int time = 0;
  int angle = 0;
  friend bool operator==(const Dimension&, const Dimension&) = default;
};

inline constexpr Dimension kDimensionless{};
inline constexpr Dimension kLength{.length = 1};
inline constexpr Dimension kTime{.time = 1};
inline constexpr Dimension kAngle{.angle = 1};
inline constexpr Dimension kSpeed{.length = 1, .time = -1};
inline constexpr Dimension kAcceleration{.length = 1, .time = -2};
inline constexpr Dimension kAngularSpeed{.time = -1, .angle = 1};
inline constexpr Dimension kDensity{.length = -3, .mass = 1};
inline constexpr Dimension kArea{.length = 2};
inline constexpr Dimension kVolume{.length = 3};
inline constexpr Dimension kFrequency{.time = -1};
inline constexpr Dimension kForce{.length = 1, .mass = 1, .time = -2};
inline constexpr Dimension kForcePerLength{.mass = 1, .time = -2};
inline constexpr Dimension kForcePerVolume{.length = -2, .mass = 1, .time = -2};
inline constexpr Dimension kEnergy{.length = 2, .mass = 1, .time = -2};
inline constexpr Dimension kPressure{.length = -1, .mass = 1, .time = -2};

/// A number in SI units (metre, kilogram, second, radian and what they make) with its dimension.
struct Quantity {
  double value = 0;
  Dimension dimension = {};
};

/// A text that is no quantity: the message says why, without a location.
class QuantityError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Reads `0.8 mm`, `60 N/m`, `5 kg*m/s^2`, `0`. A decimal prefix is applied to the decimal text before rounding, so
/// `0.3 mm` is exactly the double nearest to 0.0003. Each `/` divides by the one factor that follows it.
/// Throws QuantityError: not a number, not finite, an unknown unit.
Quantity parse_quantity(std::string_view text);

/// Reads a unit by itself, `mm` as 0.001 metre. Throws QuantityError.
Quantity parse_unit(std::string_view text);

/// "a length", "a pressure"; "a plain number" without dimension; "a quantity in kg*m/s^3" for one without a name.
std::string dimension_name(const Dimension& dimension);

/// An example in the words of a scenario file: "0.8 mm"; for a dimension without a name one of its SI unit.
std::string dimension_example(const Dimension& dimension);

/// The SI unit: "m", "Pa", "kg/m^3"; "" without dimension.
std::string si_unit(const Dimension& dimension);

/// An SI value in the unit of an example: 0.0008 like "5 mm" gives "0.8 mm".
std::string format_like(double value, std::string_view example);

}  // namespace thinwall
