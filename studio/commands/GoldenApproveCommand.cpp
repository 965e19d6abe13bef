#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "studio/commands/Commands.hpp"
#include "studio/commands/ExitCode.hpp"
#include "studio/commands/GoldenAnswers.hpp"
#include "studio/commands/GoldenScenarios.hpp"
#include "studio/commands/JsonAnswer.hpp"
#include "studio/golden/GoldenRenewal.hpp"
#include "studio/golden/GoldenVideoComparison.hpp"
#include "studio/recorder/FolderLock.hpp"
#include "studio/recorder/Messages.hpp"

namespace thinwall {
namespace {

using Json = nlohmann::ordered_json;

/// Whether an approval of an equal picture is of an early version, which kept nothing that tells later what has
/// changed: to renew it changes no picture.
bool lacks_evidence(const JudgedScenario& judged, std::size_t index) {
  const GoldenResult& result = judged.results[index];
  if (result.is_video || result.outcome != GoldenOutcome::kOk || result.rung != "bytes") return false;
  const std::vector<GoldenApproval> approvals = read_approvals(golden_folder(judged.scenario.name));
  const GoldenApproval* approval = find_approval(approvals, result.at, result.driver);
  if (approval == nullptr || approval->driver != result.driver) return false;
  return approval->history.empty() || approval->picture_hash.empty();
}

/// Whether a golden that is good is not the very one that was approved, here and on this driver.
bool differs_within_limits(const GoldenResult& result) {
  if (result.outcome != GoldenOutcome::kOk) return false;
  const bool is_equal = result.is_video ? result.different_frames.empty() : result.rung == "bytes";
  return !is_equal || result.state.verdict != StateVerdict::kEqual || result.driver != result.golden_driver;
}

GoldenResult renew_picture(const JudgedScenario& judged, std::size_t index, const std::string& why) {
  const GoldenPicture& picture = judged.pictures.pictures[index];
  const std::filesystem::path folder = golden_folder(judged.scenario.name);
  if (lacks_evidence(judged, index)) {
    // The picture is the one that was approved then, for the reason that was given then.
    const std::vector<GoldenApproval> approvals = read_approvals(folder);
    const GoldenApproval before = *find_approval(approvals, picture.at, judged.pictures.driver);
    renew_golden(judged.scenario, picture, judged.pictures.driver, folder, before.who, before.why);
  } else {
    renew_golden(judged.scenario, picture, judged.pictures.driver, folder, approver(), why);
  }
  return compare_with_golden(judged.scenario.name, judged.scenario.goldens[index], picture, judged.pictures.driver,
                             folder);
}

GoldenResult renew_video(const JudgedScenario& judged, std::size_t index, const std::string& why) {
  const std::filesystem::path folder = golden_folder(judged.scenario.name);
  if (!judged.video->encoder_failure.empty()) {
    throw UsageError("golden approve: there is no video to approve: " + judged.video->encoder_failure);
  }
  renew_golden_video(*judged.video, folder, approver(), why);
  return compare_with_golden_video(judged.scenario.name, judged.scenario.goldens[index], *judged.video, folder).result;
}

/// What became of the goldens that were named.
struct Approvals {
  Json list = Json::array();
  int code = kExitGood;  // of those that were not approved
  int approved = 0;
  std::string within_limits;  // names of those that differ and were not named by their moment, each after a space
};

/// What approving has made of a golden; the object is that of the comparison before it.
void add(Json golden, const std::optional<GoldenResult>& after, Approvals& approvals) {
  golden["approved"] = after.has_value();
  if (after) golden["after"] = {{"outcome", outcome_name(after->outcome)}, {"message", after->message}};
  approvals.list.push_back(std::move(golden));
}

void approve_scenario(const JudgedScenario& judged, const std::string& why, bool is_chosen, Approvals& approvals) {
  for (std::size_t i = 0; i < judged.results.size(); ++i) {
    const std::optional<GoldenResult> after = approve_golden(judged, i, why, is_chosen);
    add(golden_as_json(judged, i), after, approvals);
    if (after) {
      ++approvals.approved;
      continue;
    }
    if (differs_within_limits(judged.results[i])) approvals.within_limits += " " + golden_argument(judged.results[i]);
    print_result(judged, i);
    approvals.code = worse_exit_code(approvals.code, exit_code(judged.results[i]));
  }
}

/// Stops at the first scenario that cannot be drawn here, as none can then.
Approvals approve_all(const std::vector<JudgedScenario>& all, const NamedGoldens& named, const std::string& why) {
  Approvals approvals;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k].results.front().outcome == GoldenOutcome::kSkipped) {
      print_result(all[k], 0);
      add(golden_as_json(all[k], 0), std::nullopt, approvals);
      approvals.code = kExitNoPicture;
      break;
    }
    approve_scenario(all[k], why, named.are_chosen[k], approvals);
  }
  return approvals;
}

}  // namespace

std::optional<GoldenResult> approve_golden(const JudgedScenario& judged, std::size_t index, const std::string& why,
                                           bool within_limits_too) {
  const GoldenResult& before = judged.results[index];
  const bool is_wrong = before.outcome == GoldenOutcome::kFailed || before.outcome == GoldenOutcome::kGoldenMissing;
  const bool is_meant = within_limits_too && differs_within_limits(before);
  if (!is_wrong && !is_meant && !lacks_evidence(judged, index)) return std::nullopt;
  GoldenResult after = before.is_video ? renew_video(judged, index, why) : renew_picture(judged, index, why);
  print_message(stderr, "approved: {} {}\n  before: {}: {}\n  after:  {}: {}\n", before.scenario, moment_name(before),
                outcome_name(before.outcome), before.message, outcome_name(after.outcome), after.message);
  return after;
}

int approve_goldens(const GoldenOptions& options) {
  if (is_continuous_integration()) throw UsageError("golden approve: goldens are approved by a person, not in CI");
  if (options.why.find_first_not_of(" \t\n") == std::string::npos) {
    throw UsageError("golden approve: say with --why what has changed and why that is right");
  }
  if (options.scenarios.empty()) throw UsageError("golden approve: name the scenarios to approve");
  const NamedGoldens named = named_goldens(options.scenarios);
  refuse_broken(named);
  const FolderLock lock(options.out);
  const std::vector<JudgedScenario> all =
      judge_scenarios(named.scenarios, golden_run(options, false), [](const JudgedScenario&) {});
  const Approvals approvals = approve_all(all, named, options.why);
  if (approvals.approved == 0 && approvals.code == kExitGood) {
    if (approvals.within_limits.empty()) {
      throw UsageError("golden approve: nothing of what was named has changed, so nothing was approved");
    }
    throw UsageError(
        "golden approve: nothing of what was named has changed beyond its limits, so nothing was approved; "
        "to approve it all the same, name each:" +
        approvals.within_limits);
  }
  if (options.json) print_json({{"goldens", approvals.list}, {"exit_code", approvals.code}});
  return approvals.code;
}

}  // namespace thinwall
