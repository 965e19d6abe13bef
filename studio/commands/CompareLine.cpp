#include "studio/commands/CompareLine.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "studio/commands/Commands.hpp"
#include "studio/commands/ExitCode.hpp"
#include "studio/commands/JsonAnswer.hpp"
#include "studio/recorder/Interruption.hpp"
#include "studio/schema/Wording.hpp"

namespace thinwall {
namespace {

/// Every range holds "nan", as no comparison with it is true.
std::string refuse_nan(const std::string& text) {
  return std::isnan(std::strtod(text.c_str(), nullptr)) ? text + " is no number" : "";
}

/// The options of the command that was called.
std::vector<std::string> options_of_called(const CLI::App& app) {
  const CLI::App* called = &app;
  while (!called->get_subcommands().empty()) called = called->get_subcommands().front();
  std::vector<std::string> names;
  for (const CLI::Option* option : called->get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

/// The first option that the command has not, by its name; the parser would name it last, behind what belongs to it.
void refuse_unknown_option(const CLI::App& app, const std::vector<std::string>& remaining) {
  for (const std::string& argument : remaining) {
    if (!argument.starts_with("--")) continue;
    const std::string name = argument.substr(0, argument.find('='));
    throw UsageError("there is no option " + name + " here" + did_you_mean(name, options_of_called(app)) +
                     "\nRun with --help for more.");
  }
}

/// An empty value, as of a shell's variable that is not set, would be taken for an option that is absent.
void refuse_empty_values(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    if (std::ranges::find(option->results(), "") == option->results().end()) continue;
    throw UsageError(option->get_name() + ": its value is empty; give one, or leave the option out");
  }
  for (const CLI::App* command : app.get_subcommands()) refuse_empty_values(*command);
}

}  // namespace

void add_compare_arguments(CLI::App& command, CompareArguments& arguments) {
  command.add_option("A", arguments.options.first, "the first picture, video or folder: what it should be")->required();
  command.add_option("B", arguments.options.second, "the second one: what it is")->required();
  command.add_option("--metric", arguments.metric, "figures that are wanted: pixels, ssim, flip or all")
      ->type_name("METRIC")
      ->capture_default_str();
  const auto number = [&](const std::string& name, auto& value, const std::string& documentation) {
    return command.add_option(name, value, documentation)->type_name("NUMBER")->check(refuse_nan);
  };
  PictureLimits& limits = arguments.options.comparison.limits;
  number("--max", limits.largest, "largest difference allowed, 8-bit levels")->check(CLI::Range(0.0, 255.0));
  number("--mean", limits.mean, "largest mean difference allowed, 8-bit levels")->check(CLI::Range(0.0, 255.0));
  number("--failing", limits.failing, "largest fraction of failing pixels allowed, 0 to 1")
      ->check(CLI::Range(0.0, 1.0));
  number("--drift", limits.drift, "largest allowed change of the mean of red, green or blue, as a part of it")
      ->check(CLI::Range(0.0, 1.0));
  number("--level", limits.tolerance.level, "levels above which a pixel fails")->check(CLI::Range(0, 255));
  number("--shift", limits.tolerance.shift, "pixels by which what a pixel shows may lie elsewhere")
      ->check(CLI::Range(0, 4));
  number("--ssim", limits.structure, "least mean of structural similarity, up to 1")->check(CLI::Range(-1.0, 1.0));
  number("--flip", limits.flip, "largest mean of FLIP allowed, 0 to 1")->check(CLI::Range(0.0, 1.0));
  number("--flip-99", limits.flip_99, "largest 99th percentile of FLIP allowed, 0 to 1")->check(CLI::Range(0.0, 1.0));
  number("--pixels-per-degree", arguments.options.comparison.flip.pixels_per_degree,
         "of the viewer's sight, for FLIP; 67 when absent")
      ->check(CLI::Range(5.0, 500.0));
  command.add_option("--mask", arguments.mask, "a picture, dark where nothing counts")->type_name("PICTURE");
  command.add_option("--layer", arguments.layer, "what the numbers are: depth, normals, ids or flow")
      ->type_name("LAYER");
  number("--tolerance", arguments.tolerance, "of a layer: metres, degrees or pixels above which a pixel fails")
      ->check(CLI::NonNegativeNumber);
  number("--edge-band", arguments.edge_band, "of depth: pixels by which a silhouette may move")
      ->check(CLI::Range(0, 16));
  command.add_flag("--pixels-only", arguments.options.comparison.pixels_only,
                   "of videos: times, captions, chapters and colour tags do not count");
  command.add_option("--diff", arguments.difference, "write a picture of the difference; of folders, a folder of them")
      ->type_name("PNG");
  command.add_flag("--json", arguments.options.json, kJsonWords);
}

std::optional<int> parse_arguments(CLI::App& app, std::vector<std::string> arguments) {
  // The parser takes them from the back.
  std::reverse(arguments.begin(), arguments.end());
  try {
    app.parse(arguments);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    refuse_unknown_option(app, app.remaining(true));
    throw UsageError(std::string(error.what()) + "\nRun with --help for more.");
  }
  refuse_empty_values(app);
  return std::nullopt;
}

int run_compare_line(const std::vector<std::string>& arguments) {
  return exit_code_of(
      [&] {
        CLI::App app("", "thinwall");
        app.set_help_flag("-h,--help", kHelpWords);
        CompareArguments read;
        add_compare_arguments(*app.add_subcommand(kCompareCommand, kCompareWords), read);
        if (const std::optional<int> code = parse_arguments(app, arguments)) return *code;
        note_interruptions();
        return compare(compare_options(read));
      },
      failure_as(arguments));
}

}  // namespace thinwall
