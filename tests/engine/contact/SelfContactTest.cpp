#include "engine/contact/SelfContact.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <random>
#include <set>

#include "engine/mesh/MeshTopology.hpp"
#include "engine/mesh/Shapes.hpp"
#include "tests/engine/contact/SelfContactWall.hpp"
#include "tests/engine/contact/SurfaceIntersections.hpp"

namespace thinwall {
namespace {

/// A sphere pressed flat between two planes that are `gap` apart, metres.
Eigen::VectorXd flattened(const Eigen::VectorXd& rest, double gap) {
  Eigen::VectorXd position = rest;
  double top = 0;
  for (Eigen::Index k = 2; k < rest.size(); k += 3) top = std::max(top, rest[k]);
  for (Eigen::Index k = 2; k < rest.size(); k += 3) position[k] *= 0.5 * gap / top;
  return position;
}

/// A wall that has been cut, with the ranges of the whole wall where an edge length is given.
SelfContactDefinition after_a_cut(const Wall& cut, const Eigen::VectorXd& placement, double edge_length = 0) {
  return {.triangles = cut.mesh.triangles,
          .position = cut.rest,
          .thickness = cut.thickness,
          .fixed = cut.fixed,
          .floors = {},
          .pressure = 1e3,
          .placement = placement,
          .edge_length = edge_length};
}

/// A pair by its vertices, whatever the order within its two parts and, of edges, of the two.
std::array<int, 5> key_of(PairKind kind, std::array<int, 4> v) {
  if (kind == PairKind::kPointTriangle) {
    std::sort(v.begin() + 1, v.end());
    return {0, v[0], v[1], v[2], v[3]};
  }
  std::sort(v.begin(), v.begin() + 2);
  std::sort(v.begin() + 2, v.end());
  const std::array one = {v[0], v[1]}, two = {v[2], v[3]};
  const auto& [low, high] = std::minmax(one, two);
  return {1, low[0], low[1], high[0], high[1]};
}

/// Distances of all parts that share no vertex, tried one by one.
std::set<std::array<int, 5>> pairs_within(const SurfaceMesh& mesh, const Eigen::VectorXd& position, double reach) {
  const auto at = [&](int v) -> Eigen::Vector3d { return position.segment<3>(3 * v); };
  std::set<std::array<int, 5>> pairs;
  const auto try_pair = [&](PairKind kind, std::array<int, 4> v) {
    std::array<int, 4> sorted = v;
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) return;
    if (pair_distance(kind, {at(v[0]), at(v[1]), at(v[2]), at(v[3])}).distance < reach) pairs.insert(key_of(kind, v));
  };
  for (int v = 0; v < static_cast<int>(mesh.vertices.size()); ++v) {
    for (const Eigen::Vector3i& t : mesh.triangles) try_pair(PairKind::kPointTriangle, {v, t[0], t[1], t[2]});
  }
  const MeshTopology topology = topology_of(static_cast<int>(mesh.vertices.size()), mesh.triangles);
  for (std::size_t i = 0; i < topology.edges.size(); ++i) {
    for (std::size_t j = i + 1; j < topology.edges.size(); ++j) {
      const auto &a = topology.edges[i], &b = topology.edges[j];
      try_pair(PairKind::kEdgeEdge, {a[0], a[1], b[0], b[1]});
    }
  }
  return pairs;
}

TEST(SelfContact, LeavesASmoothWallAlone) {
  Wall wall(make_sphere(20e-3, 1280));
  Eigen::VectorXd gradient;
  const SelfContactTerms terms = wall.evaluate(wall.rest, gradient);
  EXPECT_TRUE(terms.folds.empty());
  EXPECT_EQ(terms.energy, 0);
  EXPECT_EQ(gradient.norm(), 0);
  EXPECT_EQ(wall.contact.listed(), 0U);
}

TEST(SelfContact, LeavesAWallAloneThatPrestretchLetsShrinkToItsStressFreeShape) {
  // Stretched to three times its size where it is given; then its parts are nearer than half of what they were.
  const SurfaceMesh mesh = make_sheet(40e-3, 40e-3, 800);
  const Eigen::VectorXd given = position_of(mesh), shrunk = given / 3;
  const std::vector<double> thickness(mesh.triangles.size(), 1e-3);
  const std::vector<char> fixed(given.size(), 0);
  for (const double stretch : {1.0, 3.0}) {
    SelfContact contact({.triangles = mesh.triangles,
                         .position = given,
                         .thickness = thickness,
                         .fixed = fixed,
                         .floors = {},
                         .pressure = 1e3,
                         .stretch = std::vector<double>(mesh.triangles.size(), stretch)});
    Eigen::VectorXd gradient;
    EXPECT_EQ(evaluated(contact, shrunk, gradient).folds.empty(), stretch == 3) << stretch;
    EXPECT_FALSE(evaluated(contact, shrunk / 3, gradient).folds.empty()) << "crumpled as much again, " << stretch;
  }
}

TEST(SelfContact, FindsEveryPairWithinRangeOnce) {
  // Thin enough for the thickness to be the range of all pairs but neighbours.
  Wall wall(make_sphere(20e-3, 128), 0.5e-3);
  Eigen::VectorXd gradient;
  for (const double gap : {20e-3, 2e-3, 0.4e-3, 0.1e-3}) {
    const Eigen::VectorXd position = flattened(wall.rest, gap);
    const SelfContactTerms terms = wall.evaluate(position, gradient);
    std::set<std::array<int, 5>> found;
    for (const FoldContact& contact : terms.folds) {
      std::array<int, 4> vertices;
      std::copy_n(contact.vertices.data(), 4, vertices.begin());
      EXPECT_TRUE(found.insert(key_of(contact.pair.kind, vertices)).second) << gap;
    }
    EXPECT_EQ(found, pairs_within(wall.mesh, position, 0.5e-3)) << gap;
  }
}

TEST(SelfContact, HasTheGradientOfItsEnergy) {
  Wall wall(make_sphere(20e-3, 128), 1e-3, {{.normal = Eigen::Vector3d::UnitZ(), .height = -25e-3}});
  Eigen::VectorXd position = flattened(wall.rest, 0.6e-3), gradient, ignored;
  for (Eigen::Index k = 2; k < position.size(); k += 3) position[k] -= 24.5e-3;
  const SelfContactTerms terms = wall.evaluate(position, gradient);
  ASSERT_GT(terms.folds.size(), 100U);
  ASSERT_GT(terms.floors.size(), 10U);
  for (Eigen::Index k = 0; k < position.size(); k += 7) {
    const double step = 1e-9, middle = position[k];
    position[k] = middle + step;
    const double up = wall.evaluate(position, ignored).energy;
    position[k] = middle - step;
    const double down = wall.evaluate(position, ignored).energy;
    position[k] = middle;
    EXPECT_NEAR(gradient[k], (up - down) / (2 * step), 1e-5 * terms.largest_force);
  }
}

TEST(SelfContact, PushesAWholeWallWithoutNetForceOrMoment) {
  Wall wall(make_sphere(20e-3, 320));
  Eigen::VectorXd gradient;
  const Eigen::VectorXd position = flattened(wall.rest, 0.5e-3);
  const SelfContactTerms terms = wall.evaluate(position, gradient);
  ASSERT_GT(terms.folds.size(), 100U);
  Eigen::Vector3d force = Eigen::Vector3d::Zero(), moment = Eigen::Vector3d::Zero();
  for (Eigen::Index k = 0; k < gradient.size(); k += 3) {
    force += gradient.segment<3>(k);
    moment += Eigen::Vector3d(position.segment<3>(k)).cross(Eigen::Vector3d(gradient.segment<3>(k)));
  }
  EXPECT_LT(force.norm(), 1e-12 * gradient.norm());
  EXPECT_LT(moment.norm(), 1e-12 * 20e-3 * gradient.norm());
}

TEST(SelfContact, GivesTheSameBitsWhateverItCameFrom) {
  Wall fresh(make_sphere(20e-3, 320)), travelled(make_sphere(20e-3, 320));
  Eigen::VectorXd gradient, other;
  for (double gap = 30e-3; gap > 0.5e-3; gap *= 0.97) travelled.evaluate(flattened(travelled.rest, gap), other);
  const Eigen::VectorXd position = flattened(fresh.rest, 0.5e-3);
  const double energy = fresh.evaluate(position, gradient).energy;
  EXPECT_EQ(travelled.evaluate(position, other).energy, energy);
  EXPECT_EQ(gradient, other);
}

TEST(SelfContact, ListsAnewOnlyForWhatHasMovedAndStillFindsAllAsAFreshOne) {
  std::mt19937 random(5);
  std::normal_distribution<double> draw(0, 1);
  Wall travelled(make_sphere(20e-3, 320), 2e-3);
  Eigen::VectorXd gradient, other, position = flattened(travelled.rest, 2e-3);
  travelled.evaluate(position, other);
  const std::size_t vertices = travelled.mesh.vertices.size();
  EXPECT_EQ(travelled.contact.listed_anew(), vertices);
  std::size_t most = 0, contacts = 0;
  for (int step = 0; step < 60; ++step) {
    // A patch flutters while the whole drifts: each vertex by a part of its margin, so that some pairs are listed for
    // places where one of the two no longer is.
    const Eigen::Vector3d center = travelled.rest.segment<3>(3 * (random() % vertices));
    for (Eigen::Index k = 0; k < position.size(); k += 3) {
      position.segment<3>(k) += Eigen::Vector3d(1e-3, 0, 0);
      if ((travelled.rest.segment<3>(k) - center).norm() > 8e-3) continue;
      for (int axis = 0; axis < 3; ++axis) position[k + axis] += 0.2e-3 * draw(random);
    }
    Wall fresh(travelled.mesh, 2e-3);
    const SelfContactTerms terms = fresh.evaluate(position, gradient);
    const SelfContactTerms again = travelled.evaluate(position, other);
    ASSERT_EQ(again.folds.size(), terms.folds.size()) << step;
    ASSERT_EQ(again.energy, terms.energy) << step;
    ASSERT_EQ(other, gradient) << step;
    if (travelled.contact.listings() > 1) most = std::max(most, travelled.contact.listed_anew());
    contacts += terms.folds.size();
  }
  EXPECT_GT(travelled.contact.listings(), 20);
  EXPECT_LT(most, vertices / 2);
  EXPECT_GT(contacts, 1000U);
}

TEST(SelfContact, KeepsItsListWhileTheWallMovesAsAWholeOrALittle) {
  Wall wall(make_sphere(20e-3, 320));
  Eigen::VectorXd gradient, position = wall.rest;
  EXPECT_EQ(wall.contact.listings(), 0);
  wall.evaluate(position, gradient);
  const long before = wall.contact.listings();
  for (int step = 0; step < 50; ++step) {
    position.reshaped(3, position.size() / 3).colwise() += Eigen::Vector3d(1e-3, 2e-3, -3e-3);
    wall.evaluate(position, gradient);
  }
  wall.evaluate(position * 1.001, gradient);
  EXPECT_EQ(wall.contact.listings(), before);
  wall.evaluate(position * 1.5, gradient);
  EXPECT_EQ(wall.contact.listings(), before + 1);
}

TEST(SelfContact, StopsRandomMotionsBeforeTheWallPassesThroughItself) {
  std::mt19937 random(21);
  std::normal_distribution<double> draw(0, 1);
  int crossed = 0;
  for (int trial = 0; trial < 60; ++trial) {
    Wall wall(make_sphere(20e-3, 128));
    Eigen::VectorXd position = wall.rest;
    for (int step = 0; step < 6; ++step) {
      Eigen::VectorXd motion(position.size());
      for (double& component : motion) component = 8e-3 * draw(random);
      crossed += surface_intersections(wall.mesh.triangles, position + motion).empty() ? 0 : 1;
      position += wall.contact.safe_fraction(position, motion) * motion;
      ASSERT_TRUE(surface_intersections(wall.mesh.triangles, position).empty()) << trial << ", " << step;
    }
  }
  EXPECT_GT(crossed, 300);  // of 360: the motions would have crossed
}

TEST(SelfContact, StopsFewVerticesThatGoFarAmongManyThatHardlyMove) {
  std::mt19937 random(22);
  std::normal_distribution<double> draw(0, 1);
  int crossed = 0, stopped = 0;
  Wall wall(make_sphere(20e-3, 512));
  Eigen::VectorXd position = flattened(wall.rest, 6e-3);
  const std::size_t vertices = wall.mesh.vertices.size();
  for (int step = 0; step < 200; ++step) {
    Eigen::VectorXd motion(position.size());
    for (double& component : motion) component = 0.02e-3 * draw(random);
    // Through the opposite side, a tenth of the vertices at most.
    const Eigen::Vector3d center = position.segment<3>(3 * (random() % vertices));
    const Eigen::Vector3d way(0, 0, center.z() > 0 ? -8e-3 : 8e-3);
    for (Eigen::Index k = 0; k < position.size(); k += 3) {
      const bool is_there = center.z() * position[k + 2] > 0 && (position.segment<3>(k) - center).norm() < 5e-3;
      if (is_there) motion.segment<3>(k) += way;
    }
    crossed += surface_intersections(wall.mesh.triangles, position + motion).empty() ? 0 : 1;
    const double fraction = wall.contact.safe_fraction(position, motion);
    stopped += fraction < 1 ? 1 : 0;
    ASSERT_TRUE(surface_intersections(wall.mesh.triangles, position + fraction * motion).empty()) << step;
    position += 0.1 * fraction * motion;
  }
  EXPECT_GT(crossed, 150);  // of 200: the motions would have crossed
  EXPECT_GE(stopped, crossed);
}

TEST(SelfContact, LetsThroughMotionsThatMeetNothing) {
  Wall wall(make_sphere(20e-3, 320));
  EXPECT_EQ(wall.contact.safe_fraction(wall.rest, 5 * wall.rest), 1);
  Eigen::VectorXd turned = wall.rest;
  const Eigen::Matrix3d half_turn = Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitX()).toRotationMatrix();
  turned.reshaped(3, turned.size() / 3) = half_turn * wall.rest.reshaped(3, turned.size() / 3);
  EXPECT_EQ(wall.contact.safe_fraction(wall.rest, turned - wall.rest), 1);
}

/// A sheet that is cut in two along x = 0, and which of its vertices are on the right.
struct HalvedSheet {
  SurfaceMesh mesh = make_sheet(40e-3, 40e-3, 512);
  std::vector<char> is_right;
  HalvedSheet() {
    const std::size_t whole = mesh.vertices.size();
    std::vector<int> doubled(whole, -1);
    is_right.assign(whole, 0);
    for (Eigen::Vector3i& triangle : mesh.triangles) {
      double middle = 0;
      for (const int v : triangle) middle += mesh.vertices[v].x() / 3;
      if (middle < 0) continue;
      for (int& v : triangle) {
        if (doubled[v] < 0) {
          doubled[v] = static_cast<int>(mesh.vertices.size());
          mesh.vertices.push_back(mesh.vertices[v]);
          is_right.push_back(1);
        }
        v = doubled[v];
      }
    }
  }
  Eigen::VectorXd moved(const Eigen::Vector3d& by) const {
    Eigen::VectorXd position = position_of(mesh);
    for (std::size_t v = 0; v < is_right.size(); ++v) {
      if (is_right[v]) position.segment<3>(3 * static_cast<Eigen::Index>(v)) += by;
    }
    return position;
  }
};

TEST(SelfContact, LetsTheLipsOfACutSlideOverEachOtherByAnEdge) {
  const HalvedSheet sheet;  // edges of 2.5 mm
  Wall wall(sheet.mesh);
  Eigen::VectorXd gradient;
  for (const double by : {-1e-3, -2.4e-3}) {
    const Eigen::VectorXd over = sheet.moved({by, 0, 0});
    EXPECT_EQ(wall.contact.safe_fraction(wall.rest, over - wall.rest), 1) << by;
    EXPECT_TRUE(wall.evaluate(over, gradient).folds.empty()) << by;
  }
  // What lay farther from the cut is kept apart, as any two parts of the wall.
  const Eigen::VectorXd above = sheet.moved({-12e-3, 0, 0.3e-3}), below = sheet.moved({-12e-3, 0, -0.3e-3});
  EXPECT_GT(wall.evaluate(above, gradient).folds.size(), 20U);
  EXPECT_LT(wall.contact.safe_fraction(above, below - above), 0.5);
}

TEST(SelfContact, KnowsAfterACutWhatAFreshOneFindsOut) {
  const HalvedSheet halves;
  Wall whole(make_sheet(40e-3, 40e-3, 512)), cut(halves.mesh);
  // Folded over along y = 0, with a ripple so that nothing lies on anything.
  std::mt19937 random(3);
  std::uniform_real_distribution<double> ripple(-0.15e-3, 0.15e-3);
  const auto folded = [&](const Eigen::VectorXd& rest) {
    Eigen::VectorXd position = rest;
    for (Eigen::Index v = 0; v < rest.size() / 3; ++v) {
      const double y = rest[3 * v + 1];
      position.segment<3>(3 * v) +=
          Eigen::Vector3d(ripple(random), y < 0 ? -2 * y : 0, (y < 0 ? 0.7e-3 : 0) + ripple(random));
    }
    return position;
  };
  // A shell has further unknowns behind the positions.
  Eigen::VectorXd before = folded(whole.rest), gradient;
  before.conservativeResizeLike(Eigen::VectorXd::Constant(before.size() + 100, 0.1));
  whole.evaluate(before, gradient);
  const Eigen::VectorXd placement = folded(cut.rest);
  const SelfContactDefinition definition = after_a_cut(cut, placement, whole.contact.edge_length());
  SelfContact known(definition, whole.contact), fresh(definition);
  for (int k = 0; k < 5; ++k) {
    const Eigen::VectorXd position = k == 0 ? placement : folded(cut.rest);
    Eigen::VectorXd of_one, of_other;
    const SelfContactTerms one = evaluated(known, position, of_one), other = evaluated(fresh, position, of_other);
    EXPECT_GT(one.folds.size(), 100U);
    EXPECT_EQ(one.folds.size(), other.folds.size());
    EXPECT_EQ(one.energy, other.energy);
    EXPECT_EQ(of_one, of_other);
    if (k == 0) {
      EXPECT_LT(known.listed_anew(), fresh.listed_anew());
    }
  }
}

TEST(SelfContact, LeavesPartsAloneThatACutHasLeftInEachOther) {
  // Two sheets that are a centimetre apart at rest; the upper one is brought down onto the other and through it.
  SurfaceMesh sheets = make_sheet(20e-3, 20e-3, 100);
  const int vertices = static_cast<int>(sheets.vertices.size()), triangles = static_cast<int>(sheets.triangles.size());
  for (int v = 0; v < vertices; ++v) sheets.vertices.push_back(sheets.vertices[v] + Eigen::Vector3d(1e-3, 0, 10e-3));
  for (int t = 0; t < triangles; ++t) sheets.triangles.push_back(sheets.triangles[t].array() + vertices);
  Wall wall(sheets);
  Eigen::VectorXd pressed = wall.rest, motion = Eigen::VectorXd::Zero(wall.rest.size());
  for (int v = vertices; v < 2 * vertices; ++v) {
    pressed[3 * v + 2] = 1e-6;
    motion[3 * v + 2] = -1e-3;
  }
  Eigen::VectorXd gradient;
  EXPECT_GT(wall.evaluate(pressed, gradient).energy, 0);
  EXPECT_LT(wall.contact.safe_fraction(pressed, motion), 1);
  SelfContact after(after_a_cut(wall, pressed));
  SelfContactTerms terms = evaluated(after, pressed, gradient);
  for (const FoldContact& fold : terms.folds) EXPECT_GT(fold.pair.closest.distance, 1e-5);
  EXPECT_EQ(after.safe_fraction(pressed, 1e-3 * motion), 1);
  // Until the next cut, by when they have come out of each other.
  const Eigen::VectorXd apart = pressed - 0.03 * motion;
  SelfContact later(after_a_cut(wall, apart, after.edge_length()), after);
  terms = evaluated(later, apart, gradient);
  EXPECT_GT(
      std::ranges::count_if(terms.folds, [](const FoldContact& fold) { return fold.pair.closest.distance < 3.2e-5; }),
      50);
}

TEST(SelfContact, IgnoresPartsThatTouchInTheStressFreeShape) {
  // Two sheets on the same vertices' places, as the lips of a cut are.
  SurfaceMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1e-2, 0, 0}, {0, 1e-2, 0}, {1e-2, 0, 0}, {0, 1e-2, 0}, {1e-2, 1e-2, 0}};
  mesh.triangles = {{0, 1, 2}, {3, 5, 4}};
  Wall wall(mesh);
  Eigen::VectorXd gradient;
  EXPECT_TRUE(wall.evaluate(wall.rest, gradient).folds.empty());
  EXPECT_EQ(gradient.norm(), 0);
}

}  // namespace
}  // namespace thinwall
