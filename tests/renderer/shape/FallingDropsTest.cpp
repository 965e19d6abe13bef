#include "renderer/shape/FallingDrops.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/renderer/shape/CutSheets.hpp"

namespace thinwall {
namespace {

constexpr double kPlenty = 1e-5;  // metres^3

/// A steep sheet, from the lower side of whose slit fluid runs.
struct Leak {
  Leak() : sheet(test::slit_sheet(20, 0.001, 0.8)) {
    const std::vector<BorderEdge> borders = border_edges(*sheet.topology);
    layout = lay_out_wounds(*sheet.topology, borders, cut_lips(*sheet.topology, borders), {0, 0, -1});
  }
  Film drops(double leaked, double time) const { return falling_drops(sheet, layout, gravity, leaked, time); }

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
  Vector3 gravity{0, 0, -9.81};
};

TEST(FallingDrops, NeedALeakAndTheTimeToRunDown) {
  const Leak leak;
  ASSERT_FALSE(leak.layout.fluid_runs.empty());
  EXPECT_TRUE(leak.drops(0, 5).corners.empty());
  EXPECT_TRUE(leak.drops(kPlenty, 0.01).corners.empty());
  EXPECT_FALSE(leak.drops(kPlenty, 1).corners.empty());
}

TEST(FallingDrops, FallFreelyWithTheGravityThereIs) {
  for (const double strength : {9.81, 1.62}) {
    Leak leak;
    leak.gravity = {0, 0, -strength};
    // At a moment when none comes or goes: no place in the list then holds a higher drop than before.
    double time = 1;
    std::vector<double> before, middle, after;
    const auto are_the_same = [](const std::vector<double>& earlier, const std::vector<double>& later) {
      return earlier.size() == later.size() &&
             std::equal(later.begin(), later.end(), earlier.begin(), [](double a, double b) { return a < b; });
    };
    do {
      time += 0.005;
      before = leak.heights(kPlenty, time);
      middle = leak.heights(kPlenty, time + 0.01);
      after = leak.heights(kPlenty, time + 0.02);
    } while (time < 2 && !(are_the_same(before, middle) && are_the_same(middle, after)));
    ASSERT_EQ(before.size(), after.size());
    ASSERT_FALSE(before.empty());
    for (std::size_t i = 0; i < before.size(); ++i) {
      // The mean of a drop's vertices lies in its middle to what single precision keeps of 0.1 m.
      EXPECT_NEAR(before[i] - 2 * middle[i] + after[i], -strength * 0.01 * 0.01, 2e-7);
    }
  }
}

TEST(FallingDrops, FallAlongTheSnapshotsGravityAndDownwardsOnEarthWithoutOne) {
  Snapshot snapshot;
  snapshot.gravity = {0, 3, -4};
  EXPECT_EQ(gravity_of_drops(snapshot).y, 3);
  EXPECT_EQ(gravity_of_drops(snapshot).z, -4);
  snapshot.gravity = {};
  EXPECT_EQ(gravity_of_drops(snapshot).y, 0);
  EXPECT_NEAR(gravity_of_drops(snapshot).z, -9.81, 1e-12);
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
