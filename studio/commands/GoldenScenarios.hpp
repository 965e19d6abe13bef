#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "studio/commands/Commands.hpp"
#include "studio/golden/GoldenRun.hpp"
#include "studio/scenario/InputError.hpp"
#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// The folder that holds the goldens of a scenario.
std::filesystem::path golden_folder(const std::string& scenario);

/// The folder that holds a folder of goldens for each scenario.
std::filesystem::path golden_root();

/// A scenario that has goldens and cannot be read.
struct BrokenScenario {
  std::filesystem::path file;
  InputErrors errors;
};

/// Which goldens are meant: scenario files, names in the folder of scenarios, each perhaps with "@1.5s" behind it for
/// one moment of it, or "@video". All that have goldens when none is named; then files that others include are no
/// scenarios where they cannot stand alone. One that cannot be read stops no other. Throws UsageError, and InputErrors
/// where a file that is named is not there.
struct NamedGoldens {
  std::vector<Scenario> scenarios = {};  // with the goldens that are meant alone
  std::vector<bool> are_chosen = {};     // of each: whether one golden of it was named by its moment
  bool are_whole = true;                 // whether no golden of theirs was left out
  bool are_all = false;                  // of the folder of scenarios
  std::vector<BrokenScenario> broken = {};
};
NamedGoldens named_goldens(const std::vector<std::string>& names);

/// Throws InputErrors where scenarios cannot be read.
void refuse_broken(const NamedGoldens& named);

/// What lies among the goldens and no scenario asks for: a line each.
std::vector<std::string> golden_notes(const NamedGoldens& named);

/// How goldens are made on this machine. With `keeps`, which is for whole scenarios, what is good is remembered in the
/// options' folder, and several scenarios are tested at once.
GoldenRunOptions golden_run(const GoldenOptions& options, bool keeps);

/// Judges all of them, those that cannot be read last; `done` is called for one after the other.
std::vector<JudgedScenario> judge_named(const NamedGoldens& named, const GoldenOptions& options,
                                        const std::function<void(const JudgedScenario&)>& done);

/// True in continuous integration, where nobody approves anything.
bool is_continuous_integration();

}  // namespace thinwall
