#include "renderer/picture/FallingDrops.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/renderer/picture/CutSheets.hpp"

namespace thinwall {
namespace {

constexpr double kPlenty = 1e-5;  // metres^3

/// A steep sheet, from the lower side of whose slit fluid runs.
struct Leak {
  Leak() : sheet(test::slit_sheet(20, 0.001, 0.8)) {
    const std::vector<BorderEdge> borders = border_edges(*sheet.topology);
    layout = lay_out_wounds(*sheet.topology, borders, cut_lips(*sheet.topology, borders), {0, 0, -1});
  }
  Film drops(double leaked, double time) const { return falling_drops(sheet, layout, {0, 0, -1}, leaked, time); }

  /// Heights of the drops' middles, each of the same number of vertices.
  std::vector<double> heights(double leaked, double time) const {
    constexpr std::size_t kVertices = 9 * 14;
    const Film film = drops(leaked, time);
    EXPECT_EQ(film.vertices.size() % kVertices, 0u);
    std::vector<double> heights;
    for (std::size_t first = 0; first < film.vertices.size(); first += kVertices) {
      double sum = 0;
      for (std::size_t v = first; v < first + kVertices; ++v) sum += film.vertices[v].position[2];
      heights.push_back(sum / kVertices);
    }
    return heights;
  }

  SnapshotSurface sheet;
  WoundLayout layout;
};

TEST(FallingDrops, NeedALeakAndTheTimeToRunDown) {
  const Leak leak;
  ASSERT_FALSE(leak.layout.fluid_runs.empty());
  EXPECT_TRUE(leak.drops(0, 5).corners.empty());
  EXPECT_TRUE(leak.drops(kPlenty, 0.01).corners.empty());
  EXPECT_FALSE(leak.drops(kPlenty, 1).corners.empty());
}

TEST(FallingDrops, FallFreely) {
  const Leak leak;
  // The lowest drop that is there at both times has been there since the first.
  double time = 1;
  while (leak.heights(kPlenty, time).size() != leak.heights(kPlenty, time + 0.02).size()) time += 0.005;
  const std::vector<double> before = leak.heights(kPlenty, time), middle = leak.heights(kPlenty, time + 0.01),
                            after = leak.heights(kPlenty, time + 0.02);
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    // The mean of a drop's vertices lies in its middle to what single precision keeps of 0.1 m.
    EXPECT_NEAR(before[i] - 2 * middle[i] + after[i], -9.81 * 0.01 * 0.01, 2e-7);
  }
}

TEST(FallingDrops, AreNoMoreThanWhatHasLeaked) {
  const Leak leak;
  const double drop = 4.0 / 3 * 3.14159265 * std::pow(0.0013, 3);
  // Enough for the ways down and for three drops of each run, all of which have long fallen.
  const double leaked = static_cast<double>(leak.layout.fluid_runs.size()) * (3 * drop + 0.045 * 2 * 0.0026 * 0.0006);
  EXPECT_TRUE(leak.drops(leaked, 30).corners.empty());
  EXPECT_FALSE(leak.drops(1, 30).corners.empty());
}

TEST(FallingDrops, AreAFunctionOfTheMomentAlone) {
  const Leak leak;
  const std::vector<double> alone = leak.heights(kPlenty, 2);
  leak.heights(kPlenty, 1);
  EXPECT_EQ(leak.heights(kPlenty, 2), alone);
}

}  // namespace
}  // namespace thinwall
