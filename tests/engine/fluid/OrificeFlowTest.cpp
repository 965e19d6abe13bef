#include "engine/fluid/OrificeFlow.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace thinwall {
namespace {

TEST(OrificeFlow, IsBernoullisAboveTheLaminarPressure) {
  // The linear part changes the flow by (laminar / p)^2 / 4: 2.5e-7 at 100 Pa.
  const Flow flow = orifice_flow(0.61, 2e-6, 1000, 100);
  EXPECT_NEAR(flow.rate, 0.61 * 2e-6 * std::sqrt(2 * 100 / 1000.0), 3e-7 * flow.rate);
  EXPECT_NEAR(flow.slope, flow.rate / 200, 2e-6 * flow.slope);
}

TEST(OrificeFlow, IsOddAndSmoothThroughZero) {
  const Flow at_rest = orifice_flow(0.61, 2e-6, 1000, 0);
  EXPECT_EQ(at_rest.rate, 0);
  EXPECT_GT(at_rest.slope, 0);
  for (const double pressure : {1e-4, 0.01, 3.0}) {
    const Flow there = orifice_flow(0.61, 2e-6, 1000, pressure), back = orifice_flow(0.61, 2e-6, 1000, -pressure);
    EXPECT_EQ(there.rate, -back.rate);
    EXPECT_EQ(there.slope, back.slope);
    const double h = 1e-5 * pressure;
    const double difference =
        (orifice_flow(0.61, 2e-6, 1000, pressure + h).rate - orifice_flow(0.61, 2e-6, 1000, pressure - h).rate) /
        (2 * h);
    EXPECT_NEAR(there.slope, difference, 1e-8 * there.slope) << pressure;
  }
}

}  // namespace
}  // namespace thinwall
