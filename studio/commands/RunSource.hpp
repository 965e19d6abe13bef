#pragma once

#include <memory>

#include "studio/record/Moment.hpp"
#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// The simulation of a scenario as something to record. It begins (bodies, equilibrium) with the first moment asked
/// for, so that a GL context can come up meanwhile; that call may throw InputErrors too.
/// A scenario with a comparison is simulated twice: each moment has the second take's snapshot.
std::unique_ptr<MomentSource> simulate_scenario(const Scenario& scenario);

/// Of a scenario with a comparison the first take alone.
std::unique_ptr<MomentSource> simulate_one_take(const Scenario& scenario);

}  // namespace thinwall
