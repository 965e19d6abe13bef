#include <algorithm>
#include <cmath>

#include "engine/fluid/EnclosedVolume.hpp"
#include "engine/simulation/Body.hpp"

namespace thinwall {
namespace {

/// Part of its volume by which a body is filled from one equilibrium to the next, and drained.
constexpr double kFilled = 0.35;
constexpr double kDrained = 0.15;
constexpr double kLeastFilled = 0.02;

/// Of the way down to the limit point, where the wall bears most.
constexpr int kMostDrainings = 20;

/// Of solutions that tell how the pressure goes.
constexpr double kLooseTolerance = 1e-2;
constexpr int kMostIterations = 25;

}  // namespace

std::optional<double> Body::pressure_at(double volume, const EquilibriumProblem& whole, EquilibriumState& state) {
  EquilibriumProblem problem = whole;
  problem.fluids[0] = {.mode = FluidMode::kIncompressible, .fluid_volume = volume};
  if (!solve(problem, state, {.most_iterations = kMostIterations, .tolerance = kLooseTolerance, .takes_flaps = true})
           .converged)
    return {};
  return state.pressure[0];
}

std::optional<double> Body::most_borne(const EquilibriumProblem& whole, double most_volume,
                                       const EquilibriumState& grown) {
  if (whole.fluids.size() != 1 || whole.fluids[0].mode != FluidMode::kGivenPressure) return {};
  const double wanted = whole.fluids[0].pressure;
  double volume = enclosed_volumes(*model_, grown.position)[0];
  EquilibriumState state = grown;
  const std::optional<double> first = pressure_at(volume, whole, state);
  if (!first || *first >= wanted) return {};
  double most = *first;
  EquilibriumState less = state;
  for (int k = 1; k <= kMostDrainings; ++k) {
    const std::optional<double> pressure = pressure_at(volume * std::pow(1 - kDrained, k), whole, less);
    if (!pressure || *pressure < most) break;
    if (*pressure >= wanted) return {};
    most = *pressure;
  }
  for (double filled = kFilled; volume < most_volume * model_->rest_volume;) {
    EquilibriumState more = state;
    const std::optional<double> pressure = pressure_at((1 + filled) * volume, whole, more);
    if (pressure && *pressure >= wanted) return {};
    if (pressure) {
      volume *= 1 + filled;
      state = more;
      most = std::max(most, *pressure);
    } else {
      filled *= 0.5;
      if (filled < kLeastFilled) return {};
    }
  }
  return most;
}

}  // namespace thinwall
