// Paths that are traced, cut by the kernel and traced across the cuts again.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "engine/cutting/CarriedPoints.hpp"
#include "engine/cutting/CutSurface.hpp"
#include "engine/cutting/SurfacePath.hpp"
#include "engine/mesh/Shapes.hpp"
#include "tests/engine/cutting/CurveChecks.hpp"
#include "tests/engine/tool/TestSurface.hpp"

namespace thinwall {
namespace {

Eigen::Vector3d place_of(const SurfaceMesh& mesh, const SurfacePoint& point) {
  const TestSurface surface(mesh);
  return position_of(surface.view(), point);
}

/// Cuts the path through points, piece by piece; returns over how many gaps it went.
int cut_through(CutSurface& wall, const std::vector<Eigen::Vector3d>& points, bool open) {
  const TestSurface start(wall.mesh(), open);
  PathResult found = surface_path(start.view(), points, {}, 1);
  int gaps = -1;
  while (!found.problem && !found.path.pieces.empty()) {
    const std::vector<SurfaceCurve> pieces = found.path.pieces;
    const SurfaceMesh before = wall.mesh();
    const TestSurface surface(before, open);
    for (const SurfaceCurve& piece : pieces) expect_connected(surface.view(), piece, 1e-12);
    ++gaps;
    std::vector<SurfacePoint> ahead;
    for (std::size_t k = 1; k < pieces.size(); ++k) {
      ahead.insert(ahead.end(), pieces[k].points.begin(), pieces[k].points.end());
    }
    const Cut cut = pieces[0].points.size() < 2 ? Cut{} : wall.cut({.from = {}, .points = pieces[0].points});
    const std::vector<SurfacePoint> carried = carried_over(ahead, before, wall.mesh(), cut);
    for (std::size_t k = 0; k < carried.size(); ++k) {
      EXPECT_LT((place_of(wall.mesh(), carried[k]) - place_of(before, ahead[k])).norm(), 1e-12);
    }
    const TestSurface now(wall.mesh(), open);
    found = path_through(now.view(), carried);
  }
  EXPECT_FALSE(found.problem) << static_cast<int>(found.problem->kind);
  return gaps;
}

TEST(CutAlongPath, PathsCrossTheCutsOfEarlierOnes) {
  int crossings = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform(-0.8, 0.8);
    const bool open = seed % 2 == 0;
    CutSurface wall(open ? make_sheet(2, 2, 300) : make_sphere(1, 720));
    const auto any_point = [&]() -> Eigen::Vector3d {
      const Eigen::Vector3d point(uniform(random), uniform(random), 0);
      return open ? point : Eigen::Vector3d(point.x(), point.y(), std::sqrt(std::max(0.0, 1 - point.squaredNorm())));
    };
    for (int incision = 0; incision < 5; ++incision) {
      crossings += cut_through(wall, {any_point(), any_point(), any_point()}, open);
    }
  }
  EXPECT_GT(crossings, 100);
}

TEST(CutAlongPath, WhatLiesAheadIsCarriedOverAndCutLater) {
  for (const bool flat : {true, false}) {
    SCOPED_TRACE(flat);
    CutSurface wall(flat ? make_sheet(2, 2, 300) : make_sphere(1, 1280));
    const TestSurface surface(wall.mesh(), flat);
    const std::vector<Eigen::Vector3d> points = {
        {-0.7, -0.3, flat ? 0 : 0.65}, {0.1, 0.2, flat ? 0 : 0.97}, {0.5, -0.4, flat ? 0 : 0.77}};
    const PathResult found = surface_path(surface.view(), points, {}, 1);
    ASSERT_FALSE(found.problem);
    ASSERT_EQ(found.path.pieces.size(), 1U);
    std::vector<SurfacePoint> ahead = found.path.pieces[0].points;
    const std::vector<Eigen::Vector3d> places = [&] {
      std::vector<Eigen::Vector3d> all;
      for (const SurfacePoint& point : ahead) all.push_back(place_of(wall.mesh(), point));
      return all;
    }();
    CutPath next;
    double length = 0, deviation = 0;
    while (!ahead.empty()) {
      const std::size_t count = std::min<std::size_t>(3, ahead.size());
      next.points.insert(next.points.end(), ahead.begin(), ahead.begin() + static_cast<std::ptrdiff_t>(count));
      ahead.erase(ahead.begin(), ahead.begin() + static_cast<std::ptrdiff_t>(count));
      const SurfaceMesh before = wall.mesh();
      const Cut cut = wall.cut(next);
      ahead = carried_over(ahead, before, wall.mesh(), cut);
      for (std::size_t k = 0; k < ahead.size(); ++k) {
        EXPECT_LT((place_of(wall.mesh(), ahead[k]) - places[places.size() - ahead.size() + k]).norm(), 1e-12);
      }
      length += cut.length;
      deviation = std::max(deviation, cut.deviation);
      next = {.from = cut.tip ? cut.tip : next.from, .points = cut.rest};
    }
    // Snapping moves nodes by less than an edge, which is 0.13 and 0.09 here.
    EXPECT_NEAR(length, found.path.length(), 0.1);
    EXPECT_LT(deviation, 0.13);
  }
}

TEST(CutAlongPath, ABladeThatGoesOnByTinyStepsLeavesItsPathByAFifthOfAnEdge) {
  for (int k = 0; k < 12; ++k) {
    SCOPED_TRACE(k);
    const double angle = 0.07 + 0.5 * k;
    const Eigen::Vector3d along(std::cos(angle), std::sin(angle), 0), across(-along.y(), along.x(), 0);
    CutSurface wall(make_sheet(2, 2, 300));  // edges of 0.13
    const Eigen::Vector3d begin = -0.5 * along + 0.03 * k * across;
    CutPath next;
    double farthest = 0, length = 0;
    for (double travel = 0.01; travel < 1; travel += 0.01) {
      const TestSurface now(wall.mesh(), true);
      const auto below = [&](const Eigen::Vector3d& point) { return *project(now.view(), point, {}, 1).point; };
      const SurfacePoint from = next.from ? below(wall.mesh().vertices[*next.from]) : below(begin);
      const SurfaceTrace way = trace(now.view(), from, below(begin + travel * along));
      const Cut cut = wall.cut({.from = next.from, .points = way.pieces.front().points, .goes_on = true});
      if (cut.tip) next.from = cut.tip;
      length += cut.length;
      for (const Lips& lips : cut.lips) {
        for (const int vertex : lips.left) {
          farthest = std::max(farthest, std::abs((wall.mesh().vertices[vertex] - begin).dot(across)));
        }
      }
    }
    EXPECT_LT(farthest, 0.2 * 0.13);
    EXPECT_NEAR(length, 1, 0.13);
  }
}

TEST(CutAlongPath, ABladeThatGoesOnByTinyStepsCrossesAnEarlierCut) {
  for (int k = 0; k < 12; ++k) {
    SCOPED_TRACE(k);
    CutSurface wall(make_sheet(2, 2, 300));  // edges of 0.13
    cut_through(wall, {{-0.7, 0.02 * k, 0}, {0.7, 0.01 * k, 0}}, true);
    const double angle = 0.8 + 0.13 * k;
    const Eigen::Vector3d along(std::cos(angle), std::sin(angle), 0);
    const Eigen::Vector3d begin = -0.5 * along + Eigen::Vector3d(0.02 * k, 0, 0);
    std::optional<int> tip;
    std::optional<Eigen::Vector3d> start = begin;
    double length = 0;
    int joined = 0;
    for (double travel = 0.01; travel < 1; travel += 0.01) {
      const TestSurface now(wall.mesh(), true);
      const auto below = [&](const Eigen::Vector3d& point) { return *project(now.view(), point, {}, 1).point; };
      const Eigen::Vector3d place = begin + travel * along;
      if (!tip && !start) start = place;
      const SurfacePoint from = tip ? below(wall.mesh().vertices[*tip]) : below(*start);
      const SurfaceTrace way = trace(now.view(), from, below(place));
      if (way.pieces.empty()) continue;
      const Cut cut = wall.cut({.from = tip, .points = way.pieces.front().points, .goes_on = true});
      if (cut.triangles.empty()) continue;
      length += cut.length;
      tip = cut.tip;
      start.reset();
      joined += cut.tip ? 0 : 1;
    }
    std::printf("joined %d, length %.3f\n", joined, length);
    EXPECT_EQ(joined, 1);
    EXPECT_NEAR(length, 1, 0.13);
  }
}

}  // namespace
}  // namespace thinwall
