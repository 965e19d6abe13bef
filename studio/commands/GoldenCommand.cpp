#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>

#include "renderer/image/Folder.hpp"
#include "renderer/image/PictureFailure.hpp"
#include "renderer/image/WholeFile.hpp"
#include "studio/commands/Commands.hpp"
#include "studio/commands/ExitCode.hpp"
#include "studio/commands/GoldenScenarios.hpp"
#include "studio/golden/GoldenRenewal.hpp"
#include "studio/golden/GoldenReport.hpp"
#include "studio/golden/GoldenVideoComparison.hpp"
#include "studio/golden/JUnitReport.hpp"
#include "studio/golden/PicturesForLooking.hpp"
#include "studio/recorder/FolderLock.hpp"
#include "studio/schema/Wording.hpp"

namespace thinwall {
namespace {

using Json = nlohmann::ordered_json;

void print_result(const JudgedScenario& judged, std::size_t index) {
  const GoldenResult& result = judged.results[index];
  fmt::print(stderr, "{}: {} {}{}{}{}\n", outcome_name(result.outcome), result.scenario, moment_name(result),
             result.message.empty() ? "" : ": ", result.message, judged.from_cache ? " (unchanged since)" : "");
  if (judged.attributions[index]) fmt::print(stderr, "  cause: {}\n", judged.attributions[index]->sentence);
  if (!result.details.empty()) fmt::print(stderr, "{}\n", result.details);
}

Json to_json(const JudgedScenario& judged, std::size_t index) {
  const GoldenResult& result = judged.results[index];
  Json json = {{"scenario", result.scenario},
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

/// What one golden gives. Nothing was compared where it is skipped, which is no success.
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

/// Of two goldens': what is to be mended first. A regression is one, whatever else could not be made.
int worse_exit_code(int first, int second) {
  for (const int code : {kExitBadInput, kExitRegression, kExitNoPicture}) {
    if (first == code || second == code) return code;
  }
  return kExitGood;
}

int exit_code(const std::vector<JudgedScenario>& all) {
  int code = kExitGood;
  for (const JudgedScenario& judged : all) {
    for (const GoldenResult& result : judged.results) code = worse_exit_code(code, exit_code(result));
  }
  return code;
}

std::map<GoldenOutcome, int> counts(const std::vector<JudgedScenario>& all) {
  std::map<GoldenOutcome, int> counts;
  for (const auto outcome : {GoldenOutcome::kOk, GoldenOutcome::kFailed, GoldenOutcome::kResultMissing,
                             GoldenOutcome::kGoldenMissing, GoldenOutcome::kSkipped, GoldenOutcome::kBroken}) {
    counts[outcome] = 0;
  }
  for (const JudgedScenario& judged : all) {
    for (const GoldenResult& result : judged.results) ++counts[result.outcome];
  }
  return counts;
}

void print_summary(const std::vector<JudgedScenario>& all, const std::vector<std::string>& notes, int code, bool json) {
  std::string line;
  Json json_counts = Json::object();
  for (const auto& [outcome, count] : counts(all)) {
    line += fmt::format("{}{} {}", line.empty() ? "" : ", ", count, outcome_name(outcome));
    json_counts[outcome_name(outcome)] = count;
  }
  for (const std::string& note : notes) fmt::print(stderr, "{}\n", note);
  fmt::print(stderr, "{}\n", line);
  if (!json) return;
  Json list = Json::array();
  for (const JudgedScenario& judged : all) {
    for (std::size_t i = 0; i < judged.results.size(); ++i) list.push_back(to_json(judged, i));
  }
  const Json result = {{"goldens", list}, {"counts", json_counts}, {"notes", notes}, {"exit_code", code}};
  fmt::print("{}\n", result.dump(2, ' ', false, Json::error_handler_t::replace));
}

std::vector<JudgedScenario> judge_and_print(const NamedGoldens& named, const GoldenOptions& options) {
  const auto print = [&](const JudgedScenario& judged) {
    PicturesForLooking pictures(options.out / judged.scenario.name);
    for (std::size_t i = 0; i < judged.results.size(); ++i) {
      print_result(judged, i);
      for (const std::string& line : pictures.keep(judged, i, golden_folder(judged.scenario.name))) {
        fmt::print(stderr, "  {}\n", line);
      }
    }
    pictures.remove_others();
  };
  return judge_named(named, options, print);
}

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

/// "small@0.12s" or "small@video"
std::string own_name(const GoldenResult& result) {
  return shell_argument(result.scenario) + (result.is_video ? "@video" : fmt::format("@{:.9g}s", result.at));
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

std::filesystem::path report_page(const GoldenOptions& options) {
  return options.out / "index.html";
}

std::filesystem::path write_report(const std::vector<JudgedScenario>& all, const GoldenOptions& options) {
  std::filesystem::path page = report_page(options);
  write_whole_file(page, golden_report(all, golden_root()));
  return page;
}

/// Before the comparison, so that what cannot be written is told at once.
void prepare_junit(const std::filesystem::path& file) {
  if (file.has_parent_path()) make_folder(file.parent_path());
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) {
    throw UsageError("golden: --junit " + file.string() + " is a folder; name a file");
  }
  if (!error || error == std::errc::no_such_file_or_directory) return;
  throw PictureFailure("cannot write " + file.string() + ": " + error.message() + "; " +
                       cure_for_write_error(error.value()));
}

/// When the page to look at is written.
enum class PageOf { kFailures, kAll };

int compare_goldens(const GoldenOptions& options, PageOf page) {
  const NamedGoldens named = named_goldens(options.scenarios);
  const FolderLock lock(options.out);
  if (!options.junit.empty()) prepare_junit(options.junit);
  const std::vector<JudgedScenario> all = judge_and_print(named, options);
  const int code = exit_code(all);
  if (!options.junit.empty()) write_whole_file(options.junit, junit_report(all));
  if (std::getenv("GITHUB_ACTIONS") != nullptr) fmt::print(stderr, "{}", github_annotations(all));
  if (code != kExitGood || page == PageOf::kAll) {
    fmt::print(stderr, "report: {}\n", write_report(all, options).string());
  } else {
    std::error_code ignored;
    std::filesystem::remove(report_page(options), ignored);  // of an earlier test, in which something had failed
  }
  print_summary(all, golden_notes(named), code, options.json);
  return code;
}

}  // namespace

int test_goldens(const GoldenOptions& options) {
  return compare_goldens(options, PageOf::kFailures);
}

int report_goldens(const GoldenOptions& options) {
  return compare_goldens(options, PageOf::kAll);
}

bool approve_golden(const JudgedScenario& judged, std::size_t index, const std::string& why, bool within_limits_too) {
  const GoldenResult& before = judged.results[index];
  const bool is_wrong = before.outcome == GoldenOutcome::kFailed || before.outcome == GoldenOutcome::kGoldenMissing;
  const bool is_meant = within_limits_too && differs_within_limits(before);
  if (!is_wrong && !is_meant && !lacks_evidence(judged, index)) return false;
  const GoldenResult after = before.is_video ? renew_video(judged, index, why) : renew_picture(judged, index, why);
  fmt::print(stderr, "approved: {} {}\n  before: {}: {}\n  after:  {}: {}\n", before.scenario, moment_name(before),
             outcome_name(before.outcome), before.message, outcome_name(after.outcome), after.message);
  return true;
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
  int code = kExitGood;
  int approved = 0;
  std::string within_limits;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const JudgedScenario& judged = all[k];
    if (judged.results.front().outcome == GoldenOutcome::kSkipped) {
      print_result(judged, 0);
      return kExitNoPicture;
    }
    for (std::size_t i = 0; i < judged.results.size(); ++i) {
      if (approve_golden(judged, i, options.why, named.are_chosen[k])) {
        ++approved;
        continue;
      }
      if (differs_within_limits(judged.results[i])) within_limits += " " + own_name(judged.results[i]);
      print_result(judged, i);
      code = worse_exit_code(code, exit_code(judged.results[i]));
    }
  }
  if (code != kExitGood) return code;
  if (approved > 0) return kExitGood;
  if (within_limits.empty()) {
    throw UsageError("golden approve: nothing of what was named has changed, so nothing was approved");
  }
  throw UsageError(
      "golden approve: nothing of what was named has changed beyond its limits, so nothing was approved; "
      "to approve it all the same, name each:" +
      within_limits);
}

}  // namespace thinwall
