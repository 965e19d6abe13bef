#include "studio/recorder/Painter.hpp"

#include <map>

#include "renderer/annotation/AnnotationDrawing.hpp"
#include "renderer/overlay/Overlay.hpp"
#include "renderer/picture/PictureLayout.hpp"
#include "renderer/picture/Renderer.hpp"

namespace thinwall {
namespace {

class RendererPainter final : public Painter {
 public:
  RendererPainter(const DeviceChoice& device, ImageSize size, Tier tier, ViewDefinition view)
      : device_(device), size_(size), tier_(tier), view_(std::move(view)) {
    renderer_of(size_);
  }

  Image paint(const Snapshot& snapshot, const Shot& shot) override {
    const PictureBox own = main_box(shot, size_);
    Image image = renderer_of(own.size).draw(snapshot, view_, shot.camera);
    if (shot.beside) {
      const PictureBox box = beside_box(size_);
      Image both{.size = size_, .pixels = std::vector<std::uint8_t>(3 * pixel_count(size_))};
      paste(image, own, both);
      paste(renderer_of(box.size).draw(snapshot, view_, *shot.beside), box, both);
      image = std::move(both);
    }
    if (shot.inset) {
      const PictureBox box = inset_box(shot.corner, size_);
      paste(renderer_of(box.size).draw(snapshot, view_, *shot.inset), box, image);
      frame_box(box, image);
    }
    return image;
  }

  std::string driver() const override { return renderers_.at({size_.width, size_.height}).driver(); }

 private:
  static std::size_t pixel_count(ImageSize size) {
    return static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  }

  /// A renderer draws one size.
  Renderer& renderer_of(ImageSize size) {
    return renderers_.try_emplace({size.width, size.height}, device_, size, tier_).first->second;
  }

  DeviceChoice device_;
  ImageSize size_;
  Tier tier_;
  ViewDefinition view_;
  std::map<std::pair<int, int>, Renderer> renderers_;  // by width and height
};

}  // namespace

Image finished_picture(const Frame& frame, Painter& painter) {
  Image image = painter.paint(frame.snapshot, frame.shot);
  if (frame.annotations) {
    draw_annotations(image, main_box(frame.shot, image.size), *frame.annotations, frame.snapshot, frame.shot.camera);
  }
  draw_overlay(image, frame.overlay);
  if (!frame.badge.empty()) draw_badge(image, frame.badge);
  if (frame.card) draw_card(image, *frame.card);
  return image;
}

PainterFactory renderer_painters(const DeviceChoice& device, Tier tier, const ViewDefinition& view) {
  return [=](ImageSize size) { return std::make_unique<RendererPainter>(device, size, tier, view); };
}

}  // namespace thinwall
