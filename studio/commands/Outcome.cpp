#include "studio/commands/Outcome.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "renderer/image/WholeFile.hpp"
#include "studio/commands/ExitCode.hpp"
#include "studio/commands/JsonAnswer.hpp"
#include "studio/recorder/Messages.hpp"
#include "studio/scenario/InputError.hpp"

namespace thinwall {
namespace {

int exit_code_after(const ManifestContext& context, const RecordingReport& report) {
  if (!report.failure.empty()) return kExitSimulationFailed;
  const bool met = std::ranges::all_of(context.expectations, &ExpectationResult::passed);
  return met ? kExitGood : kExitRegression;
}

void print_result(const ManifestContext& context, const RecordingPlan& plan, const RecordingReport& report) {
  nlohmann::ordered_json json = {{"result", result_words(context, report)},
                                 {"exit_code", exit_code_after(context, report)},
                                 {"folder", plan.folder.generic_string()},
                                 {"manifest", (plan.folder / "manifest.json").generic_string()},
                                 {"steps", report.steps},
                                 {"simulated_s", report.simulated},
                                 {"frames", report.frame_hashes.size()},
                                 {"state_digest", report.state_digest},
                                 {"warnings", all_warnings(context, report)},
                                 {"wall_s", report.times.total}};
  if (!context.expectations.empty()) json["expectations"] = expectation_part(context.expectations);
  if (!report.passes.empty()) json["passes_ms"] = passes_as_json(report.passes);
  if (!report.failure.empty()) json["failure"] = report.failure;
  print_json(json);
}

}  // namespace

nlohmann::ordered_json passes_as_json(const std::vector<PassTime>& passes) {
  nlohmann::ordered_json json;
  for (const PassTime& pass : passes) json[pass.pass] = 1e3 * pass.wall_seconds;
  return json;
}

void tell_warnings(const Scenario& scenario) {
  for (const std::string& warning : scenario.warnings) print_message(stderr, "{}\n", warning);
}

void tell_note(const std::string& note) {
  print_message(stderr, "thinwall: note: {}\n", note);
}

int conclude(const ManifestContext& context, const RecordingPlan& plan, const RecordingReport& report, bool json) {
  write_whole_file(plan.folder / "manifest.json", manifest(context, plan, report));
  for (const std::string& warning : report.warnings) {
    if (std::ranges::find(context.told, warning) == context.told.end()) tell_note(warning);
  }
  const RecordingTimes& times = report.times;
  const std::string truth = plan.ground_truth ? fmt::format("ground truth {:.1f}, ", times.truth.wall) : "";
  print_message(stderr,
                "{:.2f} s in {} steps and {} frames, recorded in {} within {:.1f} s (simulate {:.1f}, render {:.1f}, "
                "{}encode {:.1f})\n",
                report.simulated, report.steps, report.frame_hashes.size(), plan.folder.string(), times.total,
                times.simulate.wall, times.render.wall, truth, times.encode.wall);
  print_message(stderr, "{}", pass_table(report.passes));
  if (json) print_result(context, plan, report);
  for (const ExpectationResult& result : context.expectations) {
    print_message(stderr, "thinwall: {}: {}\n", to_text(result.expectation.location), to_text(result));
  }
  if (!report.failure.empty()) {
    print_message(stderr, "thinwall: the simulation failed: {}; what it had reached is recorded\n", report.failure);
  }
  return exit_code_after(context, report);
}

}  // namespace thinwall
