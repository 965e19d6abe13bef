// What cuts do to the mesh around them: caps, groups, kept vertices, refinement.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "engine/cutting/CutSurface.hpp"
#include "engine/mesh/MeshMeasures.hpp"
#include "engine/mesh/Shapes.hpp"
#include "tests/engine/cutting/CheckedCuts.hpp"
#include "tests/engine/cutting/SurfaceWalk.hpp"

namespace thinwall {
namespace {

// ---- Caps, groups, kept vertices

TEST(CutSurface, KeepsWallAndCapClosedWhereACutOpensTheRim) {
  for (const double x : {0.0, 0.13}) {  // through a vertex of the rim, through an edge
    CutSurface surface(make_hemisphere(1, 256));
    const std::size_t caps = surface.mesh().cap_triangles.size(), rim = surface.mesh().groups.at("base").size();
    const SurfaceWalk down = walk_on(surface, nearest_point(surface.mesh(), {x + 0.01, -0.5, 0.8}), {x, -1, -1}, 3);
    ASSERT_TRUE(down.at_border);
    const Cut cut = cut_well(surface, {.from = {}, .points = down.points});
    EXPECT_FALSE(cut.tip);
    EXPECT_EQ(cut.euler_change, 0);
    EXPECT_EQ(cut.wound_loops.size(), 1U);
    EXPECT_GE(surface.mesh().cap_triangles.size(), caps + 1);
    EXPECT_GE(surface.mesh().groups.at("base").size(), rim + 1);  // both lips' nodes are in it
    // And where later ones open the corners between lips and rim, on either side of which there is no cap.
    for (const int corner : {cut.lips.front().left.back(), cut.lips.front().right.back()}) {
      const auto& mesh = surface.mesh();
      const auto at = std::ranges::find_if(mesh.triangles, [&](const auto& t) { return (t.array() == corner).any(); });
      const SurfacePoint start{.triangle = static_cast<int>(at - mesh.triangles.begin()),
                               .weights = (at->array() == corner).cast<double>()};
      Eigen::Vector3d into = -3 * mesh.vertices[corner];
      for (const int vertex : *at) into += mesh.vertices[vertex];
      EXPECT_GT(cut_well(surface, {.from = {}, .points = walk_on(surface, start, into, 0.5).points}).length, 0.2);
    }
  }
}

TEST(CutSurface, SplitsTheCapWithItsRim) {
  CutSurface surface(make_hemisphere(1, 64));
  const SurfaceMesh& mesh = surface.mesh();
  const auto base = mesh.groups.at("base");
  const Eigen::Vector3d middle = 0.5 * (mesh.vertices[base[0]] + mesh.vertices[base[1]]);
  const SurfacePoint rim = nearest_point(mesh, middle);
  const SurfaceWalk up = walk_on(surface, rim, {0, 0, 1}, 0.9);
  const Cut cut = cut_well(surface, {.from = {}, .points = up.points});
  ASSERT_FALSE(cut.lips.empty());
  const auto& members = surface.mesh().groups.at("base");
  EXPECT_EQ(members.size(), base.size() + 2);  // the new node of the rim, on both lips
  EXPECT_EQ(surface.mesh().cap_triangles.size(), make_hemisphere(1, 64).cap_triangles.size() + 2);
}

TEST(CutSurface, GivesNewVerticesTheGroupsTheyLieIn) {
  SurfaceMesh mesh = make_sheet(2, 2, 400);
  for (int v = 0; v < static_cast<int>(mesh.vertices.size()); ++v) {
    if (mesh.vertices[v].x() < 0) mesh.groups["left"].push_back(v);
    if (mesh.vertices[v].y() == -1) mesh.groups["edge"].push_back(v);
  }
  CutSurface surface(mesh);
  const Cut cut = cut_through(surface, {{-0.81, -1, 0}, {-0.4, 0.1, 0}, {0.7, 0.2, 0}});
  for (const VertexSource& source : cut.vertices) {
    const Eigen::Vector3d& place = surface.mesh().vertices[source.vertex];
    const auto is_in = [&](const char* name) {
      return std::ranges::binary_search(surface.mesh().groups.at(name), source.vertex);
    };
    EXPECT_TRUE(is_in("wall"));
    EXPECT_EQ(is_in("edge"), place.y() == -1) << place.transpose();
    EXPECT_TRUE(is_in("left") || place.x() > -0.2) << place.transpose();
    EXPECT_FALSE(is_in("left") && place.x() > 0) << place.transpose();
  }
}

TEST(CutSurface, LeavesKeptVerticesWhereTheyAre) {
  const SurfaceMesh mesh = make_sheet(2, 2, 400);
  CutOptions all;
  for (int v = 0; v < static_cast<int>(mesh.vertices.size()); ++v) all.kept_vertices.push_back(v);
  CutSurface free(mesh), kept(mesh);
  const CutPath path{.from = {}, .points = points_at(mesh, {{-0.53, -0.21, 0}, {0.43, 0.3, 0}})};
  EXPECT_GT(cut_well(free, path).counts.moved_vertices, 0);
  EXPECT_EQ(cut_well(kept, path, all).counts.moved_vertices, 0);
}

TEST(CutSurface, LeavesKeptTrianglesAsTheyAre) {
  const SurfaceMesh mesh = make_sheet(2, 2, 400);
  const std::vector<Eigen::Vector3d> ends = {{-0.53, -0.21, 0}, {0.43, 0.3, 0}};
  const Eigen::Vector3d across = Eigen::Vector3d::UnitZ().cross(ends[1] - ends[0]).normalized();
  for (const double distance : {0.02, 0.04}) {  // those that an edge would be turned in, and those drawn to the path
    CutOptions beside;                          // on one side of the path, not next to it
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
      const bool is_beside = std::ranges::all_of(
          mesh.triangles[t], [&](int v) { return across.dot(mesh.vertices[v] - ends[0]) > distance; });
      if (is_beside) beside.kept_triangles.push_back(t);
    }
    const auto changed = [&](const CutSurface& surface) {
      return std::ranges::count_if(beside.kept_triangles, [&](int t) {
        for (int k = 0; k < 3; ++k) {
          const Eigen::Vector3d now = surface.mesh().vertices[surface.mesh().triangles[t][k]];
          if (now != mesh.vertices[mesh.triangles[t][k]]) return true;
        }
        return false;
      });
    };
    CutSurface free(mesh), kept(mesh);
    const CutPath path{.from = {}, .points = points_at(mesh, ends)};
    cut_well(free, path);
    EXPECT_GT(changed(free), 0);
    EXPECT_GT(cut_well(kept, path, beside).length, 0.8 * (ends[1] - ends[0]).norm());
    EXPECT_EQ(changed(kept), 0);
  }
}

// ---- Refinement

TEST(CutSurface, RefinesTheWallAlongACutAndFollowsItsPathTheCloser) {
  const SurfaceMesh mesh = make_sphere(1, 720);
  const double edge = std::sqrt(4 / std::sqrt(3.0) * wall_area(mesh) / 720);
  double last_deviation = edge;
  for (const double part : {1.0, 0.5, 0.25}) {
    CutSurface surface(mesh);
    const SurfaceWalk walk = walk_on(surface, nearest_point(mesh, {0.5, 0.5, 0.6}), {1, -1, 0.3}, 1);
    const Cut cut = cut_well(surface, {.from = {}, .points = walk.points}, {.edge_length = part * edge});
    EXPECT_LE(cut.deviation, 0.5 * part * edge);
    EXPECT_LE(cut.deviation, last_deviation);
    last_deviation = cut.deviation;
    for (const Lips& lips : cut.lips) {
      for (std::size_t i = 1; i < lips.left.size(); ++i) {
        const auto& p = surface.mesh().vertices;
        EXPECT_LE((p[lips.left[i]] - p[lips.left[i - 1]]).norm(), 1.6 * part * edge);
      }
    }
  }
}

TEST(CutSurface, FindsRoomForASlitMuchShorterThanTheEdgesOfAnIrregularWall) {
  // Refinement spreads in such a wall, because few of its triangles can be halved well.
  SurfaceMesh mesh = make_sphere(1, 720);
  const double edge = std::sqrt(4 / std::sqrt(3.0) * wall_area(mesh) / 720);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> shift(-0.2 * edge, 0.2 * edge);
  for (Eigen::Vector3d& vertex : mesh.vertices) {
    vertex += Eigen::Vector3d(shift(random), shift(random), shift(random));
    vertex = vertex.normalized().cwiseProduct(Eigen::Vector3d(1, 0.5, 0.5));
  }
  int slits = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 18) {
    CutSurface surface(mesh);
    const SurfacePoint start{.triangle = static_cast<int>(t), .weights = {0.5, 0.3, 0.2}};
    const Eigen::Vector3d to = mesh.vertices[mesh.triangles[t][1]] - mesh.vertices[mesh.triangles[t][0]];
    const SurfaceWalk walk = walk_on(surface, start, to.normalized(), edge / 4);
    const Cut cut = cut_well(surface, {.from = {}, .points = walk.points}, {.edge_length = edge / 16});
    if (cut.triangles.empty()) continue;
    ++slits;
    EXPECT_NEAR(cut.length, edge / 4, edge / 16) << t;
  }
  // Of 40; 21 where triangles are only halved or refined whole.
  EXPECT_GE(slits, 39);
}

TEST(CutSurface, RefinesOnlyWhereACutWouldLeaveItsPath) {
  const SurfaceMesh mesh = make_sphere(1, 720);
  const double edge = std::sqrt(4 / std::sqrt(3.0) * wall_area(mesh) / 720), wanted = 0.1 * edge;
  const auto cut_with = [&](const CutOptions& options, CutSurface& surface) {
    const SurfaceWalk walk = walk_on(surface, nearest_point(mesh, {0.5, 0.5, 0.6}), {1, -1, 0.3}, 1);
    return cut_well(surface, {.from = {}, .points = walk.points}, options);
  };
  CutSurface coarse(mesh), close(mesh), fine(mesh);
  EXPECT_GT(cut_with({}, coarse).deviation, wanted);
  EXPECT_LE(cut_with({.deviation = wanted}, close).deviation, wanted);
  cut_with({.edge_length = edge / 8}, fine);
  EXPECT_LT(close.mesh().triangles.size(), fine.mesh().triangles.size());
  // In a flat wall each cut is on its path anyway.
  CutSurface flat(make_sheet(2, 2, 400)), same(make_sheet(2, 2, 400));
  const CutPath path{.from = {}, .points = points_at(flat.mesh(), {{-0.53, -0.21, 0}, {0.43, 0.3, 0}})};
  cut_well(flat, path);
  cut_well(same, path, {.deviation = 1e-9});
  EXPECT_EQ(same.mesh().triangles, flat.mesh().triangles);
}

}  // namespace
}  // namespace thinwall
