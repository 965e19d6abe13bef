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

/// Pixels at which a picture shows something and the truth says nothing, or the other way round, over those with
/// something.
double part_that_differs(const Image& image, const GroundTruth& truth) {
  int differing = 0, seen = 0;
  for (std::size_t pixel = 0; pixel < truth.instances.size(); ++pixel) {
    const int brightness = image.pixels[3 * pixel] + image.pixels[3 * pixel + 1] + image.pixels[3 * pixel + 2];
    const bool is_something = truth.instances[pixel] != 0;
    seen += is_something;
    differing += (brightness > 40) != is_something;
  }
  return static_cast<double>(differing) / seen;
}

TEST(GroundTruthGLTest, ALensBendsTheTruthAsItBendsThePicture) {
  constexpr ImageSize kSize = {.width = 640, .height = 360};
  Snapshot snapshot;
  snapshot.surfaces = {test::sphere("left", {-0.05, 0.01, 0}, 0.015, 3),
                       test::sphere("right", {0.05, -0.01, 0}, 0.015, 3)};
  for (const LensDistortion& lens :
       {LensDistortion{.k1 = -0.3, .k2 = 0.1, .p1 = 0.002, .p2 = -0.001}, LensDistortion{.k1 = 0.15, .k3 = 0.02}}) {
    ViewDefinition view;
    view.camera = {
        .position = Double3{0, 0, 0.1}, .target = Double3{0, 0, 0}, .up = Double3{0, 1, 0}, .field_of_view = 0.9};
    view.camera.lens = lens;
    view.look.floor = false;
    view.look.background = {0, 0, 0};
    const Image image = Renderer({}, kSize, Tier::kDraft).draw(snapshot, view, view.camera);
    const GroundTruth truth = ground_truth(SeenFrame(snapshot, {view.camera}, kSize));
    CameraDefinition without = view.camera;
    without.lens = {};
    const GroundTruth straight = ground_truth(SeenFrame(snapshot, {without}, kSize));
    // The lens blends the pixels at an outline with black, which moves it by up to half a pixel: 1.8 and 1.3 % seen.
    EXPECT_LT(part_that_differs(image, truth), 0.03);
    EXPECT_GT(part_that_differs(image, straight), 0.1);
  }
}

}  // namespace
}  // namespace thinwall
