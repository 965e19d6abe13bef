#include "renderer/overlay/ForceCurve.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace thinwall {
namespace {

constexpr Box kArea{10, 20, 100, 50};

TEST(ForceCurve, EndsOfTheAxesAreTheEdgesOfTheArea) {
  const auto points = curve_in_pixels({{0, 0}, {2, 8}}, exact_axis(0, 2, 2), exact_axis(0, 8, 4), kArea);
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[0].x, 10);
  EXPECT_EQ(points[0].y, 70);
  EXPECT_EQ(points[1].x, 110);
  EXPECT_EQ(points[1].y, 20);
}

TEST(ForceCurve, LongRecordKeepsPeaksAndDipsOfEachColumnAndFewPoints) {
  std::vector<PlotPoint> curve;
  for (int i = 0; i <= 100000; ++i) curve.push_back({i * 1e-5, 0.5});
  curve[41234].y = curve[72500].y = 1;  // a peak before a dip, and one after it, in one column each
  curve[41500].y = curve[72234].y = 0;
  const auto points = curve_in_pixels(curve, exact_axis(0, 1, 5), exact_axis(0, 1, 5), kArea);
  EXPECT_LE(points.size(), 4u * 101u);
  const auto count_at = [&](double y) {
    return std::count_if(points.begin(), points.end(), [&](const PlotPoint& point) { return point.y == y; });
  };
  EXPECT_EQ(count_at(20), 2);
  EXPECT_EQ(count_at(70), 2);
  EXPECT_TRUE(
      std::is_sorted(points.begin(), points.end(), [](const PlotPoint& a, const PlotPoint& b) { return a.x < b.x; }));
  EXPECT_EQ(points.back().x, 110);
}

TEST(ForceCurve, NothingStaysNothing) {
  EXPECT_TRUE(curve_in_pixels({}, exact_axis(0, 1, 5), exact_axis(0, 1, 5), kArea).empty());
}

}  // namespace
}  // namespace thinwall
