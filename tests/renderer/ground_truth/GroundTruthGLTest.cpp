#include <gtest/gtest.h>

#include "renderer/ground_truth/GroundTruth.hpp"
#include "renderer/picture/Renderer.hpp"
#include "tests/renderer/picture/TestMeshes.hpp"

namespace thinwall {
namespace {

TEST(GroundTruthGLTest, InstancesCoverThePixelsThatPicturesShowThemAt) {
  constexpr ImageSize kSize = {.width = 320, .height = 180};
  Snapshot snapshot;
  snapshot.surfaces = {test::sphere("organ", {0, 0, 0}, 0.02, 3)};
  snapshot.tools = {{.name = "probe", .kind = SnapshotToolKind::kSphere, .radius = 0.006, .tip = {0, -0.012, 0.016}}};
  for (const CameraKind kind : {CameraKind::kPinhole, CameraKind::kEndoscope}) {
    ViewDefinition view;
    view.camera.kind = kind;
    view.look.floor = false;
    view.look.background = {0, 0, 0};
    const Image image = Renderer({}, kSize, Tier::kDraft).draw(snapshot, view, view.camera);
    const GroundTruth truth = ground_truth(SeenFrame(snapshot, {view.camera}, kSize));
    int differing = 0, seen = 0;
    for (std::size_t pixel = 0; pixel < truth.instances.size(); ++pixel) {
      // Nothing of the scene is quite black.
      const int brightness = image.pixels[3 * pixel] + image.pixels[3 * pixel + 1] + image.pixels[3 * pixel + 2];
      const bool is_something = truth.instances[pixel] != 0;
      seen += is_something;
      differing += (brightness > 12) != is_something;
    }
    EXPECT_GT(seen, 5000);
    // Drivers place corners in steps of 1/256 of a pixel, so that single pixels at silhouettes differ.
    EXPECT_LT(differing, seen / 500);
  }
}

}  // namespace
}  // namespace thinwall
