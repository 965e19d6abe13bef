#include "renderer/shape/LipShape.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "renderer/shape/WallThickness.hpp"
#include "tests/renderer/shape/CutSheets.hpp"

namespace thinwall {
namespace {

constexpr double kGap = 0.0016;  // metres between the lips in the middle

/// A slit in a sheet, 2 mm thick, that lies in z = 0; its lips are drawn apart along y, and wrinkled by `wrinkle`
/// metres.
struct OpenSlit {
  explicit OpenSlit(double wrinkle = 0) : surface(test::slit_sheet(20, 0.001, 0)) {
    borders = border_edges(*surface.topology);
    is_lip = cut_lips(*surface.topology, borders);
    std::vector<double> side(is_lip.size(), 0);
    for (const Triangle& triangle : surface.topology->triangles) {
      for (const std::uint32_t v : triangle) {
        for (const std::uint32_t other : triangle) side[v] += surface.topology->rest_positions[other][1];
      }
    }
    for (std::size_t v = 0; v < is_lip.size(); ++v) {
      const float x = surface.topology->rest_positions[v][0];
      if (!is_lip[v] || std::abs(x) > 0.0075F) continue;
      lips.push_back(v);
      surface.positions[v][1] += static_cast<float>(side[v] > 0 ? 0.5 * kGap : -0.5 * kGap);
      surface.positions[v][2] += static_cast<float>(std::lround(1000 * x) % 2 == 0 ? wrinkle : -wrinkle);
    }
    wall = wall_vertices(surface);
  }
  double side(std::size_t lip) const { return surface.positions[lip][1] > 0 ? 1 : -1; }
  bool is_in_the_middle(std::size_t lip) const { return std::abs(surface.positions[lip][0]) < 0.0045F; }

  SnapshotSurface surface;
  std::vector<BorderEdge> borders;
  std::vector<char> is_lip;
  std::vector<std::size_t> lips;  // without the ends of the cut
  std::vector<SurfaceVertex> wall;
};

TEST(LipShape, LeadsIntoTheWoundAndKnowsTheRoomThere) {
  const OpenSlit slit;
  const LipShape shape = lip_shape(slit.surface, slit.wall, slit.borders);
  ASSERT_GE(slit.lips.size(), 28u);
  for (const std::size_t lip : slit.lips) {
    if (!slit.is_in_the_middle(lip)) continue;
    EXPECT_NEAR(shape.forward[lip].y, -slit.side(lip), 1e-6) << lip;
    EXPECT_NEAR(shape.through[lip].z, -1, 1e-6);
    EXPECT_NEAR(shape.room[lip], 0.5 * kGap, 1e-7);
  }
  for (std::size_t v = 0; v < slit.is_lip.size(); ++v) {
    if (slit.is_lip[v]) continue;
    EXPECT_EQ(shape.room[v], 0);
  }
}

TEST(LipShape, HasNoRoomWhereLipsTouch) {
  const SnapshotSurface closed = test::slit_sheet(20, 0.001, 0);
  const LipShape shape = lip_shape(closed, wall_vertices(closed), border_edges(*closed.topology));
  for (const double room : shape.room) EXPECT_LT(room, 1e-9);
}

TEST(LipShape, GoesEvenlyThroughAWrinkledLip) {
  const OpenSlit slit(0.0004);
  const LipShape shape = lip_shape(slit.surface, slit.wall, slit.borders);
  double most_tilted = 1, most_even = 1;
  for (const std::size_t lip : slit.lips) {
    most_tilted = std::min(most_tilted, double{slit.wall[lip].normal[2]});
    most_even = std::min(most_even, -shape.through[lip].z);
  }
  EXPECT_LT(most_tilted, 0.93) << "the wrinkles tilt the normals";
  EXPECT_GT(most_even, 0.985);
}

TEST(LipShape, BothFacesOfACutAreSeenFromOutsideAndDoNotMeet) {
  const OpenSlit slit;
  const WallDepth depth =
      wall_depth(slit.surface, slit.wall, slit.borders, wall_ways(slit.surface, slit.wall, slit.borders));
  std::size_t seen = 0;
  for (std::size_t i = 0; i < depth.rim.size(); ++i) {
    const BorderEdge& edge = slit.borders[i / 4];
    const std::uint32_t lip = i % 4 < 2 ? edge.start : edge.end;
    if (!slit.is_lip[lip] || !slit.is_in_the_middle(lip) || std::abs(slit.surface.positions[lip][1]) < 1e-4F) continue;
    ++seen;
    EXPECT_GT(depth.rim[i].normal[2], 0.15F);
    EXPECT_GT(slit.side(lip) * depth.lining[lip].position[1], 0.00005) << "on its own side of the wound";
    EXPECT_LT(slit.side(lip) * depth.lining[lip].position[1], 0.45 * kGap);
  }
  EXPECT_GE(seen, 60u);
}

TEST(LipShape, EveningKeepsWhatIsEvenAndLeavesTheRestOfTheWall) {
  const OpenSlit slit;
  const LipShape shape = lip_shape(slit.surface, slit.wall, slit.borders);
  std::vector<double> values(slit.wall.size(), 2);
  for (std::size_t v = 0; v < values.size(); ++v) {
    if (!slit.is_lip[v]) values[v] = 7 + static_cast<double>(v);
  }
  std::vector<double> evened = values;
  even_along_lips(shape, 3, evened);
  EXPECT_EQ(evened, values);
  evened[slit.lips[14]] = 4;
  even_along_lips(shape, 1, evened);
  EXPECT_DOUBLE_EQ(evened[slit.lips[14]], 3);
}

}  // namespace
}  // namespace thinwall
