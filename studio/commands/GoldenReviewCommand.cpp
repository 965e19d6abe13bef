#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>

#include "renderer/image/PictureFailure.hpp"
#include "renderer/image/WholeFile.hpp"
#include "renderer/video/Program.hpp"
#include "studio/commands/Answer.hpp"
#include "studio/commands/Commands.hpp"
#include "studio/commands/ExitCode.hpp"
#include "studio/commands/GoldenScenarios.hpp"
#include "studio/golden/GoldenReport.hpp"
#include "studio/golden/GoldenVideoApproval.hpp"
#include "studio/recorder/FolderLock.hpp"
#include "studio/take/TakeError.hpp"
#include "studio/take/TakeReader.hpp"

namespace thinwall {
namespace {

using Json = nlohmann::ordered_json;

enum class Answer { kAccept, kReject, kSkip, kQuit };

/// Asks until an answer is one; the end of the input is the wish to end.
Answer ask() {
  for (;;) {
    fmt::print(stderr, "  [a]ccept, [r]eject, [s]kip or [q]uit? ");
    const std::optional<std::string> line = read_answer();
    if (!line) return Answer::kQuit;
    if (line == "a" || line == "accept") return Answer::kAccept;
    if (line == "r" || line == "reject") return Answer::kReject;
    if (line == "s" || line == "skip") return Answer::kSkip;
    if (line == "q" || line == "quit") return Answer::kQuit;
  }
}

std::string ask_why(const std::string& given) {
  std::string why = given;
  while (why.find_first_not_of(" \t") == std::string::npos) {
    fmt::print(stderr, "  why is the new picture right? ");
    const std::optional<std::string> line = read_answer();
    if (!line) return "";
    why = *line;
  }
  return why;
}

bool needs_review(const GoldenResult& result) {
  return result.outcome == GoldenOutcome::kFailed || result.outcome == GoldenOutcome::kGoldenMissing;
}

/// What a review has come to.
struct Tally {
  int accepted = 0;
  int rejected = 0;
  int skipped = 0;
  int left = 0;  // not asked for
};

/// What is found in a video stands in a line for each frame.
std::string in_lines(const GoldenResult& result) {
  std::string lines = result.message;
  if (!result.is_video) return lines;
  for (std::size_t at = lines.find("; "); at != std::string::npos; at = lines.find("; ", at))
    lines.replace(at, 2, "\n  ");
  return lines;
}

/// "2 of 5", of those that a person has to judge.
std::string place_of(const Tally& tally, std::size_t all) {
  return fmt::format("{} of {}", tally.accepted + tally.rejected + tally.skipped + 1, all);
}

/// False when the user wants to end.
bool review_one(const JudgedScenario& judged, std::size_t index, const std::string& place, const std::string& why,
                Tally& tally) {
  const GoldenResult& result = judged.results[index];
  const std::string cause = cause_line(judged, index);
  fmt::print(stderr, "\n{}, {}: {} {}\n", place, outcome_name(result.outcome), result.scenario, moment_name(result));
  if (cause != result.message) fmt::print(stderr, "  cause: {}\n", cause);
  fmt::print(stderr, "  {}\n", in_lines(result));
  switch (ask()) {
    case Answer::kAccept: {
      const std::string reason = ask_why(why);
      if (reason.empty()) return false;
      approve_golden(judged, index, reason, false);
      ++tally.accepted;
      return true;
    }
    case Answer::kReject:
      ++tally.rejected;
      return true;
    case Answer::kSkip:
      ++tally.skipped;
      return true;
    case Answer::kQuit:
      break;
  }
  return false;
}

/// What the scenario says differently since a golden was approved, without simulating.
std::vector<ScenarioChange> changes_since(const GoldenApproval& approval, const Scenario& scenario) {
  try {
    const TakeReader take(golden_folder(scenario.name) / approval.state);
    return compare_scenarios(take.description().resolved, scenario.resolved);
  } catch (const TakeError&) {
    return {};
  }
}

/// Who changed the goldens of a scenario and when, as git tells it; empty where there is no git.
std::string history_by_git(const std::string& scenario) {
  try {
    const std::filesystem::path folder = golden_folder(scenario);
    const ProgramResult log = run_program(
        {"git", "-C", folder.string(), "log", "--date=short", "--format=    %ad %h %an: %s", "--", "approval.json"});
    return log.exit_code == 0 ? log.output : "";
  } catch (const PictureFailure&) {
    return "";
  }
}

void explain_video(const Scenario& scenario, const GoldenDefinition& golden) {
  fmt::print("{} the video\n  allowed: {}: {}\n", scenario.name, limits_text(golden), golden.why);
  const std::vector<GoldenVideoApproval> approvals = read_video_approvals(golden_folder(scenario.name));
  for (const GoldenVideoApproval& approval : approvals) {
    fmt::print("  approved by {}: {}\n    on {}\n    {} frames, encoded by {}\n", approval.who, approval.why,
               approval.video.driver, approval.video.frames.size(), approval.video.encoded.program);
    for (const ScenarioChange& change : compare_scenarios(approval.video.resolved, scenario.resolved)) {
      fmt::print("    the scenario has changed since: {}\n", to_text(change));
    }
  }
  if (approvals.empty()) fmt::print("  no video is approved\n");
}

void explain(const Scenario& scenario, const GoldenDefinition& golden, const std::vector<GoldenApproval>& approvals) {
  fmt::print("{} at {:.9g} s\n  allowed: {}: {}\n", scenario.name, golden.at, limits_text(golden), golden.why);
  bool any = false;
  for (const GoldenApproval& approval : approvals) {
    if (std::abs(approval.at - golden.at) > 1e-9) continue;
    any = true;
    fmt::print("  approved by {}: {}\n    on {}\n    {}\n", approval.who, approval.why, approval.driver,
               (golden_folder(scenario.name) / approval.image).string());
    for (const ScenarioChange& change : changes_since(approval, scenario)) {
      fmt::print("    the scenario has changed since: {}\n", to_text(change));
    }
  }
  if (!any) fmt::print("  no picture is approved\n");
}

}  // namespace

int review_goldens(const GoldenOptions& options) {
  if (is_continuous_integration()) throw UsageError("golden review: goldens are approved by a person, not in CI");
  const NamedGoldens named = named_goldens(options.scenarios);
  const FolderLock lock(options.out);
  const std::vector<JudgedScenario> all = judge_named(
      named, options, [](const JudgedScenario& judged) { fmt::print(stderr, "compared: {}\n", judged.scenario.name); });
  write_whole_file(options.out / "index.html", golden_report(all, golden_root()));
  fmt::print(stderr, "look at the pictures: {}\n", (options.out / "index.html").string());
  std::size_t to_judge = 0;
  for (const JudgedScenario& judged : all) to_judge += std::ranges::count_if(judged.results, needs_review);
  Tally tally;
  bool goes_on = true;
  for (const JudgedScenario& judged : all) {
    for (std::size_t i = 0; i < judged.results.size(); ++i) {
      const GoldenResult& result = judged.results[i];
      if (result.outcome == GoldenOutcome::kOk) continue;
      if (!needs_review(result)) {
        fmt::print(stderr, "{}: {} {}: {}\n", outcome_name(result.outcome), result.scenario, moment_name(result),
                   result.message);
        ++tally.left;
      } else if (goes_on) {
        goes_on = review_one(judged, i, place_of(tally, to_judge), options.why, tally);
        if (!goes_on) ++tally.left;
      } else {
        ++tally.left;
      }
    }
  }
  const int left = tally.skipped + tally.left;
  fmt::print(stderr, "{} accepted, {} rejected, {} left\n", tally.accepted, tally.rejected, left);
  const auto is_broken = [](const GoldenResult& result) { return result.outcome == GoldenOutcome::kBroken; };
  const bool any_broken = std::ranges::any_of(
      all, [&](const JudgedScenario& judged) { return std::ranges::any_of(judged.results, is_broken); });
  if (any_broken) return kExitBadInput;
  return tally.rejected + left > 0 ? kExitRegression : kExitGood;
}

namespace {

Json picture_drivers(const std::vector<GoldenApproval>& approvals, double at) {
  Json drivers = Json::array();
  for (const GoldenApproval& approval : approvals) {
    if (std::abs(approval.at - at) < 1e-9) drivers.push_back(approval.driver);
  }
  return drivers;
}

Json video_drivers(const Scenario& scenario) {
  Json drivers = Json::array();
  for (const GoldenVideoApproval& approval : read_video_approvals(golden_folder(scenario.name))) {
    drivers.push_back(approval.video.driver);
  }
  return drivers;
}

/// Throws GoldenError.
void list_scenario(const Scenario& scenario, bool is_json, Json& list) {
  const std::vector<GoldenApproval> approvals = read_approvals(golden_folder(scenario.name));
  for (const GoldenDefinition& golden : scenario.goldens) {
    const Json drivers = golden.video > 0 ? video_drivers(scenario) : picture_drivers(approvals, golden.at);
    if (!is_json) {
      fmt::print("{:<32} {:>8}  {}  {}\n", scenario.name,
                 golden.video > 0 ? "video" : fmt::format("{:.9g} s", golden.at), limits_text(golden),
                 drivers.empty()
                     ? "nothing is approved"
                     : fmt::format("approved for {} driver{}", drivers.size(), drivers.size() > 1 ? "s" : ""));
    }
    list.push_back({{"scenario", scenario.name},
                    {"at_s", golden.video > 0 ? Json() : Json(golden.at)},
                    {"video", golden.video > 0},
                    {"max", golden.max},
                    {"mean", golden.mean},
                    {"drift", golden.drift},
                    {"limits", limits_text(golden)},
                    {"why", golden.why},
                    {"drivers", drivers}});
  }
}

}  // namespace

int list_goldens(const GoldenOptions& options) {
  Json list = Json::array();
  const NamedGoldens named = named_goldens(options.scenarios);
  std::vector<std::string> notes;
  bool any_damaged = false;
  for (const Scenario& scenario : named.scenarios) {
    try {
      list_scenario(scenario, options.json, list);
    } catch (const GoldenError& error) {
      any_damaged = true;
      notes.emplace_back(error.what());
    }
  }
  std::ranges::copy(golden_notes(named), std::back_inserter(notes));
  for (const std::string& note : notes) fmt::print(stderr, "{}\n", note);
  const int code = named.broken.empty() && !any_damaged ? kExitGood : kExitBadInput;
  if (options.json) {
    const Json result = {{"goldens", list}, {"notes", notes}, {"exit_code", code}};
    fmt::print("{}\n", result.dump(2, ' ', false, Json::error_handler_t::replace));
  }
  for (const BrokenScenario& broken : named.broken) fmt::print(stderr, "{}\n", broken.errors.what());
  return code;
}

int explain_goldens(const GoldenOptions& options) {
  if (options.scenarios.empty()) throw UsageError("golden why: name a scenario");
  const NamedGoldens named = named_goldens(options.scenarios);
  refuse_broken(named);
  for (const Scenario& scenario : named.scenarios) {
    const std::vector<GoldenApproval> approvals = read_approvals(golden_folder(scenario.name));
    for (const GoldenDefinition& golden : scenario.goldens) {
      if (golden.video > 0) {
        explain_video(scenario, golden);
      } else {
        explain(scenario, golden, approvals);
      }
    }
    const std::string history = history_by_git(scenario.name);
    if (!history.empty()) fmt::print("  changes of the approval:\n{}", history);
  }
  return kExitGood;
}

}  // namespace thinwall
