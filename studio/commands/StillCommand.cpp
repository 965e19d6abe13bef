#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "renderer/image/Folder.hpp"
#include "renderer/image/PngFile.hpp"
#include "renderer/image/WholeFile.hpp"
#include "renderer/snapshot/SameTime.hpp"
#include "studio/commands/Commands.hpp"
#include "studio/commands/DataViewRange.hpp"
#include "studio/commands/ExitCode.hpp"
#include "studio/commands/Outcome.hpp"
#include "studio/commands/SecondTake.hpp"
#include "studio/recorder/FontNotes.hpp"
#include "studio/recorder/FrameComposer.hpp"
#include "studio/recorder/GroundTruthSeries.hpp"
#include "studio/recorder/Interruption.hpp"
#include "studio/recorder/OutputFolder.hpp"
#include "studio/recorder/Painter.hpp"
#include "studio/recorder/ResolvedPicture.hpp"
#include "studio/scenario/LoadScenario.hpp"

namespace thinwall {
namespace {

/// Frames of a scenario at times that ascend.
class FramesInOrder {
 public:
  explicit FramesInOrder(const Scenario& scenario)
      : source_(simulate_scenario(scenario)),
        composer_(scenario.title, scenario.overlays, scenario.view, scenario.teaching.annotations) {}

  /// Nothing when the scenario ends before.
  std::optional<Frame> at(double time) {
    while (!composer_.reaches(time)) {
      throw_if_interrupted();
      std::optional<Moment> moment = source_->next();
      if (!moment) return std::nullopt;
      end_ = moment->snapshot.time;
      composer_.add(*std::move(moment));
    }
    return composer_.compose(time);
  }
  double end() const { return end_; }  // seconds, as far as known

 private:
  std::unique_ptr<MomentSource> source_;
  FrameComposer composer_;
  double end_ = 0;
};

/// The time so many frames of a recording later, seconds: to the last bit that of the recording's own frame where the
/// recording has one at `time`.
double frames_later(double time, int count, double frames_per_second) {
  const double frame = std::round(time * frames_per_second);
  if (std::abs(frame / frames_per_second - time) < kSameTime) return (frame + count) / frames_per_second;
  return time + count / frames_per_second;
}

std::filesystem::path truth_folder(const std::filesystem::path& picture) {
  return picture.parent_path() / (picture.stem().string() + "_" + kGroundTruthFolder);
}

}  // namespace

int make_still(const StillOptions& options) {
  Scenario scenario = load_scenario(options.scenario, options.overrides);
  std::ranges::copy(font_notes(scenario), std::back_inserter(scenario.warnings));
  tell_warnings(scenario);
  require_data_range(scenario.view.look);
  if (options.ground_truth) prepare_truth(scenario.view);
  const PainterFactory painters = renderer_painters(options.device, scenario.record.tier, scenario.view, options.stats);
  // Before the simulation, so that a missing device is told at once.
  const std::unique_ptr<Painter> painter = painters(options.size.value_or(scenario.record.size));
  const double fps = scenario.record.frames_per_second;
  FramesInOrder frames(scenario);
  std::optional<Frame> before;
  if (options.ground_truth && options.at > 0) before = frames.at(std::max(0.0, frames_later(options.at, -1, fps)));
  const double time = frames_later(options.at, 0, fps);
  const std::optional<Frame> frame = frames.at(time);
  if (!frame) throw UsageError(fmt::format("--at {:g}s: the scenario ends at {:.4g} s", options.at, frames.end()));
  const Image image = finished_picture(*frame, *painter);
  if (options.picture.has_parent_path()) make_folder(options.picture.parent_path());
  write_png(options.picture, image);
  if (options.ground_truth) {
    remove_ground_truth(truth_folder(options.picture));
    remove_ground_truth(unfinished_name(truth_folder(options.picture)));
    GroundTruthSeries::write_still({.folder = truth_folder(options.picture),
                                    .size = image.size,
                                    .organs = tissue_kinds(scenario.resolved),
                                    .edges = drawn_edges(scenario.view.look)},
                                   before, *frame, frames.at(frames_later(time, 1, fps)));
  }
  fmt::print(stderr, "{}", pass_table(painter->pass_times()));
  fmt::print(stderr, "{} shows {} at {:.4g} s\n", options.picture.string(), scenario.name, options.at);
  return kExitGood;
}

}  // namespace thinwall
