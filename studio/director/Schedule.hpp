#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "studio/director/Plan.hpp"
#include "studio/record/TimedText.hpp"

namespace thinwall {

/// Times closer than this are the same: what rounding leaves between sums of steps and of durations.
inline constexpr double kTimeTolerance = 1e-9;  // seconds

/// A clip with when it plays: as planned on the surfaces at time zero until it begins, then for good.
struct ScheduledClip {
  Plan plan;
  double begin = 0;  // seconds
  double end = 0;    // seconds
  bool begun = false;
};

/// Clips follow one another unless they say when they start. `clips`: (timeline); those that have begun stay.
void schedule(std::span<const Clip> timeline, std::span<ScheduledClip> clips);

/// How long a clip lasts depends on where its tool meets the wall, so two clips of one tool, or of two blades in one
/// body, may be found to play at once only here. Throws InputErrors then.
void refuse_overlaps(std::span<const Clip> timeline, std::span<const ScheduledClip> clips);

/// A tool's way from its stand-off is known here only, and may take for ever. `time_step`: seconds. Throws InputErrors
/// where a clip ends after more than kMostSteps.
void refuse_endless(std::span<const Clip> timeline, std::span<const ScheduledClip> clips, double time_step);

/// Lets a palpation or piercing that has begun stay at its full depth until a step ends: forces are asked for at the
/// ends of steps only, and none would show the peak. Not where clips of one tool would then play at once. `clips`: as
/// `schedule` and `refuse_overlaps` leave them; `time_step`: seconds.
void turn_at_step_end(std::span<const Clip> timeline, std::span<ScheduledClip> clips, std::size_t index,
                      double time_step);

/// Plans moves from where the clips before them leave their tools, as far as that is known at time zero. `clips` have
/// been scheduled. Throws InputErrors as `plan_move` does.
void foresee_moves(std::span<const Clip> timeline, std::span<ScheduledClip> clips);

/// The clips that drive tools in a step that begins at `from` and lasts `until`, seconds, by the tool's name: of two
/// that hand a tool over within the step the later one.
std::map<std::string, std::size_t> driving_clips(std::span<const Clip> timeline, std::span<const ScheduledClip> clips,
                                                 double from, double until);

/// When the last clip ends, seconds.
double end_of(std::span<const ScheduledClip> clips);

/// Captions or chapters of the clips begun so far, in order of time.
std::vector<TimedText> texts_of(std::span<const Clip> timeline, std::span<const ScheduledClip> clips, bool chapters);

}  // namespace thinwall
