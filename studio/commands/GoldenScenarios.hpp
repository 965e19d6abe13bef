#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "studio/commands/Commands.hpp"
#include "studio/golden/GoldenRun.hpp"
#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// The folder that holds the goldens of a scenario.
std::filesystem::path golden_folder(const std::string& scenario);

/// The folder that holds a folder of goldens for each scenario.
std::filesystem::path golden_root();

/// One golden of a scenario.
struct GoldenChoice {
  bool is_video = false;
  double at = 0;  // seconds, of a moment
};

/// Which goldens are meant: scenario files, names in the folder of scenarios, each perhaps with "@1.5s" behind it for
/// one moment of it, or "@video". All that have goldens when none is named. Throws UsageError.
struct NamedGoldens {
  std::vector<Scenario> scenarios;
  std::vector<std::optional<GoldenChoice>> choices;  // (scenarios); all of a scenario when absent

  /// Whether a golden belongs to what was named.
  bool means(std::size_t scenario, const GoldenResult& result) const;
  bool means(std::size_t scenario, const GoldenDefinition& definition) const;
};
NamedGoldens named_goldens(const std::vector<std::string>& names);

/// How goldens are made on this machine. With `keeps` what is good is remembered in the options' folder, and several
/// scenarios are tested at once.
GoldenRunOptions golden_run(const GoldenOptions& options, bool keeps);

/// True in continuous integration, where nobody approves anything.
bool is_continuous_integration();

}  // namespace thinwall
