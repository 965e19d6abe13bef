#pragma once

#include <nlohmann/json_fwd.hpp>

namespace thinwall {

/// What --json does, for the help.
inline constexpr const char* kJsonWords = "say the result as JSON on standard output";

/// Says the answer of a command on standard output. Bytes that are no UTF-8, as names of files may have, are replaced.
void print_json(const nlohmann::ordered_json& answer);

}  // namespace thinwall
