#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/simulation/Body.hpp"

namespace thinwall {

/// What has to hold of a leaking body of one chamber after each step: its books close, the fluid and what has leaked
/// keep their sum, and there is no pressure while there is air.
struct LeakWatch {
  double whole = 0, worst_identity = 0, worst_imbalance = 0, largest = 0, lowest_pressure = 0, most_air = 0;
  bool both = false;  // air and pressure at once

  explicit LeakWatch(const Body& body) : whole(body.state().fluid_volume.sum()) {}
  void note_sums(const Body& body) {
    const BodyState& state = body.state();
    const double identity = (state.fluid_volume.sum() + state.leaked.sum()) / whole - 1;
    worst_identity = std::max(worst_identity, std::abs(identity));
    const double imbalance = state.books.imbalance();
    EXPECT_TRUE(std::isfinite(imbalance));
    worst_imbalance = std::max(worst_imbalance, std::abs(imbalance));
    for (const double term : {state.books.elastic, state.books.leak, state.books.gravity, state.books.script_work,
                              state.books.tool_work, state.books.kinetic}) {
      largest = std::max(largest, std::abs(term));
    }
  }
  void note(const Body& body) {
    note_sums(body);
    const BodyState& state = body.state();
    lowest_pressure = std::min(lowest_pressure, state.equilibrium.pressure[0]);
    most_air = std::max(most_air, state.air[0]);
    both = both || (state.air[0] > 0 && state.equilibrium.pressure[0] > 1e-6);
    EXPECT_NEAR(state.volume[0], state.fluid_volume[0] + state.air[0], 1e-9 * whole);
  }
  void expect_sound() const {
    EXPECT_FALSE(both);
    EXPECT_GT(lowest_pressure, -1e-6);
    EXPECT_LT(worst_identity, 1e-12);
    EXPECT_LT(worst_imbalance, 1e-9 * largest);
  }
};

}  // namespace thinwall
