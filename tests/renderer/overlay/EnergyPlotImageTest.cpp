#include "renderer/overlay/EnergyPlotImage.hpp"

#include <gtest/gtest.h>

namespace thinwall {
namespace {

/// A tool that stores half of its work and rubs the rest away.
std::vector<EnergyPoint> some_energies(double joules) {
  std::vector<EnergyPoint> points;
  for (int i = 0; i <= 100; ++i) {
    const double work = joules * i / 100;
    points.push_back({.time = i * 0.01,
                      .stored = joules + 0.5 * work,
                      .friction = 0.5 * work,
                      .tool_work = work,
                      .script_work = joules});
  }
  return points;
}

/// Pixels of the part of the page right of `left` that are darker than a grid line in any channel.
int drawn_pixels(const Image& image, int left, int right) {
  int count = 0;
  for (int y = image.size.height / 4; y < image.size.height * 9 / 10; ++y) {
    for (int x = left; x < right; ++x) {
      const std::uint8_t* pixel = &image.pixels[3 * static_cast<std::size_t>(y * image.size.width + x)];
      count += pixel[0] < 150 || pixel[1] < 150 || pixel[2] < 150;
    }
  }
  return count;
}

TEST(EnergyPlotImage, SameRecordGivesTheSameBytes) {
  EXPECT_EQ(energy_plot_image("Title", some_energies(1e-3), {}).pixels,
            energy_plot_image("Title", some_energies(1e-3), {}).pixels);
}

TEST(EnergyPlotImage, IsTheSameWithAnotherUnitOfEnergy) {
  EXPECT_EQ(drawn_pixels(energy_plot_image("Title", some_energies(2e-3), {}), 100, 990),
            drawn_pixels(energy_plot_image("Title", some_energies(2e-6), {}), 100, 990));
}

TEST(EnergyPlotImage, DrawsTermsOverZeroAndLeavesOutThoseThatNeverCount) {
  const Image empty = energy_plot_image("Title", {}, {});
  std::vector<EnergyPoint> points = some_energies(1e-3);
  const Image image = energy_plot_image("Title", points, {});
  EXPECT_GT(drawn_pixels(image, 100, 990), drawn_pixels(empty, 100, 990) + 1500);
  for (EnergyPoint& point : points) point.leak = 1e-12 * point.time;
  EXPECT_EQ(energy_plot_image("Title", points, {}).pixels, image.pixels);
  for (EnergyPoint& point : points) point.leak *= 1e8;
  EXPECT_NE(energy_plot_image("Title", points, {}).pixels, image.pixels);
}

TEST(EnergyPlotImage, BooksThatDoNotCloseShow) {
  std::vector<EnergyPoint> points = some_energies(1e-3);
  const Image image = energy_plot_image("Title", points, {});
  for (EnergyPoint& point : points) point.friction *= 1.05;
  EXPECT_GT(points.back().imbalance(), 0.02e-3);
  EXPECT_NE(energy_plot_image("Title", points, {}).pixels, image.pixels);
}

TEST(EnergyPlotImage, ShowsThePhasesOfEachTool) {
  const auto phases = [](const std::string& tool, const std::string& later) {
    return ToolForces{.tool = tool,
                      .points = {{.time = 0, .force = {}, .depth = 0, .phase = "approach"},
                                 {.time = 0.5, .force = {}, .depth = 0, .phase = later},
                                 {.time = 1, .force = {}, .depth = 0, .phase = later}}};
  };
  const auto page = [&](const std::vector<ToolForces>& tools) {
    return energy_plot_image("Title", some_energies(1e-3), tools).pixels;
  };
  EXPECT_NE(page({phases("probe", "contact"), phases("blade", "cutting")}),
            page({phases("probe", "contact"), phases("blade", "contact")}));
  EXPECT_NE(page({phases("probe", "contact"), phases("blade", "cutting")}),
            page({phases("probe", "contact"), phases("knife", "cutting")}))
      << "several are told apart by their names";
  EXPECT_EQ(page({phases("probe", "contact")}), page({phases("finger", "contact")}));
}

TEST(EnergyPlotImage, TakesABodyThatNothingHappensTo) {
  EXPECT_EQ(energy_plot_image("Title", {EnergyPoint{}}, {ToolForces{}}, {800, 450}).size, (ImageSize{800, 450}));
}

}  // namespace
}  // namespace thinwall
