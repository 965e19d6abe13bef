#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/simulation/Body.hpp"
#include "studio/director/Schedule.hpp"
#include "studio/scenario/InputError.hpp"

namespace thinwall {

// What a run tells its reader of a scenario beside the results: one sentence each.

/// Of a body at time zero: that rigid motions of it are left free, which a quasi-static analysis has to remove, that
/// caps meet at corners which nothing holds, and that it is where it would buckle, of which the steps of a dynamic
/// analysis tell nothing.
std::vector<std::string> start_notes(const Body& body, const SimulationOptions& options);

/// That a tool is in the wall of a body before its first step, so that what drives them apart is work that nobody does;
/// nothing where it is not.
std::optional<std::string> buried_tool_note(const ToolDefinition& tool, const ToolPose& pose, const Body& body);

/// Of palpations that come upon their bodies from the side that is away from `at`, as with a `direction` the wrong way
/// round.
std::vector<std::string> far_side_notes(std::span<const Clip> timeline,
                                        const std::function<const Body&(const std::string&)>& body_of);

/// What tip a bare point acts like on the membrane that it touches, see effective_point_radius.
std::string bare_point_note(const ToolDefinition& tool, const SurfaceView& surface, const Attachment& attachment);

/// That a body which encloses a fluid is less wide than two walls are thick, and that a round tool is smaller than the
/// wall that a palpation presses is thick.
std::vector<std::string> thick_wall_notes(const Scenario& scenario, const BodyDefinition& body);

/// What helps where a wall that nothing stretches takes long, to be added to a sentence that says so; empty where there
/// is no such wall: a membrane without pressure and prestretch gives way across itself without a force.
std::string slack_wall_advice(const Scenario& scenario);

/// That a clip goes the way that it had when the run began, see kept_way. `number`: of the clip, from 1. `begin`:
/// seconds. `missed`: why it found none.
std::string kept_way_note(std::size_t number, double begin, const InputErrors& missed);

/// Tells that a clip which is to inflate a chamber to a pressure has to drain it, or the other way round; nothing where
/// it does as its verb says. `number`: of the clip, from 1.
std::optional<std::string> fill_note(std::size_t number, const FillPlan& plan);

/// Of the clips that have ended by `time`, seconds: needles that no wall has given way to, blades that have cut
/// nothing, and jaws that have closed on nothing, have not reached their grip, or have lost the wall that they held.
/// `clips`: (timeline).
std::vector<std::string> ended_clip_notes(std::span<const ScheduledClip> clips, double time);

}  // namespace thinwall
