#include "studio/recorder/Recorder.hpp"

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <future>
#include <mutex>
#include <optional>
#include <thread>

#include "engine/simulation/SimulationFailure.hpp"
#include "renderer/image/Folder.hpp"
#include "renderer/image/ImageHash.hpp"
#include "renderer/image/PictureFailure.hpp"
#include "renderer/image/PngFile.hpp"
#include "renderer/image/WholeFile.hpp"
#include "renderer/overlay/ContactSheet.hpp"
#include "renderer/overlay/EnergyPlotImage.hpp"
#include "renderer/overlay/ForcePlotImage.hpp"
#include "renderer/video/VideoSurvey.hpp"
#include "renderer/video/VideoWriter.hpp"
#include "renderer/video/WebVtt.hpp"
#include "studio/recorder/BoundedQueue.hpp"
#include "studio/recorder/FrameComposer.hpp"
#include "studio/recorder/Highlights.hpp"
#include "studio/recorder/Interruption.hpp"
#include "studio/recorder/OutputFolder.hpp"
#include "studio/recorder/PlotPoints.hpp"
#include "studio/recorder/Progress.hpp"
#include "studio/recorder/RecordCsv.hpp"
#include "studio/recorder/ResolvedPicture.hpp"
#include "studio/recorder/ShownTexts.hpp"
#include "studio/recorder/SurfaceSeries.hpp"
#include "studio/recorder/VideoScript.hpp"

namespace thinwall {
namespace {

// Enough to even out steps and frames of unequal cost; a moment of 20 000 triangles is about a megabyte.
constexpr std::size_t kWaitingMoments = 64;
constexpr std::size_t kWaitingPictures = 4;
constexpr std::chrono::milliseconds kBetweenLooksForSignals(50);

/// The threads of a recording. The first error stops all of them.
class Pipeline {
 public:
  Pipeline(MomentSource& source, const RecordingPlan& plan, const PainterFactory& painters)
      : source_(source), plan_(plan), painters_(painters), progress_(plan.progress, "recording") {}

  RecordingReport run();

 private:
  [[noreturn]] void throw_error() const;
  void simulate();
  bool take_moments();
  bool wait_for_painter();
  void open_records();
  void keep(const Moment& moment);
  void finish_records();
  void render();
  bool show(const FrameComposer& composer, const VideoCue& cue, Painter& painter);
  void open_pictures();
  void encode();
  void wait_for_pictures();
  void finish_video();
  void finish_pictures();

  void stop(std::exception_ptr error);
  void show_progress(double time);
  template <typename Work>
  std::jthread stage(Work work);

  MomentSource& source_;
  const RecordingPlan& plan_;
  const PainterFactory& painters_;
  Progress progress_;
  RecordingReport report_;

  BoundedQueue<Moment> moments_{kWaitingMoments};
  BoundedQueue<FinishedPicture> pictures_{kWaitingPictures};
  std::mutex mutex_;
  std::condition_variable stages_changed_;
  int running_stages_ = 0;
  std::atomic<bool> has_painter_ = false;
  std::exception_ptr error_;
  std::atomic<double> planned_duration_ = 0;

  // Of the simulating thread.
  bool records_open_ = false;
  bool replaces_results_ = false;  // of an earlier recording
  std::optional<TakeWriter> take_;
  std::optional<RecordCsv> csv_;
  std::optional<SurfaceSeries> surfaces_;
  std::optional<FrameComposer> surface_frames_;
  std::size_t next_surface_frame_ = 0;
  std::vector<TimedText> captions_;
  PlotPoints plots_;
  PlotPoints second_plots_;  // of the take that is compared

  // Of the rendering thread.
  VideoScript script_{plan_.teaching};
  std::optional<VideoCue> last_cue_;
  std::optional<GroundTruthSeries> truth_;
  Frame last_frame_;
  FinishedPicture last_picture_;

  // Of the encoding thread, until it has ended.
  std::optional<VideoWriter> video_;
  Highlights highlights_;
};

std::filesystem::path frame_folder(const RecordingPlan& plan) {
  return plan.folder / "frames";
}

GroundTruthPlan truth_plan(const RecordingPlan& plan) {
  return {.folder = plan.folder / kGroundTruthFolder,
          .size = plan.size,
          .organs = tissue_kinds(plan.description.resolved),
          .look = plan.view.look};
}

template <typename Work>
std::jthread Pipeline::stage(Work work) {
  {
    const std::lock_guard lock(mutex_);
    ++running_stages_;
  }
  return std::jthread([this, work] {
    try {
      work();
    } catch (...) {
      stop(std::current_exception());
    }
    const std::lock_guard lock(mutex_);
    --running_stages_;
    stages_changed_.notify_all();
  });
}

void Pipeline::stop(std::exception_ptr error) {
  {
    const std::lock_guard lock(mutex_);
    if (!error_) error_ = std::move(error);
    stages_changed_.notify_all();
  }
  moments_.abort();
  pictures_.abort();
}

RecordingReport Pipeline::run() {
  const auto start = std::chrono::steady_clock::now();
  make_folder(plan_.folder);
  {
    std::jthread renderer;
    std::jthread encoder;
    try {
      if (plan_.pictures) {
        renderer = stage([this] { render(); });
        encoder = stage([this] { encode(); });
      }
      simulate();
      wait_for_pictures();
    } catch (...) {
      stop(std::current_exception());
    }
  }
  progress_.end();
  if (error_) throw_error();
  if (plan_.pictures) finish_pictures();
  report_.times.total = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return std::move(report_);
}

/// Where earlier results had to make room for a recording that was not finished, the user is told.
void Pipeline::throw_error() const {
  if (!replaces_results_) std::rethrow_exception(error_);
  const std::string consequence = "the earlier results in " + plan_.folder.string() +
                                  " had been removed, and this run has not finished all of its own";
  try {
    std::rethrow_exception(error_);
  } catch (const Interrupted& interrupted) {
    throw Interrupted(interrupted, consequence);
  } catch (const FileUnwritable& failure) {
    throw FileUnwritable(failure.what() + ("; " + consequence));
  } catch (const PictureFailure& failure) {
    throw PictureFailure(failure.what() + ("; " + consequence));
  }
}

void Pipeline::simulate() {
  try {
    if (!take_moments()) return;
  } catch (const SimulationFailure& failure) {
    report_.failure = failure.what();
  }
  moments_.close();
  if (!wait_for_painter()) return;
  open_records();
  report_.warnings = source_.warnings();
  report_.state_digest = source_.state_digest();
  finish_records();
}

/// False when there is none, as on a device that cannot draw, or another stage has stopped.
bool Pipeline::wait_for_painter() {
  if (!plan_.pictures || records_open_) return true;
  std::unique_lock lock(mutex_);
  while (!stages_changed_.wait_for(lock, kBetweenLooksForSignals, [this] { return has_painter_ || error_; })) {
    throw_if_interrupted();
  }
  return !error_;
}

/// Only once there is something to record and to draw with, so that a scenario or device that turns out to be wrong
/// leaves the earlier recording.
void Pipeline::open_records() {
  if (records_open_) return;
  records_open_ = true;
  replaces_results_ = prepare_output_folder(plan_.folder);
  if (plan_.records) {
    take_.emplace(plan_.folder / "take.h5", plan_.description);
    csv_.emplace(plan_.folder);
  }
  if (plan_.surfaces) {
    surfaces_.emplace(plan_.folder);
    surface_frames_.emplace(plan_.description.title, plan_.overlays);
  }
}

/// False when another stage has stopped.
bool Pipeline::take_moments() {
  while (true) {
    throw_if_interrupted();
    std::optional<Moment> moment;
    {
      const StageClock clock(report_.times.simulate);
      moment = source_.next();
    }
    if (!moment) return true;
    if (!wait_for_painter()) return false;
    {
      const StageClock clock(report_.times.write);
      open_records();
      keep(*moment);
    }
    planned_duration_ = moment->planned_duration;
    if (!plan_.pictures) {
      show_progress(moment->snapshot.time);
    } else if (!moments_.push(*std::move(moment))) {
      return false;
    }
  }
}

void Pipeline::keep(const Moment& moment) {
  // First, because it refuses what is not a number.
  if (csv_) csv_->write(moment.record);
  if (take_) take_->write(moment);
  if (surfaces_) {
    surface_frames_->add(moment);
    for (;; ++next_surface_frame_) {
      const double time = static_cast<double>(next_surface_frame_) / plan_.frames_per_second;
      if (!surface_frames_->reaches(time)) break;
      surfaces_->write(surface_frames_->compose(time).snapshot);
    }
  }
  plots_.add(moment.record);
  if (moment.second) second_plots_.add(moment.second->record);
  captions_ = moment.captions;
  report_.chapters = moment.chapters;
  report_.simulated = moment.snapshot.time;
  ++report_.steps;
}

void Pipeline::finish_records() {
  const StageClock clock(report_.times.write);
  if (take_) {
    take_->finish(
        {.complete = report_.failure.empty(), .warnings = report_.warnings, .state_digest = report_.state_digest});
  }
  if (csv_) csv_->finish();
  if (surfaces_) surfaces_->finish();
  const bool is_compared = plan_.view.comparison && !second_plots_.forces().empty();
  const std::vector<ToolForces> forces =
      is_compared ? compared_forces(plots_, second_plots_, plan_.view.comparison->captions) : plots_.forces();
  write_png(plan_.folder / "forces.png", force_plot_image(plan_.description.title, forces));
  write_png(plan_.folder / "energies.png",
            energy_plot_image(plan_.description.title, plots_.energies(), plots_.forces()));
  const double end = script_.clock().last_shown(report_.simulated) + 1 / plan_.frames_per_second;
  write_web_vtt(plan_.folder / "captions.vtt",
                up_to(end, shown_captions(captions_, script_.clock(), script_.title_duration()), &VideoCaption::text));
}

void Pipeline::render() {
  const std::unique_ptr<Painter> painter = painters_(plan_.size);
  report_.driver = painter->driver();
  has_painter_ = true;
  stages_changed_.notify_all();
  FrameComposer composer(plan_.description.title, plan_.overlays, plan_.view, plan_.teaching.annotations,
                         {plan_.size, planned_work(plan_.description.resolved), script_.badges()});
  std::size_t frame = 0;
  std::optional<double> end;
  const auto cue_now = [&] { return script_.at(static_cast<double>(frame) / plan_.frames_per_second, end); };
  while (auto moment = moments_.pop()) {
    composer.add(*std::move(moment));
    for (auto cue = cue_now(); composer.reaches(cue->simulation); ++frame, cue = cue_now()) {
      if (!show(composer, *cue, *painter)) return;
    }
  }
  end = composer.last_time();
  for (auto cue = cue_now(); end && cue; ++frame, cue = cue_now()) {
    if (!show(composer, *cue, *painter)) return;
  }
  if (truth_) {
    const StageClock clock(report_.times.truth);
    truth_->finish();
  }
  report_.passes = painter->pass_times();
  pictures_.close();
}

/// False when the encoder has stopped. A picture that shows the same as the one before is not drawn again.
bool Pipeline::show(const FrameComposer& composer, const VideoCue& cue, Painter& painter) {
  if (!last_cue_ || *last_cue_ != cue) {
    const StageClock clock(report_.times.render);
    last_frame_ = composer.compose(cue.simulation);
    last_frame_.overlay.badge = cue.badge;
    last_frame_.card = cue.card;
    last_picture_ = {.image = finished_picture(last_frame_, painter),
                     .time = cue.simulation,
                     .force = last_frame_.overlay.force,
                     .covered = cue.card ? cue.card->opacity : 0};
    last_cue_ = cue;
  }
  if (plan_.ground_truth) {
    const StageClock clock(report_.times.truth);
    // Once there is a picture: the folder is then prepared.
    if (!truth_) truth_.emplace(truth_plan(plan_));
    truth_->add(last_frame_);
  }
  return pictures_.push(FinishedPicture(last_picture_));
}

/// Once there is a picture, for the same reason.
void Pipeline::open_pictures() {
  if (plan_.frames) make_folder(unfinished_name(frame_folder(plan_)));
  if (plan_.video) {
    video_.emplace(plan_.folder / "video.mp4",
                   VideoOptions{.size = plan_.size, .frames_per_second = plan_.frames_per_second});
  }
}

void Pipeline::encode() {
  while (const auto picture = pictures_.pop()) {
    const StageClock clock(report_.times.encode);
    const std::size_t frame = report_.frame_hashes.size();
    if (frame == 0) open_pictures();
    if (plan_.frames) {
      write_png(unfinished_name(frame_folder(plan_)) / fmt::format("frame_{:06}.png", frame), picture->image);
    }
    if (video_) video_->write(picture->image);
    report_.frame_hashes.push_back(image_hash(picture->image));
    highlights_.add(*picture);
    show_progress(picture->time);
  }
}

void Pipeline::wait_for_pictures() {
  std::unique_lock lock(mutex_);
  while (!stages_changed_.wait_for(lock, kBetweenLooksForSignals, [this] { return running_stages_ == 0; })) {
    throw_if_interrupted();
  }
}

void Pipeline::finish_video() {
  const double end = static_cast<double>(report_.frame_hashes.size()) / plan_.frames_per_second;
  video_->finish(up_to(end, shown_chapters(report_.chapters, script_.clock(), end), &VideoChapter::title),
                 up_to(end, shown_captions(captions_, script_.clock(), script_.title_duration()), &VideoCaption::text));
}

/// Beside the video, whose end is mostly waiting for programs that start.
void Pipeline::finish_pictures() {
  if (report_.frame_hashes.empty()) return;
  const StageClock clock(report_.times.encode);
  report_.poster_time = highlights_.poster_time();
  std::future<void> video;
  if (video_) {
    video = std::async(std::launch::async, [this] { finish_video(); });
    report_.encoder = program_version("ffmpeg");
  }
  if (plan_.frames) rename_folder(unfinished_name(frame_folder(plan_)), frame_folder(plan_));
  write_png(plan_.folder / "poster.png", highlights_.poster());
  write_png(plan_.folder / "contact_sheet.png", contact_sheet(plan_.description.title, highlights_.sheet_frames()));
  if (video.valid()) video.get();
}

void Pipeline::show_progress(double time) {
  const double duration = planned_duration_;
  progress_.reach(duration > 0 ? time / duration : 1);
}

}  // namespace

RecordingReport record(MomentSource& source, const RecordingPlan& plan, const PainterFactory& painters) {
  return Pipeline(source, plan, painters).run();
}

}  // namespace thinwall
