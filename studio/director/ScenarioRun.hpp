#pragma once

#include <memory>
#include <string>
#include <vector>

#include "renderer/snapshot/Snapshot.hpp"
#include "studio/record/StepRecord.hpp"
#include "studio/record/TimedText.hpp"
#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// Plays the timeline of a scenario against the engine, step by step. Needs no GL and writes no file.
class ScenarioRun {
 public:
  /// Makes the bodies and lets them find their equilibrium; then time is zero and the first record is there.
  /// Throws InputErrors (a mesh that cannot be used, a clip whose line misses the body), SimulationFailure.
  explicit ScenarioRun(const Scenario& scenario);
  ~ScenarioRun();
  ScenarioRun(ScenarioRun&&) noexcept;
  ScenarioRun& operator=(ScenarioRun&&) noexcept;

  /// Advances by one time step; false, and nothing done, when the timeline has ended. Throws SimulationFailure;
  /// what was reached before stays readable.
  bool step();

  double time() const;  // seconds
  /// The length of the timeline, seconds: exact once all clips have begun, before that planned on the surfaces at time
  /// zero.
  double planned_duration() const;

  const Snapshot& snapshot() const;
  const StepRecord& record() const;

  /// Captions and chapters of the clips begun so far, in order of time; ends are as planned.
  std::vector<TimedText> captions() const;
  std::vector<TimedText> chapters() const;

  /// Things that a user should know but that did not stop the run: one sentence each.
  std::vector<std::string> warnings() const;

  /// Hash of positions, velocities, pressures and tool forces to the last bit: 32 hexadecimal digits.
  std::string state_digest() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace thinwall
