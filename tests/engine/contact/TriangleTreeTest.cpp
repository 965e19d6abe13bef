// Pairs of triangles that lie near each other, from the tree as it was built and from one that has grown with a cut.

#include "engine/contact/TriangleTree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "engine/mesh/Shapes.hpp"

namespace thinwall {
namespace {

struct Wall {
  std::vector<Eigen::Vector3i> triangles;
  Eigen::VectorXd position;  // metres

  std::vector<double> margins() const { return std::vector<double>(position.size() / 3, 1e-4); }
};

Wall ball(int triangles = 320) {
  const SurfaceMesh mesh = make_sphere(0.02, triangles);
  Wall wall{.triangles = mesh.triangles, .position = Eigen::VectorXd(3 * mesh.vertices.size())};
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) wall.position.segment<3>(3 * v) = mesh.vertices[v];
  return wall;
}

/// With some triangles divided at their middles, as a cut leaves them: one of the three keeps the number.
Wall divided(Wall wall, const std::vector<int>& which) {
  for (const int t : which) {
    const Eigen::Vector3i corners = wall.triangles[t];
    const int middle = static_cast<int>(wall.position.size() / 3);
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
    for (const int corner : corners) place += wall.position.segment<3>(3 * corner) / 3;
    wall.position.conservativeResize(wall.position.size() + 3);
    wall.position.tail<3>() = place;
    wall.triangles[t] = {corners[0], corners[1], middle};
    wall.triangles.emplace_back(corners[1], corners[2], middle);
    wall.triangles.emplace_back(corners[2], corners[0], middle);
  }
  return wall;
}

Eigen::AlignedBox3d box_of(const Wall& wall, int triangle) {
  Eigen::AlignedBox3d box;
  for (const int vertex : wall.triangles[triangle]) box.extend(wall.position.segment<3>(3 * vertex));
  return box;
}

using Pairs = std::set<std::pair<int, int>>;

Pairs pairs_from(const TriangleTree& tree, double range) {
  std::vector<std::vector<std::pair<int, int>>> found;  // (tasks)
  tree.visit_near(
      range, 1e9, [&](std::size_t tasks) { found.resize(tasks); },
      [&](std::size_t task, int one, int other, double) {
        found[task].push_back(std::minmax({one, other}));
      });
  Pairs pairs;
  for (const auto& of_task : found) {
    for (const auto& pair : of_task) {
      EXPECT_TRUE(pairs.insert(pair).second) << pair.first << " and " << pair.second << " came twice";
    }
  }
  return pairs;
}

/// With margins of both triangles, of which all are alike.
Pairs pairs_by_trying_all(const Wall& wall, double range) {
  Pairs pairs;
  for (int one = 0; one < static_cast<int>(wall.triangles.size()); ++one) {
    for (int other = 0; other < one; ++other) {
      if (box_of(wall, one).exteriorDistance(box_of(wall, other)) <= range + 2e-4) pairs.insert({other, one});
    }
  }
  return pairs;
}

/// 1280: so many that threads share the pairs.
TEST(TriangleTree, FindsEachPairOnce) {
  for (const int triangles : {320, 1280}) {
    const Wall wall = ball(triangles);
    const TriangleTree tree(wall.triangles, wall.position, wall.margins());
    EXPECT_EQ(pairs_from(tree, 1e-3), pairs_by_trying_all(wall, 1e-3)) << triangles << " triangles";
  }
}

TEST(TriangleTree, ThatHasGrownFindsThePairsOfOneBuiltAnew) {
  const Wall before = ball();
  TriangleTree tree(before.triangles, before.position, before.margins());
  Wall wall = before;
  // Twice beside each other, and once in what has been divided already. The last time it is built anew.
  for (const std::vector<int>& which :
       {std::vector{17, 18}, {17, 200}, std::vector{5, 6, 7, 8, 9, 30, 31, 32, 33, 34}}) {
    for (int round = 0; round < 3; ++round) wall = divided(wall, which);
    tree = TriangleTree(wall.triangles, wall.position, wall.margins(), tree);
    EXPECT_EQ(pairs_from(tree, 1e-3), pairs_by_trying_all(wall, 1e-3)) << wall.triangles.size() << " triangles";
  }
}

TEST(TriangleTree, LeavesOutPairsBetweenWhichAGapStaysThroughoutTheMotion) {
  // Two triangles, one 10 mm above the other.
  Wall wall{.triangles = {{0, 1, 2}, {3, 4, 5}}, .position = Eigen::VectorXd::Zero(18)};
  wall.position << 0, 0, 0, 1e-3, 0, 0, 0, 1e-3, 0, 0, 0, 10e-3, 1e-3, 0, 10e-3, 0, 1e-3, 10e-3;
  TriangleTree tree(wall.triangles, wall.position, wall.margins());
  // Aside it goes farther than they lie apart.
  const auto may_meet = [&](double upwards) {
    Eigen::VectorXd motion = Eigen::VectorXd::Zero(18);
    for (int v = 3; v < 6; ++v) motion.segment<3>(3 * v) = Eigen::Vector3d(50e-3, 0, upwards);
    tree.fit(wall.position, motion);
    int pairs = 0;
    tree.visit_meeting(
        0.1, [](std::size_t) {}, [&](std::size_t, int, int) { ++pairs; });
    return pairs > 0;
  };
  EXPECT_FALSE(may_meet(50e-3));
  EXPECT_FALSE(may_meet(-8.5e-3));
  EXPECT_TRUE(may_meet(-9.2e-3)) << "less than a tenth of the gap is left";
  EXPECT_TRUE(may_meet(-50e-3)) << "past each other, with a gap at either end";
}

}  // namespace
}  // namespace thinwall
