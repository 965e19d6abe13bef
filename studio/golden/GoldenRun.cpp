#include "studio/golden/GoldenRun.hpp"

#include <mutex>

#include "renderer/metric/Tiles.hpp"
#include "studio/golden/GoldenCache.hpp"

namespace thinwall {
namespace {

GoldenResult skipped(const Scenario& scenario, const GoldenDefinition& golden, const std::string& why) {
  GoldenResult result;
  result.scenario = scenario.name;
  result.at = golden.at;
  result.outcome = GoldenOutcome::kSkipped;
  result.message = why;
  return result;
}

/// A picture within its limits whose simulation has changed is good, but worth a word.
void mention_history(GoldenResult& result, const GoldenPicture& picture, const std::filesystem::path& folder) {
  const std::vector<GoldenApproval> approvals = read_approvals(folder);
  const GoldenApproval* approval = find_approval(approvals, result.at, result.driver);
  if (approval == nullptr) return;
  const HistoryChange change = history_change(picture, *approval, folder);
  if (change.changed) result.message += "; within the limits, though physics changed " + change.sentence;
}

void judge(JudgedScenario& judged, const GoldenRunOptions& options) {
  const Scenario& scenario = judged.scenario;
  const std::filesystem::path folder = options.goldens / scenario.name;
  judged.pictures = golden_pictures(scenario, options.sources, options.painters(scenario.resolved));
  judged.attributions.resize(scenario.goldens.size());
  for (std::size_t i = 0; i < scenario.goldens.size(); ++i) {
    if (!judged.pictures.no_device.empty()) {
      judged.results.push_back(skipped(scenario, scenario.goldens[i], judged.pictures.no_device));
      continue;
    }
    const GoldenPicture& picture = judged.pictures.pictures[i];
    GoldenResult result =
        compare_with_golden(scenario.name, scenario.goldens[i], picture, judged.pictures.driver, folder);
    if (result.outcome == GoldenOutcome::kFailed) {
      judged.attributions[i] = attribute(scenario, picture, result, folder, options.painters);
    } else if (result.outcome == GoldenOutcome::kOk && result.state.verdict != StateVerdict::kEqual) {
      mention_history(result, picture, folder);
    }
    judged.results.push_back(std::move(result));
  }
}

/// Hands over in order what is ready.
class InOrder {
 public:
  InOrder(const std::vector<JudgedScenario>& all, const std::function<void(const JudgedScenario&)>& done)
      : all_(all), done_(done), ready_(all.size(), false) {}

  void finished(std::size_t index) {
    const std::lock_guard guard(lock_);
    ready_[index] = true;
    for (; next_ < all_.size() && ready_[next_]; ++next_) done_(all_[next_]);
  }

 private:
  const std::vector<JudgedScenario>& all_;
  const std::function<void(const JudgedScenario&)>& done_;
  std::vector<bool> ready_;
  std::size_t next_ = 0;
  std::mutex lock_;
};

}  // namespace

std::vector<JudgedScenario> judge_scenarios(std::vector<Scenario> scenarios, const GoldenRunOptions& options,
                                            const std::function<void(const JudgedScenario&)>& done) {
  std::vector<JudgedScenario> all;
  for (Scenario& scenario : scenarios) {
    all.push_back({.scenario = std::move(scenario), .pictures = {}, .results = {}, .attributions = {}});
  }
  std::optional<GoldenCache> cache;
  if (options.cache) cache.emplace(*options.cache, options.program);
  InOrder order(all, done);
  for_each_in_parallel(
      all.size(),
      [&](std::size_t index) {
        JudgedScenario& judged = all[index];
        const std::filesystem::path folder = options.goldens / judged.scenario.name;
        const std::string key = cache ? cache->key(judged.scenario, folder) : "";
        if (cache) judged.results = cache->find(judged.scenario, key);
        judged.from_cache = !judged.results.empty();
        if (judged.from_cache) {
          judged.attributions.resize(judged.results.size());
        } else {
          judge(judged, options);
          if (cache) cache->keep(judged.scenario, key, judged.results);
        }
        order.finished(index);
      },
      options.jobs);
  if (cache) cache->write();
  return all;
}

std::string cause_line(const JudgedScenario& judged, std::size_t index) {
  const std::optional<Attribution>& attribution = judged.attributions[index];
  return attribution ? attribution->sentence : judged.results[index].message;
}

}  // namespace thinwall
