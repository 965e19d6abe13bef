#include "engine/tool/FirstContact.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/mesh/Shapes.hpp"
#include "tests/engine/tool/TestSurface.hpp"

namespace thinwall {
namespace {

TEST(FirstEntry, MeetsAFaceAtItsPlace) {
  const TestSurface cube(unit_cube());
  const auto hit = first_entry(cube.view(), {0.3, 0.4, 3}, kDown);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->travel, 2, 1e-15);
  EXPECT_LT((cube.point(hit->triangle, hit->weights) - Eigen::Vector3d(0.3, 0.4, 1)).norm(), 1e-15);
}

TEST(FirstEntry, MeetsEdgesDiagonalsAndVerticesWithoutSlippingThrough) {
  const TestSurface cube(unit_cube());
  const std::vector<Eigen::Vector2d> places = {{0.5, 0.5}, {0, 0}, {1, 1}, {1, 0}, {0, 0.5}, {0.5, 0}, {1, 0.3}};
  for (const Eigen::Vector2d& place : places) {
    const auto hit = first_entry(cube.view(), {place.x(), place.y(), 3}, kDown);
    ASSERT_TRUE(hit) << place.transpose();
    EXPECT_NEAR(hit->travel, 2, 1e-14) << place.transpose();
    EXPECT_LT((cube.point(hit->triangle, hit->weights) - Eigen::Vector3d(place.x(), place.y(), 1)).norm(), 1e-14);
  }
  // Every vertex and edge midpoint of a finer mesh, aimed at from outside along its own radius.
  const SurfaceMesh mesh = make_sphere(1, 320);
  const TestSurface sphere(mesh);
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d vertex = mesh.vertices[triangle[k]];
      const Eigen::Vector3d middle = 0.5 * (vertex + mesh.vertices[triangle[(k + 1) % 3]]);
      for (const Eigen::Vector3d& aim : {vertex, middle}) {
        const auto hit = first_entry(sphere.view(), 3 * aim, -aim.normalized());
        ASSERT_TRUE(hit);
        ASSERT_NEAR(hit->travel, 2 * aim.norm(), 1e-12);
      }
    }
  }
}

TEST(Overrun, IsByAWallThatWasAheadOfThePointAndIsBehind) {
  const TestSurface cube(unit_cube());
  const Eigen::Vector3d inside(0.3, 0.4, 0.9);
  const auto moved_from = [&](double z) {
    Eigen::VectorXd before = cube.view().position;
    for (Eigen::Index v = 0; v < before.size() / 3; ++v) before[3 * v + 2] += z;
    return before;
  };
  const auto hit = overrun_by(cube.view(), moved_from(-0.2), inside, kDown);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->travel, -0.1, 1e-15);
  EXPECT_LT((cube.point(hit->triangle, hit->weights) - Eigen::Vector3d(0.3, 0.4, 1)).norm(), 1e-15);
  EXPECT_FALSE(overrun_by(cube.view(), moved_from(-0.05), inside, kDown)) << "it was behind the point before";
  EXPECT_FALSE(overrun_by(cube.view(), moved_from(0), inside, kDown)) << "it did not move";
  EXPECT_FALSE(overrun_by(cube.view(), moved_from(-0.2), {0.3, 0.4, 1.1}, kDown)) << "it is ahead still";
  EXPECT_FALSE(overrun_by(cube.view(), moved_from(-0.2), {1.3, 0.4, 0.9}, kDown)) << "it is beside";
}

TEST(FirstEntry, GivesNothingForALineThatMisses) {
  const TestSurface cube(unit_cube());
  EXPECT_FALSE(first_entry(cube.view(), {1.001, 0.5, 3}, kDown));
  EXPECT_FALSE(first_entry(cube.view(), {5, 5, 3}, kDown));
}

TEST(FirstEntry, CountsTheOuterSideOnly) {
  // From inside the cube the line, which has no beginning, still enters at the top.
  const TestSurface cube(unit_cube());
  const auto hit = first_entry(cube.view(), {0.3, 0.4, 0.5}, kDown);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->travel, -0.5, 1e-15);
  // A single triangle seen from its inner side.
  SurfaceMesh triangle;
  triangle.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.triangles = {{0, 1, 2}};
  EXPECT_TRUE(first_entry(TestSurface(triangle).view(), {0.2, 0.2, 1}, kDown));
  EXPECT_FALSE(first_entry(TestSurface(triangle).view(), {0.2, 0.2, -1}, -kDown));
}

TEST(FirstEntry, TakesBothSidesOfAnOpenSheet) {
  const TestSurface sheet(make_sheet(2, 2, 50), true);
  const auto above = first_entry(sheet.view(), {0.1, 0.2, 1}, kDown),
             below = first_entry(sheet.view(), {0.1, 0.2, -1}, -kDown);
  ASSERT_TRUE(above && below);
  EXPECT_NEAR(above->travel, 1, 1e-15);
  EXPECT_NEAR(below->travel, 1, 1e-15);
}

TEST(FirstEntry, ParallelLineInThePlaneOfAFaceIsNoEntry) {
  SurfaceMesh triangle;
  triangle.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.triangles = {{0, 1, 2}};
  EXPECT_FALSE(first_entry(TestSurface(triangle).view(), {-1, 0.2, 0}, Eigen::Vector3d::UnitX()));
}

TEST(FirstEntryOnSegment, ReachesFromItsBeginToItsEndAndNoFarther) {
  const TestSurface cube(unit_cube());
  const auto to = [&](double begin, double end) {
    return first_entry_on_segment(cube.view(), {0.3, 0.4, begin}, {0.3, 0.4, end});
  };
  ASSERT_TRUE(to(3, 0.5));
  EXPECT_NEAR(to(3, 0.5)->travel, 2, 1e-15);
  EXPECT_TRUE(to(3, 1));       // the end counts
  EXPECT_TRUE(to(1, 0.5));     // so does the beginning
  EXPECT_FALSE(to(3, 1.001));  // not there yet
  EXPECT_FALSE(to(0.9, 0.5));  // begins inside
  EXPECT_FALSE(to(0.5, 3));    // leaves
  EXPECT_FALSE(to(3, 3));      // stands still
}

TEST(NearestEntryOnSegment, IsThatOfTheLobeAtThePlaceAndNoOtherOnTheWay) {
  SurfaceMesh lobes = unit_cube();
  const auto count = static_cast<int>(lobes.vertices.size());
  for (const Eigen::Vector3d& vertex : unit_cube().vertices)
    lobes.vertices.push_back(vertex + Eigen::Vector3d(0, 0, 3));
  for (const Eigen::Vector3i& triangle : unit_cube().triangles) lobes.triangles.push_back(triangle.array() + count);
  const TestSurface surface(lobes);
  const Eigen::Vector3d begin(0.3, 0.4, 6), end(0.3, 0.4, 0.5);
  const auto travel_near = [&](double height) {
    return nearest_entry_on_segment(surface.view(), begin, end, {0, 0, height})->travel;
  };
  EXPECT_NEAR(travel_near(0.5), 5, 1e-15);
  EXPECT_NEAR(travel_near(2.4), 5, 1e-15);
  EXPECT_NEAR(travel_near(2.6), 2, 1e-15);
  EXPECT_NEAR(travel_near(9), 2, 1e-15);
  EXPECT_NEAR(first_entry_on_segment(surface.view(), begin, end)->travel, 2, 1e-15);
}

TEST(FirstEntryOnSegment, StepsThatMeetWithinRoundOffOfTheSurfaceDoNotLetTheToolThrough) {
  // Whichever step ends at the surface, it or the next one must see it.
  const SurfaceMesh mesh = make_sphere(1, 320);
  const TestSurface sphere(mesh);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const double part = 0.001 * static_cast<double>(t);
    const Eigen::Vector3d middle = sphere.point(static_cast<int>(t), {0.3 + part, 0.5 - part, 0.2});
    const Eigen::Vector3d motion = -middle + 0.3 * Eigen::Vector3d(part, 0.5, -part);
    EXPECT_TRUE(first_entry_on_segment(sphere.view(), middle - 0.7 * motion, middle) ||
                first_entry_on_segment(sphere.view(), middle, middle + 0.3 * motion))
        << t;
  }
}

const ToolDefinition kSphere{.name = "ball", .kind = ToolKind::kSphere, .length = 0, .radius = 0.25};

std::optional<double> sphere_travel(const TestSurface& surface, const Eigen::Vector3d& tip,
                                    const Eigen::Vector3d& motion) {
  return travel_to_contact(surface.view(), kSphere, {.tip = tip, .direction = kDown, .axis = Eigen::Vector3d::UnitY()},
                           motion);
}

TEST(TravelToContact, OfAPointIsItsFirstEntry) {
  const TestSurface cube(unit_cube());
  const ToolDefinition point{.name = "tip", .kind = ToolKind::kPoint, .length = 0, .radius = 0};
  const auto travel = travel_to_contact(cube.view(), point, {.tip = {0.3, 0.4, 3}}, kDown);
  ASSERT_TRUE(travel);
  EXPECT_NEAR(*travel, 2, 1e-15);
}

TEST(TravelToContact, OfASphereOntoAPlaneEndsWithItsLowestPoint) {
  // The tip is the lowest point of a sphere that points down.
  const TestSurface cube(unit_cube());
  const auto straight = sphere_travel(cube, {0.5, 0.5, 3}, kDown);
  ASSERT_TRUE(straight);
  EXPECT_NEAR(*straight, 2, 1e-15);
  // Slanting: the centre must come down by 2, on a way that falls 0.8 per length.
  const auto slanting = sphere_travel(cube, {-1.2, 0.5, 3}, Eigen::Vector3d(0.6, 0, -0.8));
  ASSERT_TRUE(slanting);
  EXPECT_NEAR(*slanting, 2 / 0.8, 1e-14);
}

TEST(TravelToContact, OfASphereOntoAnEdgeEndsAtItsRadiusFromTheEdge) {
  // Centre 0.15 beyond the edge: it stops sqrt(0.25^2 - 0.15^2) = 0.2 above; its tip is then 0.05 below the top.
  const TestSurface cube(unit_cube());
  const auto travel = sphere_travel(cube, {1.15, 0.5, 3}, kDown);
  ASSERT_TRUE(travel);
  EXPECT_NEAR(*travel, 2.05, 1e-14);
  EXPECT_FALSE(sphere_travel(cube, {1.2501, 0.5, 3}, kDown));
  EXPECT_TRUE(sphere_travel(cube, {1.2499, 0.5, 3}, kDown));
}

TEST(TravelToContact, OfASphereOntoACornerEndsAtItsRadiusFromTheCorner) {
  // Beyond the corner by (0.12, 0.09), 0.15 away: again 0.2 above.
  const TestSurface cube(unit_cube());
  const auto travel = sphere_travel(cube, {1.12, 1.09, 3}, kDown);
  ASSERT_TRUE(travel);
  EXPECT_NEAR(*travel, 2.05, 1e-14);
  EXPECT_FALSE(sphere_travel(cube, {1.18, 1.18, 3}, kDown));  // 0.2546 from the corner, though 0.18 from each edge
}

TEST(TravelToContact, OfASphereTouchingAlreadyIsZeroOrLess) {
  const TestSurface cube(unit_cube());
  const auto touching = sphere_travel(cube, {0.5, 0.5, 1}, kDown),
             overlapping = sphere_travel(cube, {0.5, 0.5, 0.9}, kDown);
  ASSERT_TRUE(touching && overlapping);
  EXPECT_NEAR(*touching, 0, 1e-15);
  EXPECT_NEAR(*overlapping, -0.1, 1e-15);
}

TEST(TravelToContact, OfASphereOntoASheetFromEitherSideIsTheSame) {
  const TestSurface sheet(make_sheet(2, 2, 50), true);
  const auto above = sphere_travel(sheet, {0.1, 0.2, 1}, kDown);
  ASSERT_TRUE(above);
  EXPECT_NEAR(*above, 1, 1e-14);
  const auto below = travel_to_contact(
      sheet.view(), kSphere, {.tip = {0.1, 0.2, -1}, .direction = -kDown, .axis = Eigen::Vector3d::UnitY()}, -kDown);
  ASSERT_TRUE(below);
  EXPECT_NEAR(*below, 1, 1e-14);
}

TEST(TravelToContact, OfASphereOntoARoundMeshLiesBetweenItsInscribedAndCircumscribedSpheres) {
  const SurfaceMesh mesh = make_sphere(1, 320);
  const TestSurface sphere(mesh);
  double inradius = 1;
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    const Eigen::Vector3d &a = mesh.vertices[triangle[0]], &b = mesh.vertices[triangle[1]],
                          &c = mesh.vertices[triangle[2]];
    inradius = std::min(inradius, (b - a).cross(c - a).normalized().dot(a));
  }
  for (int k = 0; k <= 20; ++k) {
    const Eigen::Vector3d tip(0.061 * k, 0.013 * k, 3);
    const auto travel = sphere_travel(sphere, tip, kDown);
    const double offset = std::hypot(tip.x(), tip.y());
    // The polyhedron lies between its inscribed and its circumscribed sphere.
    if (offset > 1.25) {
      EXPECT_FALSE(travel) << k;
      continue;
    }
    if (offset > inradius + 0.25) continue;
    ASSERT_TRUE(travel) << k;
    const double center = tip.z() + 0.25 - *travel;
    const double outer = std::sqrt(1.25 * 1.25 - offset * offset),
                 inner = std::sqrt((inradius + 0.25) * (inradius + 0.25) - offset * offset);
    EXPECT_LE(center, outer + 1e-12) << k;
    EXPECT_GE(center, inner - 1e-12) << k;
  }
}

}  // namespace
}  // namespace thinwall
