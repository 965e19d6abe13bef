#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

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

/// Multiple of the volume that it had beyond which a body under a given pressure has burst: past its limit point a
/// wall under constant pressure grows without end.
constexpr double kBurstVolume = 30;

/// The same of the area of a wall without contents under a load that is a pressure, as a sheet that is held at its
/// border.
constexpr double kBurstArea = 10;

/// Multiple of the volume from which on it is asked what pressure the wall bears, and by how many times it grows until
/// that is asked again where there was no answer, as in a wall that lies in folds.
constexpr double kGrownVolume = 1.5;
constexpr double kAskedAgain = 2;

/// How many times the volume a body encloses that it had, or its rest volume where that is more.
double times_its_volume(const BodyModel& model, const EquilibriumState& state, double had) {
  return model.has_fluid() ? enclosed_volumes(model, state.position).sum() / std::max(had, model.rest_volume) : 1;
}

/// Metres^2 of a wall without contents that a pressure loads; 0 of any other.
double pressed_area(const BodyModel& model, const EquilibriumProblem& problem, const EquilibriumState& state) {
  bool is_pressed = false;
  for (std::size_t k = 0; k < model.loads.size(); ++k) {
    const double factor = k < problem.load_factors.size() ? problem.load_factors[k] : 1;
    is_pressed = is_pressed || (model.loads[k].kind == LoadKind::kFollowerPressure && factor != 0);
  }
  if (model.has_fluid() || !is_pressed) return 0;
  double area = 0;
  for (const Eigen::Vector3i& triangle : model.definition.mesh.triangles) {
    const auto corners = corners_of(triangle, state.position);
    area += 0.5 * (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm();
  }
  return area;
}

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

NewtonResult Body::burst(const std::optional<MostBorne>& most) {
  std::ostringstream reason;
  reason << "it bursts: it grows without end, past ";
  reason << (model_->has_fluid() ? kBurstVolume : kBurstArea) << " times its "
         << (model_->has_fluid() ? "volume" : "area");
  if (most) {
    const std::string& chamber = model_->chambers[most->chamber].name;
    reason << ", as " << (chamber.empty() ? "its wall" : "the wall of its chamber `" + chamber + "`") << " bears "
           << std::fixed << std::setprecision(most->pressure < 100 ? 2 : 0) << most->pressure << " Pa at most";
  }
  bursts_ = true;
  report_.is_past_bearing = most.has_value();
  return fail(reason.str());
}

Body::Growth Body::growth_from(const EquilibriumProblem& problem, const EquilibriumState& state) const {
  return {.had = model_->has_fluid() ? enclosed_volumes(*model_, state.position).sum() : 0,
          .most_area = kBurstArea * pressed_area(*model_, problem, state),
          .asked_at = kGrownVolume};
}

std::optional<NewtonResult> Body::burst_of(Growth& growth, const EquilibriumProblem& problem,
                                           const EquilibriumState& state) {
  const double grown = times_its_volume(*model_, state, growth.had);
  if (grown > kBurstVolume || pressed_area(*model_, problem, state) > growth.most_area) return burst();
  if (grown <= growth.asked_at) return {};
  growth.asked_at = kAskedAgain * grown;
  if (const auto most = most_borne(problem, kBurstVolume, state)) return burst(most);
  return {};
}

}  // namespace thinwall
