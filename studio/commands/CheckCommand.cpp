#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "engine/simulation/SimulationFailure.hpp"
#include "studio/commands/Commands.hpp"
#include "studio/commands/ExitCode.hpp"
#include "studio/commands/JsonAnswer.hpp"
#include "studio/commands/LongWait.hpp"
#include "studio/commands/MistakesAsJson.hpp"
#include "studio/commands/Outcome.hpp"
#include "studio/director/BodyNotes.hpp"
#include "studio/director/Plan.hpp"
#include "studio/director/RunNotes.hpp"
#include "studio/director/ScenarioRun.hpp"
#include "studio/recorder/FontNotes.hpp"
#include "studio/recorder/Interruption.hpp"
#include "studio/scenario/InputError.hpp"
#include "studio/scenario/LoadScenario.hpp"

namespace thinwall {
namespace {

/// Whether the clip is held against a body when it is planned: it touches a wall, or drains.
bool needs_body(const Clip& clip) {
  if (const auto* fill = std::get_if<FillClip>(&clip.action)) return fill->added < 0;
  return !body_of(clip).empty();
}

/// Where a clip's tool meets a wall, and how much fluid there is to drain, is known of bodies in equilibrium alone: the
/// timeline is planned as a run does. Where there is no equilibrium, which is a run's to tell, that is noted.
void check_clips(Scenario scenario, std::vector<std::string>& notes) {
  if (std::ranges::none_of(scenario.timeline, needs_body)) return;
  LongWait wait("`" + scenario.name + "`: finding the equilibrium that its clips begin with", tell_note,
                slack_wall_advice(scenario));
  scenario.simulation.between_iterations = [&wait] {
    throw_if_interrupted();
    wait.look();
  };
  try {
    ScenarioRun{scenario};
  } catch (const SimulationFailure& failure) {
    notes.push_back(fmt::format("what its clips meet or drain is not known: {}", failure.what()));
  }
}

/// What is found of a scenario beyond its file, and in the second take of its comparison otherwise than in the first.
std::vector<std::string> notes_of(const Scenario& scenario) {
  std::vector<std::string> notes = body_notes(scenario);
  check_clips(scenario, notes);
  if (!scenario.comparison) return notes;
  const std::vector<std::string> first = notes;
  for (const std::string& note : notes_of(*scenario.comparison->second)) {
    if (std::ranges::find(first, note) == first.end()) notes.push_back("the second take: " + note);
  }
  return notes;
}

}  // namespace

int check_scenarios(const CheckOptions& options) {
  nlohmann::ordered_json results = nlohmann::ordered_json::array();
  int code = kExitGood;
  for (const std::filesystem::path& file : options.scenarios) {
    throw_if_interrupted();
    nlohmann::ordered_json errors = nlohmann::ordered_json::array();
    std::vector<std::string> notes, warnings;
    try {
      Scenario scenario = load_scenario(file, options.overrides);
      std::ranges::copy(font_notes(scenario), std::back_inserter(scenario.warnings));
      warnings = scenario.warnings;
      tell_warnings(scenario);
      notes = notes_of(scenario);
      for (const std::string& note : notes) fmt::print(stderr, "{}: note: {}\n", file.string(), note);
      fmt::print(stderr, "{}: good\n", file.string());
    } catch (const InputErrors& mistakes) {
      code = kExitBadInput;
      fmt::print(stderr, "{}\n", mistakes.what());
      errors = mistakes_as_json(mistakes.diagnostics());
    }
    results.push_back({{"file", file.generic_string()},
                       {"good", errors.empty()},
                       {"errors", errors},
                       {"warnings", warnings},
                       {"notes", notes}});
  }
  if (options.json) {
    print_json({{"scenarios", results}, {"exit_code", code}});
  }
  return code;
}

}  // namespace thinwall
