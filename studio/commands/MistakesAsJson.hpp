#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "studio/scenario/InputError.hpp"

namespace thinwall {

/// A list of objects: file, line, column, message.
nlohmann::ordered_json mistakes_as_json(const std::vector<Diagnostic>& mistakes);

}  // namespace thinwall
