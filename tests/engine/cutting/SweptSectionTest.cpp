#include "engine/cutting/SweptSection.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <random>

#include "engine/contact/ClosestPoint.hpp"
#include "engine/cutting/ExactGrid.hpp"
#include "engine/mesh/Shapes.hpp"
#include "tests/engine/cutting/CurveChecks.hpp"
#include "tests/engine/cutting/SlitMeshes.hpp"
#include "tests/engine/tool/TestSurface.hpp"

namespace thinwall {
namespace {

/// A blade that stands upright, from 10 mm below z = 0 to 10 mm above it, in the plane z = 0 at `x`, `y`.
BladeEdge upright(double x, double y) {
  return {.begin = {x, y, -0.01}, .end = {x, y, 0.01}};
}

double distance_to(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                   const Eigen::Vector3d& point) {
  if ((b - a).cross(c - a).norm() == 0) return std::numeric_limits<double>::infinity();
  const std::array<Eigen::Vector3d, 3> corners = {a, b, c};
  const Eigen::Vector3d weights = closest_point(corners, point).weights;
  return (weights[0] * a + weights[1] * b + weights[2] * c - point).norm();
}

/// That curves hold together, run along the motion and lie on the swept surface to within `within` metres.
void expect_swept(const SurfaceView& surface, const std::vector<SweptCurve>& curves, const BladeEdge& first,
                  const BladeEdge& last, double within) {
  for (const SweptCurve& swept : curves) {
    expect_connected(surface, swept.curve, -1);
    ASSERT_EQ(swept.motion.size(), swept.curve.points.size());
    ASSERT_EQ(swept.along.size(), swept.curve.points.size());
    EXPECT_LE(swept.motion.front(), swept.motion.back());
    for (std::size_t k = 0; k < swept.motion.size(); ++k) {
      EXPECT_TRUE(swept.motion[k] >= 0 && swept.motion[k] <= 1 + 1e-15 && swept.along[k] >= 0 &&
                  swept.along[k] <= 1 + 1e-15);
      const Eigen::Vector3d position = position_of(surface, swept.curve.points[k]);
      EXPECT_LE(std::min(distance_to(first.begin, first.end, last.end, position),
                         distance_to(first.begin, last.end, last.begin, position)),
                within);
    }
  }
}

TEST(SweptSection, OfASheetIsTheLineThatTheBladeDraws) {
  const TestSurface sheet(make_sheet(0.04, 0.04, 400), true);
  const BladeEdge first = upright(-0.0113, 0.0041), last = upright(0.0087, -0.0067);
  const auto curves = swept_section(sheet.view(), first, last);
  ASSERT_EQ(curves.size(), 1U);
  expect_swept(sheet.view(), curves, first, last, 1e-13);
  EXPECT_NEAR(length_of(sheet.view(), curves[0].curve), std::hypot(0.02, 0.0108), 1e-13);
  const Eigen::Vector3d begin = position_of(sheet.view(), curves[0].curve.points.front());
  EXPECT_LT((begin - Eigen::Vector3d(-0.0113, 0.0041, 0)).norm(), 1e-13);
  EXPECT_EQ(curves[0].motion.front(), 0);
  EXPECT_EQ(curves[0].motion.back(), 1);
  for (const double along : curves[0].along) EXPECT_NEAR(along, 0.5, 1e-11);
  for (std::size_t k = 1; k < curves[0].motion.size(); ++k) EXPECT_GE(curves[0].motion[k], curves[0].motion[k - 1]);
}

TEST(SweptSection, OfASphereIsAnArcOfACircle) {
  const double radius = 0.02, depth = 0.004;
  const TestSurface sphere(make_sphere(radius, 5120));
  // A wide blade, its edge along x, that is pressed in from above along y = 3 mm.
  const BladeEdge first{.begin = {-0.03, 0.003, 0.03}, .end = {0.03, 0.003, 0.03}};
  const BladeEdge last{.begin = {-0.03, 0.003, radius - depth}, .end = {0.03, 0.003, radius - depth}};
  const auto curves = swept_section(sphere.view(), first, last);
  ASSERT_EQ(curves.size(), 1U);
  expect_swept(sphere.view(), curves, first, last, 1e-12 * 0.06);
  const double circle = std::sqrt(radius * radius - 9e-6), angle = 2 * std::acos((radius - depth) / circle);
  EXPECT_NEAR(length_of(sphere.view(), curves[0].curve), circle * angle, 5e-3 * circle * angle);
  EXPECT_NEAR(curves[0].motion.front(), 1, 1e-12) << "both ends are where the edge comes to rest";
}

TEST(SweptSection, GoesThroughBothWallsOfAFold) {
  SurfaceMesh mesh = make_sheet(0.04, 0.04, 400), lower = mesh;
  for (Eigen::Vector3d& vertex : lower.vertices) vertex.z() -= 1e-4;
  add_mesh(lower, mesh);
  const TestSurface fold(mesh, true);
  const BladeEdge first = upright(-0.01, 0.001), last = upright(0.01, 0.002);
  const auto curves = swept_section(fold.view(), first, last);
  ASSERT_EQ(curves.size(), 2U);
  for (const SweptCurve& swept : curves) {
    EXPECT_NEAR(length_of(fold.view(), swept.curve), std::hypot(0.02, 0.001), 1e-13);
  }
  EXPECT_NEAR(curves[1].along.front() - curves[0].along.front(), 0.005, 1e-9) << "the lower one lies nearer to `begin`";
}

TEST(SweptSection, FollowsRowsOfVerticesOnThem) {
  const TestSurface sheet(make_sheet(0.04, 0.04, 400), true);
  const BladeEdge first = upright(0, -0.0131), last = upright(0, 0.0117);
  const auto curves = swept_section(sheet.view(), first, last);
  ASSERT_EQ(curves.size(), 1U);
  expect_swept(sheet.view(), curves, first, last, 1e-13);
  EXPECT_NEAR(length_of(sheet.view(), curves[0].curve), 0.0248, 1e-13) << "without changing sides";
}

TEST(SweptSection, BeginsAndEndsAtBordersAndWounds) {
  const TestSurface sheet(slit_sheet(1e-3), true);
  const BladeEdge first = upright(-0.03, 0), last = upright(0.03, 0.001);
  const auto curves = swept_section(sheet.view(), first, last);
  ASSERT_EQ(curves.size(), 2U);
  expect_swept(sheet.view(), curves, first, last, 1e-13);
  for (const SweptCurve& swept : curves) {
    EXPECT_TRUE(is_on_border(sheet.view(), swept.curve.points.front()));
    EXPECT_TRUE(is_on_border(sheet.view(), swept.curve.points.back()));
  }
  EXPECT_LT(curves[0].motion.back(), curves[1].motion.front());
}

TEST(SweptSection, OfNoMotionOrOfOneAlongTheEdgeIsNothing) {
  const TestSurface sheet(make_sheet(0.04, 0.04, 400), true);
  const BladeEdge edge = upright(0.001, 0.002);
  EXPECT_TRUE(swept_section(sheet.view(), edge, edge).empty());
  BladeEdge deeper = edge;
  deeper.begin.z() -= 0.003;
  deeper.end.z() -= 0.003;
  EXPECT_TRUE(swept_section(sheet.view(), edge, deeper).empty());
  const BladeEdge oblique{.begin = {0.0013, 0.0007, -0.01}, .end = {0.0024, 0.0031, 0.01}};
  const Eigen::Vector3d slide = 0.13 * (oblique.end - oblique.begin);
  EXPECT_TRUE(
      swept_section(sheet.view(), oblique, {.begin = oblique.begin + slide, .end = oblique.end + slide}).empty());
}

TEST(SweptSection, ABladeThatGrazesAlongTheWallMeetsNothing) {
  const TestSurface sheet(make_sheet(0.04, 0.04, 400), true);
  const BladeEdge first{.begin = {-0.01, -0.005, 0}, .end = {-0.01, 0.005, 0}};
  const BladeEdge last{.begin = {0.01, -0.005, 0}, .end = {0.01, 0.005, 0}};
  EXPECT_TRUE(swept_section(sheet.view(), first, last).empty());
}

TEST(SweptSection, ABladeThatTurnsAboutItsEndDrawsOneCurve) {
  const TestSurface sheet(make_sheet(0.04, 0.04, 400), true);
  const BladeEdge first{.begin = {0, 0, 0.005}, .end = {-0.01, 0.002, -0.008}};
  const BladeEdge last{.begin = {0, 0, 0.005}, .end = {0.01, 0.001, -0.008}};
  const auto curves = swept_section(sheet.view(), first, last);
  ASSERT_EQ(curves.size(), 1U);
  expect_swept(sheet.view(), curves, first, last, 1e-13);
}

TEST(SweptSection, OfAStepGoesOnWhereThatOfTheStepBeforeEnded) {
  const TestSurface sphere(make_sphere(0.02, 5120));
  std::optional<Eigen::Vector3d> end;
  for (int step = 0; step < 40; ++step) {
    const auto edge = [](int k) {
      const double angle = 0.03 * k;
      const Eigen::Vector3d outward(std::sin(angle), 0.3 * std::sin(2 * angle), std::cos(angle));
      return BladeEdge{.begin = 0.017 * outward.normalized(), .end = 0.03 * outward.normalized()};
    };
    const auto curves = swept_section(sphere.view(), edge(step), edge(step + 1));
    ASSERT_EQ(curves.size(), 1U) << step;
    const Eigen::Vector3d begin = position_of(sphere.view(), curves[0].curve.points.front());
    EXPECT_LT((begin - end.value_or(begin)).norm(), 1e-13);
    end = position_of(sphere.view(), curves[0].curve.points.back());
  }
}

TEST(SweptSection, RandomSweepsThroughGeneralAndDegeneratePlacesHoldTogether) {
  static const TestSurface sphere(make_sphere(0.02, 1280)), sheet(make_sheet(0.04, 0.04, 400), true),
      tube(slit_sheet(5e-4, true), true), cube(unit_cube());
  int met = 0;
  for (std::uint64_t seed = 1; seed <= 1200; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const TestSurface* surfaces[] = {&sphere, &sheet, &tube, &cube};
    const SurfaceView view = surfaces[seed % 4]->view();
    const double size = scale_of(view);
    std::uniform_real_distribution<double> uniform(-1.2 * size, 1.2 * size);
    // Ends of the edge lie anywhere, on vertices, between vertices, or one over another.
    const auto vertex = [&]() -> Eigen::Vector3d {
      return view.position.segment<3>(3 * static_cast<Eigen::Index>(random() % (view.position.size() / 3)));
    };
    const auto corner = [&]() -> Eigen::Vector3d {
      switch (random() % 4) {
        case 0:
          return vertex();
        case 1:
          return 0.5 * (vertex() + vertex());
        default:
          return {uniform(random), uniform(random), uniform(random)};
      }
    };
    const BladeEdge first{.begin = corner(), .end = corner()};
    BladeEdge last{.begin = corner(), .end = corner()};
    if (random() % 5 == 0) last.begin = first.begin;
    if (random() % 5 == 0) last.end = last.begin + first.end - first.begin;
    const auto curves = swept_section(view, first, last);
    met += curves.empty() ? 0 : 1;
    expect_swept(view, curves, first, last, 3e-12 * 2.4 * size);
    // Away from the swept surface's own border a curve ends at that of the wall only.
    for (const SweptCurve& swept : curves) {
      if (swept.curve.closed) continue;
      for (const std::size_t k : {std::size_t{0}, swept.motion.size() - 1}) {
        const double inside = std::min({swept.motion[k], 1 - swept.motion[k], swept.along[k], 1 - swept.along[k]});
        EXPECT_TRUE(inside < 1e-9 || is_on_border(view, swept.curve.points[k])) << inside;
      }
    }
  }
  EXPECT_GT(met, 600);
}

TEST(ExactGrid, VolumesAreExactToTheLastUnit) {
  const ExactGrid grid({-1, -1, -1}, {1, 1, 1});
  const std::int64_t far = std::int64_t{1} << 39;
  const GridPoint a = {-far, -far, -far}, b = {far, -far, -far}, c = {-far, far, -far};
  EXPECT_EQ(grid.at({1, 0, -0.5}), (GridPoint{far / 2, 0, -far / 4}));
  WideInteger side = far;
  side *= 2;
  EXPECT_TRUE(volume(a, b, c, {-far, -far, far}) == side * side * side);
  EXPECT_TRUE(volume(a, b, c, {-far, -far, -far + 1}) == side * side) << "one unit above the plane";
  EXPECT_TRUE(volume(a, b, c, {far, far, -far}) == 0);
  EXPECT_EQ(sign_of(volume(b, a, c, {0, 0, 0})), -1);
}

}  // namespace
}  // namespace thinwall
