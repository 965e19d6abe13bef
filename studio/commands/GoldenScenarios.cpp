#include "studio/commands/GoldenScenarios.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <map>
#include <set>
#include <thread>
#include <utility>

#include "renderer/image/PictureFailure.hpp"
#include "renderer/video/Program.hpp"
#include "renderer/video/VideoSurvey.hpp"
#include "studio/commands/Arguments.hpp"
#include "studio/commands/ExitCode.hpp"
#include "studio/commands/Outcome.hpp"
#include "studio/commands/RunSource.hpp"
#include "studio/director/StressFreeAnswers.hpp"
#include "studio/golden/GoldenCache.hpp"
#include "studio/golden/UnaskedGoldens.hpp"
#include "studio/recorder/Interruption.hpp"
#include "studio/recorder/ResolvedPicture.hpp"
#include "studio/scenario/IncludePass.hpp"
#include "studio/scenario/LoadScenario.hpp"
#include "studio/scenario/YamlReader.hpp"
#include "studio/schema/Wording.hpp"

namespace thinwall {
namespace {

constexpr const char* kCache = "unchanged.json";  // in the folder for what is to be looked at

/// The folder that holds scenes/ and golden_images/.
std::filesystem::path home() {
  const char* home = std::getenv("THINWALL_HOME");
  return home != nullptr ? home : ".";
}

std::vector<std::filesystem::path> all_scenes() {
  std::vector<std::filesystem::path> files;
  if (!std::filesystem::is_directory(home() / "scenes")) return files;
  for (const auto& entry : std::filesystem::directory_iterator(home() / "scenes")) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// One golden of a scenario.
struct GoldenChoice {
  bool is_video = false;
  double at = 0;  // seconds, of a moment
};

/// "NAME@1.5s" -> "NAME" and 1.5 s; a file whose name has an @ in it is a file.
std::pair<std::string, std::optional<GoldenChoice>> name_and_choice(const std::string& text) {
  const std::size_t at = text.rfind('@');
  if (at == std::string::npos || std::filesystem::exists(text)) return {text, std::nullopt};
  if (text.substr(at + 1) == "video") return {text.substr(0, at), GoldenChoice{.is_video = true}};
  return {text.substr(0, at),
          GoldenChoice{.is_video = false, .at = parse_time(text.substr(0, at + 1), text.substr(at + 1))}};
}

void leave_only(std::vector<GoldenDefinition>& goldens, const GoldenChoice& choice, const std::string& scenario) {
  std::erase_if(goldens, [&](const GoldenDefinition& golden) {
    const bool is_video = golden.video > 0;
    return is_video != choice.is_video || (!is_video && std::abs(golden.at - choice.at) > 1e-9);
  });
  if (!goldens.empty()) return;
  throw UsageError(scenario + ": this scenario has no golden " + (choice.is_video ? "of its video" : "at that time") +
                   "; see thinwall golden list");
}

/// Whether a file that is no scenario by itself asks for goldens, itself or by what it includes. One that cannot be
/// parsed may do so.
bool may_ask_for_goldens(const std::filesystem::path& file) {
  Diagnostics ignored;
  std::optional<TextNode> root = read_yaml_file(file, ignored);
  if (!root) return true;
  include_pass(*root, ignored);
  return root->find("golden") != nullptr;
}

bool includes(const std::filesystem::path& file, const std::filesystem::path& other) {
  Diagnostics ignored;
  const std::optional<TextNode> root = read_yaml_file(file, ignored);
  const TextMember* include = root ? root->find("include") : nullptr;
  if (include == nullptr) return false;
  const auto is_other = [&](const TextNode& item) {
    std::error_code failure;
    return std::filesystem::equivalent(file.parent_path() / item.text, other, failure);
  };
  const TextNode& value = include->value;
  return value.kind == NodeKind::kText ? is_other(value) : std::ranges::any_of(value.items, is_other);
}

std::vector<std::string> scene_names() {
  std::vector<std::string> names;
  for (const std::filesystem::path& file : all_scenes()) names.push_back(file.stem().string());
  return names;
}

/// Whether a file that cannot be read as a scenario should be one, and have goldens.
bool should_have_goldens(const std::filesystem::path& file, const std::vector<std::filesystem::path>& all) {
  if (std::filesystem::is_directory(golden_folder(file.stem().string()))) return true;
  return may_ask_for_goldens(file) && std::ranges::none_of(all, [&](const auto& one) { return includes(one, file); });
}

/// All scenarios of the folder that have goldens.
NamedGoldens goldens_of_folder() {
  const std::vector<std::filesystem::path> all = all_scenes();
  NamedGoldens named{.are_all = true};
  for (const std::filesystem::path& file : all) {
    try {
      Scenario scenario = load_scenario(file, {}, stress_free_answers());
      if (scenario.goldens.empty()) continue;
      named.scenarios.push_back(std::move(scenario));
      named.are_chosen.push_back(false);
    } catch (const InputErrors& errors) {
      if (should_have_goldens(file, all)) named.broken.push_back({file, errors});
    }
  }
  if (!named.scenarios.empty() || !named.broken.empty()) return named;
  throw UsageError("no scenario with a `golden:` list was found in " + (home() / "scenes").string());
}

/// Adds the scenario of a file, with the goldens chosen alone, or that it cannot be read.
void add_named(NamedGoldens& named, const std::filesystem::path& file, const std::optional<GoldenChoice>& choice) {
  try {
    Scenario scenario = load_scenario(file, {}, stress_free_answers());
    if (scenario.goldens.empty()) {
      throw UsageError(file.string() + ": this scenario has no `golden:` list, so there is nothing to compare");
    }
    if (choice) leave_only(scenario.goldens, *choice, scenario.name);
    named.are_whole = named.are_whole && !choice;
    named.scenarios.push_back(std::move(scenario));
    named.are_chosen.push_back(choice.has_value());
  } catch (const InputErrors& errors) {
    if (!std::filesystem::exists(file)) throw;  // a wrong name is no scenario
    named.broken.push_back({file, errors});
  }
}

/// Goldens are kept by the names of scenarios: what is approved of one would be compared with the other.
void refuse_one_name(const std::vector<Scenario>& scenarios) {
  std::map<std::string, std::filesystem::path> files;
  for (const Scenario& scenario : scenarios) {
    const auto [first, is_new] = files.emplace(scenario.name, scenario.file);
    std::error_code failure;
    if (is_new || std::filesystem::equivalent(first->second, scenario.file, failure)) continue;
    throw UsageError(fmt::format("golden: {} and {} have one name, by which goldens are kept; rename one of them",
                                 first->second.string(), scenario.file.string()));
  }
}

/// Holds a folder for each scenario that another process tests.
std::filesystem::path jobs_folder(const GoldenOptions& options) {
  return options.out / "jobs";
}

/// Runs this program with other arguments to its end, or to that of this one: where that is asked to end, so is the
/// other, and killed where it does not. Where this one is ended at once, as by a second signal, the system kills it.
void run_until_interrupted(const std::vector<std::string>& arguments) {
  constexpr std::chrono::milliseconds kBetweenLooks{50}, kPatience{800};
  std::vector<std::string> words{"setpriv", "--pdeathsig", "KILL", std::filesystem::read_symlink("/proc/self/exe")};
  std::ranges::copy(arguments, std::back_inserter(words));
  Program program(words);
  while (!program.finish_within(kBetweenLooks)) {
    try {
      throw_if_interrupted();
    } catch (const Interrupted&) {
      program.terminate();
      program.finish_within(kPatience);
      throw;
    }
  }
}

/// The driver that draws here, as it names itself; why there is none, when there is none.
std::string driver_here(const DeviceChoice& device) {
  try {
    return renderer_painters(device, Tier::kDraft, {})({.width = 8, .height = 8})->driver();
  } catch (const PictureFailure& failure) {
    return failure.what();
  }
}

}  // namespace

std::filesystem::path golden_root() {
  return home() / "golden_images";
}

std::filesystem::path golden_folder(const std::string& scenario) {
  return golden_root() / scenario;
}

void refuse_broken(const NamedGoldens& named) {
  std::vector<Diagnostic> mistakes;
  for (const BrokenScenario& broken : named.broken) {
    std::ranges::copy(broken.errors.diagnostics(), std::back_inserter(mistakes));
  }
  if (!mistakes.empty()) throw InputErrors(std::move(mistakes));
}

std::vector<std::string> golden_notes(const NamedGoldens& named) {
  std::vector<std::string> notes;
  if (named.are_whole) {
    for (const Scenario& scenario : named.scenarios) {
      std::ranges::copy(unasked_goldens(scenario, golden_folder(scenario.name)), std::back_inserter(notes));
    }
  }
  if (!named.are_all) return notes;
  GoldenOwners owners{.scenes = home() / "scenes", .scenarios = named.scenarios, .broken = {}};
  for (const BrokenScenario& broken : named.broken) owners.broken.insert(broken.file.stem().string());
  std::ranges::copy(unasked_folders(golden_root(), owners), std::back_inserter(notes));
  return notes;
}

NamedGoldens named_goldens(const std::vector<std::string>& names) {
  if (names.empty()) return goldens_of_folder();
  NamedGoldens named;
  std::set<std::pair<std::filesystem::path, std::string>> seen;  // files, and which of their goldens
  for (const std::string& text : names) {
    const auto [name, choice] = name_and_choice(text);
    const std::filesystem::path scene = home() / "scenes" / (name + ".yaml");
    const bool is_name = !std::filesystem::exists(name) && std::filesystem::exists(scene);
    const std::filesystem::path file = is_name ? scene : std::filesystem::path(name);
    if (!seen.insert({std::filesystem::weakly_canonical(file), text.substr(name.size())}).second) continue;
    if (!is_name && !std::filesystem::exists(file) && !file.has_parent_path() && !file.has_extension()) {
      throw UsageError(
          fmt::format("golden: there is no file {}, and no scenario of that name in {}{}; see thinwall golden list",
                      name, (home() / "scenes").string(), did_you_mean(name, scene_names())));
    }
    add_named(named, file, choice);
  }
  refuse_one_name(named.scenarios);
  return named;
}

GoldenRunOptions golden_run(const GoldenOptions& options, bool keeps) {
  GoldenRunOptions run{.sources = simulate_scenario,
                       .painters =
                           [device = options.device](const std::string& resolved) {
                             const PictureSettings settings = picture_settings(resolved);
                             return renderer_painters(device, settings.record.tier, settings.view);
                           },
                       .goldens = golden_root(),
                       .cache = {},
                       .videos = options.out / "videos",
                       .program = ""};
  if (!keeps) return run;
  run.cache = options.out / kCache;
  run.anew = options.all;
  run.program = file_hash("/proc/self/exe") + " " + options.device_text + " " + driver_here(options.device) + " " +
                program_version("ffmpeg");
  run.jobs = options.jobs > 0 ? options.jobs : static_cast<int>(std::thread::hardware_concurrency());
  run.in_other_process = [options](const Scenario& scenario) {
    const std::filesystem::path out = jobs_folder(options) / scenario.name;
    run_until_interrupted(
        {"golden", "test", scenario.file, "--all", "--jobs", "1", "--device", options.device_text, "--out", out});
    return out / kCache;
  };
  run.cannot_keep = [](const PictureFailure& failure) {
    tell_note(fmt::format("what is good is not remembered, so the next test makes it again: {}", failure.what()));
  };
  return run;
}

std::vector<JudgedScenario> judge_named(const NamedGoldens& named, const GoldenOptions& options,
                                        const std::function<void(const JudgedScenario&)>& done) {
  std::vector<JudgedScenario> all = judge_scenarios(named.scenarios, golden_run(options, named.are_whole), done);
  std::error_code ignored;
  std::filesystem::remove(jobs_folder(options), ignored);  // where it is empty
  for (const BrokenScenario& broken : named.broken) {
    all.push_back(unreadable_scenario(broken.file, broken.errors));
    done(all.back());
  }
  return all;
}

bool is_continuous_integration() {
  const char* ci = std::getenv("CI");
  const std::string value = ci != nullptr ? ci : "";
  return !value.empty() && value != "false" && value != "0";
}

}  // namespace thinwall
