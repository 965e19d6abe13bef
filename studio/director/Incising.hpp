#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/simulation/Body.hpp"
#include "studio/director/IncisionPlan.hpp"
#include "studio/director/Schedule.hpp"

namespace thinwall {

/// A step of a clip that drives a blade.
struct BladeStep {
  int tool = 0;      // index
  double begin = 0;  // seconds since the clip began
  double end = 0;
  std::span<const ToolPose> after = {};  // (tools), at its end
};

/// What a slit as long as the blade is wide costs where the path begins, joule: toughness times thickness times width.
double cost_of_entry(const Body& body, const IncisionPlan& plan, const ToolDefinition& blade);

/// Notes what the entry of a blade costs when its clip begins.
void begin_incision(IncisionPlan& plan, const Body& body, const ToolDefinition& blade);

/// What the blade does to the wall during a step; nothing while it is not in the wall, or goes out of it again.
std::optional<BladeInput> blade_input(const IncisionPlan& plan, const Body& body, const BladeStep& step);

/// After a step: lets the blade go through the wall once it has put `IncisionPlan::entry_cost` into the dent that it
/// makes, or has to go on along its path, at the path's beginning where it came there within the step; cuts the wall up
/// to the blade; frees the wall from it when the clip ends. Says what has been cut. Throws SimulationFailure as
/// Body::follow_blade does.
std::optional<Cut> incise(IncisionPlan& plan, Body& body, const BladeStep& step);

/// After that: lets the cut run ahead of the blade by one piece along the path where that pays, straight on beyond the
/// path's end; see Body::run_ahead.
std::optional<Cut> run_ahead(const IncisionPlan& plan, Body& body, const BladeStep& step);

/// That the cuts of a body have run ahead of blades.
struct RunningCut {
  std::string blade;  // the first one
  double since = 0;   // seconds, of time
};

/// After a step: notes in `plan` how much of its path the blade passed above the wall since its first cut: where its
/// edge met no wall, and there was some below its tip, no deeper than the blade is long. Over an open wound there is
/// none.
void note_wall_below(IncisionPlan& plan, const Body& body, const ToolDefinition& blade, const BladeStep& step);

/// After a step: notes in `plan` how much of its path the blade went through what was cut before.
void note_open_wall(IncisionPlan& plan, const Body& body, const BladeStep& step);

/// Sentences for the user: which blades have passed above a wall by more than their width.
std::vector<std::string> passed_over_notes(std::span<const ScheduledClip> clips, std::span<const ToolDefinition> tools);

/// A sentence for the user.
std::string to_text(const RunningCut& run, const Body& body);

}  // namespace thinwall
