#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/simulation/ToolResponse.hpp"
#include "renderer/snapshot/Snapshot.hpp"
#include "studio/record/StepRecord.hpp"
#include "studio/record/TimedText.hpp"
#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// A tool that somebody else than the timeline moves, and where to.
struct DrivenTool {
  int index = 0;  // in the order of the scenario
  ToolPose pose;
};

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

  /// Advances by `count` time steps at once, with a tool brought to a pose whatever its clips say, also beyond the end
  /// of the timeline. Throws SimulationFailure.
  void step_driven(int count, const DrivenTool& driven);

  /// What all bodies together do to a tool now, see Body::respond. `duration`: seconds; `reach`: metres.
  ToolResponse respond(int tool, double duration, double reach);

  /// Cuts and punctures made so far.
  long cuts() const;

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
