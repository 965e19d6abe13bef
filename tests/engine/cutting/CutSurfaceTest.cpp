#include "engine/cutting/CutSurface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "engine/cutting/PlaneSection.hpp"
#include "engine/mesh/MeshMeasures.hpp"
#include "engine/mesh/MeshTopology.hpp"
#include "engine/mesh/Shapes.hpp"
#include "tests/engine/cutting/CheckedCuts.hpp"
#include "tests/engine/cutting/SurfaceWalk.hpp"

namespace thinwall {
namespace {

/// A sheet 2 wide and long about the origin; edges of about 0.15.
int open_loops(const CutSurface& surface) {
  const SurfaceMesh& mesh = surface.mesh();
  return static_cast<int>(topology_of(static_cast<int>(mesh.vertices.size()), mesh.triangles).boundary_loops.size());
}

bool is_nothing(const Cut& cut) {
  return cut.lips.empty() && cut.vertices.empty() && cut.triangles.empty() && cut.length == 0;
}

// ---- Where cuts begin and end

TEST(CutSurface, OpensASlitInASheetExactlyAlongItsPath) {
  CutSurface surface = sheet();
  const Cut cut = cut_through(surface, {{-0.5, -0.21, 0}, {0.43, 0.17, 0}});
  EXPECT_NEAR(cut.length, std::hypot(0.93, 0.38), 1e-12);
  EXPECT_LT(cut.deviation, 1e-12);
  EXPECT_EQ(cut.euler_change, -1);
  ASSERT_EQ(cut.lips.size(), 1U);
  ASSERT_TRUE(cut.tip);
  EXPECT_LT((surface.mesh().vertices[*cut.tip] - Eigen::Vector3d(0.43, 0.17, 0)).norm(), 1e-12);
  ASSERT_EQ(cut.wound_loops.size(), 1U);
  EXPECT_EQ(cut.wound_loops[0].size(), 2 * cut.lips[0].left.size() - 2);
  EXPECT_EQ(open_loops(surface), 2);
}

TEST(CutSurface, FollowsACurveInASheetToAFewHundredthsOfAnEdge) {
  CutSurface surface = sheet();
  Places arc;
  for (int i = 0; i <= 60; ++i) {
    const double angle = i * 4.5 / 60;
    arc.emplace_back(0.6 * std::cos(angle), 0.6 * std::sin(angle), 0);
  }
  const Cut cut = cut_through(surface, arc);
  EXPECT_NEAR(cut.length, 0.6 * 4.5, 0.01 * 0.6 * 4.5);  // chords of 0.15 on the arc: 0.3 %
  EXPECT_LT(cut.deviation, 0.1 * 0.15);
}

TEST(CutSurface, OpensABorderWhereAPathBegins) {
  CutSurface surface = sheet();
  const Cut cut = cut_through(surface, {{0.05, -1, 0}, {0.1, 0.3, 0}});
  EXPECT_EQ(cut.euler_change, 0);
  EXPECT_TRUE(cut.tip);
  EXPECT_EQ(open_loops(surface), 1);
  EXPECT_NE(cut.lips.front().left.front(), cut.lips.front().right.front());
}

TEST(CutSurface, StopsShortOfABorderThatAPathEndsCloseToAndLeavesTheRestForLater) {
  CutSurface surface = sheet();
  const Eigen::Vector3d end(0.1, 0.99, 0);
  const Cut cut = cut_through(surface, {{0.05, 0, 0}, end});
  ASSERT_TRUE(cut.tip);
  EXPECT_LT(surface.mesh().vertices[*cut.tip].y(), 0.98);
  ASSERT_FALSE(cut.rest.empty());
  EXPECT_LT((position_of(surface.mesh(), cut.rest.back()) - end).norm(), 1e-12);
}

TEST(CutSurface, DividesASheetFromBorderToBorder) {
  CutSurface surface = sheet();
  const Cut cut = cut_through(surface, {{0.05, -1, 0}, {-0.1, 0.2, 0}, {0.3, 1, 0}});
  EXPECT_EQ(cut.euler_change, 1);
  EXPECT_EQ(cut.separated.size(), 1U);
  EXPECT_EQ(surface.component_count(), 2);
  EXPECT_FALSE(cut.tip);
}

TEST(CutSurface, CutsOutAPieceWhereAPathCloses) {
  CutSurface surface = sheet();
  const Cut cut =
      cut_through(surface, {{-0.4, -0.4, 0}, {0.4, -0.4, 0}, {0.4, 0.4, 0}, {-0.4, 0.4, 0}, {-0.4, -0.4, 0}});
  EXPECT_NEAR(cut.length, 3.2, 1e-9);
  EXPECT_EQ(cut.euler_change, 0);
  EXPECT_EQ(cut.separated.size(), 1U);
  EXPECT_EQ(cut.wound_loops.size(), 2U);
  double area = 0;
  const auto areas = triangle_areas(surface.mesh().vertices, surface.mesh().triangles);
  for (std::size_t t = 0; t < areas.size(); ++t)
    area += surface.components()[t] == cut.separated.front() ? areas[t] : 0;
  EXPECT_NEAR(area, 0.64, 1e-12);
}

TEST(CutSurface, ClosesALoopThatComesBackToItsLip) {
  CutSurface surface = sheet();
  const Cut first = cut_through(surface, {{-0.4, -0.4, 0}, {0.4, -0.4, 0}, {0.4, 0.4, 0}, {-0.4, 0.4, 0}});
  ASSERT_TRUE(first.tip);
  const SurfaceWalk to_lip = walk_on(surface, nearest_point(surface.mesh(), {0, -0.3, 0}), {0, -1, 0}, 1);
  ASSERT_TRUE(to_lip.at_border);
  const Cut second = cut_well(surface, {.from = first.tip, .points = {to_lip.points.back()}});
  EXPECT_EQ(second.separated.size(), 1U);
  EXPECT_NEAR(second.length, std::hypot(0.4, 0.8), 0.05);
  EXPECT_FALSE(second.tip);
}

TEST(CutSurface, CrossesAnEarlierCut) {
  CutSurface surface = sheet();
  cut_through(surface, {{-0.6, 0, 0}, {0.6, 0, 0}});
  const Places below = {{0.05, -0.5, 0}, {0.03, 0, 0}}, above = {{0.03, 0, 0}, {0.02, 0.5, 0}};
  for (const Places& piece : {below, above}) {
    // The lips lie on each other: the point at the lip is that of the side on which the piece lies.
    const double side = piece.front().y() + piece.back().y();
    std::vector<SurfacePoint> points;
    for (const Eigen::Vector3d& place : piece) points.push_back(nearest_point(surface.mesh(), place, side));
    const Cut cut = cut_well(surface, {.from = {}, .points = points});
    EXPECT_EQ(cut.euler_change, 0);
    EXPECT_NEAR(cut.length, 0.5, 0.1);
  }
  EXPECT_EQ(open_loops(surface), 2);
}

TEST(CutSurface, CrossesItselfWithinOnePathAndEndsAtItself) {
  for (const auto& [side, end] : {std::pair(1, -0.62), std::pair(1, 0.0), std::pair(-1, 0.0)}) {
    for (int i = 0; i < 12; ++i) {  // at nodes of the first line and between them
      const double x = 0.013 * i, y = 0.5 * side;
      CutSurface surface = sheet();
      const Cut cut = cut_through(surface, {{-0.5, 0, 0}, {0.5, 0, 0}, {0.5, y, 0}, {x, y, 0}, {x, end, 0}});
      EXPECT_EQ(cut.separated.size(), 1U);
      EXPECT_EQ(open_loops(surface), 3);  // the sheet, the piece, the wound around it
      EXPECT_NEAR(cut.length, 2.5 - x - end, 0.15);
      EXPECT_LT(cut.deviation, 0.2 * 0.15);
    }
  }
}

TEST(CutSurface, CutsABodyInTwo) {
  const SurfaceMesh mesh = make_sphere(1, 720);
  Eigen::VectorXd position(3 * mesh.vertices.size());
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    position.segment<3>(3 * static_cast<Eigen::Index>(v)) = mesh.vertices[v];
  }
  // Askew; through rows of vertices; through the poles.
  for (const Eigen::Vector3d& normal : Places{{0.2, 0.3, 1}, {0, 0, 1}, {1, 0, 0}, {0.3, 1, 0}}) {
    const auto curves =
        plane_section({.triangles = mesh.triangles, .position = position},
                      {.point = Eigen::Vector3d::Zero(), .normal = normal.normalized()}, PlaneTies::kBehind);
    ASSERT_EQ(curves.size(), 1U);
    CutPath path{.from = {}, .points = curves[0].points};
    path.points.push_back(path.points.front());
    CutSurface surface(mesh);
    const Cut cut = cut_well(surface, path);
    EXPECT_EQ(cut.separated.size(), 1U);
    EXPECT_EQ(cut.euler_change, 0);
    EXPECT_EQ(cut.wound_loops.size(), 2U);
    EXPECT_FALSE(cut.tip);
    EXPECT_NEAR(cut.length, 2 * std::numbers::pi, 0.3);
  }
}

TEST(CutSurface, CutsACylinderInTwoWithACapOnEachPart) {
  CutSurface surface(make_cylinder(1, 3, 800));
  const SurfaceWalk round = walk_on(surface, nearest_point(surface.mesh(), {1, 0.21, 0.02}), {0, 0, 1}, 6.2);
  std::vector<SurfacePoint> points = round.points;
  // A cylinder's generators are parallel: the way around closes on itself.
  const Eigen::Vector3d end = position_of(surface.mesh(), points.back());
  const SurfaceWalk last =
      walk_on(surface, points.back(), round.direction, (position_of(surface.mesh(), points.front()) - end).norm());
  points.insert(points.end(), last.points.begin() + 1, last.points.end());
  points.push_back(points.front());
  const Cut cut = cut_well(surface, {.from = {}, .points = points});
  EXPECT_EQ(cut.euler_change, 0);
  EXPECT_EQ(cut.separated.size(), 1U);
  EXPECT_EQ(cut.wound_loops.size(), 2U);
  EXPECT_NEAR(cut.length, 2 * std::numbers::pi, 0.15);
}

// ---- Paths that cut nothing new

TEST(CutSurface, CutsNothingWithoutMotion) {
  CutSurface surface = sheet();
  const SurfacePoint point = nearest_point(surface.mesh(), {0.1, 0.2, 0});
  EXPECT_TRUE(is_nothing(cut_well(surface, {.from = {}, .points = {}})));
  EXPECT_TRUE(is_nothing(cut_well(surface, {.from = {}, .points = {point}})));
  EXPECT_TRUE(is_nothing(cut_well(surface, {.from = {}, .points = {point, point, point}})));
}

TEST(CutSurface, CutsNothingOnTheWayBack) {
  CutSurface there = sheet(), back = sheet();
  const Cut cut = cut_through(there, {{-0.5, 0.1, 0}, {0.5, 0.1, 0}});
  const Cut both = cut_through(back, {{-0.5, 0.1, 0}, {0.5, 0.1, 0}, {-0.3, 0.1, 0}});
  EXPECT_NEAR(both.length, cut.length, 1e-12);
  EXPECT_EQ(both.euler_change, -1);
  const SurfacePoint behind = nearest_point(there.mesh(), {0, 0.1, 0});
  EXPECT_TRUE(is_nothing(cut_well(there, {.from = cut.tip, .points = {behind}})));
}

TEST(CutSurface, MergesAWayBackThatIsAlmostTheSame) {
  CutSurface surface = sheet();
  const Cut cut = cut_through(surface, {{-0.5, 0, 0}, {0.5, 0, 0}, {-0.4, 0.06, 0}});
  EXPECT_GE(cut.least_meeting_angle, 10 * std::numbers::pi / 180 - 1e-9);
}

TEST(CutSurface, CutsNothingAlongABorderOrTheRimOfACap) {
  CutSurface flat = sheet();
  EXPECT_TRUE(is_nothing(cut_through(flat, {{-0.5, -1, 0}, {0.5, -1, 0}})));
  CutSurface capped(make_hemisphere(1, 256));
  CutPath rim{.from = {}, .points = {}};
  for (const int vertex : capped.mesh().groups.at("base")) {
    if (rim.points.size() < 3) rim.points.push_back(nearest_point(capped.mesh(), capped.mesh().vertices[vertex]));
  }
  EXPECT_TRUE(is_nothing(cut_well(capped, rim)));
}

TEST(CutSurface, RefusesAPathThatLeavesTheSurface) {
  CutSurface surface(make_sphere(1, 320));
  const SurfacePoint a = nearest_point(surface.mesh(), {1, 0, 0}), b = nearest_point(surface.mesh(), {0, 1, 0});
  EXPECT_THROW(surface.cut({.from = {}, .points = {a, b}}), std::invalid_argument);
  EXPECT_THROW(surface.cut({.from = {}, .points = {{.triangle = 4000, .weights = {1, 0, 0}}}}), std::invalid_argument);
  EXPECT_THROW(surface.cut({.from = {}, .points = {{.triangle = 0, .weights = {2, -1, 0}}}}), std::invalid_argument);
  EXPECT_THROW(surface.cut({.from = 4000, .points = {a}}), std::invalid_argument);
}

TEST(CutSurface, RefusesAWallThatIsNoManifold) {
  const SurfaceMesh book{.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}},
                         .triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}},
                         .cap_triangles = {},
                         .groups = {}};
  EXPECT_THROW(CutSurface{book}, std::invalid_argument);
}

// ---- Along what is there

TEST(CutSurface, GoesAlongEdgesAndThroughVerticesWithoutNewOnes) {
  CutSurface surface(make_sphere(1, 320));
  const SurfaceMesh mesh = surface.mesh();
  CutPath path{.from = 0, .points = {}};
  std::vector<int> chain = {0};
  while (chain.size() < 5) {  // the neighbour farthest from the first vertex
    int next = -1;
    for (const Eigen::Vector3i& t : mesh.triangles) {
      if ((t.array() == chain.back()).any()) {
        for (const int v : t) {
          const auto far = [&](int w) { return (mesh.vertices[w] - mesh.vertices[0]).norm(); };
          if (next < 0 || far(v) > far(next)) next = v;
        }
      }
    }
    chain.push_back(next);
    path.points.push_back(nearest_point(mesh, mesh.vertices[next]));
    path.points.back().weights.array() += 1e-13;  // as found, to round-off
  }
  const Cut cut = cut_well(surface, path);
  EXPECT_EQ(cut.counts.splits, 0);
  EXPECT_EQ(cut.vertices.size(), 3U);  // the inner ones are doubled
  EXPECT_EQ(cut.lips.front().left.size(), 5U);
  EXPECT_LT(cut.deviation, 1e-12);
}

TEST(CutSurface, AdvancesByTwentiethsOfAnEdgeWithoutEverSmallerTriangles) {
  for (const SurfaceMesh& mesh : {make_sheet(2, 2, 400), make_sphere(0.6, 400)}) {
    CutSurface surface(mesh);
    const double edge = 1.52 * std::sqrt(wall_area(mesh) / static_cast<double>(mesh.triangles.size()));
    const SurfacePoint start =
        nearest_point(mesh, {-0.5, -0.1, mesh.cap_triangles.empty() && mesh.vertices[0].z() == 0 ? 0.0 : 0.33});
    Eigen::Vector3d direction(1, 0.23, 0);
    CutPath path{.from = {}, .points = {start}};
    double length = 0;
    constexpr int kSteps = 140;
    for (int step = 0; step < kSteps; ++step) {
      const SurfaceWalk walk = walk_on(surface, path.points.back(), direction, 0.05 * edge);
      direction = walk.direction;
      path.points.insert(path.points.end(), walk.points.begin() + 1, walk.points.end());
      const Cut cut = cut_well(surface, path);
      length += cut.length;
      if (cut.lips.empty()) continue;
      ASSERT_TRUE(cut.tip);
      path.from = cut.tip;
      path.points = cut.rest;
      if (path.points.empty()) path.points = {nearest_point(surface.mesh(), surface.mesh().vertices[*cut.tip])};
    }
    EXPECT_NEAR(length, kSteps * 0.05 * edge, 1.2 * edge);
    EXPECT_LT(surface.mesh().triangles.size() - mesh.triangles.size(), 80U);
    EXPECT_GE(quality_of(surface.mesh()).least_area, 0.02 * quality_of(mesh).mean_area);
  }
}

TEST(CutSurface, GoesOnFromATip) {
  CutSurface surface = sheet();
  const Cut first = cut_through(surface, {{-0.5, 0.1, 0}, {0, 0.12, 0}});
  const Cut second = cut_well(surface, {.from = first.tip, .points = points_at(surface.mesh(), {{0.5, 0.2, 0}})});
  EXPECT_EQ(second.euler_change, 0);
  EXPECT_EQ(open_loops(surface), 2);
  EXPECT_EQ(second.vertices.front().original.value_or(-1), -1);
  const bool tip_is_doubled =
      std::ranges::any_of(second.vertices, [&](const VertexSource& source) { return source.original == first.tip; });
  EXPECT_TRUE(tip_is_doubled);
}

// ---- Bad meshes, equal runs

TEST(CutSurface, KeepsSliversNoWorseThanTheyWere) {
  SurfaceMesh mesh = make_sheet(2, 2, 400);
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex.y() *= 0.2;
  CutSurface surface(mesh);
  const Cut cut = cut_through(surface, {{-0.5, -0.1, 0}, {0.5, 0.1, 0}});
  EXPECT_GT(cut.length, 0.9);
}

TEST(CutSurface, GivesTheSameMeshEachTime) {
  const auto run = [] {
    CutSurface surface(make_sphere(1, 500));
    for (const double z : {0.1, 0.4}) {
      const SurfaceWalk walk = walk_on(surface, nearest_point(surface.mesh(), {0.5, 0.5, z}), {1, -1, 0.3}, 2);
      surface.cut({.from = {}, .points = walk.points});
    }
    return surface;
  };
  const CutSurface first = run(), second = run();
  EXPECT_EQ(first.mesh().vertices, second.mesh().vertices);
  EXPECT_EQ(first.mesh().triangles, second.mesh().triangles);
}

TEST(CutSurface, ACutAlongOneEdgeWithinTheWallOpensInItsMiddle) {
  CutSurface surface(make_sphere(1, 320));
  const SurfaceMesh mesh = surface.mesh();
  double length = 0;
  CutPath path;
  path.goes_on = true;
  // The longest of all edges: a path shorter than the edges around would wait.
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3;
      const double edge = (mesh.vertices[mesh.triangles[t][next]] - mesh.vertices[mesh.triangles[t][k]]).norm();
      if (edge <= length) continue;
      length = edge;
      path.points = {{.triangle = t, .weights = Eigen::Vector3d::Unit(k)},
                     {.triangle = t, .weights = Eigen::Vector3d::Unit(next)}};
    }
  }
  const Cut cut = cut_well(surface, path);
  EXPECT_NEAR(cut.length, length, 0.05 * length);
  ASSERT_EQ(cut.lips.size(), 1U);
  EXPECT_EQ(cut.lips[0].left.size(), 3U);
}

}  // namespace
}  // namespace thinwall
