#include "studio/commands/RunSource.hpp"

#include <fmt/format.h>

#include "engine/simulation/SimulationFailure.hpp"
#include "studio/commands/CameraPlaces.hpp"
#include "studio/commands/LongWait.hpp"
#include "studio/commands/Outcome.hpp"
#include "studio/director/BodyNotes.hpp"
#include "studio/director/RunNotes.hpp"
#include "studio/director/ScenarioRun.hpp"
#include "studio/recorder/Interruption.hpp"
#include "studio/recorder/PairedSource.hpp"

namespace thinwall {
namespace {

constexpr const char* kEquilibrium = "finding the equilibrium before the first step";

class RunSource final : public MomentSource {
 public:
  explicit RunSource(const Scenario& scenario) : scenario_(scenario) {
    // A step that is hard to solve may take minutes, as may the equilibrium before the first, and show no progress.
    scenario_.simulation.between_iterations = [this] {
      throw_if_interrupted();
      wait_.look();
    };
  }

  std::optional<Moment> next() override {
    if (!run_) {
      begin();
    } else {
      wait_ = wait_for(fmt::format("the step that begins at {:.4g} s", run_->time()));
      if (!run_->step()) return std::nullopt;
    }
    return Moment{.snapshot = run_->snapshot(),
                  .record = run_->record(),
                  .planned_duration = run_->planned_duration(),
                  .captions = run_->captions(),
                  .chapters = run_->chapters()};
  }

  std::vector<std::string> warnings() const override { return run_ ? run_->warnings() : notes_; }
  std::string state_digest() const override { return run_ ? run_->state_digest() : ""; }

 private:
  /// What is told of the bodies, such as a doubt of a mesh's unit, may be why there is no equilibrium.
  void begin() {
    wait_ = wait_for(kEquilibrium);
    try {
      run_.emplace(scenario_);
      refuse_blind_cameras(scenario_, run_->snapshot());
    } catch (const SimulationFailure&) {
      notes_ = body_notes(scenario_);
      throw;
    }
  }

  LongWait wait_for(const std::string& what) const {
    return {"`" + scenario_.name + "`: " + what, tell_note, slack_wall_advice(scenario_)};
  }

  Scenario scenario_;
  LongWait wait_ = wait_for(kEquilibrium);
  std::optional<ScenarioRun> run_;
  std::vector<std::string> notes_;
};

}  // namespace

std::unique_ptr<MomentSource> simulate_one_take(const Scenario& scenario) {
  return std::make_unique<RunSource>(scenario);
}

std::unique_ptr<MomentSource> simulate_scenario(const Scenario& scenario) {
  if (!scenario.comparison) return simulate_one_take(scenario);
  return pair_sources(simulate_one_take(scenario), simulate_one_take(*scenario.comparison->second));
}

}  // namespace thinwall
