#include "studio/schema/Quantity.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace thinwall {
namespace {

std::string reason(const std::string& text) {
  try {
    parse_quantity(text);
  } catch (const QuantityError& error) {
    return error.what();
  }
  return "";
}

struct Example {
  std::string text;
  double value;
  Dimension dimension;
};

class ReadQuantity : public testing::TestWithParam<Example> {};

TEST_P(ReadQuantity, IsTheSiValueToTheLastBit) {
  const Quantity quantity = parse_quantity(GetParam().text);
  EXPECT_EQ(quantity.value, GetParam().value);
  EXPECT_EQ(quantity.dimension, GetParam().dimension);
}

INSTANTIATE_TEST_SUITE_P(
    Quantity, ReadQuantity,
    testing::Values(
        Example{"0.8 mm", 0.0008, kLength}, Example{"0.3mm", 0.0003, kLength}, Example{"12 kPa", 12000, kPressure},
        Example{"30 deg", 30 * (std::numbers::pi / 180), kAngle}, Example{"1.5 s", 1.5, kTime},
        Example{"60 N/m", 60, {.mass = 1, .time = -2}}, Example{"0.4 kJ/m^2", 400, {.mass = 1, .time = -2}},
        Example{"1060 kg/m^3", 1060, kDensity}, Example{"1.1 g/cm³", 1100, kDensity}, Example{"10 mm/s", 0.01, kSpeed},
        Example{"5 ml", 5e-6, {.length = 3}}, Example{"2 MPa", 2e6, kPressure},
        Example{"3 kg*m/s^2", 3, {.length = 1, .mass = 1, .time = -2}}, Example{"9.81 m/s^2", 9.81, kAcceleration},
        Example{"4 mm²", 4e-6, {.length = 2}}, Example{"2 min", 120, kTime}, Example{"1 1/s", 1, {.time = -1}},
        Example{"10 mmHg", 1333.22, kPressure}, Example{"0.3 µm", 3e-7, kLength}, Example{"-2e-3 m", -0.002, kLength},
        Example{"+.5 m", 0.5, kLength}, Example{"5. m", 5, kLength}, Example{"1e3", 1000, kDimensionless},
        Example{"0", 0, kDimensionless}, Example{"2 m^-1", 2, {.length = -1}}, Example{"  7  N ", 7, {1, 1, -2, 0}}));

TEST(Quantity, EachSlashDividesByOneFactorOnly) {
  EXPECT_EQ(parse_quantity("1 kg/m/s*m").dimension, (Dimension{.mass = 1, .time = -1}));
}

TEST(Quantity, AUnitByItselfIsOneOfIt) {
  EXPECT_EQ(parse_unit("mm").value, 0.001);
  EXPECT_EQ(parse_unit("deg/s").dimension, kAngularSpeed);
}

TEST(Quantity, WhatIsNoQuantityIsRefusedWithTheReason) {
  EXPECT_EQ(reason("abc"), "it does not begin with a number");
  EXPECT_EQ(reason(""), "it does not begin with a number");
  EXPECT_EQ(reason("\u22125 mm"), "its minus sign is one of typography; write `-`");
  EXPECT_EQ(reason("\u20135 mm"), "its minus sign is one of typography; write `-`");
  for (const char* typed : {"5\u00A0mm", "5\u2009mm", "5\u2007mm", "5 \u202Fmm"}) {
    EXPECT_EQ(reason(typed), "the space before its unit is one of typography; write a plain one, or none");
  }
  EXPECT_EQ(reason("- 5 mm"), "it does not begin with a number");
  EXPECT_EQ(reason("nan"), "it is not a finite number");
  EXPECT_EQ(reason("-.inf"), "it is not a finite number");
  EXPECT_EQ(reason("infinity mm"), "it is not a finite number");
  EXPECT_EQ(reason("1,5 mm"), "a decimal point is needed, not a comma");
  EXPECT_EQ(reason("5 mmm"), "unknown unit `mmm`, did you mean `mm`?");
  EXPECT_EQ(reason("1 inch"), "unknown unit `inch`, write 25.4 mm for each inch");
  EXPECT_EQ(reason("5 parsec"), "unknown unit `parsec`");
  EXPECT_EQ(reason("20 mm/sec"), "unknown unit `sec`, write `s`");
  EXPECT_EQ(reason("400 J/m2"), "unknown unit `m2`, write `m^2`");
  EXPECT_EQ(reason("5 mm3"), "unknown unit `mm3`, write `mm^3`");
  EXPECT_EQ(reason("5 millimeter"), "unknown unit `millimeter`, write `mm`");
  EXPECT_EQ(reason("5 milimeter"), "unknown unit `milimeter`, write `mm`");
  EXPECT_EQ(reason("$depth"), "it does not begin with a number; a parameter's value is written `${name}`");
  EXPECT_EQ(reason("5 psi"), "unknown unit `psi`, write 6.895 kPa for each psi");
  EXPECT_EQ(reason("5 kdeg"), "unknown unit `kdeg`, did you mean `deg`?");
  EXPECT_EQ(reason("0x10 m"), "unknown unit `x10 m`");
  EXPECT_EQ(reason("1.2.3"), "unknown unit `.3`");
  EXPECT_EQ(reason("5 m//s"), "a unit is missing in `m//s`");
  EXPECT_EQ(reason("5 m^x"), "the exponent `x` of a unit is not a whole number from -9 to 9");
  EXPECT_EQ(reason("5 m^99999999999"), "the exponent `99999999999` of a unit is not a whole number from -9 to 9");
  EXPECT_EQ(reason("1e400"), "the number `1e400` is beyond what a double can hold");
  EXPECT_EQ(reason("1e99999999999999999999 m"), "the number `1e99999999999999999999` is beyond what a double can hold");
  EXPECT_EQ(reason("1e306 km"), "the number `1e306` is beyond what a double can hold");
  EXPECT_EQ(reason(std::string(300, '1')), "the number `" + std::string(60, '1') + "...` is too long");
  EXPECT_EQ(reason("1 m*m*m*m*m*m*m*m*m*m*m*m*m*m*m*m*m"),
            "the unit `m*m*m*m*m*m*m*m*m*m*m*m*m*m*m*m*m` has more than 16 factors");
}

TEST(Quantity, AMillionOfWhatNoneHasAMillionOfIsASlipOfTheShiftKey) {
  EXPECT_EQ(reason("20 Mm"), "unknown unit `Mm`: `M` does not go with `m`; did you mean `mm`?");
  EXPECT_EQ(reason("20 Mm/s"), "unknown unit `Mm`: `M` does not go with `m`; did you mean `mm`?");
  EXPECT_EQ(reason("5 Ms"), "unknown unit `Ms`: `M` does not go with `s`; did you mean `ms`?");
  EXPECT_EQ(reason("5 Ml"), "unknown unit `Ml`: `M` does not go with `l`; did you mean `ml`?");
  EXPECT_EQ(reason("2 Mbar"), "unknown unit `Mbar`: `M` does not go with `bar`; did you mean `mbar`?");
  EXPECT_EQ(reason("2 Grad"), "unknown unit `Grad`: `G` does not go with `rad`");
}

TEST(Quantity, AMillionStandsBeforeUnitsThatHaveOne) {
  EXPECT_EQ(parse_quantity("2 MN/m^2").value, 2e6);
  EXPECT_EQ(parse_quantity("1.06 Mg/m^3").value, 1060);
  EXPECT_EQ(parse_quantity("1 MHz").value, 1e6);
  EXPECT_EQ(parse_quantity("2.2 GPa").value, 2.2e9);
  EXPECT_EQ(parse_quantity("3 MJ/m^3").value, 3e6);
}

TEST(Quantity, DimensionsHaveNames) {
  EXPECT_EQ(dimension_name(kPressure), "a pressure");
  EXPECT_EQ(dimension_name(kDimensionless), "a plain number");
  EXPECT_EQ(dimension_name({.length = 1, .mass = 1, .time = -3}), "a quantity in kg*m/s^3");
  EXPECT_EQ(dimension_name({.length = -4}), "a quantity in 1/m^4");
  EXPECT_EQ(si_unit(kDensity), "kg/m^3");
}

TEST(Quantity, ValuesAreShownInTheUnitOfAnExample) {
  EXPECT_EQ(format_like(0.0008, "5 mm"), "0.8 mm");
  EXPECT_EQ(format_like(std::numbers::pi, "30 deg"), "180 deg");
  EXPECT_EQ(format_like(0.25, "0.5"), "0.25");
  EXPECT_EQ(format_like(0.02, "mm"), "20 mm");
}

}  // namespace
}  // namespace thinwall
