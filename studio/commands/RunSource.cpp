#include "studio/commands/RunSource.hpp"

#include "studio/director/ScenarioRun.hpp"
#include "studio/recorder/Interruption.hpp"
#include "studio/recorder/PairedSource.hpp"

namespace thinwall {
namespace {

class RunSource final : public MomentSource {
 public:
  explicit RunSource(const Scenario& scenario) : scenario_(scenario) {
    // A step that is hard to solve may take minutes.
    scenario_.simulation.between_iterations = throw_if_interrupted;
  }

  std::optional<Moment> next() override {
    if (!run_) {
      run_.emplace(scenario_);
    } else if (!run_->step()) {
      return std::nullopt;
    }
    return Moment{.snapshot = run_->snapshot(),
                  .record = run_->record(),
                  .planned_duration = run_->planned_duration(),
                  .captions = run_->captions(),
                  .chapters = run_->chapters()};
  }

  std::vector<std::string> warnings() const override { return run_ ? run_->warnings() : std::vector<std::string>{}; }
  std::string state_digest() const override { return run_ ? run_->state_digest() : ""; }

 private:
  Scenario scenario_;
  std::optional<ScenarioRun> run_;
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
