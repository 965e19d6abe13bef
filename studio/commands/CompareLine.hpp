#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studio/commands/CompareArguments.hpp"

namespace CLI {
class App;
}

namespace thinwall {

inline constexpr const char* kCompareCommand = "compare";
inline constexpr const char* kCompareWords = "two pictures, two videos or two folders of them";
inline constexpr const char* kHelpWords = "this help";

/// Gives the command the arguments of `compare`; what is written after it ends up in `arguments`.
void add_compare_arguments(CLI::App& command, CompareArguments& arguments);

/// Parses the arguments (without the program's name), runs callbacks, and says on stderr what is wrong with them. Gives
/// the exit code when that is all: after a mistake, and after help or version have been printed.
std::optional<int> parse_arguments(CLI::App& app, std::vector<std::string> arguments);

/// What the program does with `compare` and what follows it. Gives the exit code.
int run_compare_line(const std::vector<std::string>& arguments);

}  // namespace thinwall
