#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "renderer/image/PictureFailure.hpp"
#include "renderer/video/Program.hpp"
#include "studio/commands/Commands.hpp"
#include "studio/commands/ExitCode.hpp"
#include "studio/commands/GoldenScenarios.hpp"
#include "studio/commands/JsonAnswer.hpp"
#include "studio/commands/StandardOutput.hpp"
#include "studio/golden/GoldenVideoApproval.hpp"
#include "studio/golden/ScenarioDifference.hpp"
#include "studio/take/TakeError.hpp"
#include "studio/take/TakeReader.hpp"

namespace thinwall {
namespace {

using Json = nlohmann::ordered_json;

/// What the scenario says differently since a golden was approved, without simulating.
std::vector<ScenarioChange> changes_since(const GoldenApproval& approval, const Scenario& scenario) {
  try {
    const TakeReader take(golden_folder(scenario.name) / approval.state);
    return compare_scenarios(take.description().resolved, scenario.resolved);
  } catch (const TakeError&) {
    return {};
  }
}

/// Who changed the goldens of a scenario and when, a line each as git tells it; none where there is no git.
std::vector<std::string> history_by_git(const std::string& scenario) {
  try {
    const std::filesystem::path folder = golden_folder(scenario);
    const ProgramResult log = run_program(
        {"git", "-C", folder.string(), "log", "--date=short", "--format=%ad %h %an: %s", "--", "approval.json"});
    if (log.exit_code != 0) return {};
    std::vector<std::string> changes;
    std::istringstream lines(log.output);
    for (std::string line; std::getline(lines, line);) changes.push_back(line);
    return changes;
  } catch (const PictureFailure&) {
    return {};
  }
}

/// Why a golden is as it is.
struct Explanation {
  /// Who has approved what.
  struct Approval {
    std::string who;
    std::string why;
    std::string driver;
    std::string golden;                        // the picture's file, or what is kept of the video
    std::vector<ScenarioChange> changes = {};  // of the scenario since
  };
  const GoldenDefinition& golden;
  std::vector<Approval> approvals = {};
};

Explanation explain_video(const Scenario& scenario, const GoldenDefinition& golden) {
  Explanation explanation{golden};
  for (const GoldenVideoApproval& approval : read_video_approvals(golden_folder(scenario.name))) {
    const GoldenVideo& video = approval.video;
    explanation.approvals.push_back(
        {.who = approval.who,
         .why = approval.why,
         .driver = video.driver,
         .golden = fmt::format("{} frames, encoded by {}", video.frames.size(), video.encoded.program),
         .changes = compare_scenarios(video.resolved, scenario.resolved)});
  }
  return explanation;
}

Explanation explain_picture(const Scenario& scenario, const GoldenDefinition& golden) {
  Explanation explanation{golden};
  const std::filesystem::path folder = golden_folder(scenario.name);
  for (const GoldenApproval& approval : read_approvals(folder)) {
    if (std::abs(approval.at - golden.at) > 1e-9) continue;
    explanation.approvals.push_back({.who = approval.who,
                                     .why = approval.why,
                                     .driver = approval.driver,
                                     .golden = (folder / approval.image).string(),
                                     .changes = changes_since(approval, scenario)});
  }
  return explanation;
}

void print(const Scenario& scenario, const Explanation& explanation) {
  const GoldenDefinition& golden = explanation.golden;
  const bool is_video = golden.video > 0;
  say_result(fmt::format("{} {}\n  allowed: {}: {}\n", scenario.name,
                         is_video ? "the video" : fmt::format("at {:.9g} s", golden.at), limits_text(golden),
                         golden.why));
  for (const Explanation::Approval& approval : explanation.approvals) {
    say_result(fmt::format("  approved by {}: {}\n    on {}\n    {}\n", approval.who, approval.why, approval.driver,
                           approval.golden));
    for (const ScenarioChange& change : approval.changes) {
      say_result(fmt::format("    the scenario has changed since: {}\n", to_text(change)));
    }
  }
  if (explanation.approvals.empty()) say_result(fmt::format("  no {} is approved\n", is_video ? "video" : "picture"));
}

Json to_json(const Scenario& scenario, const Explanation& explanation) {
  Json approvals = Json::array();
  for (const Explanation::Approval& approval : explanation.approvals) {
    Json changes = Json::array();
    for (const ScenarioChange& change : approval.changes) {
      changes.push_back({{"key", change.key}, {"before", change.before}, {"after", change.after}});
    }
    approvals.push_back({{"who", approval.who},
                         {"why", approval.why},
                         {"driver", approval.driver},
                         {"golden", approval.golden},
                         {"changes", changes}});
  }
  const GoldenDefinition& golden = explanation.golden;
  return {{"scenario", scenario.name}, {"at_s", golden.video > 0 ? Json() : Json(golden.at)},
          {"video", golden.video > 0}, {"limits", limits_text(golden)},
          {"why", golden.why},         {"approvals", approvals}};
}

}  // namespace

int explain_goldens(const GoldenOptions& options) {
  const NamedGoldens named = named_goldens(options.scenarios);
  refuse_broken(named);
  Json goldens = Json::array(), histories = Json::object();
  for (const Scenario& scenario : named.scenarios) {
    for (const GoldenDefinition& golden : scenario.goldens) {
      const Explanation explanation =
          golden.video > 0 ? explain_video(scenario, golden) : explain_picture(scenario, golden);
      if (!options.json) print(scenario, explanation);
      goldens.push_back(to_json(scenario, explanation));
    }
    const std::vector<std::string> history = history_by_git(scenario.name);
    if (!options.json && !history.empty()) {
      say_result(fmt::format("  changes of the approval:\n    {}\n", fmt::join(history, "\n    ")));
    }
    histories[scenario.name] = history;
  }
  if (options.json) print_json({{"goldens", goldens}, {"changes", histories}, {"exit_code", kExitGood}});
  return kExitGood;
}

}  // namespace thinwall
