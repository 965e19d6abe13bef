#include <fmt/format.h>

#include "renderer/image/PngFile.hpp"
#include "studio/commands/Commands.hpp"
#include "studio/commands/ExitCode.hpp"
#include "studio/commands/RunSource.hpp"
#include "studio/recorder/FrameComposer.hpp"
#include "studio/recorder/Interruption.hpp"
#include "studio/recorder/OutputFolder.hpp"
#include "studio/recorder/Painter.hpp"
#include "studio/scenario/LoadScenario.hpp"

namespace thinwall {
namespace {

Frame frame_at(const Scenario& scenario, double at) {
  const std::unique_ptr<MomentSource> source = simulate_scenario(scenario);
  FrameComposer composer(scenario.title, scenario.overlays, scenario.view, scenario.teaching.annotations);
  double end = 0;
  while (!composer.reaches(at)) {
    throw_if_interrupted();
    std::optional<Moment> moment = source->next();
    if (!moment) throw UsageError(fmt::format("--at {:g}s: the scenario ends at {:.4g} s", at, end));
    end = moment->snapshot.time;
    composer.add(*std::move(moment));
  }
  return composer.compose(at);
}

}  // namespace

int make_still(const StillOptions& options) {
  const Scenario scenario = load_scenario(options.scenario, options.overrides);
  const PainterFactory painters = renderer_painters(options.device, scenario.record.tier, scenario.view);
  // Before the simulation, so that a missing device is told at once.
  const std::unique_ptr<Painter> painter = painters(options.size.value_or(scenario.record.size));
  const Frame frame = frame_at(scenario, options.at);
  const Image image = finished_picture(frame, *painter);
  if (options.picture.has_parent_path()) make_folder(options.picture.parent_path());
  write_png(options.picture, image);
  fmt::print(stderr, "{} shows {} at {:.4g} s\n", options.picture.string(), scenario.name, options.at);
  return kExitGood;
}

}  // namespace thinwall
