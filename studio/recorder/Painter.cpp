#include "studio/recorder/Painter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <vector>

#include "renderer/annotation/AnnotationDrawing.hpp"
#include "renderer/camera/PictureLayout.hpp"
#include "renderer/overlay/HalfCaptions.hpp"
#include "renderer/overlay/Overlay.hpp"
#include "renderer/picture/Renderer.hpp"

namespace thinwall {
namespace {

class RendererPainter final : public Painter {
 public:
  RendererPainter(const DeviceChoice& device, ImageSize size, Tier tier, ViewDefinition view, bool is_timed)
      : device_(device), size_(size), tier_(tier), view_(std::move(view)), is_timed_(is_timed) {
    renderer_of(size_);
  }

  Image paint(const Snapshot& snapshot, const Shot& shot) override {
    const PictureBox own = main_box(shot, size_);
    picture_.clear();
    Image image = draw(own.size, snapshot, view_, shot.camera);
    if (shot.beside) {
      const PictureBox box = beside_box(size_);
      Image both{.size = size_, .pixels = std::vector<std::uint8_t>(3 * pixel_count(size_))};
      paste(image, own, both);
      const Snapshot& seen = shot.beside_snapshot ? *shot.beside_snapshot : snapshot;
      paste(draw(box.size, seen, shot.beside_view ? *shot.beside_view : view_, *shot.beside), box, both);
      image = std::move(both);
    }
    if (shot.inset) {
      const PictureBox box = inset_box(shot, size_);
      paste(draw(box.size, snapshot, view_, *shot.inset), box, image);
      frame_box(box, image);
    }
    for (const PassTime& time : picture_) times_[time.pass].push_back(time);
    return image;
  }

  std::vector<PassTime> pass_times() override {
    if (times_.empty()) return {};
    std::vector<PassTime> medians;
    for (const std::string& pass : order_) medians.push_back(median_of(times_.at(pass)));
    std::vector<PassTime> passes;
    renderer_of(size_).draw_timed({}, view_, passes);
    PassTime empty{.pass = "an empty frame"};
    for (const PassTime& time : passes) {
      empty.wall_seconds += time.wall_seconds;
      empty.processor_seconds += time.processor_seconds;
    }
    medians.push_back(empty);
    return medians;
  }

  std::string driver() const override { return renderers_.at({size_.width, size_.height}).driver(); }

 private:
  static std::size_t pixel_count(ImageSize size) {
    return static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  }

  Image draw(ImageSize size, const Snapshot& snapshot, const ViewDefinition& view, const CameraDefinition& camera) {
    if (!is_timed_) return renderer_of(size).draw(snapshot, view, camera);
    // A renderer's first picture makes the driver compile its shaders.
    const bool is_new = !renderers_.contains({size.width, size.height});
    if (is_new) renderer_of(size).draw(snapshot, view, camera);
    std::vector<PassTime> times;
    Image image = renderer_of(size).draw_timed(snapshot, view, camera, times);
    for (const PassTime& time : times) {
      if (std::ranges::find(order_, time.pass) == order_.end()) order_.push_back(time.pass);
      const auto found = std::ranges::find(picture_, time.pass, &PassTime::pass);
      PassTime& sum = found == picture_.end() ? picture_.emplace_back(PassTime{.pass = time.pass}) : *found;
      sum.wall_seconds += time.wall_seconds;
      sum.processor_seconds += time.processor_seconds;
    }
    return image;
  }

  /// In a median neither the pictures count in which the driver still compiles nor those that another load held up.
  static PassTime median_of(std::vector<PassTime> times) {
    PassTime median = times.front();
    const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
    for (double PassTime::*seconds : {&PassTime::wall_seconds, &PassTime::processor_seconds}) {
      std::ranges::nth_element(times, middle, {}, seconds);
      median.*seconds = (*middle).*seconds;
    }
    return median;
  }

  /// A renderer draws one size.
  Renderer& renderer_of(ImageSize size) {
    return renderers_.try_emplace({size.width, size.height}, device_, size, tier_).first->second;
  }

  DeviceChoice device_;
  ImageSize size_;
  Tier tier_;
  ViewDefinition view_;
  bool is_timed_;
  std::vector<PassTime> picture_;                       // of the picture that is painted, all its cameras together
  std::map<std::string, std::vector<PassTime>> times_;  // by pass, of the pictures that have it
  std::vector<std::string> order_;                      // of the passes
  std::map<std::pair<int, int>, Renderer> renderers_;   // by width and height
};

Box canvas_box(const PictureBox& box) {
  return {static_cast<double>(box.left), static_cast<double>(box.top), static_cast<double>(box.size.width),
          static_cast<double>(box.size.height)};
}

/// Of a picture or of each of its halves.
std::vector<AnnotationLayers> annotations_of(const Frame& frame, ImageSize size, const std::optional<PictureBox>& inset,
                                             const std::optional<Box>& taken) {
  std::vector<AnnotationLayers> annotations;
  if (!frame.annotations || frame.annotations->is_empty()) return annotations;
  std::vector<Box> kept_clear = half_caption_places(size, frame.overlay.half_captions, taken);
  for (const Box& legend : places_of_legends(frame.overlay, size, taken)) kept_clear.push_back(legend);
  annotations.emplace_back(size, main_box(frame.shot, size), *frame.annotations, frame.snapshot, frame.shot.camera,
                           inset, kept_clear);
  if (frame.shot.beside_snapshot) {
    annotations.emplace_back(size, beside_box(size), *frame.annotations, *frame.shot.beside_snapshot,
                             *frame.shot.beside, inset, kept_clear);
  }
  return annotations;
}

}  // namespace

Image finished_picture(const Frame& frame, Painter& painter) {
  Image image = painter.paint(frame.snapshot, frame.shot);
  const Image bare = frame.card ? image : Image{};
  std::optional<PictureBox> inset;
  if (frame.shot.inset) inset = inset_box(frame.shot, image.size);
  std::optional<Box> taken;
  if (inset) taken = canvas_box(*inset);
  const std::vector<AnnotationLayers> annotations = annotations_of(frame, image.size, inset, taken);
  // Digits and letters are read over the lines of labels; under plates nobody would see which point is meant.
  for (const AnnotationLayers& layers : annotations) layers.lay_lines(image);
  if (!frame.overlay.half_captions[0].empty()) draw_half_captions(image, frame.overlay.half_captions, taken);
  for (const std::string& text : draw_overlay(image, frame.overlay, taken)) painter.see_cut_text(text);
  for (const AnnotationLayers& layers : annotations) layers.lay_points(image);
  if (frame.card) draw_card(image, bare, *frame.card);
  return image;
}

PainterFactory renderer_painters(const DeviceChoice& device, Tier tier, const ViewDefinition& view, bool is_timed) {
  return [=](ImageSize size) { return std::make_unique<RendererPainter>(device, size, tier, view, is_timed); };
}

std::string pass_table(const std::vector<PassTime>& times) {
  std::string table;
  PassTime all{.pass = "all passes"};
  const auto line = [](const PassTime& time) {
    return fmt::format("{:>18} {:9.3f} ms, {:9.3f} ms of processors\n", time.pass, 1e3 * time.wall_seconds,
                       1e3 * time.processor_seconds);
  };
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (i + 1 == times.size()) table += line(all);
    table += line(times[i]);
    all.wall_seconds += times[i].wall_seconds;
    all.processor_seconds += times[i].processor_seconds;
  }
  return table;
}

}  // namespace thinwall
