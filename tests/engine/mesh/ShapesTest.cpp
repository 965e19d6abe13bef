#include "engine/mesh/Shapes.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <numeric>
#include <set>
#include <utility>

#include "engine/mesh/MeshMeasures.hpp"
#include "engine/mesh/MeshTopology.hpp"
#include "engine/mesh/Region.hpp"

namespace thinwall {
namespace {

using std::numbers::pi;

constexpr double kRadius = 0.02;  // metres
constexpr double kInner = 0.008;  // metres
constexpr double kLength = 0.05;  // metres
constexpr double kWidth = 0.03;   // metres

double degrees(double radians) {
  return radians * 180 / pi;
}

struct ShapeCase {
  const char* name;
  std::function<SurfaceMesh(int)> make;
  double wall_area;          // metres^2, of the smooth shape
  double volume;             // metres^3, of the smooth shape; 0 when open
  int euler_characteristic;  // of wall and caps
  double least_angle;        // degrees, a bound: about 1 degree below what was measured
  double median_angle;       // degrees, likewise
};

void PrintTo(const ShapeCase& shape, std::ostream* out) {
  *out << shape.name;
}

class EveryShape : public testing::TestWithParam<ShapeCase> {};

TEST_P(EveryShape, ComesNearTheWantedCount) {
  for (const int wanted : {64, 320, 1280, 5120}) {
    const int got = static_cast<int>(GetParam().make(wanted).triangles.size());
    // The coarsest patterns are 20 n^2 and 6 n^2: neighbouring counts differ by 2 / n.
    EXPECT_NEAR(got, wanted, 0.31 * wanted) << wanted;
    if (wanted >= 1280) {
      EXPECT_NEAR(got, wanted, 0.08 * wanted) << wanted;
    }
  }
}

TEST_P(EveryShape, IsAnOrientedManifoldOfTheRightTopology) {
  for (const int wanted : {20, 64, 500, 1280}) {
    const SurfaceMesh mesh = GetParam().make(wanted);
    const MeshTopology topology = topology_of(static_cast<int>(mesh.vertices.size()), closed_surface(mesh));
    EXPECT_TRUE(is_oriented_manifold(topology)) << wanted;
    EXPECT_EQ(topology.open_edges.empty(), GetParam().volume > 0) << wanted;
    EXPECT_EQ(topology.component_count, 1) << wanted;
    EXPECT_EQ(topology.euler_characteristic, GetParam().euler_characteristic) << wanted;
  }
}

TEST_P(EveryShape, ConvergesToTheSmoothShapeWithTheSquareOfTheEdgeLength) {
  const SurfaceMesh coarse = GetParam().make(320);
  const SurfaceMesh fine = GetParam().make(5120);
  const double refinement = static_cast<double>(fine.triangles.size()) / static_cast<double>(coarse.triangles.size());
  const auto check = [&](double coarse_value, double fine_value, double exact) {
    const double coarse_error = 1 - coarse_value / exact;
    const double fine_error = 1 - fine_value / exact;
    if (std::abs(coarse_error) < 1e-12) return;  // flat with straight edges: exact on any mesh
    EXPECT_GT(fine_error, 0);                    // inscribed
    // The error goes with the square of the edge length, so with the inverse of the count; where only the arc is curved
    // the strips alone count, which grow a little unlike the rest when divisions are rounded.
    EXPECT_NEAR(coarse_error / fine_error, refinement, 0.25 * refinement);
    EXPECT_LT(fine_error, 4e-3);
  };
  check(wall_area(coarse), wall_area(fine), GetParam().wall_area);
  if (GetParam().volume > 0) check(enclosed_volume(coarse), enclosed_volume(fine), GetParam().volume);
}

TEST_P(EveryShape, HasWellShapedTriangles) {
  for (const int wanted : {320, 1280, 5120}) {
    const MeshQuality quality = quality_of(GetParam().make(wanted));
    EXPECT_GT(degrees(quality.least_angle), GetParam().least_angle) << wanted;
    EXPECT_GT(degrees(quality.median_angle), GetParam().median_angle) << wanted;
    EXPECT_LT(degrees(quality.largest_angle), 100) << wanted;
  }
}

TEST_P(EveryShape, NamesAllItsVerticesWallAndUsesEachOfThem) {
  const SurfaceMesh mesh = GetParam().make(320);
  std::vector<int> all(mesh.vertices.size());
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(mesh.groups.at("wall"), all);
  std::set<int> used;
  for (const Eigen::Vector3i& t : mesh.triangles) used.insert({t[0], t[1], t[2]});
  EXPECT_EQ(used.size(), all.size());
}

TEST_P(EveryShape, IsCentredOnTheOrigin) {
  const SurfaceMesh mesh = GetParam().make(1280);
  Eigen::Vector3d least = mesh.vertices.front();
  Eigen::Vector3d largest = least;
  for (const Eigen::Vector3d& v : mesh.vertices) {
    least = least.cwiseMin(v);
    largest = largest.cwiseMax(v);
  }
  const Eigen::Vector3d middle = (least + largest) / 2;
  // The icosahedron and the discs of odd rings do not reach equally far to both sides: off by less than half an edge.
  EXPECT_NEAR(middle[0], 0, 0.01 * kRadius);
  EXPECT_NEAR(middle[1], 0, 0.01 * kRadius);
}

const ShapeCase kShapes[] = {
    {"sphere", [](int n) { return make_sphere(kRadius, n); }, 4 * pi* kRadius* kRadius,
     4 * pi / 3 * kRadius* kRadius* kRadius, 2, 53, 53.4},
    {"hemisphere", [](int n) { return make_hemisphere(kRadius, n); }, 2 * pi* kRadius* kRadius,
     2 * pi / 3 * kRadius* kRadius* kRadius, 2, 33.5, 45.8},
    {"semicylinder", [](int n) { return make_semicylinder(kRadius, kLength, n); }, pi* kRadius* kLength,
     pi / 2 * kRadius* kRadius* kLength, 2, 25.8, 52.8},
    {"cylinder", [](int n) { return make_cylinder(kRadius, kLength, n); }, 2 * pi* kRadius* kLength,
     pi* kRadius* kRadius* kLength, 2, 25, 55},
    {"sheet", [](int n) { return make_sheet(kWidth, kLength, n); }, kWidth* kLength, 0, 1, 25, 55},
    {"disc", [](int n) { return make_disc(kRadius, n); }, pi* kRadius* kRadius, 0, 1, 42, 50},
    {"annulus", [](int n) { return make_annulus(kInner, kRadius, n); }, pi*(kRadius* kRadius - kInner * kInner), 0, 0,
     50, 55},
};

INSTANTIATE_TEST_SUITE_P(Shapes, EveryShape, testing::ValuesIn(kShapes),
                         [](const testing::TestParamInfo<ShapeCase>& shape) { return shape.param.name; });

TEST(Sphere, FiveThousandTrianglesAreGivenExactly) {
  EXPECT_EQ(make_sphere(kRadius, 5120).triangles.size(), 5120u);
  EXPECT_EQ(make_sphere(kRadius, 5120).vertices.size(), 2562u);
}

TEST(Sphere, VerticesLieOnTheSphereAndTrianglesAreNearlyEqual) {
  const SurfaceMesh mesh = make_sphere(kRadius, 5120);
  for (const Eigen::Vector3d& v : mesh.vertices) EXPECT_NEAR(v.norm(), kRadius, 1e-15 * kRadius + 4e-18);
  const MeshQuality quality = quality_of(mesh);
  EXPECT_LT(quality.largest_area / quality.least_area, 1.25);
}

TEST(Hemisphere, SixtyFourTrianglesAreThePublishedMeshOfFortyOneNodes) {
  const SurfaceMesh mesh = make_hemisphere(kRadius, 64);
  EXPECT_EQ(mesh.triangles.size(), 64u);
  ASSERT_EQ(mesh.vertices.size(), 41u);
  EXPECT_EQ(mesh.vertices[0], Eigen::Vector3d(0, 0, kRadius));
  for (const auto& [ring, count] : {std::pair{1, 4}, {2, 8}, {3, 12}, {4, 16}}) {
    const double height = kRadius * std::cos(ring * pi / 8);
    EXPECT_EQ(vertices_in(PlaneRegion{2, height, 1e-12}, mesh).size(), static_cast<std::size_t>(count));
  }
}

TEST(Hemisphere, BaseIsTheRimAndLiesInTheGround) {
  const SurfaceMesh mesh = make_hemisphere(kRadius, 5120);
  EXPECT_EQ(mesh.groups.at("base"), vertices_in(BoundaryRegion{}, mesh));
  EXPECT_EQ(mesh.groups.at("base"), vertices_in(PlaneRegion{2, 0, 0}, mesh));
  for (const Eigen::Vector3i& t : mesh.cap_triangles) {
    for (const int v : t) EXPECT_EQ(mesh.vertices[v][2], 0);
  }
}

/// Whether turning the sign of one coordinate maps the vertices and the triangles onto themselves.
bool is_mirror_symmetric(const SurfaceMesh& mesh, int axis) {
  std::map<std::array<double, 3>, int> index;
  const auto key = [](Eigen::Vector3d v) { return std::array<double, 3>{v[0], v[1], v[2]}; };
  for (int v = 0; v < static_cast<int>(mesh.vertices.size()); ++v) {
    // Adding zero turns -0 into 0.
    index[key(mesh.vertices[v] + Eigen::Vector3d::Zero())] = v;
  }
  std::set<std::array<int, 3>> triangles;
  const auto sorted = [](std::array<int, 3> t) {
    std::sort(t.begin(), t.end());
    return t;
  };
  for (const Eigen::Vector3i& t : mesh.triangles) triangles.insert(sorted({t[0], t[1], t[2]}));
  for (const Eigen::Vector3i& t : mesh.triangles) {
    std::array<int, 3> image{};
    for (int k = 0; k < 3; ++k) {
      Eigen::Vector3d mirrored = mesh.vertices[t[k]];
      mirrored[axis] = -mirrored[axis];
      const auto found = index.find(key(mirrored + Eigen::Vector3d::Zero()));
      if (found == index.end()) return false;
      image[k] = found->second;
    }
    if (!triangles.contains(sorted(image))) return false;
  }
  return true;
}

TEST(Semicylinder, IsMirrorSymmetricAboutTheCrownToTheLastBit) {
  for (const int wanted : {20, 320, 1111, 5120}) {
    EXPECT_TRUE(is_mirror_symmetric(make_semicylinder(0.01, 0.012, wanted), 0)) << wanted;
  }
}

TEST(Semicylinder, HasARowOfVerticesAlongTheCrownAndEvenArcs) {
  const SurfaceMesh mesh = make_semicylinder(kRadius, kLength, 1280);
  std::vector<double> arcs;  // radians from the crown
  int on_crown = 0;
  for (const Eigen::Vector3d& v : mesh.vertices) {
    if (v[0] == 0) {
      ++on_crown;
      EXPECT_EQ(v[2], kRadius);
    }
    EXPECT_NEAR(std::hypot(v[0], v[2]), kRadius, 1e-17);
    arcs.push_back(std::atan2(v[0], v[2]));
  }
  EXPECT_GT(on_crown, 5);
  std::sort(arcs.begin(), arcs.end());
  const auto same = [](double a, double b) { return std::abs(a - b) < 1e-12; };
  arcs.erase(std::unique(arcs.begin(), arcs.end(), same), arcs.end());
  const double step = pi / static_cast<double>(arcs.size() - 1);
  for (std::size_t i = 0; i + 1 < arcs.size(); ++i) EXPECT_NEAR(arcs[i + 1] - arcs[i], step, 1e-14);
}

TEST(Semicylinder, GroupsAreTheStraightEdgesAndTheArcs) {
  const SurfaceMesh mesh = make_semicylinder(kRadius, kLength, 1280);
  EXPECT_EQ(mesh.groups.at("base"), vertices_in(PlaneRegion{2, 0, 0}, mesh));
  std::vector<int> ends = vertices_in(PlaneRegion{1, -kLength / 2, 0}, mesh);
  const std::vector<int> front = vertices_in(PlaneRegion{1, kLength / 2, 0}, mesh);
  ends.insert(ends.end(), front.begin(), front.end());
  std::sort(ends.begin(), ends.end());
  EXPECT_EQ(mesh.groups.at("ends"), ends);
  for (const Eigen::Vector3i& t : mesh.cap_triangles) {
    const Eigen::Vector3d normal =
        (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]).normalized();
    const double y = mesh.vertices[t[0]][1];
    const bool faces_down = normal[2] < -0.999;
    const bool faces_end = normal[1] * y > 0 && std::abs(normal[1]) > 0.999;
    EXPECT_TRUE(faces_down || faces_end);
  }
}

TEST(Semicylinder, ShortFingerStillHasNearlyEquilateralTriangles) {
  const MeshQuality quality = quality_of(make_semicylinder(0.01, 0.002, 400));
  EXPECT_GT(degrees(quality.least_angle), 25);
}

TEST(Cylinder, HasARowOfVerticesAtTheCrownAndEndsOnCircles) {
  const SurfaceMesh mesh = make_cylinder(kRadius, kLength, 1280);
  EXPECT_GT(vertices_in(BoxRegion{{0, -kLength, kRadius}, {0, kLength, kRadius}}, mesh).size(), 5u);
  EXPECT_EQ(mesh.groups.at("ends"), vertices_in(BoundaryRegion{}, mesh));
}

TEST(Sheet, IsMirrorSymmetricAndFacesUp) {
  const SurfaceMesh mesh = make_sheet(kWidth, kLength, 320);
  EXPECT_TRUE(is_mirror_symmetric(mesh, 0));
  EXPECT_TRUE(is_mirror_symmetric(mesh, 1));
  for (const Eigen::Vector3i& t : mesh.triangles) {
    EXPECT_GT((mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]])[2], 0);
  }
}

TEST(SlitAnnulus, LipsLieOnEachOtherWithVerticesOfTheirOwn) {
  const SurfaceMesh mesh = make_slit_annulus(kInner, kRadius, 1280);
  const std::vector<int>&start = mesh.groups.at("slit_start"), &end = mesh.groups.at("slit_end");
  ASSERT_EQ(start.size(), end.size());
  for (std::size_t k = 0; k < start.size(); ++k) {
    EXPECT_NE(start[k], end[k]);
    EXPECT_EQ(mesh.vertices[start[k]], mesh.vertices[end[k]]);
    EXPECT_EQ(mesh.vertices[start[k]].y(), 0);
  }
  EXPECT_EQ(mesh.vertices[start.front()].x(), kInner);
  EXPECT_EQ(mesh.vertices[start.back()].x(), kRadius);
  const MeshTopology topology = topology_of(static_cast<int>(mesh.vertices.size()), mesh.triangles);
  EXPECT_TRUE(is_oriented_manifold(topology));
  EXPECT_EQ(topology.boundary_loops.size(), 1U);
  EXPECT_EQ(topology.euler_characteristic, 1);
  // The start is where the ring goes counter-clockwise from: its triangles lie above it.
  for (const Eigen::Vector3i& t : mesh.triangles) {
    const bool at_start = std::count(start.begin(), start.end(), t[0]) > 0;
    if (!at_start) continue;
    EXPECT_GE(mesh.vertices[t[1]].y() + mesh.vertices[t[2]].y(), 0);
  }
}

TEST(Annulus, RimsLieOnTheirCircles) {
  const SurfaceMesh mesh = make_annulus(kInner, kRadius, 1280);
  for (const int v : vertices_in(BoundaryRegion{}, mesh)) {
    const double reach = mesh.vertices[v].norm();
    EXPECT_LT(std::min(std::abs(reach - kInner), std::abs(reach - kRadius)), 1e-17);
  }
}

TEST(Annulus, HasItsCirclesAsGroups) {
  for (const SurfaceMesh& mesh : {make_annulus(kInner, kRadius, 1280), make_slit_annulus(kInner, kRadius, 1280)}) {
    std::vector<int> inner, outer;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
      const double reach = mesh.vertices[v].norm();
      if (reach < kInner + 1e-15) inner.push_back(static_cast<int>(v));
      if (reach > kRadius - 1e-15) outer.push_back(static_cast<int>(v));
    }
    EXPECT_GT(inner.size(), 20U);
    EXPECT_EQ(mesh.groups.at("inner"), inner);
    EXPECT_EQ(mesh.groups.at("outer"), outer);
  }
}

}  // namespace
}  // namespace thinwall
