#pragma once

#include <map>
#include <string>

#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// Hashes of the files that a scenario and that of its second take name, by the names they have there, and of the
/// files that those name in turn; empty for a file that cannot be read.
std::map<std::string, std::string> named_files(const Scenario& scenario);

/// The same as JSON, for an approval; empty when no file is named.
std::string named_files_record(const Scenario& scenario);

/// What has made the physics change, to go on a sentence with: a file that the scenario names or the scenario, which
/// asks for `asked` now, else the engine. Of records as above; approvals of earlier versions kept none.
std::string told_cause_of_physics(const std::string& files_before, const std::string& files_today,
                                  const std::string& asked);

}  // namespace thinwall
