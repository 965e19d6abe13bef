#include "studio/commands/CommandsFirst.hpp"

#include <CLI/CLI.hpp>
#include <cstddef>
#include <set>

#include "studio/commands/ExitCode.hpp"
#include "studio/schema/Wording.hpp"

namespace thinwall {
namespace {

/// The names of options that take a value.
void collect_options_with_value(const CLI::App& app, std::set<std::string>& names) {
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_items_expected_max() == 0) continue;
    for (const std::string& name : option->get_lnames()) names.insert("--" + name);
    for (const std::string& name : option->get_snames()) names.insert("-" + name);
  }
  for (const CLI::App* command : app.get_subcommands(nullptr)) collect_options_with_value(*command, names);
}

/// The parser would only say that a command is missing. `before`: the command whose command is looked for, with a space
/// behind it.
void refuse_unknown_command(const CLI::App& level, const std::string& before,
                            const std::vector<std::string>& arguments) {
  std::vector<std::string> known;
  for (const CLI::App* command : level.get_subcommands(nullptr)) known.push_back(command->get_name());
  for (const std::string& argument : arguments) {
    if (argument.empty() || argument[0] == '-') continue;
    throw UsageError("there is no command `" + before + argument + "`" + did_you_mean(argument, known) +
                     "; see thinwall " + before + "--help");
  }
}

const CLI::App* find_command(const CLI::App& parent, const std::string& name) {
  for (const CLI::App* command : parent.get_subcommands(nullptr)) {
    if (command->get_name() == name) return command;
  }
  return nullptr;
}

}  // namespace

std::vector<std::string> commands_first(const CLI::App& app, const std::vector<std::string>& arguments) {
  std::set<std::string> with_value;
  collect_options_with_value(app, with_value);
  std::vector<std::string> first;
  std::vector<std::string> rest;
  const CLI::App* level = &app;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    const CLI::App* command = find_command(*level, argument);
    if (command != nullptr) {
      first.push_back(argument);
      level = command;
      continue;
    }
    // The parser would take the sign for the beginning of the value.
    if (argument.size() > 2 && argument[2] == '=' && with_value.count(argument.substr(0, 2)) > 0) {
      rest.insert(rest.end(), {argument.substr(0, 2), argument.substr(3)});
      continue;
    }
    rest.push_back(argument);
    if (with_value.count(argument) > 0 && i + 1 < arguments.size()) rest.push_back(arguments[++i]);
  }
  if (!level->get_subcommands(nullptr).empty()) {
    refuse_unknown_command(*level, first.empty() ? "" : first.back() + " ", rest);
  }
  first.insert(first.end(), rest.begin(), rest.end());
  return first;
}

}  // namespace thinwall
