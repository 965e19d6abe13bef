#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "studio/golden/Attribution.hpp"
#include "studio/golden/GoldenComparison.hpp"

namespace thinwall {

/// A scenario with all that is known of its goldens today.
struct JudgedScenario {
  Scenario scenario;
  GoldenPictures pictures;                               // none when the cache answered
  std::vector<GoldenResult> results;                     // (scenario.goldens)
  std::vector<std::optional<Attribution>> attributions;  // (scenario.goldens), of those that failed
  bool from_cache = false;
};

struct GoldenRunOptions {
  SourceFactory sources;
  ViewPainters painters;
  std::filesystem::path goldens;               // the folder that holds a folder for each scenario
  std::optional<std::filesystem::path> cache;  // a file with what was good before; absent: everything is made anew
  std::string program;                         // a hash of what simulates and draws, for the cache
  int jobs = 0;                                // scenarios at once; 0: as many as there are cores
};

/// Simulates, draws and compares, several scenarios at once; the results are in the order of the scenarios. `done` is
/// called for one after the other, in that order, as soon as it and those before it are ready.
std::vector<JudgedScenario> judge_scenarios(std::vector<Scenario> scenarios, const GoldenRunOptions& options,
                                            const std::function<void(const JudgedScenario&)>& done);

/// The cause of a failure in one line; the comparison's own words where nothing more is known.
std::string cause_line(const JudgedScenario& judged, std::size_t index);

}  // namespace thinwall
