#include "studio/recorder/Painter.hpp"

#include "renderer/picture/Renderer.hpp"

namespace thinwall {
namespace {

class RendererPainter final : public Painter {
 public:
  RendererPainter(const DeviceChoice& device, ImageSize size, Tier tier, ViewDefinition view)
      : renderer_(device, size, tier), view_(std::move(view)) {}
  Image paint(const Snapshot& snapshot) override { return renderer_.draw(snapshot, view_); }
  std::string driver() const override { return renderer_.driver(); }

 private:
  Renderer renderer_;
  ViewDefinition view_;
};

}  // namespace

PainterFactory renderer_painters(const DeviceChoice& device, Tier tier, const ViewDefinition& view) {
  return [=](ImageSize size) { return std::make_unique<RendererPainter>(device, size, tier, view); };
}

}  // namespace thinwall
