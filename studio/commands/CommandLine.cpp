#include "studio/commands/CommandLine.hpp"

#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <functional>
#include <optional>

#include "studio/commands/Commands.hpp"
#include "studio/commands/CommandsFirst.hpp"
#include "studio/commands/CompareArguments.hpp"
#include "studio/commands/CompareLine.hpp"
#include "studio/commands/ExitCode.hpp"
#include "studio/commands/JsonAnswer.hpp"
#include "studio/commands/PictureName.hpp"
#include "studio/recorder/Interruption.hpp"
#include "studio/recorder/Versions.hpp"

namespace thinwall {
namespace {

/// Texts as they were given; they become values when the command is known to be meant.
struct Texts {
  std::vector<std::string> overrides;
  std::string device = "auto";
  std::string size;
  std::string time;
  std::string out;
  std::string view;
  std::string data;
  std::string data_scale;
  std::string data_from;
  std::string data_to;
  std::string trajectory;
  std::string peer;
  std::string duration;
  std::string record;
  std::string forces = "auto";
};

using Action = std::function<int()>;

constexpr const char* kGoldensWords = "scenario files or names, each perhaps with a moment: NAME@1.5s";
constexpr const char* kStatsWords = "say what each pass of the pictures takes, and an empty frame";

/// A flag that makes `value` false. The help of a flag with a value of its own would tell that value.
void add_refusal(CLI::App& command, const std::string& name, bool& value, const std::string& documentation) {
  command.add_flag_callback(
      name, [&value] { value = false; }, documentation);
}

/// The parser of the whole command line. What is chosen ends up in `action`.
class CommandLine {
 public:
  CommandLine();
  int run(std::vector<std::string> arguments);

 private:
  void add_run();
  void add_check();
  void add_render();
  void add_still();
  void add_compare();
  void add_golden();
  CLI::App* add_golden_command(CLI::App& golden, const std::string& name, const std::string& documentation,
                               int (*action)(const GoldenOptions&));
  void add_doctor();
  void add_haptic();

  CLI::App* add_command(CLI::App& parent, const std::string& name, const std::string& documentation, Action action);
  void add_overrides(CLI::App& command);
  void add_device(CLI::App& command);
  void add_threads(CLI::App& command);
  void add_size(CLI::App& command);
  void add_recording(CLI::App& command, bool& video, bool& frames, bool& surfaces, bool& truth, bool& stats,
                     bool& json);

  CLI::App app_{
      "Thinwall: what a surgical tool does to soft tissue, simulated, rendered without a window, recorded and "
      "compared with golden images.",
      "thinwall"};
  Texts texts_;
  int threads_ = 0;  // 0: as many as there are cores
  RunOptions run_;
  CheckOptions check_;
  RenderOptions render_;
  StillOptions still_;
  CompareArguments compare_;
  GoldenOptions golden_;
  DoctorOptions doctor_;
  HapticOptions haptic_;
  Action action_;
};

DeviceChoice device_choice(const std::string& text) {
  try {
    return parse_device_choice(text);
  } catch (const std::invalid_argument& error) {
    throw UsageError("--device " + text + ": " + error.what());
  }
}

HapticForces haptic_forces(const std::string& text) {
  if (text == "auto") return HapticForces::kAuto;
  if (text == "full") return HapticForces::kFull;
  if (text == "local") return HapticForces::kLocal;
  throw UsageError("--forces " + text + ": there are no such forces; choose one of auto, full, local");
}

CommandLine::CommandLine() {
  app_.set_version_flag("--version", version_text(), "the version, and the licence of this build");
  app_.set_help_flag("-h,--help", kHelpWords);
  app_.require_subcommand(1);
  add_run();
  add_check();
  add_render();
  add_still();
  add_golden();
  add_compare();
  add_haptic();
  add_doctor();
  app_.footer(
      "Exit codes: 0 good, 1 a comparison or expectation failed, 2 bad usage or input, 3 the simulation failed,\n"
      "4 no picture or file could be made, 130 interrupted, 143 terminated.");
}

CLI::App* CommandLine::add_command(CLI::App& parent, const std::string& name, const std::string& documentation,
                                   Action action) {
  CLI::App* command = parent.add_subcommand(name, documentation);
  command->callback([this, action = std::move(action)] { action_ = action; });
  return command;
}

void CommandLine::add_overrides(CLI::App& command) {
  command.add_option("--set", texts_.overrides, "give a parameter of the scenario another value: name=value")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
}

void CommandLine::add_device(CLI::App& command) {
  command.add_option("--device", texts_.device, "what draws: auto, software, gpu or the number of an EGL device")
      ->type_name("DEVICE")
      ->capture_default_str();
}

void CommandLine::add_threads(CLI::App& command) {
  command.add_option("--threads", threads_, "how many threads the physics may use; changes no bit of the results")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
}

void CommandLine::add_size(CLI::App& command) {
  command.add_option("--size", texts_.size, "another size than the scenario's, in pixels")->type_name("WIDTHxHEIGHT");
}

void CommandLine::add_recording(CLI::App& command, bool& video, bool& frames, bool& surfaces, bool& truth, bool& stats,
                                bool& json) {
  add_refusal(command, "--no-video", video, "make no video");
  command.add_flag("--frames", frames, "keep each picture as PNG");
  command.add_flag("--surfaces", surfaces, "keep the deforming surfaces for ParaView");
  command.add_flag("--stats", stats, kStatsWords);
  command.add_flag("--aov", truth, "keep what each pixel shows: depth, normals, numbers, flow, stress, poses, masks");
  command.add_flag("--json", json, kJsonWords);
}

void CommandLine::add_run() {
  CLI::App* command = add_command(app_, "run", "simulate a scenario, render and record it", [this] {
    run_.overrides = parse_overrides(texts_.overrides);
    run_.device = device_choice(texts_.device);
    run_.device_text = texts_.device;
    if (!texts_.out.empty()) run_.out = texts_.out;
    if (run_.ground_truth && !run_.render) {
      throw UsageError("--aov: it tells what the pictures show, and --no-render makes none; leave one of both away");
    }
    if (run_.frames && !run_.render) {
      throw UsageError("--frames: it keeps the pictures, and --no-render makes none; leave one of both away");
    }
    if (run_.stats && !run_.render) {
      throw UsageError("--stats: it measures the pictures, and --no-render makes none; leave one of both away");
    }
    return run_scenario(run_);
  });
  command->add_option("SCENARIO", run_.scenario, "the scenario file")->required();
  command->add_option("--out", texts_.out, "the folder for the results; out/NAME when absent")->type_name("DIR");
  add_overrides(*command);
  add_device(*command);
  add_threads(*command);
  add_refusal(*command, "--no-render", run_.render, "physics and records only; needs no graphics");
  add_recording(*command, run_.video, run_.frames, run_.surfaces, run_.ground_truth, run_.stats, run_.json);
}

void CommandLine::add_check() {
  CLI::App* command = add_command(app_, "check", "read and check scenarios, nothing more", [this] {
    check_.overrides = parse_overrides(texts_.overrides);
    return check_scenarios(check_);
  });
  command->add_option("SCENARIO", check_.scenarios, "scenario files")->required();
  add_overrides(*command);
  command->add_flag("--json", check_.json, kJsonWords);
}

void CommandLine::add_render() {
  CLI::App* command = add_command(app_, "render", "pictures and video again from a take, without simulating", [this] {
    render_.overrides = parse_overrides(texts_.overrides);
    render_.device = device_choice(texts_.device);
    render_.device_text = texts_.device;
    if (!texts_.out.empty()) render_.out = texts_.out;
    if (!texts_.view.empty()) render_.view = texts_.view;
    if (!render_.overrides.empty() && !render_.view) {
      throw UsageError(
          "--set: a take holds what its run has computed; run its scenario again with --set, or name with "
          "--view the scenario that looks at it");
    }
    if (!texts_.data.empty()) render_.data = parse_data_quantity(texts_.data);
    DataViewChanges& changes = render_.data_changes;
    if (!texts_.data_scale.empty()) changes.scale = parse_data_scale(texts_.data_scale);
    if (!texts_.data_from.empty()) changes.from = parse_data_end("--data-from", texts_.data_from);
    if (!texts_.data_to.empty()) changes.to = parse_data_end("--data-to", texts_.data_to);
    if (!texts_.size.empty()) render_.size = parse_size(texts_.size);
    return render_take(render_);
  });
  command->add_option("TAKE", render_.take, "the take.h5 of a run")->required();
  command->add_option("--out", texts_.out, "the folder for the results; `render` beside the take when absent")
      ->type_name("DIR");
  command->add_option("--view", texts_.view, "take camera, lights, look and record from this scenario")
      ->type_name("SCENARIO");
  command->add_option("--data", texts_.data, "show a quantity of the walls in colours: " + data_words())
      ->type_name("QUANTITY");
  command->add_option("--data-from", texts_.data_from, "what the darkest colour of the data stands for: 5kPa")
      ->type_name("VALUE");
  command->add_option("--data-to", texts_.data_to, "what the lightest colour of the data stands for: 20kPa")
      ->type_name("VALUE");
  command
      ->add_option("--data-scale", texts_.data_scale,
                   "how colours go with the data: linear, or root, which shows the low end")
      ->type_name("SCALE");
  command->add_flag("--mesh", render_.mesh, "draw the edges of the triangles, those of cuts stronger");
  command->add_option("--fps", render_.frames_per_second, "pictures per second")->check(CLI::Range(1.0, 240.0));
  add_size(*command);
  add_overrides(*command);
  add_device(*command);
  add_recording(*command, render_.video, render_.frames, render_.surfaces, render_.ground_truth, render_.stats,
                render_.json);
}

void CommandLine::add_still() {
  CLI::App* command = add_command(app_, "still", "one picture of a scenario", [this] {
    still_.overrides = parse_overrides(texts_.overrides);
    still_.device = device_choice(texts_.device);
    still_.at = parse_time("--at ", texts_.time);
    if (!texts_.size.empty()) still_.size = parse_size(texts_.size);
    require_picture_name("-o", still_.picture);
    return make_still(still_);
  });
  command->add_option("SCENARIO", still_.scenario, "the scenario file")->required();
  command->add_option("--at", texts_.time, "when, for example 1.5s")->required()->type_name("TIME");
  command->add_option("-o", still_.picture, "the picture file")->required()->type_name("PNG");
  command->add_flag("--stats", still_.stats, kStatsWords);
  command->add_flag("--json", still_.json, kJsonWords);
  command->add_flag("--aov", still_.ground_truth, "keep what each pixel shows, in NAME_ground_truth beside NAME.png");
  add_size(*command);
  add_overrides(*command);
  add_device(*command);
  add_threads(*command);
}

void CommandLine::add_compare() {
  CLI::App* command =
      add_command(app_, kCompareCommand, kCompareWords, [this] { return compare(compare_options(compare_)); });
  add_compare_arguments(*command, compare_);
}

CLI::App* CommandLine::add_golden_command(CLI::App& golden, const std::string& name, const std::string& documentation,
                                          int (*action)(const GoldenOptions&)) {
  CLI::App* command = add_command(golden, name, documentation, [this, action] {
    golden_.device = device_choice(texts_.device);
    golden_.device_text = texts_.device;
    return action(golden_);
  });
  command->add_option("SCENARIO", golden_.scenarios,
                      std::string(kGoldensWords) + "; all that have goldens when absent");
  return command;
}

void CommandLine::add_golden() {
  CLI::App* golden = app_.add_subcommand("golden", "compare scenarios with approved pictures");
  golden->require_subcommand(1);
  CLI::App* test = add_golden_command(*golden, "test", "compare, and write no golden", test_goldens);
  CLI::App* report = add_golden_command(*golden, "report", "compare, and write a page to look at", report_goldens);
  CLI::App* review = add_golden_command(*golden, "review", "one failed golden after the other: accept, reject or skip",
                                        review_goldens);
  CLI::App* approve = add_golden_command(
      *golden, "approve", "make today's pictures of the named scenarios the golden ones", approve_goldens);
  approve->get_option("SCENARIO")->description(std::string(kGoldensWords) + " or NAME@video");
  CLI::App* list = add_golden_command(*golden, "list", "what goldens there are", list_goldens);
  CLI::App* why = add_golden_command(
      *golden, "why", "who approved a golden and why, and what its scenario has changed since", explain_goldens);
  for (CLI::App* command : {test, report, review, approve}) {
    add_device(*command);
    add_threads(*command);
    command->add_option("--out", golden_.out, "where the report and pictures that failed are put, to be looked at")
        ->type_name("DIR")
        ->capture_default_str();
  }
  for (CLI::App* command : {test, report, review}) {
    command->add_option("--jobs", golden_.jobs, "scenarios at once; as many as there are cores when absent")
        ->type_name("N")
        ->check(CLI::Range(1, 256));
  }
  for (CLI::App* command : {test, report, approve, list, why}) {
    command->add_flag("--json", golden_.json, kJsonWords);
  }
  for (CLI::App* command : {test, report}) {
    command->add_flag("--all", golden_.all, "also what has not changed since it was good");
    command->add_option("--junit", golden_.junit, "write the results as JUnit XML")->type_name("FILE");
  }
  for (CLI::App* command : {review, approve}) {
    command->add_option("--why", golden_.why, "what has changed and why that is right")->type_name("TEXT");
  }
}

void CommandLine::add_haptic() {
  CLI::App* command = add_command(app_, "haptic", "let a hand feel a scenario at 1 kHz, and tell how well", [this] {
    haptic_.overrides = parse_overrides(texts_.overrides);
    if (!texts_.trajectory.empty()) haptic_.trajectory = texts_.trajectory;
    if (!texts_.peer.empty()) haptic_.peer = texts_.peer;
    if (!texts_.duration.empty()) haptic_.duration = parse_duration("--for ", texts_.duration);
    haptic_.forces = haptic_forces(texts_.forces);
    if (!texts_.record.empty()) haptic_.record = texts_.record;
    return drive_haptics(haptic_);
  });
  command->add_option("SCENARIO", haptic_.scenario, "the scenario file")->required();
  command->add_option("--tool", haptic_.tool, "what the hand holds; the first tool when absent")->type_name("NAME");
  CLI::Option* trajectory = command
                                ->add_option("--trajectory", texts_.trajectory,
                                             "a recorded motion instead of the timeline's: a table with "
                                             "time_s, x_m, y_m, z_m, such as the forces.csv of a run")
                                ->type_name("CSV");
  command->add_option("--peer", texts_.peer, "a driver's motion: it sends poses to this socket and receives forces")
      ->type_name("SOCKET")
      ->excludes(trajectory);
  command->add_option("--for", texts_.duration, "how long at most, for example 5s; 10 minutes when absent")
      ->type_name("TIME");
  command
      ->add_option("--forces", texts_.forces,
                   "auto, full (solved in each tick) or local (a model of the contact, "
                   "refreshed by solutions beside the loop)")
      ->type_name("KIND")
      ->capture_default_str();
  command->add_option("--record", texts_.record, "write a table of all ticks")->type_name("CSV");
  add_refusal(*command, "--no-real-time", haptic_.real_time, "do not ask for real-time scheduling");
  add_overrides(*command);
  add_threads(*command);
  command->add_flag("--json", haptic_.json, kJsonWords);
}

void CommandLine::add_doctor() {
  CLI::App* command = add_command(app_, "doctor", "what this machine can draw and encode with, and what helps", [this] {
    doctor_.device = device_choice(texts_.device);
    return examine_machine(doctor_);
  });
  add_device(*command);
  command->add_flag("--json", doctor_.json, kJsonWords);
}

int CommandLine::run(std::vector<std::string> arguments) {
  arguments = commands_first(app_, arguments);
  if (const std::optional<int> code = parse_arguments(app_, std::move(arguments))) return *code;
  note_interruptions();
  std::optional<tbb::global_control> limit;
  if (threads_ > 0) limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads_));
  return action_();
}

}  // namespace

int run_command_line(const std::vector<std::string>& arguments) {
  return exit_code_of([&] { return CommandLine().run(arguments); }, failure_as(arguments));
}

}  // namespace thinwall
