#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "renderer/image/WholeFile.hpp"
#include "studio/commands/Commands.hpp"
#include "studio/commands/ExitCode.hpp"
#include "studio/commands/Outcome.hpp"
#include "studio/commands/RunSource.hpp"
#include "studio/recorder/Interruption.hpp"
#include "studio/recorder/Painter.hpp"
#include "studio/scenario/LoadScenario.hpp"

namespace thinwall {

int run_scenario(const RunOptions& options) {
  StageTime preparation;
  Scenario scenario;
  {
    const StageClock clock(preparation);
    scenario = load_scenario(options.scenario, options.overrides);
  }
  const RecordingPlan plan{
      .folder = options.out.value_or(std::filesystem::path("out") / scenario.name),
      .description = {.name = scenario.name, .title = scenario.title, .resolved = scenario.resolved},
      .overlays = scenario.overlays,
      .size = scenario.record.size,
      .frames_per_second = scenario.record.frames_per_second,
      .pictures = options.render,
      .video = options.video && scenario.record.video,
      .frames = options.frames,
      .surfaces = options.surfaces,
      .progress = stderr};
  const std::unique_ptr<MomentSource> source = simulate_scenario(scenario);
  const RecordingReport report =
      record(*source, plan, renderer_painters(options.device, scenario.record.tier, scenario.view));
  return conclude({.command = "run",
                   .source = options.scenario,
                   .device = options.device_text,
                   .overrides = options.overrides,
                   .preparation = preparation.wall},
                  plan, report, options.json);
}

}  // namespace thinwall
