#include "renderer/overlay/Axis.hpp"

#include <gtest/gtest.h>

namespace thinwall {
namespace {

std::vector<std::string> labels(const Axis& axis) {
  std::vector<std::string> result;
  for (const double tick : axis.ticks) result.push_back(axis.label(tick));
  return result;
}

using Labels = std::vector<std::string>;

TEST(Axis, GrowingAxisLeavesRoomAboveTheLargestValue) {
  EXPECT_EQ(labels(growing_axis(0.312)), (Labels{"0", "0.1", "0.2", "0.3", "0.4"}));
  EXPECT_EQ(labels(growing_axis(0.01)), (Labels{"0", "0.005", "0.010", "0.015"}));
  EXPECT_EQ(labels(growing_axis(37)), (Labels{"0", "10", "20", "30", "40"}));
  EXPECT_EQ(labels(growing_axis(38)), (Labels{"0", "20", "40", "60"}));
}

TEST(Axis, GrowingAxisHasTwoToFourStepsOverManyDecades) {
  for (double value = 1e-6; value < 1e9; value *= 1.013) {
    const Axis axis = growing_axis(value);
    EXPECT_GE(axis.highest, 1.0799 * value);
    EXPECT_GE(axis.ticks.size(), 3u) << value;
    EXPECT_LE(axis.ticks.size(), 5u) << value;
    EXPECT_LE(growing_axis(value, 2).ticks.size(), 3u) << value;
    EXPECT_NEAR(axis.ticks.back(), axis.highest, 1e-9 * axis.highest);
  }
}

TEST(Axis, GrowingAxisNeverShrinksWhileTheValueGrows) {
  double highest = 0;
  for (double value = 1e-3; value < 1e3; value *= 1.01) {
    EXPECT_GE(growing_axis(value).highest, highest * (1 - 1e-12));
    highest = growing_axis(value).highest;
  }
}

TEST(Axis, ExactAxisKeepsItsEnds) {
  const Axis axis = exact_axis(0, 6.2, 6);
  EXPECT_EQ(axis.lowest, 0);
  EXPECT_EQ(axis.highest, 6.2);
  EXPECT_EQ(labels(axis), (Labels{"0", "2", "4", "6"}));
  EXPECT_EQ(labels(exact_axis(0, 0.3, 3)), (Labels{"0", "0.1", "0.2", "0.3"}));
}

TEST(Axis, EnclosingAxisReachesBeyondBothEnds) {
  EXPECT_EQ(labels(enclosing_axis(-0.03, 0.31, 8)),
            (Labels{"\u22120.05", "0", "0.05", "0.10", "0.15", "0.20", "0.25", "0.30", "0.35"}));
}

TEST(Axis, FractionRunsFromZeroToOne) {
  const Axis axis = exact_axis(2, 4, 4);
  EXPECT_EQ(axis.fraction(2), 0);
  EXPECT_EQ(axis.fraction(3), 0.5);
  EXPECT_EQ(axis.fraction(4), 1);
}

}  // namespace
}  // namespace thinwall
