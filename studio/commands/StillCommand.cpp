#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>

#include "renderer/image/Folder.hpp"
#include "renderer/image/ImageHash.hpp"
#include "renderer/image/PngFile.hpp"
#include "renderer/image/WholeFile.hpp"
#include "renderer/snapshot/SameTime.hpp"
#include "studio/commands/Commands.hpp"
#include "studio/commands/DataViewRange.hpp"
#include "studio/commands/ExitCode.hpp"
#include "studio/commands/JsonAnswer.hpp"
#include "studio/commands/Outcome.hpp"
#include "studio/commands/SecondTake.hpp"
#include "studio/director/StressFreeAnswers.hpp"
#include "studio/recorder/FontNotes.hpp"
#include "studio/recorder/FrameComposer.hpp"
#include "studio/recorder/GroundTruthSeries.hpp"
#include "studio/recorder/Interruption.hpp"
#include "studio/recorder/Messages.hpp"
#include "studio/recorder/OutputFolder.hpp"
#include "studio/recorder/Painter.hpp"
#include "studio/recorder/ResolvedPicture.hpp"
#include "studio/recorder/VideoScript.hpp"
#include "studio/scenario/LoadScenario.hpp"

namespace thinwall {
namespace {

/// Frames of a scenario at times that ascend.
class FramesInOrder {
 public:
  FramesInOrder(const Scenario& scenario, ImageSize size)
      : source_(simulate_scenario(scenario)),
        composer_(scenario.title, scenario.overlays, scenario.view, scenario.teaching.annotations,
                  {size, planned_work(scenario.resolved), VideoScript(scenario.teaching).badges()}) {}

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

/// What the frames of the recording show around a time of the simulation, to the last bit as the recording has it where
/// a frame shows that time (the first that does). Freezes and slow motion decide what the next frame shows.
class RecordedTimes {
 public:
  RecordedTimes(const Scenario& scenario, double time)
      : script_(scenario.teaching), frames_per_second_(scenario.record.frames_per_second), time_(time) {
    const VideoClock& clock = script_.clock();
    shown_ = time > 0 ? clock.first_shown(time) : script_.title_duration();  // after the card
    const double frame = std::ceil((shown_ - kSameTime) * frames_per_second_);
    if (frame / frames_per_second_ < clock.last_shown(time) + kSameTime) frame_ = frame;
  }

  /// Seconds of the simulation in the frame that comes so many later; nothing before the first and under a card.
  std::optional<double> later(int count) const {
    if (count == 0 && !frame_) return time_;
    if (frame_ && *frame_ + count < 0) return std::nullopt;
    const double video = frame_ ? (*frame_ + count) / frames_per_second_ : shown_ + count / frames_per_second_;
    const std::optional<VideoCue> cue = script_.at(std::max(0.0, video));
    return cue && !cue->card ? std::optional(cue->simulation) : std::nullopt;
  }

 private:
  VideoScript script_;
  double frames_per_second_ = 0;
  double time_ = 0;   // seconds, of the simulation
  double shown_ = 0;  // seconds, of the video
  std::optional<double> frame_;
};

std::filesystem::path truth_folder(const std::filesystem::path& picture) {
  return picture.parent_path() / (picture.stem().string() + "_" + kGroundTruthFolder);
}

void print_still(const StillOptions& options, const Scenario& scenario, const Image& image, const std::string& driver,
                 const std::vector<PassTime>& passes) {
  nlohmann::ordered_json json = {{"result", "ok"},
                                 {"exit_code", kExitGood},
                                 {"picture", options.picture.generic_string()},
                                 {"scenario", scenario.name},
                                 {"at_s", options.at},
                                 {"size", {image.size.width, image.size.height}},
                                 {"hash", image_hash(image)},
                                 {"driver", driver},
                                 {"warnings", scenario.warnings}};
  if (options.ground_truth) json["ground_truth"] = truth_folder(options.picture).generic_string();
  if (!passes.empty()) json["passes_ms"] = passes_as_json(passes);
  print_json(json);
}

}  // namespace

int make_still(const StillOptions& options) {
  Scenario scenario = load_scenario(options.scenario, options.overrides, stress_free_answers());
  std::ranges::copy(font_notes(scenario), std::back_inserter(scenario.warnings));
  tell_warnings(scenario);
  require_data_range(scenario.view.look);
  if (scenario.view.comparison) require_data_range(scenario.view.comparison->second.look);
  if (options.ground_truth) prepare_truth(scenario.view);
  const PainterFactory painters = renderer_painters(options.device, scenario.record.tier, scenario.view, options.stats);
  // Before the simulation, so that a missing device is told at once.
  const ImageSize size = options.size.value_or(scenario.record.size);
  const std::unique_ptr<Painter> painter = painters(size);
  const RecordedTimes times(scenario, options.at);
  FramesInOrder frames(scenario, size);
  const auto frame_later = [&](int count) {
    const std::optional<double> time = times.later(count);
    return time ? frames.at(*time) : std::nullopt;
  };
  const std::optional<Frame> before = options.ground_truth ? frame_later(-1) : std::nullopt;
  const std::optional<Frame> frame = frame_later(0);
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
                                    .look = scenario.view.look},
                                   before, *frame, frame_later(1));
  }
  const std::vector<PassTime> passes = painter->pass_times();
  print_message(stderr, "{}", pass_table(passes));
  print_message(stderr, "{} shows {} at {:.4g} s\n", options.picture.string(), scenario.name, options.at);
  if (options.json) print_still(options, scenario, image, painter->driver(), passes);
  return kExitGood;
}

}  // namespace thinwall
