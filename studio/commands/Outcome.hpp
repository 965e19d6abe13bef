#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "studio/recorder/Manifest.hpp"
#include "studio/recorder/Recorder.hpp"
#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// Says on stderr what a user should know of a scenario that can be run, a line each.
void tell_warnings(const Scenario& scenario);

/// Says on stderr what a user should know of a run.
void tell_note(const std::string& note);

/// Milliseconds of wall time by the names of the passes, in their order.
nlohmann::ordered_json passes_as_json(const std::vector<PassTime>& passes);

/// Ends a recording: writes manifest.json, says in a few lines on stderr what was made (as JSON on stdout when `json`),
/// and gives the exit code.
int conclude(const ManifestContext& context, const RecordingPlan& plan, const RecordingReport& report, bool json);

}  // namespace thinwall
