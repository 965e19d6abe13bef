#include "engine/cutting/SurfaceTrace.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "engine/cutting/SurfaceNormals.hpp"
#include "engine/cutting/SurfacePath.hpp"
#include "engine/mesh/Shapes.hpp"
#include "tests/engine/cutting/CurveChecks.hpp"
#include "tests/engine/cutting/SlitMeshes.hpp"
#include "tests/engine/tool/TestSurface.hpp"

namespace thinwall {
namespace {

/// The way between the points of a surface nearest to two points; held to be whole.
std::vector<SurfaceCurve> way_between(const SurfaceView& surface, const Eigen::Vector3d& from,
                                      const Eigen::Vector3d& to) {
  const SurfacePoint begin = *project(surface, from, {}, 1).point, end = *project(surface, to, {}, 1).point;
  const SurfaceTrace found = trace(surface, begin, end);
  EXPECT_EQ(found.refusal, TraceRefusal::kNone);
  for (const SurfaceCurve& piece : found.pieces) expect_connected(surface, piece, 1e-12 * scale_of(surface));
  if (!found.pieces.empty()) {
    const SurfacePoint &first = found.pieces.front().points.front(), &last = found.pieces.back().points.back();
    EXPECT_LT((position_of(surface, first) - position_of(surface, begin)).norm(), 1e-15);
    EXPECT_LT((position_of(surface, last) - position_of(surface, end)).norm(), 1e-15);
  }
  return found.pieces;
}

TEST(SurfaceTrace, OnASheetIsTheStraightLine) {
  const TestSurface sheet(make_sheet(0.04, 0.04, 400), true);
  const Eigen::Vector3d from(-0.0131, 0.0072, 0), to(0.0149, -0.0117, 0);
  const auto pieces = way_between(sheet.view(), from, to);
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_NEAR(length_of(sheet.view(), pieces[0]), (to - from).norm(), 1e-15);
  EXPECT_GT(pieces[0].points.size(), 10U);
}

TEST(SurfaceTrace, OfTwoPointsInOneTriangleIsTheSegmentBetweenThem) {
  const TestSurface sheet(make_sheet(0.04, 0.04, 4), true);
  const auto pieces = way_between(sheet.view(), {0.001, 0.001, 0}, {0.002, 0.0012, 0});
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_EQ(pieces[0].points.size(), 2U);
}

TEST(SurfaceTrace, OfAPointToItselfIsThePointAlone) {
  const TestSurface sheet(make_sheet(0.04, 0.04, 400), true);
  const auto pieces = way_between(sheet.view(), {0.001, 0.001, 0}, {0.001, 0.001, 0.004});
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_EQ(pieces[0].points.size(), 1U);
}

TEST(SurfaceTrace, FollowsRowsOfVerticesAndBorders) {
  const TestSurface sheet(make_sheet(0.04, 0.04, 400), true);
  for (const double x : {-0.02, 0.0, 0.02}) {
    for (const double end : {0.02, 0.0137}) {
      const auto pieces = way_between(sheet.view(), {x, -0.02, 0}, {x, end, 0});
      ASSERT_EQ(pieces.size(), 1U) << x;
      EXPECT_NEAR(length_of(sheet.view(), pieces[0]), end + 0.02, 1e-15) << x;
      for (const SurfacePoint& point : pieces[0].points) {
        EXPECT_NEAR(position_of(sheet.view(), point).x(), x, 1e-16);
      }
    }
  }
  const auto diagonal = way_between(sheet.view(), {-0.02, -0.02, 0}, {0.02, 0.02, 0});
  ASSERT_EQ(diagonal.size(), 1U);
  EXPECT_NEAR(length_of(sheet.view(), diagonal[0]), 0.04 * std::numbers::sqrt2, 1e-15);
}

TEST(SurfaceTrace, OnASphereIsTheShorterArcOfTheGreatCircle) {
  const TestSurface sphere(make_sphere(0.02, 5120));
  const Eigen::Vector3d from = 0.02 * Eigen::Vector3d(1, 0.2, 0.1).normalized();
  const Eigen::Vector3d to = 0.02 * Eigen::Vector3d(-0.6, 0.7, 0.5).normalized();
  const auto pieces = way_between(sphere.view(), from, to);
  ASSERT_EQ(pieces.size(), 1U);
  const double angle = std::acos(from.dot(to) / (0.02 * 0.02));
  EXPECT_NEAR(length_of(sphere.view(), pieces[0]), 0.02 * angle, 2e-3 * 0.02 * angle);
  // The mean of the mesh's normals leans from the mean of the sphere's by what their interpolation leaves.
  const Eigen::Vector3d across = from.cross(to).normalized();
  for (const SurfacePoint& point : pieces[0].points) {
    EXPECT_NEAR(across.dot(position_of(sphere.view(), point)), 0, 2e-3 * 0.02);
  }
}

TEST(SurfaceTrace, OnACylinderFollowsRulingsAndCircles) {
  const double radius = 0.01;
  const TestSurface cylinder(make_cylinder(radius, 0.05, 2400), true);
  const auto ruling = way_between(cylinder.view(), {0, -0.02, radius}, {0, 0.02, radius});
  ASSERT_EQ(ruling.size(), 1U);
  EXPECT_NEAR(length_of(cylinder.view(), ruling[0]), 0.04, 1e-14);
  const double angle = 2.1;
  const auto circle =
      way_between(cylinder.view(), {0, 0.003, radius}, {radius * std::sin(angle), 0.003, radius * std::cos(angle)});
  ASSERT_EQ(circle.size(), 1U);
  EXPECT_NEAR(length_of(cylinder.view(), circle[0]), radius * angle, 5e-3 * radius);
}

TEST(SurfaceTrace, CrossesAWoundFromLipToLip) {
  for (const double gape : {0.0, 4e-4, 3e-3, -3e-4}) {
    SCOPED_TRACE(gape);
    const TestSurface sheet(slit_sheet(gape), true);
    const Eigen::Vector3d from(-0.0131, 0.0012, 0), to(0.0149, -0.0017, 0);
    const auto pieces = way_between(sheet.view(), from, to);
    ASSERT_EQ(pieces.size(), 2U);
    EXPECT_TRUE(is_on_border(sheet.view(), pieces[0].points.back()));
    EXPECT_TRUE(is_on_border(sheet.view(), pieces[1].points.front()));
    EXPECT_LT(position_of(sheet.view(), pieces[0].points.front()).x(), 0);
    EXPECT_GT(position_of(sheet.view(), pieces[1].points.front()).x(), -0.5 * std::abs(gape) - 1e-15);
    const double length = length_of(sheet.view(), pieces[0]) + length_of(sheet.view(), pieces[1]);
    // The way is slanted to the wound by 0.1, and its lips are bent.
    EXPECT_NEAR(length, (to - from).norm() - gape, 0.05 * std::abs(gape) + 1e-15);
  }
}

TEST(SurfaceTrace, BeginsOnALipAndGoesOnAtTheOther) {
  const TestSurface sheet(slit_sheet(0), true);
  const auto away = way_between(sheet.view(), {0, 0.0011, 0}, {0.0149, -0.0017, 0});
  ASSERT_EQ(away.size(), 2U);
  EXPECT_EQ(away[0].points.size(), 1U) << "the point on the lip";
  EXPECT_NEAR(length_of(sheet.view(), away[1]), std::hypot(0.0149, 0.0028), 1e-14);
  const auto back = way_between(sheet.view(), {0, 0.0011, 0}, {-0.0149, -0.0017, 0});
  ASSERT_EQ(back.size(), 1U);
}

TEST(SurfaceTrace, FromATipAtWhichLipsMeetCrossesNoGap) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(0, 1);
  for (int k = 0; k < 200; ++k) {
    SCOPED_TRACE(k);
    const bool closed = k % 2 == 0;
    SurfaceMesh mesh = closed ? slit_sphere(2e-3 * part(random)) : slit_sheet(2e-3 * part(random));
    // The vertex nearest to the slit on its line, and a place ahead of it.
    Eigen::Vector3d tip(0, 1, 0);
    for (const Eigen::Vector3d& v : mesh.vertices) {
      if (std::abs(v.x()) < 1e-12 && v.z() > -1e-9 && v.y() > 9.9e-3 && v.y() < tip.y()) tip = v;
    }
    const double angle = 2 * (part(random) - 0.5), length = 1e-3 + 3e-3 * part(random);  // radians, metres
    const Eigen::Vector3d ahead = tip + length * Eigen::Vector3d(std::sin(angle), std::cos(angle), 0);
    // Turned, so that the ways have lengths that only rounding tells apart.
    const Eigen::AngleAxisd turn(1 + part(random), Eigen::Vector3d(1, 2, 3).normalized());
    for (Eigen::Vector3d& v : mesh.vertices) v = turn * v;
    const TestSurface surface(mesh, !closed);
    EXPECT_EQ(way_between(surface.view(), turn * tip, turn * ahead).size(), 1U);
  }
}

TEST(SurfaceTrace, PassesBesideTheEndOfAWound) {
  const TestSurface sheet(slit_sheet(4e-4), true);
  const auto pieces = way_between(sheet.view(), {-0.01, 0.0151, 0}, {0.01, 0.0151, 0});
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_NEAR(length_of(sheet.view(), pieces[0]), 0.02, 1e-15);
}

TEST(SurfaceTrace, OnAClosedBodyCrossesTheWoundRatherThanGoAround) {
  const TestSurface sphere(slit_sphere(1e-3));
  const Eigen::Vector3d from(-0.004, 0, 0.0196), to(0.005, 0, 0.0194);
  const auto pieces = way_between(sphere.view(), from, to);
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_LT(length_of(sphere.view(), pieces[0]) + length_of(sphere.view(), pieces[1]), 0.0095);
}

/// A slit mesh whose lips have been moved: the left one by `left`, the right one by `right`.
SurfaceMesh with_lips_moved(SurfaceMesh mesh, double gape, const Eigen::Vector3d& left, const Eigen::Vector3d& right) {
  for (Eigen::Vector3d& v : mesh.vertices) {
    const bool at_lip = std::abs(v.y()) < 0.0099 && v.z() > -1e-9;
    if (at_lip && std::abs(std::abs(v.x()) - 0.5 * gape * std::sqrt(1 - v.y() * v.y() / 1e-4)) < 1e-12) {
      v += v.x() < 0 ? left : right;
    }
  }
  return mesh;
}

TEST(SurfaceTrace, CrossesAWoundWithACrumpledLip) {
  // The left lip is folded back over the triangles behind it, by more than they measure.
  const TestSurface sheet(with_lips_moved(slit_sheet(2e-4), 2e-4, {-4.5e-3, 0, 1e-4}, {0, 0, 0}), true);
  const Eigen::Vector3d from(-0.0131, 0.0012, 0), to(0.0149, 0.0017, 0);
  const auto pieces = way_between(sheet.view(), from, to);
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_NEAR(position_of(sheet.view(), pieces[1].points.front()).x(), 1e-4, 1e-5);
}

TEST(SurfaceTrace, OnAClosedBodyCrossesAWoundWhoseLipsHangIn) {
  const double gape = 4e-3;
  const Eigen::Vector3d down(0, 0, -5e-3);
  const TestSurface sphere(with_lips_moved(slit_sphere(gape), gape, down, down));
  const auto pieces = way_between(sphere.view(), {-0.006, 0.0003, 0.019}, {0.007, 0.0003, 0.0187});
  ASSERT_EQ(pieces.size(), 2U);
  // Down one lip and up the other, rather than 0.11 m around.
  EXPECT_LT(length_of(sphere.view(), pieces[0]) + length_of(sphere.view(), pieces[1]), 0.03);
}

TEST(SurfaceTrace, CrossesAStripBetweenTwoWounds) {
  // Sheets side by side, a millimetre apart.
  SurfaceMesh mesh;
  for (int k = 0; k < 3; ++k) {
    SurfaceMesh sheet = make_sheet(0.01, 0.03, 60);
    for (Eigen::Vector3d& vertex : sheet.vertices) vertex += Eigen::Vector3d(0.011 * k, 0, 0);
    add_mesh(sheet, mesh);
  }
  const TestSurface sheets(mesh, true);
  const auto pieces = way_between(sheets.view(), {0, 0.001, 0}, {0.022, -0.003, 0});
  ASSERT_EQ(pieces.size(), 3U);
  const double slope = std::hypot(0.022, 0.004) / 0.022;
  EXPECT_NEAR(length_of(sheets.view(), pieces[1]), 0.01 * slope, 1e-15);
  for (const SurfacePoint& point : {pieces[1].points.front(), pieces[1].points.back()}) {
    EXPECT_TRUE(is_on_border(sheets.view(), point));
  }
}

TEST(SurfaceTrace, TellsWhyThereIsNoWay) {
  SurfaceMesh spheres = make_sphere(0.01, 320), other = make_sphere(0.01, 320);
  for (Eigen::Vector3d& vertex : other.vertices) vertex += Eigen::Vector3d(0.03, 0, 0);
  add_mesh(other, spheres);
  const TestSurface two(spheres);
  const auto point = [&](const Eigen::Vector3d& near) { return *project(two.view(), near, {}, 1).point; };
  const SurfaceTrace apart = trace(two.view(), point({0, 0.001, 0.01}), point({0.03, 0.002, 0.01}));
  EXPECT_EQ(apart.refusal, TraceRefusal::kNotJoined);
  EXPECT_TRUE(apart.pieces.empty());
  const SurfaceTrace through = trace(two.view(), point({0, 0, 0.01}), point({0, 0, -0.01}));
  EXPECT_EQ(through.refusal, TraceRefusal::kAlongNormal);
}

TEST(SurfaceTrace, RandomWaysLieInTheirPlaneAndHoldTogether) {
  int whole = 0, crossings = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const bool open = seed % 2 == 0;
    static const TestSurface sphere(make_sphere(0.02, 1280)), tube(slit_sheet(5e-4, true), true);
    const SurfaceView view = (open ? tube : sphere).view();
    const auto any_point = [&] {
      SurfacePoint point{.triangle = static_cast<int>(random() % view.triangles.size())};
      // On a face, on an edge or on a corner.
      const int corners = 1 + static_cast<int>(random() % 3);
      for (int k = 0; k < corners; ++k) point.weights[k] = 0.1 + static_cast<double>(random() % 1000);
      point.weights /= point.weights.sum();
      return point;
    };
    const SurfacePoint from = any_point(), to = any_point();
    const SurfaceTrace found = trace(view, from, to);
    if (found.refusal != TraceRefusal::kNone) continue;
    ++whole;
    const Eigen::Vector3d start = position_of(view, from), way = position_of(view, to) - start;
    const Eigen::Vector3d mean = smooth_normal(view, from) + smooth_normal(view, to);
    const Eigen::Vector3d across = way.cross(mean).normalized();
    ASSERT_FALSE(found.pieces.empty());
    for (const SurfaceCurve& piece : found.pieces) {
      expect_connected(view, piece, 1e-13 * 0.02);
      for (const SurfacePoint& point : piece.points) {
        // Over short ways the plane's normal is known less well than its points.
        EXPECT_NEAR(across.dot(position_of(view, point) - start), 0, 1e-12 * 0.04) << way.norm();
      }
    }
    EXPECT_LT((position_of(view, found.pieces.front().points.front()) - start).norm(), 1e-12 * 0.04);
    EXPECT_LT((position_of(view, found.pieces.back().points.back()) - start - way).norm(), 1e-12 * 0.04);
    for (std::size_t k = 1; k < found.pieces.size(); ++k) {
      crossings += 1;
      EXPECT_TRUE(is_on_border(view, found.pieces[k - 1].points.back()));
      EXPECT_TRUE(is_on_border(view, found.pieces[k].points.front()));
    }
  }
  EXPECT_GT(whole, 360);
  EXPECT_GT(crossings, 40);
}

}  // namespace
}  // namespace thinwall
