#include "renderer/overlay/NumberText.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace thinwall {
namespace {

TEST(NumberText, HasTheAskedDecimalsAndATrueMinus) {
  EXPECT_EQ(fixed_text(1.234, 2), "1.23");
  EXPECT_EQ(fixed_text(-1.5, 1), "\u22121.5");
  EXPECT_EQ(fixed_text(7, 0), "7");
}

TEST(NumberText, ZeroHasNoSign) {
  EXPECT_EQ(fixed_text(-0.0, 1), "0.0");
  EXPECT_EQ(fixed_text(-0.004, 2), "0.00");
}

TEST(NumberText, LargestNumberHasRoom) {
  EXPECT_EQ(fixed_text(-std::numeric_limits<double>::max(), 3).size(), 3u + 309u + 4u);  // the minus has three bytes
}

TEST(NumberText, ForceKeepsItsDecimalsWhileItFallsFromThePeak) {
  EXPECT_EQ(force_quantity(0.3124, 0.3124).text(), "0.312 N");
  EXPECT_EQ(force_quantity(0, 0).text(), "0.000 N");
  EXPECT_EQ(force_quantity(12.34, 12.34).text(), "12.3 N");
  EXPECT_EQ(force_quantity(1, 12.34).text(), "1.0 N");
  EXPECT_EQ(force_quantity(123456, 123456).text(), "123 kN");
  EXPECT_EQ(force_quantity(10, 123456).text(), "0 kN");
}

TEST(NumberText, SmallForcesHaveAUnitThatShowsThem) {
  constexpr double kOfATinyBody = 0.001, kOfACell = 1e-6;
  EXPECT_EQ(force_quantity(0, 0, kOfATinyBody).text(), "0.000 mN");
  EXPECT_EQ(force_quantity(2e-5, 2e-5, kOfATinyBody).text(), "0.020 mN");
  EXPECT_EQ(force_quantity(0.0312, 0.0312, kOfATinyBody).text(), "31.2 mN");
  EXPECT_EQ(force_quantity(4e-7, 4e-7, kOfACell).text(), "0.400 \u00b5N");
}

TEST(NumberText, ForcesThatBecomeLargerThanExpectedTakeALargerUnit) {
  EXPECT_EQ(force_quantity(0.5, 1.2, 0.001).text(), "0.50 N");
  EXPECT_EQ(force_quantity(0.5, 1.2, 1e-6).text(), "0.50 N");
  EXPECT_EQ(force_quantity(0.02, 0.02, 1e-6).text(), "20.0 mN");
}

TEST(NumberText, DepthIsInMillimetres) {
  EXPECT_EQ(depth_quantity(0.004).text(), "4.00 mm");
  EXPECT_EQ(depth_quantity(0.0123).text(), "12.3 mm");
  EXPECT_EQ(depth_quantity(-0.0005).text(), "\u22120.50 mm");
}

TEST(NumberText, PressureTakesTheUnitThatFits) {
  EXPECT_EQ(pressure_quantity(0).text(), "0.0 Pa");
  EXPECT_EQ(pressure_quantity(84.72).text(), "84.7 Pa");
  EXPECT_EQ(pressure_quantity(700).text(), "700 Pa");
  EXPECT_EQ(pressure_quantity(1140).text(), "1.14 kPa");
  EXPECT_EQ(pressure_quantity(-25000).text(), "\u221225.0 kPa");
  EXPECT_EQ(pressure_quantity(2.5e6).text(), "2.50 MPa");
}

}  // namespace
}  // namespace thinwall
