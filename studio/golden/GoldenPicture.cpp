#include "studio/golden/GoldenPicture.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/simulation/SimulationFailure.hpp"
#include "renderer/image/ImageHash.hpp"
#include "renderer/image/PictureFailure.hpp"
#include "renderer/image/Resize.hpp"
#include "studio/recorder/FrameComposer.hpp"
#include "studio/recorder/Interruption.hpp"
#include "studio/recorder/VideoScript.hpp"

namespace thinwall {
namespace {

constexpr ImageSize kLargest = {.width = 640, .height = 640};

/// Indices of the moments of the list in the order of time.
std::vector<std::size_t> in_order_of_time(const std::vector<GoldenDefinition>& goldens) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < goldens.size(); ++i) {
    if (goldens[i].video == 0) order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return goldens[a].at < goldens[b].at; });
  return order;
}

/// Keeps what was painted last, before anything is written over it.
class KeepingPainter final : public Painter {
 public:
  explicit KeepingPainter(Painter& painter) : painter_(painter) {}
  Image paint(const Snapshot& snapshot, const Shot& shot) override {
    last_ = painter_.paint(snapshot, shot);
    return last_;
  }
  std::string driver() const override { return painter_.driver(); }
  Image take_last() { return std::move(last_); }

 private:
  Painter& painter_;
  Image last_;
};

void draw(GoldenPicture& picture, const FrameComposer& composer, Moment moment, Painter& painter) {
  try {
    Frame frame = composer.compose(picture.at);
    KeepingPainter keeping(painter);
    picture.image = finished_picture(frame, keeping);
    picture.scene = keeping.take_last();
    picture.scene_hash = image_hash(picture.scene);
    picture.is_annotated = (frame.annotations && !frame.annotations->is_empty()) || frame.card;
    picture.overlay = std::move(frame.overlay);
    picture.shot = std::move(frame.shot);
    picture.moment = std::move(moment);
    picture.moment.snapshot = std::move(frame.snapshot);
    if (picture.moment.second) {
      Moment second = *picture.moment.second;
      second.snapshot = *picture.shot.beside_snapshot;
      picture.moment.second = std::make_shared<const Moment>(std::move(second));
    }
    picture.missing.clear();
  } catch (const PictureFailure& failure) {
    picture.missing = failure.what();
    picture.cannot_be_made = true;
  }
}

}  // namespace

ImageSize golden_size(ImageSize recorded) {
  return recorded.width <= kLargest.width && recorded.height <= kLargest.height ? recorded
                                                                                : size_that_fits(recorded, kLargest);
}

GoldenPictures golden_pictures(const Scenario& scenario, const SourceFactory& sources, const PainterFactory& painters) {
  GoldenPictures result;
  for (const GoldenDefinition& golden : scenario.goldens) {
    result.pictures.push_back({.at = golden.at, .missing = "", .image = {}, .moment = {}, .state_digest = ""});
  }
  const std::vector<std::size_t> order = in_order_of_time(scenario.goldens);
  if (order.empty()) return result;
  std::unique_ptr<Painter> painter;
  try {
    painter = painters(golden_size(scenario.record.size));
  } catch (const PictureFailure& failure) {
    result.no_device = failure.what();
    return result;
  }
  result.driver = painter->driver();
  std::size_t next = 0;
  std::string ending;
  try {
    const std::unique_ptr<MomentSource> source = sources(scenario);
    FrameComposer composer(
        scenario.title, scenario.overlays, scenario.view, scenario.teaching.annotations,
        {golden_size(scenario.record.size), planned_work(scenario.resolved), VideoScript(scenario.teaching).badges()});
    double end = 0;
    GoldenHistory history;
    std::size_t step = 0;
    while (next < order.size()) {
      throw_if_interrupted();
      std::optional<Moment> moment = source->next();
      if (!moment) break;
      end = moment->snapshot.time;
      composer.add(*moment);
      add_step(history, step++, *moment);
      for (; next < order.size() && composer.reaches(result.pictures[order[next]].at); ++next) {
        GoldenPicture& picture = result.pictures[order[next]];
        picture.state_digest = source->state_digest();
        picture.second_state_digest = source->second_state_digest();
        picture.history = history;
        draw(picture, composer, *moment, *painter);
      }
    }
    ending = fmt::format("the scenario ends at {:.4g} s", end);
  } catch (const SimulationFailure& failure) {
    ending = failure.what();
  }
  for (; next < order.size(); ++next) result.pictures[order[next]].missing = ending;
  return result;
}

}  // namespace thinwall
