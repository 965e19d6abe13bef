#pragma once

#include "engine/equilibrium/BodyModel.hpp"
#include "engine/simulation/BodyState.hpp"
#include "engine/simulation/SimulationOptions.hpp"

namespace thinwall {

/// How far a step, or a part of one, is off: what shorter parts would mend. Looks at the body, at its state before and
/// at the one that the step has led to, and must not outlive them.
class StepAccuracy {
 public:
  StepAccuracy(const BodyModel& model, const SimulationOptions& options, const BodyState& before,
               const BodyState& after)
      : model_(model), options_(options), before_(before), after_(after) {}

  /// By what a vertex is off at most, over the allowed error of a step, from the third derivative of its way; 0 where
  /// that is not judged. `duration`: seconds.
  double error(double duration) const;

  /// What the integrator took or gave, over what it may. `is_calm`: whether no flaps flutter.
  double unbooked(bool is_calm) const;

  /// The smallest part of a step that is divided for that. `largest_part`: that tools and blades allow.
  double smallest_part(double largest_part) const;

 private:
  /// Metres by which a vertex is off at most.
  double missed(double duration) const;
  /// By what the work of loads and filling may be off, joule: it is told by its ends, and the way between them is known
  /// no better than that each force lay between its own at the ends.
  double script_doubt() const;
  /// What the integrator gave, over what it may.
  double given() const;
  /// What it took, joule.
  double taken() const { return after_.books.numerical - before_.books.numerical; }

  const BodyModel& model_;
  const SimulationOptions& options_;
  const BodyState& before_;
  const BodyState& after_;
};

}  // namespace thinwall
