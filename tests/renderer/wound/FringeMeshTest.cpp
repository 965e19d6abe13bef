#include "renderer/wound/FringeMesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "renderer/snapshot/Vector.hpp"
#include "tests/renderer/shape/CutSheets.hpp"

namespace thinwall {
namespace {

/// A sheet with a slit along x.
struct SlitSheet {
  SlitSheet(int parts, double square) : sheet(test::slit_sheet(parts, square, 0)), half(0.5 * (parts - 2) * square) {
    const std::vector<BorderEdge> borders = border_edges(*sheet.topology);
    const std::vector<char> is_lip = cut_lips(*sheet.topology, borders);
    const WoundMap map = map_wounds(*sheet.topology, borders, is_lip);
    mesh = fringe_mesh(*sheet.topology, borders, is_lip, map);
    for (std::size_t v = 0; v < is_lip.size(); ++v) {
      reach.push_back(is_lip[v] && std::abs(place(static_cast<std::uint32_t>(v)).x) < half - 1e-6 ? kMost : 0);
    }
  }

  Vector3 place(std::uint32_t vertex) const {
    const std::vector<Float3>& rest = sheet.topology->rest_positions;
    if (vertex < rest.size()) return vector3(rest[vertex]);
    const FringeMesh::Point& point = mesh.points[vertex - rest.size()];
    return (1 - point.part) * vector3(rest[point.start]) + point.part * vector3(rest[point.end]);
  }

  /// What wells out of the slit, of an inner vertex kMost metres far, of its ends not at all, and between as it goes.
  double beyond(Vector3 place, double square) const {
    double most = -1;
    constexpr int kParts = 400;
    for (int k = 0; k <= kParts; ++k) {
      const double x = half * (2.0 * k / kParts - 1);
      const double from_lip = kMost * std::min(1.0, (half - std::abs(x)) / square);
      most = std::max(most, from_lip - std::hypot(place.x - x, place.y));
    }
    return most;
  }

  static constexpr double kMost = 0.0012;  // metres
  SnapshotSurface sheet;
  double half = 0;  // metres, of the slit
  FringeMesh mesh;
  std::vector<double> reach;  // (vertices), metres
};

TEST(FringeMesh, SpreadsRoundAPunctureSmallerThanTheTriangles) {
  constexpr double kSquare = 0.0008;
  const SlitSheet slit(4, kSquare);
  ASSERT_FALSE(slit.mesh.triangles.empty());
  double most = 0;
  for (const Triangle& triangle : slit.mesh.triangles) {
    double told = 0;
    Vector3 middle{};
    for (const std::uint32_t v : triangle) {
      told += spread_at(slit.mesh, v, slit.reach).beyond / 3;
      middle = middle + (1.0 / 3) * slit.place(v);
    }
    most = std::max(most, std::abs(told - slit.beyond(middle, kSquare)));
  }
  EXPECT_LT(most, 0.0001) << "between the sheet's own vertices 0.00016";
}

TEST(FringeMesh, LeavesTheTrianglesBesideStraightLipsAsTheyAre) {
  const SlitSheet slit(20, 0.001);
  EXPECT_FALSE(slit.mesh.points.empty());
  for (const FringeMesh::Point& point : slit.mesh.points) {
    const double from_end = std::abs(std::abs(slit.place(point.start).x) - slit.half);
    EXPECT_LT(from_end, 0.006) << "only around the ends it is not straight";
  }
}

TEST(FringeMesh, HasTheLipsOfItsOwnSideOfTheCut) {
  const SlitSheet slit(20, 0.001);
  const auto twins_from = static_cast<std::uint32_t>(21 * 21);
  for (const std::uint32_t below : {9U * 21 + 9, 9U * 21 + 11}) {
    const std::uint32_t above = below + 2 * 21;
    for (std::uint32_t lip = slit.mesh.first_lip[below]; lip < slit.mesh.first_lip[below + 1]; ++lip) {
      EXPECT_LT(slit.mesh.lips[lip].start, twins_from);
    }
    std::uint32_t on_twins = 0;
    for (std::uint32_t lip = slit.mesh.first_lip[above]; lip < slit.mesh.first_lip[above + 1]; ++lip) {
      on_twins += slit.mesh.lips[lip].start >= twins_from;
    }
    EXPECT_GT(on_twins, 4U);
  }
}

}  // namespace
}  // namespace thinwall
