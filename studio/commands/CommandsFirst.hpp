#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace thinwall {

/// The arguments with the command (and the command's command) in front: CLI11 wants them before their options, but the
/// order of options must not matter. A short option's value may stand behind a sign (`-o=a.png`), as that of a long one
/// does. Throws UsageError when there are words but no command among them.
std::vector<std::string> commands_first(const CLI::App& app, const std::vector<std::string>& arguments);

}  // namespace thinwall
