// Cuts that begin or end next to a border of the wall or to another cut: they meet it, and leave no bridge narrower
// than triangles tell. Farther off, or before the blade's last step, they begin and end where the blade does.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/mesh/MeshTopology.hpp"
#include "engine/mesh/Shapes.hpp"
#include "tests/engine/simulation/DrawnBlade.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

constexpr double kSide = 40e-3;    // metres, of the sheet
constexpr double kHeight = -2e-3;  // metres, of the blade's tip: behind the sheet

/// Without tension, so that a cut does not open and each place stays where it is. `triangles`: wanted number.
Body slack_sheet(int triangles, const ToolDefinition& blade) {
  BodyDefinition definition = make_body(make_sheet(kSide, kSide, triangles), 1e-3, neo_hookean(20e3));
  definition.fluid.kind = FluidKind::kNone;
  definition.toughness = {20};
  definition.fixed.push_back({.region = BoundaryRegion{}});
  Body body(definition, {blade}, quasi_static());
  body.settle();
  return body;
}

struct Pieces {
  int count = 0;
  std::size_t borders = 0;
};

Pieces pieces_of(const Body& body) {
  const MeshTopology topology = topology_of(body.model().vertices(), body.model().definition.mesh.triangles);
  EXPECT_TRUE(is_oriented_manifold(topology));
  return {.count = topology.component_count, .borders = topology.boundary_loops.size()};
}

/// Metres of way: longer than what a cut's end may be off a border, and so short that its own tip is always nearer.
const std::vector<double> kSteps = {1e-3, 0.1e-3};

/// The length that is cut, metres. `ends`: whether the blade stops at the last point.
double cut_along(Body& body, const std::vector<Eigen::Vector2d>& points, double step = 1e-3, bool ends = true) {
  const double before = body.state().cut.length;
  BladeStroke stroke{.points = {}, .step = step, .ends = ends};
  for (const Eigen::Vector2d& point : points) stroke.points.emplace_back(point.x(), point.y(), kHeight);
  draw_blade(body, stroke);
  return body.state().cut.length - before;
}

TEST(ACutThatEndsBesideABorder, GoesThroughItWithinAQuarterOfAnEdge) {
  for (const double step : kSteps) {
    SCOPED_TRACE(step);
    Body body = slack_sheet(800, test_blade());
    const double short_of = 0.2 * body.model().edge_length;
    const double length = cut_along(body, {{12e-3, 0.7e-3}, {kSide / 2 - short_of, 0.7e-3}}, step);
    std::printf("%.3f mm short of the border, cut by %.3f mm\n", 1e3 * short_of, 1e3 * length);
    EXPECT_EQ(pieces_of(body).borders, 1U) << "a notch is a part of the sheet's own border";
    EXPECT_NEAR(length, kSide / 2 - 12e-3, 0.1 * short_of);
  }
}

TEST(ACutThatEndsBesideABorder, StopsWhereTheBladeDoesFartherOff) {
  for (const double step : kSteps) {
    SCOPED_TRACE(step);
    Body body = slack_sheet(800, test_blade());
    const double edge = body.model().edge_length, short_of = 0.9 * edge;
    const double length = cut_along(body, {{12e-3, 0.7e-3}, {kSide / 2 - short_of, 0.7e-3}}, step);
    EXPECT_EQ(pieces_of(body).borders, 2U);
    // An end is snapped to a vertex within a part of an edge.
    EXPECT_NEAR(length, kSide / 2 - short_of - 12e-3, 0.3 * edge);
  }
}

TEST(ACutThatEndsBesideABorder, GoesThroughItWithinHalfTheBladesThickness) {
  for (const double step : kSteps) {
    SCOPED_TRACE(step);
    // Of 1 mm; triangles of 0.6 mm would bridge it.
    ToolDefinition thick = test_blade();
    thick.thickness = 2e-3;
    Body body = slack_sheet(12800, thick);
    const double short_of = 0.9e-3;
    ASSERT_LT(body.model().edge_length, short_of);
    const double length = cut_along(body, {{12e-3, 0.7e-3}, {kSide / 2 - short_of, 0.7e-3}}, step);
    EXPECT_EQ(pieces_of(body).borders, 1U);
    EXPECT_NEAR(length, kSide / 2 - 12e-3, 0.1 * short_of);
  }
}

TEST(ACutThatBeginsBesideABorder, ComesFromItWithinAQuarterOfAnEdge) {
  for (const double step : kSteps) {
    for (const double edges : {0.06, 0.12, 0.24}) {
      // At a vertex, between two, and askew.
      for (const double turn : {0.0, 0.7e-3, 6e-3}) {
        SCOPED_TRACE(testing::Message() << "step " << step << ", edges " << edges << ", turn " << turn);
        Body body = slack_sheet(800, test_blade());
        const double off = edges * body.model().edge_length;
        const Eigen::Vector2d begin(kSide / 2 - off, turn), end(12e-3, 0.7e-3);
        const double length = cut_along(body, {begin, end}, step);
        std::printf("%.3f mm off the border, cut by %.3f mm\n", 1e3 * off, 1e3 * length);
        EXPECT_EQ(pieces_of(body).borders, 1U) << "a notch is a part of the sheet's own border";
        EXPECT_NEAR(length, off + (end - begin).norm(), 0.3 * body.model().edge_length);
        EXPECT_LT(std::abs(body.state().books.imbalance()), 1e-9 * body.state().books.largest());
      }
    }
  }
}

TEST(ACutThatBeginsBesideABorder, BeginsWhereTheBladeDoesFartherOffAndAlongIt) {
  Body body = slack_sheet(800, test_blade());
  const double edge = body.model().edge_length;
  cut_along(body, {{kSide / 2 - 0.9 * edge, 0.7e-3}, {12e-3, 0.7e-3}});
  EXPECT_EQ(pieces_of(body).borders, 2U);
  Body beside = slack_sheet(800, test_blade());
  cut_along(beside, {{kSide / 2 - 0.24 * edge, -5e-3}, {kSide / 2 - 0.24 * edge, 5e-3}}, 1e-3, false);
  EXPECT_EQ(pieces_of(beside).borders, 2U);
}

TEST(ACutThatGoesOn, PassesBesideABorder) {
  Body body = slack_sheet(800, test_blade());
  const double aside = kSide / 2 - 0.2 * body.model().edge_length;
  cut_along(body, {{12e-3, 0.7e-3}, {aside, 0.7e-3}}, 1e-3, false);
  EXPECT_EQ(pieces_of(body).borders, 2U) << "the blade has not been said to stop there";
}

TEST(ACutBesideAnEarlierOne, JoinsItWhereItBeginsOrEnds) {
  for (const double step : kSteps) {
    for (const bool ends_there : {false, true}) {
      SCOPED_TRACE(testing::Message() << "step " << step << (ends_there ? ", ends" : ", begins"));
      Body body = slack_sheet(800, test_blade());
      cut_along(body, {{-9e-3, 0.3e-3}, {9e-3, 0.3e-3}});
      const double gap = 0.2 * body.model().edge_length;
      std::vector<Eigen::Vector2d> path = {{0.6e-3, 0.3e-3 - gap}, {0.6e-3, -9e-3}};
      if (ends_there) std::swap(path[0], path[1]);
      cut_along(body, path, step);
      EXPECT_EQ(pieces_of(body).borders, 2U) << "of the sheet, and of both cuts as one";
    }
  }
}

TEST(ACutThatEndsBesideItsBeginning, MeetsItThereAndFreesThePiece) {
  // From the inside, from the outside, and short of it.
  for (const Eigen::Vector2d& off :
       {Eigen::Vector2d(0.4e-3, 0.3e-3), Eigen::Vector2d(-0.35e-3, -0.3e-3), Eigen::Vector2d(0, 0.45e-3)}) {
    SCOPED_TRACE(off.transpose());
    Body body = slack_sheet(800, test_blade());
    ASSERT_LT(off.norm(), 0.25 * body.model().edge_length);
    const Eigen::Vector2d begin(-6e-3, -6e-3);
    cut_along(body, {begin, {6e-3, -6e-3}, {6e-3, 6e-3}, {-6e-3, 6e-3}, begin + off}, 0.25e-3);
    const Pieces pieces = pieces_of(body);
    std::printf("%d pieces, %zu borders, cut by %.2f mm\n", pieces.count, pieces.borders,
                1e3 * body.state().cut.length);
    EXPECT_EQ(pieces.count, 2);
    EXPECT_EQ(pieces.borders, 3U) << "no spur is left where it had begun";
  }
}

TEST(ACutThatEndsBesideABorder, IsPaidForAsFarAsItGoes) {
  Body body = slack_sheet(800, test_blade());
  const double cost = body.model().cut_cost(0), edge = body.model().edge_length;
  const double length = cut_along(body, {{12e-3, 0.7e-3}, {kSide / 2 - 0.2 * edge, 0.7e-3}});
  const EnergyBooks& books = body.state().books;
  EXPECT_NEAR(books.fracture, cost * length, 1e-9 * cost * length);
  // The blade itself has not gone the last bit.
  EXPECT_LT(std::abs(books.jump), 0.25 * edge * cost);
  EXPECT_LT(std::abs(books.imbalance()), 1e-9 * books.largest());
}

}  // namespace
}  // namespace thinwall
