#pragma once

#include <optional>
#include <string>

namespace thinwall {

/// The next line of standard input; nothing at its end. Throws Interrupted where the user ends the program instead.
std::optional<std::string> read_answer();

}  // namespace thinwall
