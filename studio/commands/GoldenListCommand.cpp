#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "studio/commands/Commands.hpp"
#include "studio/commands/ExitCode.hpp"
#include "studio/commands/GoldenScenarios.hpp"
#include "studio/commands/JsonAnswer.hpp"
#include "studio/commands/StandardOutput.hpp"
#include "studio/golden/GoldenVideoApproval.hpp"
#include "studio/recorder/Messages.hpp"

namespace thinwall {
namespace {

using Json = nlohmann::ordered_json;

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
      say_result(fmt::format(
          "{:<32} {:>8}  {}  {}\n", scenario.name, golden.video > 0 ? "video" : fmt::format("{:.9g} s", golden.at),
          limits_text(golden),
          drivers.empty() ? "nothing is approved"
                          : fmt::format("approved for {} driver{}", drivers.size(), drivers.size() > 1 ? "s" : "")));
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
  for (const std::string& note : notes) print_message(stderr, "{}\n", note);
  const int code = named.broken.empty() && !any_damaged ? kExitGood : kExitBadInput;
  if (options.json) print_json({{"goldens", list}, {"notes", notes}, {"exit_code", code}});
  for (const BrokenScenario& broken : named.broken) print_message(stderr, "{}\n", broken.errors.what());
  return code;
}

}  // namespace thinwall
