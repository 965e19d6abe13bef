#include "renderer/overlay/LegendTicks.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace thinwall {
namespace {

std::vector<std::string> labels(const std::vector<LegendTick>& ticks) {
  std::vector<std::string> words;
  for (const LegendTick& tick : ticks) words.push_back(tick.label);
  return words;
}

TEST(LegendTicks, OfALinearScaleAreEvenlySpacedRoundNumbers) {
  const std::vector<LegendTick> ticks = legend_ticks(20, 60, DataScale::kLinear);
  EXPECT_EQ(labels(ticks), (std::vector<std::string>{"20", "30", "40", "50", "60"}));
  for (std::size_t k = 0; k < ticks.size(); ++k) {
    EXPECT_NEAR(ticks[k].place, 0.25 * static_cast<double>(k), 1e-15);
  }
}

TEST(LegendTicks, OfARootScaleStandAtTheRootsOfTheirPlaces) {
  const std::vector<LegendTick> ticks = legend_ticks(10, 35, DataScale::kRoot);
  ASSERT_GE(ticks.size(), 6U);
  for (const LegendTick& tick : ticks) EXPECT_NEAR(tick.place * tick.place, (tick.value - 10) / 25, 1e-15);
}

TEST(LegendTicks, OfARootScaleTellTheLowEndMoreFinely) {
  EXPECT_EQ(labels(legend_ticks(0, 1, DataScale::kRoot)),
            (std::vector<std::string>{"0", "0.02", "0.1", "0.2", "0.4", "0.6", "0.8", "1.0"}));
  EXPECT_EQ(labels(legend_ticks(0, 20, DataScale::kRoot)),
            (std::vector<std::string>{"0", "0.5", "2", "5", "10", "15", "20"}));
}

TEST(LegendTicks, AscendAndLeaveRoomForTheirNumbers) {
  for (double to = 1.1; to < 1e6; to *= 1.37) {
    for (const double from : {-0.7 * to, 0.0, 0.4 * to}) {
      const std::vector<LegendTick> ticks = legend_ticks(from, to, DataScale::kRoot);
      ASSERT_GE(ticks.size(), 3U) << from << " " << to;
      for (std::size_t k = 1; k < ticks.size(); ++k) {
        EXPECT_GT(ticks[k].value, ticks[k - 1].value);
        EXPECT_GT(ticks[k].place - ticks[k - 1].place, 0.07) << from << " " << to;
      }
    }
  }
}

TEST(LegendTicks, OfAnEmptyRangeAreItsOneNumber) {
  for (const DataScale scale : {DataScale::kLinear, DataScale::kRoot}) {
    const std::vector<LegendTick> ticks = legend_ticks(3, 3, scale);
    EXPECT_EQ(labels(ticks), (std::vector<std::string>{"3.00"}));
    EXPECT_EQ(ticks[0].place, 0);
  }
}

}  // namespace
}  // namespace thinwall
