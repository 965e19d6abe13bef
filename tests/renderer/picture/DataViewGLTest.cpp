#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "renderer/camera/Camera.hpp"
#include "renderer/look/ColorMap.hpp"
#include "renderer/picture/Renderer.hpp"
#include "tests/renderer/shape/TestMeshes.hpp"

namespace thinwall {
namespace {

constexpr ImageSize kDataSize = {.width = 160, .height = 90};

/// A square of 2 m that faces the camera, with a pressure that runs from 0 to 400 Pa along x.
Snapshot square() {
  Snapshot snapshot;
  snapshot.surfaces = {test::quad("wall", {{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}})};
  snapshot.surfaces[0].fields = {
      {.name = "contact_pressure", .unit = "Pa", .location = FieldLocation::kVertex, .values = {0, 400, 400, 0}}};
  return snapshot;
}

ViewDefinition facing() {
  ViewDefinition view;
  view.camera.position = Double3{0, 0, 5};
  view.camera.target = Double3{0, 0, 0};
  view.camera.up = Double3{0, 1, 0};
  view.look.data = DataView{.quantity = DataQuantity::kContactPressure, .from = 100, .to = 300};
  return view;
}

/// Checks that the square has the colour of its pressure in each pixel of the middle row.
void expect_colors_of_the_legend(Tier tier, DataScale scale) {
  ViewDefinition view = facing();
  view.look.data->scale = scale;
  const Image image = Renderer({}, kDataSize, tier).draw(square(), view, view.camera);
  const double metres_per_pixel = 2 * 5 * std::tan(0.5 * view.camera.field_of_view) / kDataSize.height;
  int largest = 0, checked = 0;
  for (int column = 0; column < kDataSize.width; ++column) {
    const double x = (column + 0.5 - 0.5 * kDataSize.width) * metres_per_pixel;
    // The outermost pixels are smoothed.
    if (std::abs(x) > 1 - 2 * metres_per_pixel) continue;
    const double pressure = 200 * (x + 1);
    const double number = (pressure - 100) / 200;
    // Where a root begins, with an infinite slope, a pixel of several samples has not the colour of its middle.
    if (std::abs(number) < 0.5 * metres_per_pixel) continue;
    const Double3 color = color_map(color_place(number, scale));
    const std::size_t pixel = static_cast<std::size_t>(45 * kDataSize.width + column);
    for (std::size_t k = 0; k < 3; ++k) {
      const int level = static_cast<int>(std::lround(255 * color[k]));
      largest = std::max(largest, std::abs(level - image.pixels[3 * pixel + k]));
    }
    ++checked;
  }
  EXPECT_GT(checked, 30);
  EXPECT_LE(largest, 1);
}

TEST(DataViewGLTest, AKnownFieldHasTheColorsOfTheLegendToOneLevel) {
  for (const Tier tier : {Tier::kDraft, Tier::kRecord, Tier::kFinal}) {
    for (const DataScale scale : {DataScale::kLinear, DataScale::kRoot}) {
      SCOPED_TRACE(scale == DataScale::kRoot ? "root" : "linear");
      expect_colors_of_the_legend(tier, scale);
    }
  }
}

/// The largest difference of two channels of the pixels in which two pictures differ, 8-bit levels, and how many these
/// are.
std::pair<int, int> colors_of_the_difference(const Image& image, const Image& other) {
  int largest = 0, count = 0;
  for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
    const auto begin = image.pixels.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::equal(begin, begin + 3, other.pixels.begin() + static_cast<std::ptrdiff_t>(i))) continue;
    const auto [least, most] = std::minmax({begin[0], begin[1], begin[2]});
    largest = std::max(largest, most - least);
    ++count;
  }
  return {largest, count};
}

TEST(DataViewGLTest, ToolsAreGreyBesideTheColorsOfNumbersAndOnlyThere) {
  Snapshot with_tool = square();
  with_tool.tools = {{.name = "probe", .kind = SnapshotToolKind::kSphere, .radius = 0.3, .tip = {0.2, 0.1, 0.1}}};
  ViewDefinition view = facing();
  view.look.floor = false;
  Renderer renderer({}, kDataSize, Tier::kDraft);
  for (const double endoscope : {0.0, 1.0}) {
    view.lights.endoscope = endoscope;
    view.look.data = facing().look.data;
    const auto in_data = colors_of_the_difference(renderer.draw(with_tool, view, view.camera),
                                                  renderer.draw(square(), view, view.camera));
    EXPECT_LE(in_data.first, 1) << endoscope;
    EXPECT_GT(in_data.second, 100) << endoscope;
    view.look.data.reset();
    const auto in_nature = colors_of_the_difference(renderer.draw(with_tool, view, view.camera),
                                                    renderer.draw(square(), view, view.camera));
    EXPECT_GT(in_nature.first, 20) << endoscope;
  }
}

TEST(DataViewGLTest, TheMeshDarkensItsEdgesAndNothingElse) {
  ViewDefinition view = facing();
  Renderer renderer({}, kDataSize, Tier::kRecord);
  const Image without = renderer.draw(square(), view, view.camera);
  view.look.mesh = true;
  const Image with = renderer.draw(square(), view, view.camera);
  // The diagonal of the square crosses the middle of the picture from below to above on the right.
  const auto green = [](const Image& image, int column, int row) {
    return static_cast<int>(image.pixels[3 * static_cast<std::size_t>(row * kDataSize.width + column) + 1]);
  };
  EXPECT_LT(green(with, 80, 45) + green(with, 80, 44), green(without, 80, 45) + green(without, 80, 44));
  EXPECT_EQ(green(with, 86, 55), green(without, 86, 55));
  EXPECT_EQ(green(with, 74, 33), green(without, 74, 33));
}

/// The same as scenery.
SnapshotSurface scenery_of(SnapshotSurface surface) {
  auto topology = std::make_shared<SnapshotTopology>(*surface.topology);
  topology->is_scenery = true;
  surface.topology = std::move(topology);
  return surface;
}

TEST(DataViewGLTest, SceneryOfWhichNothingIsComputedIsGreyBesideBodiesThatAct) {
  Renderer renderer({}, kDataSize, Tier::kRecord);
  const ViewDefinition view = facing();
  Snapshot alone, behind = square();
  alone.surfaces = {scenery_of(square().surfaces[0])};
  behind.surfaces.push_back(alone.surfaces[0]);
  for (Float3& corner : behind.surfaces[1].positions) corner = {3 * corner[0], corner[1], -0.5F};
  const auto saturation = [](const Image& image, int column) {
    const auto first = image.pixels.begin() + 3 * (45 * kDataSize.width + column);
    const auto [least, most] = std::minmax({first[0], first[1], first[2]});
    return most - least;
  };
  const Image both = renderer.draw(behind, view, view.camera);
  EXPECT_LE(saturation(both, 20), 1) << "left of the square";
  EXPECT_GT(saturation(both, 75), 50);
  EXPECT_GT(saturation(renderer.draw(alone, view, view.camera), 75), 50) << "where there is nothing else";
}

/// The square, cut along the diagonal that crosses its middle; its lips lie together.
Snapshot cut_square() {
  const std::vector<Float3> corners = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  Snapshot snapshot;
  snapshot.surfaces = {test::surface_of("wall", corners, {{0, 1, 2}, {3, 4, 5}})};
  auto topology = std::make_shared<SnapshotTopology>(*snapshot.surfaces[0].topology);
  topology->cut_times = {0, kNeverCut, 0, 0, 0, kNeverCut};
  snapshot.surfaces[0].topology = std::move(topology);
  snapshot.surfaces[0].fields = {{.name = "contact_pressure",
                                  .unit = "Pa",
                                  .location = FieldLocation::kVertex,
                                  .values = {0, 400, 400, 0, 400, 0}}};
  return snapshot;
}

TEST(DataViewGLTest, ACutIsSeenThoughItsLipsHaveTheNumbersBesideIt) {
  for (const ImageSize size : {kDataSize, ImageSize{.width = 960, .height = 540}}) {
    const ViewDefinition view = facing();
    Renderer renderer({}, size, Tier::kRecord);
    const Image whole = renderer.draw(square(), view, view.camera);
    const Image cut = renderer.draw(cut_square(), view, view.camera);
    const auto largest_difference = [&](double x, double y) {
      const double pixels = 0.5 * size.height / (5 * std::tan(0.5 * view.camera.field_of_view));
      const int column = static_cast<int>(0.5 * size.width + x * pixels);
      const int row = static_cast<int>(0.5 * size.height - y * pixels);
      const std::size_t first = 3 * static_cast<std::size_t>(row * size.width + column);
      int largest = 0;
      for (std::size_t k = first; k < first + 3; ++k) {
        largest = std::max(largest, std::abs(whole.pixels[k] - cut.pixels[k]));
      }
      return largest;
    };
    for (const double along : {-0.5, 0.01, 0.5}) EXPECT_GT(largest_difference(along, along), 60) << size.height;
    EXPECT_EQ(largest_difference(0.5, -0.5), 0) << size.height;
    EXPECT_EQ(largest_difference(-0.5, 0.5), 0) << size.height;
  }
}

}  // namespace
}  // namespace thinwall
