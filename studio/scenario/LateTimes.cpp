#include "studio/scenario/LateTimes.hpp"

#include <fmt/format.h>

namespace thinwall {
namespace {

class LateTimes {
 public:
  /// The last step may end a step later than the clips.
  LateTimes(double end, double step) : end_(end), latest_(end + step) {}

  void see(double time, const std::string& path, const char* consequence) {
    if (time <= latest_) return;
    notes_.push_back(fmt::format("{}: {:.6g} s is after the end of the run, which is planned for {:.4g} s; {}", path,
                                 time, end_, consequence));
  }

  void see(double time, const std::string& path, std::size_t index, const char* key, const char* consequence) {
    see(time, fmt::format("{}[{}].{}", path, index + 1, key), consequence);
  }

  template <typename Annotations>
  void see_spans(const Annotations& annotations, const std::string& path) {
    for (std::size_t i = 0; i < annotations.size(); ++i) {
      see(annotations[i].span.begin, path, i, "from", "it is never shown");
    }
  }

  std::vector<std::string> notes() && { return std::move(notes_); }

 private:
  double end_;
  double latest_;
  std::vector<std::string> notes_;
};

void see_teaching(LateTimes& late, const Scenario& scenario) {
  const Teaching& teaching = scenario.teaching;
  late.see_spans(teaching.annotations.labels, "teaching.labels");
  late.see_spans(teaching.annotations.arrows, "teaching.arrows");
  late.see_spans(teaching.annotations.force_arrows, "teaching.force_arrows");
  for (std::size_t i = 0; i < scenario.view.highlights.size(); ++i) {
    late.see(scenario.view.highlights[i].begin, "teaching.highlights", i, "from", "it is never shown");
  }
  for (std::size_t i = 0; i < teaching.freezes.size(); ++i) {
    late.see(teaching.freezes[i].at, "teaching.freezes", i, "at", "the video never stands still for it");
  }
  for (std::size_t i = 0; i < teaching.slow_motions.size(); ++i) {
    late.see(teaching.slow_motions[i].begin, "teaching.slow_motion", i, "from", "no part of the video has its speed");
  }
}

/// Only of the last time: a load that goes on to change is told of once.
void see_loads(LateTimes& late, const Scenario& scenario) {
  for (const BodyScenario& body : scenario.bodies) {
    for (std::size_t i = 0; i < body.loads.size(); ++i) {
      const auto& over = body.loads[i].over;
      if (over.empty()) continue;
      late.see(over.back().first, fmt::format("bodies.{}.loads[{}].over[{}]", body.name, i + 1, over.size()),
               "the load does not get there");
    }
  }
}

}  // namespace

std::vector<std::string> late_times(const Scenario& scenario, double end) {
  LateTimes late(end, scenario.simulation.time_step);
  for (std::size_t i = 0; i < scenario.view.cuts.size(); ++i) {
    late.see(scenario.view.cuts[i].time, "cuts", i, "at", "it is never shown");
  }
  see_loads(late, scenario);
  see_teaching(late, scenario);
  for (std::size_t i = 0; i < scenario.goldens.size(); ++i) {
    late.see(scenario.goldens[i].at, "golden", i, "at", "there is no picture of it");
  }
  for (std::size_t i = 0; i < scenario.expectations.size(); ++i) {
    const Expectation& expectation = scenario.expectations[i];
    late.see(expectation.at.value_or(0), "expect", i, "at", "it cannot be met");
    late.see(expectation.from.value_or(0), "expect", i, "from", "it cannot be met");
    late.see(expectation.until.value_or(0), "expect", i, "until", "it cannot be met");
  }
  return std::move(late).notes();
}

}  // namespace thinwall
