#include "renderer/metric/ColorSpace.hpp"

#include <gtest/gtest.h>

namespace thinwall {
namespace {

TEST(ColorSpace, MatrixIsTheStandardsOwnToItsFourDigits) {
  const double published[3][3] = {{0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      EXPECT_NEAR(rgb_to_xyz()[row][column], published[row][column], 5.1e-5) << row << column;
    }
  }
}

TEST(ColorSpace, InverseLeadsBack) {
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      double sum = 0;
      for (std::size_t k = 0; k < 3; ++k) sum += xyz_to_rgb()[row][k] * rgb_to_xyz()[k][column];
      EXPECT_NEAR(sum, row == column ? 1 : 0, 1e-14);
    }
  }
}

TEST(ColorSpace, WhiteIsLightestAndWithoutColor) {
  const std::array<double, 3> lab = lab_of_linear({1, 1, 1});
  EXPECT_NEAR(lab[0], 100, 1e-12);
  EXPECT_NEAR(lab[1], 0, 1e-12);
  EXPECT_NEAR(lab[2], 0, 1e-12);
  EXPECT_NEAR(lab_of_linear({0, 0, 0})[0], 0, 1e-12);
}

TEST(ColorSpace, RedIsWhereTablesHaveIt) {
  const std::array<double, 3> lab = lab_of_linear({1, 0, 0});
  EXPECT_NEAR(lab[0], 53.24, 0.01);
  EXPECT_NEAR(lab[1], 80.09, 0.01);
  EXPECT_NEAR(lab[2], 67.20, 0.01);
}

TEST(ColorSpace, MiddleLevelIsAFifthOfTheLight) {
  EXPECT_EQ(linear_levels()[0], 0);
  EXPECT_EQ(linear_levels()[255], 1);
  EXPECT_NEAR(linear_levels()[128], 0.21586, 1e-5);
}

}  // namespace
}  // namespace thinwall
