#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>

#include "renderer/image/PngFile.hpp"
#include "studio/commands/Commands.hpp"
#include "studio/commands/ExitCode.hpp"
#include "studio/commands/RunSource.hpp"
#include "studio/golden/GoldenComparison.hpp"
#include "studio/golden/GoldenRenewal.hpp"
#include "studio/recorder/OutputFolder.hpp"
#include "studio/scenario/LoadScenario.hpp"

namespace thinwall {
namespace {

using Json = nlohmann::ordered_json;

/// The folder that holds scenes/ and golden_images/.
std::filesystem::path home() {
  const char* home = std::getenv("THINWALL_HOME");
  return home != nullptr ? home : ".";
}

std::filesystem::path golden_folder(const std::string& scenario) {
  return home() / "golden_images" / scenario;
}

std::vector<std::filesystem::path> all_scenes() {
  std::vector<std::filesystem::path> files;
  if (!std::filesystem::is_directory(home() / "scenes")) return files;
  for (const auto& entry : std::filesystem::directory_iterator(home() / "scenes")) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// The named scenarios (a file, or a name in scenes/), or all; those that have goldens.
std::vector<Scenario> scenarios_with_goldens(const std::vector<std::string>& names) {
  std::vector<std::filesystem::path> files;
  for (const std::string& name : names) {
    const std::filesystem::path scene = home() / "scenes" / (name + ".yaml");
    const bool is_name = !std::filesystem::exists(name) && std::filesystem::exists(scene);
    files.push_back(is_name ? scene : std::filesystem::path(name));
  }
  if (names.empty()) files = all_scenes();
  std::vector<Scenario> scenarios;
  for (const std::filesystem::path& file : files) {
    Scenario scenario = load_scenario(file, {});
    if (!scenario.goldens.empty()) {
      scenarios.push_back(std::move(scenario));
    } else if (!names.empty()) {
      throw UsageError(file.string() + ": this scenario has no `golden:` list, so there is nothing to compare");
    }
  }
  if (scenarios.empty())
    throw UsageError("no scenario with a `golden:` list was found in " + (home() / "scenes").string());
  return scenarios;
}

/// A scenario with all that is known of its goldens today.
struct Judged {
  Scenario scenario;
  GoldenPictures pictures;
  std::vector<GoldenResult> results;  // (scenario.goldens)
};

Judged judge(Scenario scenario, const DeviceChoice& device) {
  Judged judged{.scenario = std::move(scenario), .pictures = {}, .results = {}};
  const Scenario& s = judged.scenario;
  judged.pictures = golden_pictures(s, simulate_scenario, renderer_painters(device, s.record.tier, s.view));
  for (std::size_t i = 0; i < s.goldens.size(); ++i) {
    if (!judged.pictures.no_device.empty()) {
      GoldenResult skipped;
      skipped.scenario = s.name;
      skipped.at = s.goldens[i].at;
      skipped.outcome = GoldenOutcome::kSkipped;
      skipped.message = judged.pictures.no_device;
      judged.results.push_back(std::move(skipped));
    } else {
      judged.results.push_back(compare_with_golden(s.name, s.goldens[i], judged.pictures.pictures[i],
                                                   judged.pictures.driver, golden_folder(s.name)));
    }
  }
  return judged;
}

void print_result(const GoldenResult& result) {
  fmt::print(stderr, "{}: {} at {:g} s{}{}\n", outcome_name(result.outcome), result.scenario, result.at,
             result.message.empty() ? "" : ": ", result.message);
  if (!result.details.empty()) fmt::print(stderr, "{}\n", result.details);
}

/// Today's picture and the difference, to be looked at; nothing of it is a golden.
void keep_for_looking(const GoldenResult& result, const GoldenPicture& picture, const std::filesystem::path& out) {
  if (result.outcome != GoldenOutcome::kFailed && result.outcome != GoldenOutcome::kGoldenMissing) return;
  make_folder(out / result.scenario);
  const std::string stem = fmt::format("at_{:.4g}s", result.at);
  const std::filesystem::path today = out / result.scenario / (stem + ".today.png");
  write_png(today, picture.image);
  fmt::print(stderr, "  today's picture: {}\n", today.string());
  if (result.outcome != GoldenOutcome::kFailed || result.difference.verdict != ImageVerdict::kDifferent) return;
  const std::vector<GoldenApproval> approvals = read_approvals(golden_folder(result.scenario));
  const GoldenApproval* approval = find_approval(approvals, result.at, result.driver);
  const Image golden = read_png(golden_folder(result.scenario) / approval->image);
  const std::filesystem::path difference = out / result.scenario / (stem + ".difference.png");
  write_png(difference, difference_picture(golden, picture.image));
  fmt::print(stderr, "  difference: {}\n", difference.string());
}

Json to_json(const GoldenResult& result) {
  return {{"scenario", result.scenario},
          {"at_s", result.at},
          {"outcome", outcome_name(result.outcome)},
          {"rung", result.rung},
          {"largest", result.difference.largest},
          {"mean", result.difference.mean},
          {"failing_fraction", result.difference.failing_fraction},
          {"state", result.state.explanation},
          {"driver", result.driver},
          {"golden_driver", result.golden_driver},
          {"message", result.message}};
}

int exit_code(const std::vector<GoldenResult>& results) {
  const auto any = [&](auto... outcomes) {
    return std::any_of(results.begin(), results.end(),
                       [&](const GoldenResult& result) { return ((result.outcome == outcomes) || ...); });
  };
  if (any(GoldenOutcome::kFailed, GoldenOutcome::kResultMissing, GoldenOutcome::kGoldenMissing)) return kExitRegression;
  // Nothing was compared, which is no success.
  if (any(GoldenOutcome::kSkipped)) return kExitNoPicture;
  return kExitGood;
}

std::map<GoldenOutcome, int> counts(const std::vector<GoldenResult>& results) {
  std::map<GoldenOutcome, int> counts;
  for (const auto outcome : {GoldenOutcome::kOk, GoldenOutcome::kFailed, GoldenOutcome::kResultMissing,
                             GoldenOutcome::kGoldenMissing, GoldenOutcome::kSkipped}) {
    counts[outcome] = static_cast<int>(std::count_if(
        results.begin(), results.end(), [&](const GoldenResult& result) { return result.outcome == outcome; }));
  }
  return counts;
}

void print_summary(const std::vector<GoldenResult>& results, bool json) {
  std::string line;
  Json json_counts = Json::object();
  for (const auto& [outcome, count] : counts(results)) {
    line += fmt::format("{}{} {}", line.empty() ? "" : ", ", count, outcome_name(outcome));
    json_counts[outcome_name(outcome)] = count;
  }
  fmt::print(stderr, "{}\n", line);
  if (!json) return;
  Json list = Json::array();
  for (const GoldenResult& result : results) list.push_back(to_json(result));
  fmt::print("{}\n",
             Json{{"goldens", list}, {"counts", json_counts}}.dump(2, ' ', false, Json::error_handler_t::replace));
}

bool is_continuous_integration() {
  const char* ci = std::getenv("CI");
  const std::string value = ci != nullptr ? ci : "";
  return !value.empty() && value != "false" && value != "0";
}

void renew(const Judged& judged, std::size_t index, const std::string& who, const std::string& why) {
  const GoldenPicture& picture = judged.pictures.pictures[index];
  const std::filesystem::path folder = golden_folder(judged.scenario.name);
  renew_golden(judged.scenario, picture, judged.pictures.driver, folder, who, why);
  const GoldenResult after = compare_with_golden(judged.scenario.name, judged.scenario.goldens[index], picture,
                                                 judged.pictures.driver, folder);
  fmt::print(stderr, "  before: {}: {}\n  after:  {}: {}\n", outcome_name(judged.results[index].outcome),
             judged.results[index].message, outcome_name(after.outcome), after.message);
}

}  // namespace

int test_goldens(const GoldenOptions& options) {
  std::vector<GoldenResult> results;
  for (Scenario& scenario : scenarios_with_goldens(options.scenarios)) {
    const Judged judged = judge(std::move(scenario), options.device);
    for (std::size_t i = 0; i < judged.results.size(); ++i) {
      print_result(judged.results[i]);
      keep_for_looking(judged.results[i], judged.pictures.pictures[i], options.out);
      results.push_back(judged.results[i]);
    }
  }
  print_summary(results, options.json);
  return exit_code(results);
}

int approve_goldens(const GoldenOptions& options) {
  if (is_continuous_integration()) throw UsageError("golden approve: goldens are approved by a person, not in CI");
  if (options.why.find_first_not_of(" \t\n") == std::string::npos) {
    throw UsageError("golden approve: say with --why what has changed and why that is right");
  }
  if (options.scenarios.empty()) throw UsageError("golden approve: name the scenarios to approve");
  const std::string who = approver();
  bool all_there = true;
  for (Scenario& scenario : scenarios_with_goldens(options.scenarios)) {
    const Judged judged = judge(std::move(scenario), options.device);
    for (std::size_t i = 0; i < judged.results.size(); ++i) {
      const GoldenResult& result = judged.results[i];
      if (result.outcome == GoldenOutcome::kFailed || result.outcome == GoldenOutcome::kGoldenMissing) {
        fmt::print(stderr, "approved: {} at {:g} s\n", result.scenario, result.at);
        renew(judged, i, who, options.why);
      } else {
        print_result(result);
        all_there = all_there && result.outcome == GoldenOutcome::kOk;
      }
    }
    if (!judged.pictures.no_device.empty()) return kExitNoPicture;
  }
  return all_there ? kExitGood : kExitRegression;
}

}  // namespace thinwall
