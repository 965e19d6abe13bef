#include "renderer/overlay/ForcePlotImage.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace thinwall {
namespace {

ToolForces some_tool(const std::string& name) {
  ToolForces tool{.tool = name, .points = {}};
  for (int i = 0; i < 200; ++i) {
    const double force = 0.3 * std::sin(i * 0.0157);
    tool.points.push_back(
        {i * 0.01, {0.1 * force, -0.2 * force, force}, 0.004 * i / 200, i < 50 ? "approach" : "hold"});
  }
  return tool;
}

int dark_pixels(const Image& image, int left, int right) {
  int count = 0;
  for (int y = image.size.height / 5; y < image.size.height; ++y) {
    for (int x = left; x < right; ++x) {
      count += image.pixels[3 * static_cast<std::size_t>(y * image.size.width + x) + 1] < 120;
    }
  }
  return count;
}

TEST(ForcePlotImage, SameRecordGivesTheSameBytes) {
  EXPECT_EQ(force_plot_image("Title", {some_tool("probe")}).pixels,
            force_plot_image("Title", {some_tool("probe")}).pixels);
}

TEST(ForcePlotImage, BothChartsHaveCurvesOnWhite) {
  const Image image = force_plot_image("Title", {some_tool("probe")});
  const Image empty = force_plot_image("Title", {});
  EXPECT_EQ(image.size, (ImageSize{1600, 900}));
  EXPECT_EQ(image.pixels.front(), 255);
  EXPECT_GT(dark_pixels(image, 100, 1000), dark_pixels(empty, 100, 1000) + 1000);
  EXPECT_GT(dark_pixels(image, 1100, 1550), dark_pixels(empty, 1100, 1550) + 500);
}

TEST(ForcePlotImage, SeveralToolsAreTakenAndAnotherSize) {
  const Image image = force_plot_image("Title", {some_tool("one"), some_tool("two"), some_tool("three")}, {800, 450});
  EXPECT_EQ(image.size, (ImageSize{800, 450}));
}

TEST(ForcePlotImage, RecordsWithoutForceOrWithOnePointAreTaken) {
  ToolForces tool{.tool = "probe", .points = {ForcePoint{}}};
  EXPECT_GT(dark_pixels(force_plot_image("Title", {tool}), 0, 1600), 100);
  EXPECT_GT(dark_pixels(force_plot_image("Title", {ToolForces{}}), 0, 1600), 100);
}

}  // namespace
}  // namespace thinwall
