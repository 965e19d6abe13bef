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

/// The names of those whose content is not that of the record, separated by commas; of all where `record` is empty, as
/// approvals of earlier versions kept none.
std::string changed_files(const std::string& record, const Scenario& scenario);

}  // namespace thinwall
