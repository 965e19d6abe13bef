#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/equilibrium/BodyModel.hpp"
#include "engine/equilibrium/Equilibrium.hpp"
#include "engine/equilibrium/Newton.hpp"
#include "engine/simulation/BodyState.hpp"

namespace thinwall {

/// What runs out of a body through openings of its wall in a step, and the air that comes in.
///
/// Fluid leaves by FlowMemory's rule, seen from the lips: those that draw back over it let it out without pressure. A
/// chamber ends each step in one of three states: filled, with a pressure at its openings that is not negative;
/// drained, where the pressure at the highest opening is zero and as much has left as the wall has pressed out; or with
/// air that came in there. Without gravity the pressure is then zero and the volume free; under gravity the air lies
/// above the fluid, see OpenChambers, and fluid leaves through lips that are below its surface. A chamber with nothing
/// left in it is empty, whatever wall and caps enclose: less than nothing where a wall is turned inside out. States are
/// tried until one holds. In a filled chamber fluid may hang from the wall under suction, as below an opening at the
/// bottom; air that has come in ends that.
///
/// Looks at model and state, from which the step sets out, and must not outlive them.
class Leakage {
 public:
  /// `gravity`: metres / second^2. `duration`: seconds.
  Leakage(const BodyModel& model, const BodyState& state, const Eigen::Vector3d& gravity, double duration)
      : model_(model), state_(state), gravity_(gravity), duration_(duration) {}

  /// Takes from the fluids of a problem what leaves whatever the pressure, and lets the rest leave, in the states that
  /// the chambers are in. The problem has its fluids, and knows nothing of openings yet.
  void add_to(EquilibriumProblem& problem) const;

  /// Whether a solution does not hold with the states of chambers that it was found with; the problem has others then.
  /// `presses_out`: whether a chamber that would turn from drained to filled again presses out at once what it has no
  /// room for.
  bool revise(EquilibriumProblem& problem, const EquilibriumTerms& terms, const EquilibriumState& reached,
              bool presses_out) const;

  /// What has left through each opening, (openings), metres^3, in a solution.
  std::vector<double> flown(const EquilibriumProblem& problem, const EquilibriumTerms& terms,
                            const EquilibriumState& reached) const;

 private:
  /// What leaves through an opening whatever the pressure, metres^3.
  double share(const EquilibriumProblem& problem, int opening) const;
  /// Speed at which the fluid comes to the lips of an opening as both move, metres / second; zero where it stays
  /// behind.
  double approach_to(int opening) const;
  /// Under gravity above the fluid, from an opening on.
  void let_air_in(int chamber, int opening, EquilibriumProblem& problem) const;
  /// What may leave a chamber in the step, metres^3.
  double at_hand(const EquilibriumProblem& problem, int chamber) const;
  /// What is in it at the end, metres^3.
  double remaining(const EquilibriumProblem& problem, const EquilibriumTerms& terms, int chamber,
                   const EquilibriumState& reached) const;
  /// Brings what leaves at the vent of a drained chamber to what the wall has pressed out. `left`: metres^3, of fluid
  /// at the end of the step, before that.
  double flown_at_vent(const EquilibriumProblem& problem, const EquilibriumTerms& terms, int chamber, double left,
                       const EquilibriumState& reached) const;

  const BodyModel& model_;
  const BodyState& state_;
  Eigen::Vector3d gravity_;
  double duration_;
};

/// Nothing has leaked yet, and no air come in.
void start_leaks(const BodyModel& model, BodyState& state);

/// Measures the openings as they are, those that needles shut as 0.
void measure_openings(const BodyModel& model, BodyState& state);

/// Lets out of a state at the end of a step what has flown in it, see Leakage. `terms`: of the solution.
void leak(const BodyModel& model, const Eigen::Vector3d& gravity, double duration, const EquilibriumProblem& problem,
          const EquilibriumTerms& terms, BodyState& state);

/// Energy that has left with the fluid in a step to a state, joule: the work of its pressure, its motion, and what a
/// compressible one still stores less than that work; not its weight, which counts in `leaked_gravity` from then on.
double book_leaks(const BodyModel& model, const Eigen::Vector3d& gravity, const BodyState& before, BodyState& state);

}  // namespace thinwall
