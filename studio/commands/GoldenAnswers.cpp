#include "studio/commands/GoldenAnswers.hpp"

#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "studio/commands/ExitCode.hpp"
#include "studio/recorder/Messages.hpp"

namespace thinwall {

using Json = nlohmann::ordered_json;

void print_result(const JudgedScenario& judged, std::size_t index) {
  const GoldenResult& result = judged.results[index];
  print_message(stderr, "{}: {} {}{}{}{}\n", outcome_name(result.outcome), result.scenario, moment_name(result),
                result.message.empty() ? "" : ": ", result.message, judged.from_cache ? " (unchanged since)" : "");
  if (judged.attributions[index]) print_message(stderr, "  cause: {}\n", judged.attributions[index]->sentence);
  if (!result.details.empty()) print_message(stderr, "{}\n", result.details);
}

std::vector<std::string> closing_lines(const std::vector<JudgedScenario>& all) {
  std::map<GoldenOutcome, std::string> names;
  std::string approvable;
  for (const JudgedScenario& judged : all) {
    for (std::size_t i = 0; i < judged.results.size(); ++i) {
      const GoldenResult& result = judged.results[i];
      if (result.outcome == GoldenOutcome::kOk) continue;
      const std::string name = golden_argument(result);
      const std::optional<Attribution>& cause = judged.attributions[i];
      std::string& line = names[result.outcome];
      line += (line.empty() ? "" : ", ") + name + (cause ? " (" + stage_name(cause->stage) + ")" : "");
      const bool is_new = result.outcome == GoldenOutcome::kFailed || result.outcome == GoldenOutcome::kGoldenMissing;
      if (is_new) approvable += " " + name;
    }
  }
  std::vector<std::string> lines;
  for (const auto& [outcome, line] : names) lines.push_back(outcome_name(outcome) + ": " + line);
  if (!approvable.empty()) {
    lines.push_back("where today's pictures are right: thinwall golden approve" + approvable + " --why ...");
  }
  return lines;
}

Json golden_as_json(const JudgedScenario& judged, std::size_t index) {
  const GoldenResult& result = judged.results[index];
  Json json = {{"scenario", result.scenario},
               {"argument", golden_argument(result)},
               {"at_s", result.is_video || result.is_scenario ? Json() : Json(result.at)},
               {"video", result.is_video},
               {"outcome", outcome_name(result.outcome)},
               {"rung", result.rung},
               {"largest", result.difference.largest},
               {"mean", result.difference.mean},
               {"drift", result.drift.largest()},
               {"failing_fraction", result.difference.failing_fraction},
               {"state", result.state.explanation},
               {"driver", result.driver},
               {"golden_driver", result.golden_driver},
               {"message", result.message},
               {"from_cache", judged.from_cache}};
  if (result.is_video) json["different_frames"] = result.different_frames;
  if (result.failing) json["failing_by_limits"] = *result.failing;
  if (result.similarity) json["ssim"] = *result.similarity;
  if (result.flip) json["flip"] = *result.flip;
  if (const std::optional<Attribution>& attribution = judged.attributions[index]) {
    json["changed"] = stage_name(attribution->stage);
    json["cause"] = attribution->sentence;
    if (attribution->history.changed) {
      json["first_step"] = attribution->history.step;
      json["first_time_s"] = attribution->history.time;
      json["quantity"] = attribution->history.quantity;
      json["before"] = attribution->history.before;
      json["after"] = attribution->history.after;
    }
  }
  return json;
}

int exit_code(const GoldenResult& result) {
  switch (result.outcome) {
    case GoldenOutcome::kOk:
      return kExitGood;
    case GoldenOutcome::kBroken:
      return kExitBadInput;
    case GoldenOutcome::kSkipped:
      return kExitNoPicture;
    case GoldenOutcome::kResultMissing:
      return result.cannot_be_made ? kExitNoPicture : kExitRegression;
    case GoldenOutcome::kFailed:
    case GoldenOutcome::kGoldenMissing:
      break;
  }
  return kExitRegression;
}

int worse_exit_code(int first, int second) {
  for (const int code : {kExitBadInput, kExitRegression, kExitNoPicture}) {
    if (first == code || second == code) return code;
  }
  return kExitGood;
}

}  // namespace thinwall
