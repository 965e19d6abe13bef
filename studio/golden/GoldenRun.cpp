#include "studio/golden/GoldenRun.hpp"

#include <algorithm>
#include <system_error>

#include "renderer/metric/Tiles.hpp"
#include "studio/golden/GoldenCache.hpp"
#include "studio/golden/GoldenVideoComparison.hpp"
#include "studio/recorder/Interruption.hpp"

namespace thinwall {
namespace {

GoldenResult without_comparison(const Scenario& scenario, const GoldenDefinition& golden, GoldenOutcome outcome,
                                const std::string& why) {
  GoldenResult result;
  result.scenario = scenario.name;
  result.at = golden.at;
  result.is_video = golden.video > 0;
  result.outcome = outcome;
  result.message = why;
  return result;
}

/// A picture within its limits whose simulation or drawing has changed is good, but worth a word.
void mention_changes(GoldenResult& result, const GoldenPicture& picture, const std::filesystem::path& folder) {
  const std::vector<GoldenApproval> approvals = read_approvals(folder);
  const GoldenApproval* approval = find_approval(approvals, result.at, result.driver);
  if (approval == nullptr) return;
  const HistoryChange change = history_change(picture, *approval, folder);
  if (change.changed) result.message += "; within the limits, though physics changed " + change.sentence;
  const bool is_drawn_differently =
      approval->driver == result.driver && !approval->scene_hash.empty() && approval->scene_hash != picture.scene_hash;
  if (result.state.verdict == StateVerdict::kEqual && is_drawn_differently) {
    result.message += "; within the limits, though the same state is drawn differently";
  }
}

GoldenResult judge_video(JudgedScenario& judged, std::size_t index, const GoldenRunOptions& options) {
  const Scenario& scenario = judged.scenario;
  const GoldenDefinition& definition = scenario.goldens[index];
  judged.video = record_golden_video(scenario, definition.video, options.sources, options.painters(scenario.resolved),
                                     options.videos / scenario.name);
  VideoJudgement judgement =
      compare_with_golden_video(scenario.name, definition, *judged.video, options.goldens / scenario.name);
  judged.attributions[index] = std::move(judgement.attribution);
  return std::move(judgement.result);
}

GoldenResult judge_picture(JudgedScenario& judged, std::size_t index, const GoldenRunOptions& options) {
  const Scenario& scenario = judged.scenario;
  const GoldenDefinition& definition = scenario.goldens[index];
  const std::filesystem::path folder = options.goldens / scenario.name;
  if (!judged.pictures.no_device.empty()) {
    return without_comparison(scenario, definition, GoldenOutcome::kSkipped, judged.pictures.no_device);
  }
  const GoldenPicture& picture = judged.pictures.pictures[index];
  GoldenResult result = compare_with_golden(scenario.name, definition, picture, judged.pictures.driver, folder);
  if (result.outcome == GoldenOutcome::kFailed) {
    judged.attributions[index] = attribute(scenario, picture, result, folder, options.painters);
  } else if (result.outcome == GoldenOutcome::kOk) {
    mention_changes(result, picture, folder);
  }
  return result;
}

void judge(JudgedScenario& judged, const GoldenRunOptions& options) {
  const Scenario& scenario = judged.scenario;
  judged.pictures = golden_pictures(scenario, options.sources, options.painters(scenario.resolved));
  judged.attributions.resize(scenario.goldens.size());
  for (std::size_t i = 0; i < scenario.goldens.size(); ++i) {
    throw_if_interrupted();
    // One golden that is damaged says nothing of the others.
    try {
      const bool is_video = scenario.goldens[i].video > 0;
      judged.results.push_back(is_video ? judge_video(judged, i, options) : judge_picture(judged, i, options));
    } catch (const GoldenError& error) {
      judged.results.push_back(without_comparison(scenario, scenario.goldens[i], GoldenOutcome::kBroken, error.what()));
    }
  }
}

/// Of a scenario that cannot be judged: each of its goldens is broken. No other shall go untested for it.
void tell_broken(JudgedScenario& judged, const std::string& why) {
  judged.attributions.clear();
  judged.results.clear();
  for (const GoldenDefinition& golden : judged.scenario.goldens) {
    judged.results.push_back(without_comparison(judged.scenario, golden, GoldenOutcome::kBroken, why));
  }
}

void judge_or_tell_why_not(JudgedScenario& judged, const GoldenRunOptions& options) {
  try {
    judge(judged, options);
  } catch (const InputErrors& errors) {
    tell_broken(judged, errors.what());
  }
}

/// At a video that is good there is nothing to look at, and its frames take more room than all goldens; those from when
/// it was not good yet are outdated.
void remove_good_recording(const JudgedScenario& judged, const GoldenRunOptions& options) {
  const bool is_good = std::ranges::any_of(judged.results, [](const GoldenResult& result) {
    return result.is_video && result.outcome == GoldenOutcome::kOk;
  });
  if (!is_good || options.videos.empty()) return;
  std::error_code ignored;
  std::filesystem::remove_all(options.videos / judged.scenario.name, ignored);
  std::filesystem::remove(options.videos, ignored);  // where it is empty
}

/// Of the scenarios that nothing is known of, finds those that are good in other processes.
void look_in_other_processes(const std::vector<const Scenario*>& scenarios, const GoldenRunOptions& options,
                             GoldenCache& cache) {
  if (options.jobs < 2 || scenarios.size() < 2 || !options.in_other_process) return;
  std::vector<std::filesystem::path> files(scenarios.size());
  for_each_in_parallel(
      scenarios.size(),
      [&](std::size_t i) {
        throw_if_interrupted();
        files[i] = options.in_other_process(*scenarios[i]);
      },
      options.jobs);
  std::error_code ignored;
  for (const std::filesystem::path& file : files) {
    cache.take_over(file);
    std::filesystem::remove_all(file.parent_path(), ignored);
  }
}

/// No result is the worse for a cache that cannot be written.
void keep_what_was_good(const GoldenCache& cache, const GoldenRunOptions& options) {
  try {
    cache.write_to(*options.cache);
  } catch (const PictureFailure& failure) {
    if (options.cannot_keep) options.cannot_keep(failure);
  }
}

}  // namespace

std::vector<JudgedScenario> judge_scenarios(std::vector<Scenario> scenarios, const GoldenRunOptions& options,
                                            const std::function<void(const JudgedScenario&)>& done) {
  std::optional<GoldenCache> cache;
  if (options.cache) cache.emplace(*options.cache, options.program);
  std::vector<std::string> keys(scenarios.size());
  std::vector<bool> known(scenarios.size(), false);
  std::vector<const Scenario*> unknown;
  for (std::size_t i = 0; cache && i < scenarios.size(); ++i) {
    if (options.anew) cache->forget(scenarios[i]);
    keys[i] = cache->key(scenarios[i], options.goldens / scenarios[i].name);
    known[i] = !cache->find(scenarios[i], keys[i]).empty();
    if (!known[i]) unknown.push_back(&scenarios[i]);
  }
  if (cache) look_in_other_processes(unknown, options, *cache);
  std::vector<JudgedScenario> all;
  for (std::size_t i = 0; i < scenarios.size(); ++i) {
    throw_if_interrupted();
    JudgedScenario judged;
    judged.scenario = std::move(scenarios[i]);
    judged.from_cache = known[i];
    if (cache) judged.results = cache->find(judged.scenario, keys[i]);
    if (judged.results.empty()) {
      judge_or_tell_why_not(judged, options);
      if (cache) cache->keep(judged.scenario, keys[i], judged.results);
    }
    judged.attributions.resize(judged.results.size());
    remove_good_recording(judged, options);
    done(judged);
    all.push_back(std::move(judged));
  }
  if (cache) keep_what_was_good(*cache, options);
  return all;
}

JudgedScenario unreadable_scenario(const std::filesystem::path& file, const InputErrors& errors) {
  JudgedScenario judged;
  judged.scenario.name = file.stem().string();
  judged.scenario.file = file;
  judged.scenario.goldens = {{.location = errors.diagnostics().front().location}};
  tell_broken(judged, errors.what());
  judged.results.front().is_scenario = true;
  judged.attributions.resize(1);
  return judged;
}

std::string cause_line(const JudgedScenario& judged, std::size_t index) {
  const std::optional<Attribution>& attribution = judged.attributions[index];
  return attribution ? attribution->sentence : judged.results[index].message;
}

}  // namespace thinwall
