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

/// Which goldens are meant: scenario files, names in the folder of scenarios, each perhaps with "@1.5s" behind it for
/// one moment of it, or "@video". All that have goldens when none is named; then one that is broken stops no other, and
/// files that others include are no scenarios where they cannot stand alone. Throws UsageError, and InputErrors where
/// one that is named is broken or there is no other.
struct NamedGoldens {
  std::vector<Scenario> scenarios;      // with the goldens that are meant alone
  bool are_whole = true;                // whether no golden of theirs was left out
  std::vector<Diagnostic> broken = {};  // what is wrong with scenarios that have goldens and cannot be read
};
NamedGoldens named_goldens(const std::vector<std::string>& names);

/// Tells what is wrong with those that could not be read; the exit code of a command that has done the others with
/// `code`.
int tell_broken(const NamedGoldens& named, int code);

/// How goldens are made on this machine. With `keeps`, which is for whole scenarios, what is good is remembered in the
/// options' folder, and several scenarios are tested at once.
GoldenRunOptions golden_run(const GoldenOptions& options, bool keeps);

/// True in continuous integration, where nobody approves anything.
bool is_continuous_integration();

}  // namespace thinwall
