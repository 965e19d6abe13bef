#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "renderer/image/WholeFile.hpp"
#include "studio/commands/Commands.hpp"
#include "studio/commands/DataViewRange.hpp"
#include "studio/commands/ExitCode.hpp"
#include "studio/commands/MisplacedNotes.hpp"
#include "studio/commands/Outcome.hpp"
#include "studio/commands/SecondTake.hpp"
#include "studio/director/StressFreeAnswers.hpp"
#include "studio/recorder/FolderLock.hpp"
#include "studio/recorder/FontNotes.hpp"
#include "studio/recorder/Interruption.hpp"
#include "studio/recorder/Painter.hpp"
#include "studio/recorder/RecordingNotes.hpp"
#include "studio/scenario/LoadScenario.hpp"

namespace thinwall {
namespace {

/// Lets the expectations see every moment that passes. What is known before the first step is said then: the steps may
/// take long, and a wrong unit shows by it.
class WatchedSource final : public MomentSource {
 public:
  WatchedSource(RecordedTakes& takes, const Scenario& scenario)
      : source_(std::move(takes.source)),
        second_duration_(takes.second_duration),
        scenario_(scenario),
        check_(scenario.expectations) {}

  std::optional<Moment> next() override {
    std::optional<Moment> moment = source_->next();
    if (moment) check_.add(moment->record);
    if (!has_begun_ && moment) {
      misplaced_ = misplaced_notes(scenario_, *moment, second_duration_);
      told_ = warnings();
      std::ranges::for_each(told_, tell_note);
    }
    has_begun_ = true;
    return moment;
  }
  std::vector<std::string> warnings() const override {
    std::vector<std::string> all = source_->warnings();
    all.insert(all.end(), misplaced_.begin(), misplaced_.end());
    return all;
  }
  std::string state_digest() const override { return source_->state_digest(); }
  const std::vector<std::string>& told() const { return told_; }
  std::vector<ExpectationResult> results() const { return check_.results(); }

 private:
  std::unique_ptr<MomentSource> source_;
  double second_duration_;  // seconds
  const Scenario& scenario_;
  std::vector<std::string> misplaced_;
  ExpectationCheck check_;
  std::vector<std::string> told_;
  bool has_begun_ = false;
};

}  // namespace

int run_scenario(const RunOptions& options) {
  StageTime preparation;
  Scenario scenario;
  {
    const StageClock clock(preparation);
    scenario = load_scenario(options.scenario, options.overrides, stress_free_answers());
  }
  std::ranges::copy(font_notes(scenario), std::back_inserter(scenario.warnings));
  tell_warnings(scenario);
  if (options.render) require_data_range(scenario.view.look);
  if (options.render && scenario.view.comparison) require_data_range(scenario.view.comparison->second.look);
  if (options.ground_truth) prepare_truth(scenario.view);
  const RecordingPlan plan{
      .folder = options.out.value_or(std::filesystem::path("out") / scenario.name),
      .description = {.name = scenario.name, .title = scenario.title, .resolved = scenario.resolved},
      .overlays = scenario.overlays,
      .view = scenario.view,
      .teaching = scenario.teaching,
      .size = scenario.record.size,
      .frames_per_second = scenario.record.frames_per_second,
      .pictures = options.render,
      .video = options.video && scenario.record.video,
      .frames = options.frames,
      .surfaces = options.surfaces,
      .ground_truth = options.ground_truth,
      .progress = stderr};
  const FolderLock lock(plan.folder);
  RecordedTakes takes = record_second_take(scenario, plan.folder);
  WatchedSource source(takes, scenario);
  RecordingReport report = record_with_notes(
      source, plan, renderer_painters(options.device, scenario.record.tier, scenario.view, options.stats));
  keep_second_take(scenario, plan.folder);
  if (!takes.failure.empty() && report.failure.empty()) report.failure = "the second take: " + takes.failure;
  return conclude({.command = "run",
                   .source = options.scenario,
                   .device = options.device_text,
                   .overrides = options.overrides,
                   .warnings = scenario.warnings,
                   .told = source.told(),
                   .preparation = preparation.wall,
                   .expectations = source.results()},
                  plan, report, options.json);
}

}  // namespace thinwall
