#pragma once

#include <string>
#include <vector>

namespace thinwall {

/// What the program does with its arguments (without its own name). Gives the exit code.
int run_command_line(const std::vector<std::string>& arguments);

}  // namespace thinwall
