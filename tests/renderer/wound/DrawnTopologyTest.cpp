#include "renderer/wound/DrawnTopology.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/renderer/shape/CutSheets.hpp"

namespace thinwall {
namespace {

Vector3 at(const SnapshotTopology& topology, const SurfacePlace& place) {
  Vector3 sum;
  for (std::size_t k = 0; k < 3; ++k) {
    sum = sum + place.weights[k] * vector3(topology.rest_positions[topology.triangles[place.triangle][k]]);
  }
  return sum;
}

Vector3 at(const SnapshotTopology& topology, const std::vector<BorderEdge>& borders, const BorderPlace& place) {
  const Vector3 start = vector3(topology.rest_positions[borders[place.border].start]);
  return start + place.along * (vector3(topology.rest_positions[borders[place.border].end]) - start);
}

const std::vector<std::array<double, 3>> kWeights = {{1, 0, 0},       {0, 1, 0},          {0, 0, 1},
                                                     {0.2, 0.3, 0.5}, {0.81, 0.14, 0.05}, {0.05, 0.9, 0.05}};

/// A sheet with a slit, rolled so that edges across the slit are drawn as curves.
std::shared_ptr<const SnapshotTopology> rolled_slit_sheet() {
  constexpr float kRadius = 0.005F;
  auto rolled = std::make_shared<SnapshotTopology>(*test::slit_sheet(8, 0.001, 0.3).topology);
  for (auto& [x, y, z] : rolled->rest_positions) z += std::sqrt(kRadius * kRadius - x * x);
  return rolled;
}

TEST(DrawnTopology, APlaceOfTheMeshIsDrawnWhereItsMatterLies) {
  const auto mesh = rolled_slit_sheet();
  const DrawnTopology drawn = drawn_topology(mesh, DrawnEdges::kCurves);
  ASSERT_GT(drawn.parts().size(), 2 * mesh->triangles.size());
  for (std::uint32_t t = 0; t < mesh->triangles.size(); ++t) {
    for (const auto& weights : kWeights) {
      const SurfacePlace place{t, weights};
      const SurfacePlace shown = drawn_place(drawn, place);
      for (const double weight : shown.weights) EXPECT_GE(weight, -1e-15);
      EXPECT_LT(length(at(drawn.topology(), shown) - at(*mesh, place)), 1e-9);
      const SurfacePlace again = mesh_place(drawn, shown);
      EXPECT_EQ(again.triangle, t);
      for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(again.weights[k], weights[k], 1e-12);
    }
  }
}

TEST(DrawnTopology, EachDrawnTriangleShowsItsOwnPartOfTheMesh) {
  const auto mesh = rolled_slit_sheet();
  const DrawnTopology drawn = drawn_topology(mesh, DrawnEdges::kCurves);
  ASSERT_EQ(drawn.parts().size(), drawn.topology().triangles.size());
  for (std::uint32_t t = 0; t < drawn.parts().size(); ++t) {
    const SurfacePlace place{t, {0.25, 0.35, 0.4}};
    const SurfacePlace on_mesh = mesh_place(drawn, place);
    EXPECT_LT(length(at(drawn.topology(), place) - at(*mesh, on_mesh)), 1e-9);
    EXPECT_EQ(drawn_place(drawn, on_mesh).triangle, t);
  }
}

TEST(DrawnTopology, PlacesOfBordersKeepTheirMatterToo) {
  const auto mesh = rolled_slit_sheet();
  const DrawnTopology drawn = drawn_topology(mesh, DrawnEdges::kCurves);
  EXPECT_GT(drawn.borders.size(), drawn.mesh_borders.size());
  for (std::uint32_t k = 0; k < drawn.mesh_borders.size(); ++k) {
    for (const double along : {0.0, 0.2, 0.25, 0.6, 1.0}) {
      const BorderPlace place{k, along};
      const BorderPlace shown = drawn_place(drawn, place);
      EXPECT_LT(length(at(drawn.topology(), drawn.borders, shown) - at(*mesh, drawn.mesh_borders, place)), 1e-9);
      EXPECT_EQ(mesh_place(drawn, shown).border, k);
      EXPECT_NEAR(mesh_place(drawn, shown).along, along, 1e-12);
    }
  }
}

TEST(DrawnTopology, ItsBordersAreThoseOfItsTriangles) {
  const DrawnTopology drawn = drawn_topology(rolled_slit_sheet(), DrawnEdges::kCurves);
  const auto sorted = [](const std::vector<BorderEdge>& borders) {
    std::vector<Triangle> edges;
    for (const auto& [start, end, triangle] : borders) edges.push_back({start, end, triangle});
    std::ranges::sort(edges);
    return edges;
  };
  EXPECT_EQ(sorted(drawn.borders), sorted(border_edges(drawn.topology())));
}

TEST(DrawnTopology, IsTheMeshItselfWhereItsTrianglesAreAskedForOrNothingIsCutNorCoarse) {
  const auto cut = test::slit_sheet(8, 0.001, 0).topology;
  EXPECT_EQ(drawn_topology(cut, DrawnEdges::kStraight).smooth.topology, cut);
  const auto whole = test::sphere("ball", {0, 0, 0}, 0.02, 5).topology;
  EXPECT_EQ(drawn_topology(whole, DrawnEdges::kCurves).smooth.topology, whole);
  const auto coarse = test::sphere("ball", {0, 0, 0}, 0.02, 3).topology;
  EXPECT_NE(drawn_topology(coarse, DrawnEdges::kCurves).smooth.topology, coarse);
  EXPECT_EQ(drawn_topology(coarse, DrawnEdges::kCurvedLips).smooth.topology, coarse);
  const SurfacePlace place{7, {0.5, 0.25, 0.25}};
  EXPECT_EQ(drawn_place(drawn_topology(whole, DrawnEdges::kCurves), place).weights, place.weights);
}

}  // namespace
}  // namespace thinwall
