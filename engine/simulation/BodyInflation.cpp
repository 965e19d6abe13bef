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

/// Times the volume up to which it is filled at least, where that is large already.
constexpr double kLeastSearched = 4;

/// Of the way down to the limit point, where the wall bears most.
constexpr int kMostDrainings = 20;

/// Of solutions that tell how the pressure goes.
constexpr double kLooseTolerance = 1e-2;
constexpr int kMostIterations = 25;

/// Iterations after which no more is asked: a wall that lies in folds is filled in many small steps.
constexpr int kMostAsked = 400;

/// The one chamber whose pressure is given; none where there are several, or it is none.
std::optional<int> given_chamber(const EquilibriumProblem& problem) {
  std::optional<int> given;
  for (int c = 0; c < static_cast<int>(problem.fluids.size()); ++c) {
    if (problem.fluids[c].mode != FluidMode::kGivenPressure) continue;
    if (given) return {};
    given = c;
  }
  return given;
}

}  // namespace

std::optional<double> Body::pressure_at(double volume, int chamber, const EquilibriumProblem& whole,
                                        EquilibriumState& state) {
  EquilibriumProblem problem = whole;
  problem.fluids[chamber] = {.mode = FluidMode::kIncompressible, .fluid_volume = volume};
  if (!solve(problem, state,
             {.most_iterations = kMostIterations, .tolerance = kLooseTolerance, .takes_flaps = true, .buckles = true})
           .converged)
    return {};
  return state.pressure[chamber];
}

std::optional<Body::MostBorne> Body::most_borne(const EquilibriumProblem& whole, double most_volume,
                                                const EquilibriumState& grown) {
  const std::optional<int> chamber = given_chamber(whole);
  if (!chamber) return {};
  const int iterations_before = report_.newton_iterations;
  const double wanted = whole.fluids[*chamber].pressure;
  const double volume = enclosed_volumes(*model_, grown.position)[*chamber];
  const double end = std::max(most_volume * model_->chambers[*chamber].rest_volume, kLeastSearched * volume);
  EquilibriumState state = grown;
  const std::optional<double> first = pressure_at(volume, *chamber, whole, state);
  if (!first || *first >= wanted) return {};
  double most = *first;
  // Filled first: where the wall bears what is wanted a little farther on, no more is asked.
  double reached = volume;
  for (double filled = kFilled; reached < end;) {
    EquilibriumState more = state;
    const std::optional<double> pressure = pressure_at((1 + filled) * reached, *chamber, whole, more);
    if (pressure && *pressure >= wanted) return {};
    if (pressure) {
      reached *= 1 + filled;
      state = more;
      most = std::max(most, *pressure);
    } else {
      filled *= 0.5;
      if (filled < kLeastFilled) return {};
    }
    if (report_.newton_iterations > iterations_before + kMostAsked) return {};
  }
  state = grown;
  for (int k = 1; k <= kMostDrainings; ++k) {
    const std::optional<double> pressure = pressure_at(volume * std::pow(1 - kDrained, k), *chamber, whole, state);
    if (!pressure || *pressure < most) break;
    if (*pressure >= wanted) return {};
    most = *pressure;
  }
  return MostBorne{.chamber = *chamber, .pressure = most};
}

}  // namespace thinwall
