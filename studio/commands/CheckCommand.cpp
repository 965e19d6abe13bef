#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/simulation/SimulationFailure.hpp"
#include "studio/commands/Commands.hpp"
#include "studio/commands/ExitCode.hpp"
#include "studio/commands/JsonAnswer.hpp"
#include "studio/commands/MisplacedNotes.hpp"
#include "studio/commands/MistakesAsJson.hpp"
#include "studio/commands/Outcome.hpp"
#include "studio/commands/RunSource.hpp"
#include "studio/director/BodyNotes.hpp"
#include "studio/recorder/FontNotes.hpp"
#include "studio/recorder/Interruption.hpp"
#include "studio/recorder/Messages.hpp"
#include "studio/scenario/InputError.hpp"
#include "studio/scenario/LoadScenario.hpp"

namespace thinwall {
namespace {

/// A run that has begun: what is known of it then.
struct Beginning {
  std::vector<std::string> notes;
  std::optional<Moment> moment;  // nothing where it fails
};

/// Where a clip's tool meets a wall, and how much fluid there is to drain, is known of bodies in equilibrium alone: the
/// timeline is planned as a run does. Where there is no equilibrium, which is a run's to tell, that is noted.
Beginning beginning_of_run(const Scenario& scenario) {
  body_notes(scenario);  // tells the mistakes of all bodies: a run ends with the first that has some
  const std::unique_ptr<MomentSource> run = simulate_one_take(scenario);
  Beginning beginning;
  std::string failure;
  try {
    beginning.moment = run->next();
  } catch (const SimulationFailure& error) {
    failure = fmt::format("its run will fail, so what its clips meet or drain is not known: {}", error.what());
  }
  beginning.notes = run->warnings();
  if (!failure.empty()) beginning.notes.push_back(std::move(failure));
  return beginning;
}

/// What is found of a scenario beyond its file, and in the second take of its comparison otherwise than in the first.
std::vector<std::string> notes_of(const Scenario& scenario) {
  const Beginning first = beginning_of_run(scenario);
  std::vector<std::string> notes = first.notes;
  double second_duration = 0;
  if (scenario.comparison) {
    const Beginning second = beginning_of_run(*scenario.comparison->second);
    if (second.moment) second_duration = second.moment->planned_duration;
    for (const std::string& note : second.notes) {
      if (std::ranges::find(first.notes, note) == first.notes.end()) notes.push_back("the second take: " + note);
    }
  }
  if (first.moment) {
    std::ranges::copy(misplaced_notes(scenario, *first.moment, second_duration), std::back_inserter(notes));
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
      for (const std::string& note : notes) print_message(stderr, "{}: note: {}\n", file.string(), note);
      print_message(stderr, "{}: good\n", file.string());
    } catch (const InputErrors& mistakes) {
      code = kExitBadInput;
      print_message(stderr, "{}\n", mistakes.what());
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
