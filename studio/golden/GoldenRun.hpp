#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "renderer/image/PictureFailure.hpp"
#include "studio/golden/Attribution.hpp"
#include "studio/golden/GoldenComparison.hpp"
#include "studio/golden/GoldenVideo.hpp"
#include "studio/scenario/InputError.hpp"

namespace thinwall {

/// A scenario with all that is known of its goldens today.
struct JudgedScenario {
  Scenario scenario;
  GoldenPictures pictures;                               // none when the cache answered
  std::optional<RecordedVideo> video = {};               // where the scenario has a golden of it
  std::vector<GoldenResult> results;                     // (scenario.goldens)
  std::vector<std::optional<Attribution>> attributions;  // (scenario.goldens), of those that failed
  bool from_cache = false;
};

/// Of a scenario that has goldens and cannot be read: one result, which is broken, for whatever goldens it has.
JudgedScenario unreadable_scenario(const std::filesystem::path& file, const InputErrors& errors);

struct GoldenRunOptions {
  SourceFactory sources;
  ViewPainters painters;
  std::filesystem::path goldens;               // the folder that holds a folder for each scenario
  std::optional<std::filesystem::path> cache;  // a file that keeps what was good; absent: nothing is kept
  bool anew = false;                           // what was good before counts for nothing
  std::filesystem::path videos = {};  // a folder for the videos that are recorded, one in a folder for each scenario;
                                      // those that are good do not stay
  std::string program;                // a hash of what simulates and draws, for the cache
  int jobs = 1;                       // scenarios at once, each in a process of its own
  // Tests a scenario in another process, which keeps what is good in a cache of its own: that file, in a folder that
  // holds nothing else of worth. Processes, because the libraries for orderings and for take files must not be used by
  // two threads at once.
  std::function<std::filesystem::path(const Scenario&)> in_other_process = {};
  std::function<void(const PictureFailure&)> cannot_keep = {};  // told where the cache cannot be written
};

/// Simulates, draws and compares; the goldens of a scenario whose files or approvals are wrong are broken; `done` is
/// called for one scenario after the other. With several jobs and a cache, other processes look first which scenarios
/// are good; only the others are made here.
std::vector<JudgedScenario> judge_scenarios(std::vector<Scenario> scenarios, const GoldenRunOptions& options,
                                            const std::function<void(const JudgedScenario&)>& done);

/// The cause of a failure in one line; the comparison's own words where nothing more is known.
std::string cause_line(const JudgedScenario& judged, std::size_t index);

}  // namespace thinwall
