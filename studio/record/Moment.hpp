#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "renderer/snapshot/Snapshot.hpp"
#include "studio/record/StepRecord.hpp"
#include "studio/record/TimedText.hpp"

namespace thinwall {

/// All that is kept of one time step.
struct Moment {
  Snapshot snapshot;
  StepRecord record;
  double planned_duration = 0;      // seconds, of the whole, as known at this step
  std::vector<TimedText> captions;  // of the clips begun so far (from a finished take: of all), in order of time
  std::vector<TimedText> chapters;  // likewise
  std::shared_ptr<const Moment> second = {};  // of the take that this one is compared with, at the same time
};

/// What can be recorded or rendered: a simulation that is running, or a take.
class MomentSource {
 public:
  virtual ~MomentSource() = default;

  /// The next moment, in order of time, the first at time zero; empty at the end. Throws SimulationFailure or
  /// TakeError.
  virtual std::optional<Moment> next() = 0;

  /// Things that a user should know but that stopped nothing: one sentence each.
  virtual std::vector<std::string> warnings() const = 0;

  /// Hash of the state that the last moment was taken from, 32 hexadecimal digits.
  virtual std::string state_digest() const = 0;

  /// Likewise of the take that this one is compared with; empty when there is none.
  virtual std::string second_state_digest() const { return ""; }
};

}  // namespace thinwall
