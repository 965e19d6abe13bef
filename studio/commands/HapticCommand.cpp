#include <fmt/format.h>

#include "renderer/image/Folder.hpp"
#include "renderer/image/WholeFile.hpp"
#include "studio/commands/Commands.hpp"
#include "studio/commands/ExitCode.hpp"
#include "studio/commands/Outcome.hpp"
#include "studio/commands/StandardOutput.hpp"
#include "studio/haptics/HapticRun.hpp"
#include "studio/haptics/PeerDevice.hpp"
#include "studio/recorder/Interruption.hpp"
#include "studio/recorder/Messages.hpp"
#include "studio/scenario/LoadScenario.hpp"

namespace thinwall {

int drive_haptics(const HapticOptions& options) {
  HapticPlan plan{.scenario = load_scenario(options.scenario, options.overrides),
                  .tool = options.tool,
                  .trajectory = options.trajectory,
                  .peer = options.peer,
                  .duration = options.duration,
                  .forces = options.forces,
                  .real_time = options.real_time,
                  .throw_if_interrupted = throw_if_interrupted};
  tell_warnings(plan.scenario);
  plan.scenario.simulation.between_iterations = throw_if_interrupted;
  // Before the loop, so that a folder that cannot be made is told at once.
  if (options.record && options.record->has_parent_path()) make_folder(options.record->parent_path());
  HapticReport report;
  try {
    report = run_haptics(plan);
  } catch (const PeerError& error) {
    throw UsageError(fmt::format("--peer {}", error.what()));
  }
  print_message(stderr, "{}", to_text(report));
  if (options.record) write_whole_file(*options.record, tick_table(report.record));
  const int exit_code = report.failure.empty() ? kExitGood : kExitSimulationFailed;
  if (options.json) say_result(to_json(report, exit_code) + "\n");
  if (exit_code != kExitGood) {
    print_message(stderr, "thinwall: the solver behind the loop failed: {}\n", report.failure);
  }
  return exit_code;
}

}  // namespace thinwall
