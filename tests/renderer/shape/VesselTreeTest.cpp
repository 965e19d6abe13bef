#include "renderer/shape/VesselTree.hpp"

#include <gtest/gtest.h>

#include "tests/renderer/shape/TestMeshes.hpp"

namespace thinwall {
namespace {

/// A pear along `axis`, slender towards its negative end.
SnapshotSurface pear(std::size_t axis, double sense) {
  SnapshotSurface surface = test::sphere("organ", {}, 0.02, 4);
  auto topology = std::make_shared<SnapshotTopology>(*surface.topology);
  for (Float3& place : topology->rest_positions) {
    const double along = place[2] / 0.02;
    const double width = along < 0 ? 1 + 0.7 * along : 1;
    const Float3 upright = {static_cast<float>(width * place[0]), static_cast<float>(width * place[1]),
                            static_cast<float>(sense * 2.5 * place[2])};
    for (std::size_t k = 0; k < 3; ++k) place[(axis + 1 + k) % 3] = upright[k];
  }
  surface.topology = topology;
  return surface;
}

TEST(VesselTree, RunsFromTheSlenderEndOfABodyToItsFullOne) {
  for (const std::size_t axis : {0U, 1U, 2U}) {
    for (const double sense : {1.0, -1.0}) {
      const VesselTree tree = vessel_tree(*pear(axis, sense).topology);
      const std::array<double, 3> along = {tree.along.x, tree.along.y, tree.along.z};
      EXPECT_NEAR(along[axis], sense, 1e-3);
      EXPECT_NEAR(length(tree.across), 1, 1e-12);
      EXPECT_NEAR(dot(tree.along, tree.across), 0, 1e-12);
      EXPECT_NEAR(tree.half_length, 0.05, 0.012);
    }
  }
}

TEST(VesselTree, OfABallStaysWhereItIsWhenTheBallTurns) {
  const VesselTree tree = vessel_tree(*test::sphere("organ", {0.1, 0.2, 0.3}, 0.02, 4).topology);
  EXPECT_NEAR(length(tree.middle - Vector3{0.1, 0.2, 0.3}), 0, 1e-6);
  EXPECT_EQ(tree.along.x, 1);
  EXPECT_NEAR(tree.radius, 0.02 * std::sqrt(2.0 / 3), 1e-4);
}

TEST(VesselTree, DoesNotMoveWhereATriangleIsCutIntoParts) {
  const SnapshotSurface whole = pear(0, 1);
  SnapshotTopology cut = *whole.topology;
  for (std::size_t t = 0; t < whole.topology->triangles.size(); t += 3) {
    const auto [a, b, c] = cut.triangles[t];
    Float3 inside{};
    for (std::size_t k = 0; k < 3; ++k) {
      inside[k] = 0.5F * cut.rest_positions[a][k] + 0.3F * cut.rest_positions[b][k] + 0.2F * cut.rest_positions[c][k];
    }
    const auto middle = static_cast<std::uint32_t>(cut.rest_positions.size());
    cut.rest_positions.push_back(inside);
    cut.triangles[t] = {a, b, middle};
    cut.triangles.insert(cut.triangles.end(), {{b, c, middle}, {c, a, middle}});
  }
  const VesselTree before = vessel_tree(*whole.topology), after = vessel_tree(cut);
  EXPECT_LT(length(after.middle - before.middle), 1e-8);
  EXPECT_LT(length(after.along - before.along), 1e-6);
  EXPECT_NEAR(after.half_length, before.half_length, 1e-8);
  EXPECT_EQ(vessel_trunks(after, 0.01), vessel_trunks(before, 0.01));
}

/// A square in a plane, of triangles that a cut has parted at `divided` places: as wide as long but for rounding.
SnapshotTopology divided_square(std::size_t normal, std::size_t divided) {
  constexpr std::uint32_t kSides = 12;
  SnapshotTopology square;
  const auto place = [&](float u, float v) {
    Float3 result{};
    result[(normal + 1) % 3] = 0.06F * (u / kSides - 0.5F);
    result[(normal + 2) % 3] = 0.06F * (v / kSides - 0.5F);
    return result;
  };
  for (std::uint32_t j = 0; j <= kSides; ++j) {
    for (std::uint32_t i = 0; i <= kSides; ++i) {
      square.rest_positions.push_back(place(static_cast<float>(i), static_cast<float>(j)));
    }
  }
  for (std::uint32_t j = 0; j < kSides; ++j) {
    for (std::uint32_t i = 0; i < kSides; ++i) {
      const std::uint32_t a = j * (kSides + 1) + i, b = a + 1, c = a + kSides + 2, d = c - 1;
      square.triangles.insert(square.triangles.end(), {{a, b, c}, {a, c, d}});
    }
  }
  for (std::size_t t = 0; t < divided; ++t) {
    const auto [a, b, c] = square.triangles[5 * t];
    const auto middle = static_cast<std::uint32_t>(square.rest_positions.size());
    Float3 inside{};
    for (std::size_t k = 0; k < 3; ++k) {
      const float sum = 0.41F * square.rest_positions[a][k] + 0.37F * square.rest_positions[b][k];
      inside[k] = sum + 0.22F * square.rest_positions[c][k];
    }
    square.rest_positions.push_back(inside);
    square.triangles[5 * t] = {a, b, middle};
    square.triangles.insert(square.triangles.end(), {{b, c, middle}, {c, a, middle}});
  }
  return square;
}

TEST(VesselTree, OfASheetAsWideAsLongStaysWhereItIsWhenTheSheetIsCut) {
  for (const std::size_t normal : {0U, 1U, 2U}) {
    const Vector3 uncut = vessel_tree(divided_square(normal, 0)).along;
    for (std::size_t divided = 1; divided < 40; ++divided) {
      const Vector3 along = vessel_tree(divided_square(normal, divided)).along;
      // A ten thousandth of a radian: less than a hundredth of a millimetre on the sheet.
      EXPECT_LT(length(along - uncut), 1e-4) << "normal " << normal << ", " << divided << " triangles divided";
    }
  }
}

TEST(VesselTree, OfASheetLiesBelowIt) {
  const SnapshotSurface sheet =
      test::surface_of("organ", {{0, 0, 0}, {0.04F, 0, 0}, {0.04F, 0.02F, 0}, {0, 0.02F, 0}}, {{0, 1, 2}, {0, 2, 3}});
  const VesselTree tree = vessel_tree(*sheet.topology);
  EXPECT_LT(tree.middle.z, -0.005);
  EXPECT_GT(std::abs(tree.along.x), 0.999);
}

TEST(VesselTree, HasMoreTrunksOnALargerBody) {
  VesselTree small, large;
  small.radius = 0.01;
  large.radius = 0.03;
  EXPECT_EQ(vessel_trunks(small, 0.010), 2);
  EXPECT_EQ(vessel_trunks(large, 0.010), 6);
}

}  // namespace
}  // namespace thinwall
