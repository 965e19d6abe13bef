#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "studio/expectation/ExpectationCheck.hpp"
#include "studio/recorder/Recorder.hpp"

namespace thinwall {

/// What a manifest says besides the recording's own report.
struct ManifestContext {
  std::string command;                                         // "run" or "render"
  std::filesystem::path source;                                // the scenario or take, as it was named
  std::string device;                                          // as asked for
  std::vector<std::pair<std::string, std::string>> overrides;  // of `--set`
  std::vector<std::string> warnings = {};                      // of the scenario, as it was read
  std::vector<std::string> told = {};                          // of the notes, those that have been said already
  double preparation = 0;                                      // seconds, reading and checking
  std::vector<ExpectationResult> expectations = {};            // of the scenario
  bool take_complete = true;  // whether each take that is shown again reached the end of its run
};

/// "ok", "the simulation failed", "the take ends early", "an expectation failed"
std::string result_words(const ManifestContext& context, const RecordingReport& report);

/// What a user should know: of the scenario as it was read, then of what came of it.
std::vector<std::string> all_warnings(const ManifestContext& context, const RecordingReport& report);

/// What came of each of a scenario's expectations, in its order.
nlohmann::ordered_json expectation_part(const std::vector<ExpectationResult>& results);

/// 32 hexadecimal digits: XXH3 (128 bits) of the text.
std::string text_hash(const std::string& text);

/// manifest.json of a recording: version of the format, scenario resolved and its hash, versions, licence, device,
/// options, times, steps, warnings, frame hashes, files, result, and the seed of the cameras' noise: a number, by
/// camera where they have several, null where there is no noise.
std::string manifest(const ManifestContext& context, const RecordingPlan& plan, const RecordingReport& report);

}  // namespace thinwall
