#include "engine/cutting/BorderCrossing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/mesh/Shapes.hpp"

namespace thinwall {
namespace {

const Eigen::Vector3d kIntoHalves = -Eigen::Vector3d::UnitZ();

/// Two sheets of 2 by 1 side by side, 0.4 apart along y around zero, as one surface.
struct Halves {
  SurfaceMesh mesh = make_sheet(2, 1, 100);
  Eigen::VectorXd position;
  Halves() {
    const SurfaceMesh half = mesh;
    const int count = static_cast<int>(half.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), half.vertices.begin(), half.vertices.end());
    for (const Eigen::Vector3i& t : half.triangles) mesh.triangles.push_back(t.array() + count);
    position.resize(6 * count);
    for (int v = 0; v < 2 * count; ++v) {
      position.segment<3>(3 * v) = mesh.vertices[static_cast<std::size_t>(v)];
      position[3 * v + 1] += v < count ? -size() : size();
    }
  }
  static double size() { return 0.7; }
  SurfaceView view() const { return {.triangles = mesh.triangles, .position = position, .open = true}; }
  Eigen::Vector3d at(const SurfacePoint& point) const {
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
    const Eigen::Vector3i& corners = mesh.triangles[static_cast<std::size_t>(point.triangle)];
    for (int k = 0; k < 3; ++k) place += point.weights[k] * position.segment<3>(3 * corners[k]);
    return place;
  }
  double gap() const {  // half of it
    double extent = 0;
    for (const Eigen::Vector3d& vertex : mesh.vertices) extent = std::max(extent, vertex.y());
    return size() - extent;
  }
};

TEST(FirstBorder, IsTheNearSideOfAGap) {
  const Halves halves;
  const double gap = halves.gap();
  ASSERT_GT(gap, 0.1);
  const Eigen::Vector3d from(0.1, -gap - 0.3, 0), to(0.2, gap + 0.25, 0.02);
  const auto first = first_border(halves.view(), from, to, kIntoHalves);
  ASSERT_TRUE(first);
  EXPECT_NEAR(halves.at(*first).y(), -gap, 1e-12);
  EXPECT_NEAR(halves.at(*first).x(), 0.1 + 0.1 * 0.3 / (0.55 + 2 * gap), 1e-12);
  // From the near border itself only the far one counts, and none backwards.
  EXPECT_NEAR(halves.at(*first_border(halves.view(), halves.at(*first), to, kIntoHalves)).y(), gap, 1e-12);
  EXPECT_FALSE(first_border(halves.view(), from, {0.1, -gap - 0.4, 0}, kIntoHalves));
}

TEST(FirstBorder, IsTheOneWhoseWallLiesBehindWhereTheLipsOverlap) {
  Halves halves;
  const double overlap = 0.05;
  const int count = static_cast<int>(halves.mesh.vertices.size()) / 2;
  for (int v = 0; v < 2 * count; ++v) {
    halves.position[3 * v + 1] += (v < count ? 1 : -1) * (halves.gap() + 0.5 * overlap);
  }
  const auto first = first_border(halves.view(), {0.1, -0.3, 0}, {0.1, 0.3, 0}, kIntoHalves);
  ASSERT_TRUE(first);
  // Of the half that the way comes from; the other's is met before.
  EXPECT_NEAR(halves.at(*first).y(), 0.5 * overlap, 1e-12);
}

TEST(FirstBorder, LiesNoFartherThanTheWayLeadsNorAsideThanItIsLong) {
  const Halves halves;
  const double begin = -halves.gap() - 0.3, end = -halves.gap() + 0.1;  // 0.4 of way
  const auto is_met = [&](double end_of_way, double height, double rise) {
    return first_border(halves.view(), {0.1, begin, height}, {0.1, end_of_way, height + rise}, kIntoHalves).has_value();
  };
  EXPECT_TRUE(is_met(end, 0.39, 0));
  EXPECT_FALSE(is_met(end, 0.41, 0));
  EXPECT_FALSE(is_met(end, -0.41, 0));
  // Seen along the line, however far it leads along that.
  EXPECT_TRUE(is_met(end, 0, 1));
  EXPECT_FALSE(is_met(end - 0.2, 0, 1));
}

TEST(BorderBeyond, IsTheOneWhoseWallLiesAhead) {
  const Halves halves;
  const double gap = halves.gap();
  const BladeInGap blade{
      .left = {0.1, -gap, 0}, .way = Eigen::Vector3d::UnitY(), .line = kIntoHalves, .above = -0.5, .below = 0.1};
  const auto lip = border_beyond(halves.view(), blade);
  ASSERT_TRUE(lip);
  EXPECT_NEAR((halves.at(*lip) - Eigen::Vector3d(0.1, gap, 0)).norm(), 0, 1e-12);
  // No wall lies ahead the other way, nor above the blade's edge, nor where the lips are the blade's own.
  BladeInGap back = blade, below = blade, own = blade;
  back.way = -blade.way;
  back.left.y() -= 0.05;
  EXPECT_FALSE(border_beyond(halves.view(), back));
  below.above = 0.05;
  EXPECT_FALSE(border_beyond(halves.view(), below));
  for (int k = 0; k < 3; ++k) {
    own.lips = {halves.mesh.triangles[static_cast<std::size_t>(lip->triangle)][k]};
    EXPECT_EQ(border_beyond(halves.view(), own).has_value(), lip->weights[k] == 0) << k;
  }
}

TEST(BorderBeyond, IsMetAcrossByThePartOfTheLineThatTheBladeHas) {
  const Halves halves;
  BladeInGap blade{.left = {-0.9, halves.gap() - 0.1, 0}, .line = kIntoHalves, .above = -0.5, .below = 0.1};
  const auto is_met_at = [&](double sine) {
    blade.way = {std::sqrt(1 - sine * sine), sine, 0};
    return border_beyond(halves.view(), blade).has_value();
  };
  EXPECT_TRUE(is_met_at(0.27)) << "15.7 degrees";
  EXPECT_FALSE(is_met_at(0.25)) << "14.5 degrees";
  blade.left.z() = 0.11;
  EXPECT_FALSE(is_met_at(1)) << "the border lies below the blade's edge";
  blade.below = 0.12;
  EXPECT_TRUE(is_met_at(1));
}

TEST(BorderBeyond, IsTheNearestEitherWay) {
  const Halves halves;
  const double outer = halves.gap() - 2 * Halves::size();  // of the first half; its wall lies ahead too
  BladeInGap blade{
      .left = {0.1, 0, 0}, .way = Eigen::Vector3d::UnitY(), .line = kIntoHalves, .above = -0.5, .below = 0.1};
  blade.overlap = 5;
  EXPECT_NEAR(halves.at(*border_beyond(halves.view(), blade)).y(), halves.gap(), 1e-12);
  blade.left.y() = outer + 0.1;
  EXPECT_NEAR(halves.at(*border_beyond(halves.view(), blade)).y(), outer, 1e-12);
}

TEST(BorderBeyond, IsFoundWhereTheLipsOverlap) {
  const Halves halves;
  const double gap = halves.gap();
  BladeInGap blade{
      .left = {0.1, gap + 0.05, 0}, .way = Eigen::Vector3d::UnitY(), .line = kIntoHalves, .above = -0.5, .below = 0.1};
  EXPECT_FALSE(border_beyond(halves.view(), blade));
  blade.overlap = 0.1;
  const auto lip = border_beyond(halves.view(), blade);
  ASSERT_TRUE(lip);
  EXPECT_NEAR(halves.at(*lip).y(), gap, 1e-12);
}

TEST(FirstRim, IsMetByALineThatPassesTheBorderWithinHalfOfTheThickness) {
  const Halves halves;
  const std::vector<double> thickness(halves.mesh.triangles.size(), 0.02);
  const Eigen::Vector3d far(0.13, 5, 0.009), way = -Eigen::Vector3d::UnitY();
  const auto rim = first_rim(halves.view(), thickness, far, way);
  ASSERT_TRUE(rim);
  const double edge = 2 * Halves::size() - halves.gap();
  EXPECT_NEAR(rim->travel, 5 - edge, 1e-12);
  EXPECT_LT((halves.at(*rim) - Eigen::Vector3d(0.13, edge, 0)).norm(), 1e-12);
  // Of several the first, wherever on the line it is told to begin.
  EXPECT_NEAR(first_rim(halves.view(), thickness, {0.13, -5, 0}, way)->travel, -5 - edge, 1e-12);
  EXPECT_FALSE(first_rim(halves.view(), thickness, {0.13, 5, 0.011}, way)) << "above it";
  EXPECT_FALSE(first_rim(halves.view(), thickness, {1.02, 5, 0}, way)) << "beside it";
}

TEST(FirstRim, IsAsHighAsTheWallIsThickThere) {
  const Halves halves;
  std::vector<double> thickness(halves.mesh.triangles.size(), 0.02);
  std::fill(thickness.begin() + static_cast<std::ptrdiff_t>(thickness.size() / 2), thickness.end(), 0.04);
  // The half that is met first, and the other one from the other side.
  EXPECT_TRUE(first_rim(halves.view(), thickness, {0.13, 5, 0.015}, -Eigen::Vector3d::UnitY()));
  const auto behind = first_rim(halves.view(), thickness, {0.13, -5, 0.015}, Eigen::Vector3d::UnitY());
  ASSERT_TRUE(behind);
  EXPECT_NEAR(behind->travel, 5 + halves.gap(), 1e-12);
}

TEST(NearestOnBorder, IsThePlaceOfTheNearestSideOrItsEnd) {
  const Halves halves;
  const double gap = halves.gap();
  const auto expect_at = [&](const Eigen::Vector3d& point, const Eigen::Vector3d& place) {
    EXPECT_LT((halves.at(*nearest_on_border(halves.view(), point)) - place).norm(), 1e-12);
    EXPECT_NEAR(distance_from_border(halves.view(), point), (place - point).norm(), 1e-12);
  };
  expect_at({0.13, 0.05, 0.3}, {0.13, gap, 0});
  expect_at({0.13, -0.05, 0.3}, {0.13, -gap, 0});
  expect_at({1.5, gap - 0.1, 0}, {1, gap, 0});
  expect_at({0.13, gap + 0.02, 0}, {0.13, gap, 0});
  const SurfaceMesh closed = make_sphere(1, 80);
  Eigen::VectorXd position(3 * closed.vertices.size());
  for (std::size_t v = 0; v < closed.vertices.size(); ++v) {
    position.segment<3>(3 * static_cast<Eigen::Index>(v)) = closed.vertices[v];
  }
  const SurfaceView view{.triangles = closed.triangles, .position = position};
  EXPECT_FALSE(nearest_on_border(view, {0, 0, 1}));
  EXPECT_EQ(distance_from_border(view, {0, 0, 1}), std::numeric_limits<double>::infinity());
}

TEST(BordersAround, AreOfEachSideWithinReachThePlaceThatIsNearest) {
  const Halves halves;
  const double gap = halves.gap();
  EXPECT_TRUE(borders_around(halves.view(), {0.13, 0, 0}, 0.99 * gap).empty());
  const std::vector<SurfacePoint> places = borders_around(halves.view(), {0.13, 0, 0}, 1.01 * gap);
  ASSERT_EQ(places.size(), 2U);
  EXPECT_LT((halves.at(places[0]) - Eigen::Vector3d(0.13, -gap, 0)).norm(), 1e-12);
  EXPECT_LT((halves.at(places[1]) - Eigen::Vector3d(0.13, gap, 0)).norm(), 1e-12);
}

TEST(WayAhead, LeadsAwayFromTheBordersThatMeetAtTheTip) {
  const Halves halves;
  const auto vertex_at = [&](const Eigen::Vector3d& place) {
    for (int v = 0; v < static_cast<int>(halves.mesh.vertices.size()); ++v) {
      if ((halves.position.segment<3>(3 * v) - place).norm() < 1e-9) return v;
    }
    return -1;
  };
  const double gap = halves.gap();
  EXPECT_LT((way_ahead(halves.view(), vertex_at({1, gap, 0})) - Eigen::Vector3d(1, -1, 0)).norm(), 1e-12);
  EXPECT_LT((way_ahead(halves.view(), vertex_at({-1, -gap, 0})) - Eigen::Vector3d(-1, 1, 0)).norm(), 1e-12);
}

}  // namespace
}  // namespace thinwall
