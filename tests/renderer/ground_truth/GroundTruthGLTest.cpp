#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "renderer/ground_truth/GroundTruth.hpp"
#include "renderer/image/ImageDifference.hpp"
#include "renderer/picture/Renderer.hpp"
#include "renderer/shape/WoundBed.hpp"
#include "tests/renderer/shape/CutSheets.hpp"

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
    view.look.flat_triangles = true;
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

/// A slit sheet whose lips are pulled apart into a lens of 6 mm with large triangles: its edges leave the curves by
/// several pixels.
Snapshot gaping_sheet() {
  SnapshotSurface sheet = test::slit_sheet(10, 0.002, 0);
  for (std::size_t v = 0; v < sheet.positions.size(); ++v) {
    const double x = sheet.topology->rest_positions[v][0], y = sheet.topology->rest_positions[v][1];
    const double side = v >= 121 || y > 0 ? 1 : -1;
    const double gap = 0.003 * std::max(0.0, 1 - x * x / 0.000064) * (1 - std::abs(y) / 0.01);
    sheet.positions[v][1] += static_cast<float>(side * gap);
  }
  Snapshot snapshot;
  snapshot.surfaces = {sheet};
  return snapshot;
}

/// Pixels at which the tissue of the picture and that of the truth differ: tissue has the same colour on any ground.
int tissue_that_differs(const Snapshot& snapshot, ViewDefinition view, DrawnEdges edges) {
  constexpr ImageSize kSize = {.width = 640, .height = 360};
  Renderer renderer({}, kSize, Tier::kDraft);
  view.look.floor = false;
  view.look.background = {0.1, 0.1, 0.1};
  const Image dark = renderer.draw(snapshot, view, view.camera);
  view.look.background = {0.9, 0.9, 0.9};
  const Image light = renderer.draw(snapshot, view, view.camera);
  const GroundTruth truth = ground_truth(SeenFrame(snapshot, {view.camera}, kSize, edges));
  int differing = 0;
  for (std::size_t pixel = 0; pixel < truth.instances.size(); ++pixel) {
    const bool is_tissue = light.pixels[3 * pixel] - dark.pixels[3 * pixel] < 100;
    differing += is_tissue != (truth.instances[pixel] != 0);
  }
  return differing;
}

TEST(GroundTruthGLTest, LipsOfWoundsLieWhereThePictureHasThem) {
  const Snapshot snapshot = gaping_sheet();
  ViewDefinition view;
  view.camera = {.position = Double3{0, 0, 0.03}, .target = Double3{0, 0, 0}, .up = Double3{0, 1, 0}};
  TissueLook look;
  look.bleeding = look.bed = look.contents.clarity = 0;
  view.look.bodies["organ"] = look;
  // Drivers place corners in steps of 1/256 of a pixel.
  EXPECT_LE(tissue_that_differs(snapshot, view, DrawnEdges::kCurves), 3);
  EXPECT_GT(tissue_that_differs(snapshot, view, DrawnEdges::kStraight), 50);
  view.look.mesh = true;
  EXPECT_EQ(drawn_edges(view.look), DrawnEdges::kStraight);
  EXPECT_LE(tissue_that_differs(snapshot, view, drawn_edges(view.look)), 3);
}

TEST(GroundTruthGLTest, APieceThatWasCutFreeIsWhereThePictureLaysIt) {
  Snapshot snapshot;
  SnapshotSurface& sheet = snapshot.surfaces.emplace_back(test::patched_sheet(40, 0.001, 8));
  for (std::size_t v = sheet.positions.size() - 81; v < sheet.positions.size(); ++v) sheet.positions[v][2] = -0.2F;
  ViewDefinition view;
  view.camera = {.position = Double3{0.02, 0, 0.05}, .target = Double3{0, 0, 0}, .up = Double3{0, 1, 0}};
  view.look.floor = false;
  view.look.bodies["organ"].bed = 0.004;
  constexpr ImageSize kSize = {.width = 160, .height = 90};
  Renderer renderer({}, kSize, Tier::kDraft);
  for (const auto& [flat, mesh] : {std::pair{false, false}, {true, false}, {false, true}}) {
    view.look.flat_triangles = flat;
    view.look.mesh = mesh;
    const Snapshot laid = laid_on_beds(snapshot, view.look);
    EXPECT_NEAR(laid.surfaces[0].positions.back()[2], -0.004, 1e-7);
    const Image shown = renderer.draw(snapshot, view, view.camera), told = renderer.draw(laid, view, view.camera);
    EXPECT_EQ(compare_images(shown, told).failing, 0) << describe(compare_images(shown, told));
  }
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
