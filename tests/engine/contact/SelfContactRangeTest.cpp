#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "engine/contact/SelfContact.hpp"
#include "engine/mesh/Shapes.hpp"
#include "tests/engine/contact/SelfContactWall.hpp"

// How far off, on what area and of which parts a wall feels itself and its floors.

namespace thinwall {
namespace {

/// A sheet, and a smaller one turned against it above, which is moved up and down.
struct TwoSheets {
  SurfaceMesh mesh = make_sheet(40e-3, 40e-3, 512);
  int lower = static_cast<int>(mesh.vertices.size()), lower_triangles = static_cast<int>(mesh.triangles.size());

  explicit TwoSheets(double height) {
    const SurfaceMesh above = make_sheet(16e-3, 16e-3, 100);
    const Eigen::AngleAxisd turn(0.4, Eigen::Vector3d::UnitZ());
    for (const Eigen::Vector3d& vertex : above.vertices) {
      mesh.vertices.push_back(turn * vertex + Eigen::Vector3d(0.3e-3, 0.2e-3, height));
    }
    for (const Eigen::Vector3i& triangle : above.triangles) mesh.triangles.push_back(triangle.array() + lower);
  }

  Eigen::VectorXd at(double height) const {
    Eigen::VectorXd position = position_of(mesh);
    for (Eigen::Index v = lower; v < position.size() / 3; ++v) position[3 * v + 2] = height;
    return position;
  }
};

TEST(SelfContact, IsFeltBelowTheThicknessAndAPartOfTheEdgesAndOfTheStressFreeDistance) {
  struct Case {
    double thickness, height, range;  // metres; range of 0: by the edges
  };
  for (const Case& one : {Case{0.5e-3, 10e-3, 0.5e-3}, Case{10e-3, 10e-3, 0}, Case{10e-3, 0.6e-3, 0.3e-3}}) {
    const TwoSheets sheets(one.height);
    Wall wall(sheets.mesh, one.thickness);
    const double range = one.range > 0 ? one.range : 0.4 * wall.contact.edge_length();
    Eigen::VectorXd gradient;
    EXPECT_TRUE(wall.evaluate(sheets.at(1.001 * range), gradient).folds.empty()) << range;
    EXPECT_GT(wall.evaluate(sheets.at(0.999 * range), gradient).folds.size(), 100U) << range;
  }
}

TEST(SelfContact, IsFeltBelowTheMeanThicknessOfThePartsThatMeet) {
  const TwoSheets sheets(10e-3);
  std::vector<double> thickness(sheets.mesh.triangles.size(), 0.2e-3);
  std::fill_n(thickness.begin(), sheets.lower_triangles, 0.6e-3);
  const Eigen::VectorXd rest = position_of(sheets.mesh);
  const std::vector<char> fixed(rest.size(), 0);
  SelfContact contact(
      {.triangles = sheets.mesh.triangles, .position = rest, .thickness = thickness, .fixed = fixed, .floors = {}});
  Eigen::VectorXd gradient;
  // A vertex of the thin one and three of the thick one have 0.5 mm, two and two 0.4 mm, one and three 0.3 mm.
  const auto kinds_at = [&](double height) {
    std::set<std::pair<PairKind, bool>> kinds;
    for (const FoldContact& fold : evaluated(contact, sheets.at(height), gradient).folds) {
      kinds.insert({fold.pair.kind, fold.vertices[0] < sheets.lower});
    }
    return kinds.size();
  };
  EXPECT_EQ(kinds_at(0.501e-3), 0U);
  EXPECT_EQ(kinds_at(0.499e-3), 1U);
  EXPECT_EQ(kinds_at(0.401e-3), 1U);
  EXPECT_EQ(kinds_at(0.399e-3), 2U);
  EXPECT_EQ(kinds_at(0.301e-3), 2U);
  EXPECT_EQ(kinds_at(0.299e-3), 3U);
}

TEST(SelfContact, PushesAtHalfTheRangeWithAboutItsPressure) {
  const TwoSheets sheets(10e-3);
  Wall wall(sheets.mesh, 10e-6);
  Eigen::VectorXd gradient;
  const SelfContactTerms terms = wall.evaluate(sheets.at(5e-6), gradient);
  double by_points = 0, by_edges = 0;  // newton
  for (const FoldContact& fold : terms.folds) {
    (fold.pair.kind == PairKind::kPointTriangle ? by_points : by_edges) +=
        fold.pair.terms().gradient.reshaped(3, 4).row(2).cwiseAbs().sum() / 2;
  }
  // Of a pair 1.19 pressure times area, and either side's points count for a quarter: 0.60, and 2 % of them twice,
  // beside edges. Edges cross 2 / pi times the product of their lengths per area: 0.74 were their directions random.
  const double whole = 1e3 * 16e-3 * 16e-3;
  EXPECT_NEAR(by_points, 0.6 * whole, 0.03 * whole);
  EXPECT_NEAR(by_edges, 0.74 * whole, 0.05 * whole);
}

TEST(SelfContact, LeavesOnlyPartsAloneOfWhichNothingCanMove) {
  const TwoSheets sheets(10e-3);
  const Eigen::VectorXd rest = position_of(sheets.mesh), met = sheets.at(0.2e-3);
  const std::vector<double> thickness(sheets.mesh.triangles.size(), 1e-3);
  Eigen::VectorXd gradient;
  for (int axes = 0; axes <= 3; ++axes) {
    std::vector<char> fixed(rest.size(), 0);
    for (std::size_t k = 0; k < fixed.size(); ++k) fixed[k] = static_cast<int>(k % 3) < axes;
    SelfContact contact(
        {.triangles = sheets.mesh.triangles, .position = rest, .thickness = thickness, .fixed = fixed, .floors = {}});
    EXPECT_EQ(evaluated(contact, met, gradient).folds.empty(), axes == 3) << axes;
  }
}

/// A sheet that lies `height` above a floor, metres.
Wall sheet_above_floor(double height) {
  SurfaceMesh mesh = make_sheet(20e-3, 20e-3, 100);
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex.z() = height;
  return Wall(mesh, 1e-3, {{.normal = Eigen::Vector3d::UnitZ(), .height = 0}});
}

Eigen::VectorXd lifted(const Eigen::VectorXd& position, double by) {
  Eigen::VectorXd moved = position;
  for (Eigen::Index k = 2; k < moved.size(); k += 3) moved[k] += by;
  return moved;
}

TEST(SelfContact, StopsTheWallAboveItsFloor) {
  Wall wall = sheet_above_floor(0.4e-3);
  const Eigen::VectorXd fall = lifted(Eigen::VectorXd::Zero(wall.rest.size()), -0.8e-3);
  const double fraction = wall.contact.safe_fraction(wall.rest, fall);
  EXPECT_LT(fraction, 0.5);
  EXPECT_GT(fraction, 0.3);
  EXPECT_EQ(wall.contact.safe_fraction(wall.rest, -fall), 1);
}

TEST(SelfContact, IsPushedByItsFloorFromHalfTheStressFreeHeightOn) {
  Wall wall = sheet_above_floor(0.4e-3);
  Eigen::VectorXd gradient;
  EXPECT_TRUE(wall.evaluate(lifted(wall.rest, -0.199e-3), gradient).floors.empty());
  EXPECT_EQ(wall.evaluate(lifted(wall.rest, -0.201e-3), gradient).floors.size(), wall.mesh.vertices.size());
  const SelfContactTerms terms = wall.evaluate(lifted(wall.rest, -0.3e-3), gradient);
  // At half of the range with (1/4) / (1/2) + 2 (1/2) ln 2 = 1.19 of the pressure.
  const double push = 0.5 + std::log(2.0), area = 20e-3 * 20e-3;
  EXPECT_NEAR(-gradient.sum(), push * 1e3 * area, 1e-12 * 1e3 * area);
  EXPECT_EQ(terms.largest_force, gradient.cwiseAbs().maxCoeff());
}

TEST(SelfContact, FeelsNoFloorThatItStandsOnOrReachesBelowStressFree) {
  for (const double height : {0.0, -1e-3}) {
    Wall wall = sheet_above_floor(height);
    Eigen::VectorXd gradient;
    const SelfContactTerms terms = wall.evaluate(lifted(wall.rest, 1e-5), gradient);
    EXPECT_TRUE(terms.floors.empty()) << height;
    EXPECT_EQ(terms.energy, 0) << height;
    const Eigen::VectorXd fall = lifted(Eigen::VectorXd::Zero(wall.rest.size()), -1e-3);
    EXPECT_EQ(wall.contact.safe_fraction(wall.rest, fall), 1) << height;
  }
}

}  // namespace
}  // namespace thinwall
