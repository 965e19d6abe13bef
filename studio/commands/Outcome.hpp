#pragma once

#include "studio/recorder/Manifest.hpp"
#include "studio/recorder/Recorder.hpp"

namespace thinwall {

/// Ends a recording: writes manifest.json, says in a few lines on stderr what was made (as JSON on stdout when `json`),
/// and gives the exit code.
int conclude(const ManifestContext& context, const RecordingPlan& plan, const RecordingReport& report, bool json);

}  // namespace thinwall
