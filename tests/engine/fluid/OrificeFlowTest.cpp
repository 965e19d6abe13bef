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

TEST(ApproachedOrificeFlow, GoesThroughAsItComesWithoutPressureAndAsBernoullisWithoutApproach) {
  for (const double approach : {0.01, 1.0}) {
    EXPECT_NEAR(approached_orifice_flow(0.61, 2e-6, 1000, 0, approach).rate, 2e-6 * approach, 1e-20);
  }
  const Flow even = orifice_flow(0.61, 2e-6, 1000, 100);
  EXPECT_EQ(approached_orifice_flow(0.61, 2e-6, 1000, 100, 0).rate, even.rate);
  EXPECT_NEAR(approached_orifice_flow(0.61, 2e-6, 1000, 100, 1e-6).rate, even.rate,
              1e-11 * even.rate);  // (1e-6 / 0.45)^2 / 2
}

TEST(ApproachedOrificeFlow, ContractsByHalfAsBordasMouthpieceWhereTheLipsMoveFast) {
  // The mean of what comes and of what leaves, whatever the coefficient of lips that stand still.
  const double approach = 1, leaves = std::sqrt(approach * approach + 2 * 500 / 1000.0);
  for (const double coefficient : {0.5, 0.61, 0.7}) {
    EXPECT_NEAR(approached_orifice_flow(coefficient, 2e-6, 1000, 500, approach).rate, 2e-6 * 0.5 * (approach + leaves),
                1e-12)
        << coefficient;
  }
}

TEST(ApproachedOrificeFlow, HasTheSlopeOfItsRate) {
  for (const double approach : {0.01, 0.1, 1.0}) {
    for (const double pressure : {-20.0, 0.3, 20.0, 3000.0}) {
      const double h = 1e-5 * std::abs(pressure);
      const double difference = (approached_orifice_flow(0.61, 2e-6, 1000, pressure + h, approach).rate -
                                 approached_orifice_flow(0.61, 2e-6, 1000, pressure - h, approach).rate) /
                                (2 * h);
      const double slope = approached_orifice_flow(0.61, 2e-6, 1000, pressure, approach).slope;
      EXPECT_NEAR(slope, difference, 1e-7 * slope) << approach << " m/s, " << pressure << " Pa";
    }
  }
}

/// Power that the jet takes along through lips that move into the fluid, watt / metre^2: what the pressure does on the
/// fluid that leaves and on that between old lips and new, and the motion that the fluid had.
double power_of_jet(double coefficient, double pressure, double approach, double fluid_speed) {
  const double flow = approached_orifice_flow(coefficient, 1, 1000, pressure, approach).rate;
  return pressure * (flow + fluid_speed - approach) + 0.5 * 1000 * fluid_speed * fluid_speed * flow;
}

TEST(ApproachedOrificeFlow, GivesTheJetNoLessEnergyThanNone) {
  for (const double coefficient : {0.5, 0.61, 1.0}) {
    for (const double approach : {0.0, 0.03, 0.2, 1.0}) {
      for (double speed = -2; speed < 2; speed += 0.01) {
        for (const double pressure : {1.0, 20.0, 500.0}) {
          EXPECT_GT(power_of_jet(coefficient, pressure, approach, speed), -1e-4 * pressure);
        }
      }
    }
  }
  // With Borda's contraction that is the energy of the jet as it flies on.
  const double leaves = std::sqrt(0.04 + 2 * 500 / 1000.0), flow = 0.5 * (0.2 + leaves);
  EXPECT_NEAR(power_of_jet(0.5, 500, 0.2, -0.3), 0.5 * 1000 * flow * std::pow(leaves - 0.2 - 0.3, 2), 1e-3);
}

}  // namespace
}  // namespace thinwall
