#include "engine/simulation/StepAccuracy.hpp"

#include <algorithm>
#include <cmath>

namespace thinwall {
namespace {

/// Part of the largest of its energies that the integrator may take or give in a part of a step of a cut body: walls
/// that collapse, and jets that begin at once, ask for shorter ones. Where the wall jumps none is short enough.
constexpr double kMostUnbooked = 5e-4;
constexpr double kSmallestUnbookedPart = 1.0 / 64;

/// How much smaller a part may be in which a wall that is being let go of jumps and gives energy: the way is that of
/// the jump, however short the part, but the less is let go the better its work is known. Energy that this work does
/// not account for no such part mends.
constexpr double kSmallerWhereHeld = 1.0 / 16;

/// What it may give any body, for no wall jumps to where it has more energy than before: a solver that found such a
/// shape has gone astray, from less far away it finds one that is nearer.
constexpr double kMostGiven = 2.5e-3;

}  // namespace

double StepAccuracy::error(double duration) const {
  return options_.analysis == Analysis::kDynamic && options_.step_error > 0 ? missed(duration) / options_.step_error
                                                                            : 0;
}

double StepAccuracy::missed(double duration) const {
  const Eigen::VectorXd uniform = before_.equilibrium.position + duration * before_.velocity;
  if (before_.previous_step == 0) {
    // A backward Euler step misses half of the square of the step times the acceleration.
    return 0.5 * (after_.equilibrium.position - uniform).head(3 * model_.vertices()).lpNorm<Eigen::Infinity>();
  }
  // With j the third derivative, h the step and an equal one before, the prediction misses h^3 j / 6 on one side and
  // the backward difference 2 h^3 j / 9 on the other.
  const Eigen::VectorXd predicted = uniform + 0.5 * duration * duration * before_.acceleration;
  return 4.0 / 7 * (after_.equilibrium.position - predicted).head(3 * model_.vertices()).lpNorm<Eigen::Infinity>();
}

double StepAccuracy::script_doubt() const {
  const Eigen::VectorXd reached = after_.fluid_volume - before_.fluid_volume + after_.leaked - before_.leaked;
  const Eigen::VectorXd motion = after_.equilibrium.position - before_.equilibrium.position;
  const double of_fluids =
      reached.cwiseAbs().dot((after_.equilibrium.pressure - before_.equilibrium.pressure).cwiseAbs());
  return 0.5 * (of_fluids + motion.cwiseAbs().dot((after_.load_force - before_.load_force).cwiseAbs()));
}

double StepAccuracy::given() const {
  const double largest = after_.books.largest();
  // What holds the lips of a cut, or a dent, is among the loads, and has a measure of its own.
  const double doubt = before_.cut.held.empty() ? script_doubt() : 0;
  // Forces of a loose tolerance tell their work no better.
  const double most_given = std::max(kMostGiven, options_.tolerance);
  return std::max(0.0, -taken() - doubt) / (most_given * std::max(largest, model_.least_energy()));
}

double StepAccuracy::unbooked(bool is_calm) const {
  const double largest = after_.books.largest();
  // What walls take that jump or flaps that flutter, and what a drag takes up, is no matter of the step's length.
  const bool is_even = before_.cut.has_incised && is_calm && after_.drag_force.size() == 0;
  if (!is_even || largest == 0) return given();
  return std::abs(taken()) / (kMostUnbooked * largest);
}

double StepAccuracy::smallest_part(double largest_part) const {
  const bool jumps_held = !before_.cut.held.empty() && given() > 1 && -taken() < 2 * script_doubt();
  return kSmallestUnbookedPart * (before_.cut.has_incised ? 1 : largest_part) * (jumps_held ? kSmallerWhereHeld : 1);
}

}  // namespace thinwall
