// What may be eliminated side by side.

#include "engine/solver/EliminationSchedule.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "engine/mesh/Shapes.hpp"
#include "engine/solver/NodeOrder.hpp"

namespace thinwall {
namespace {

struct Scheduled {
  SupernodeTree tree;
  EliminationSchedule schedule;
  std::vector<int> task_of;  // (supernodes)

  explicit Scheduled(const std::vector<int>& sizes) {
    // Bodies of these numbers of triangles that have nothing in common.
    std::vector<Eigen::Vector3i> triangles;
    int vertices = 0;
    for (const int size : sizes) {
      const SurfaceMesh mesh = make_sphere(1, size);
      for (const Eigen::Vector3i& triangle : mesh.triangles) triangles.emplace_back(triangle.array() + vertices);
      vertices += static_cast<int>(mesh.vertices.size());
    }
    const BlockPattern pattern = make_block_pattern(vertices, triangles);
    tree = make_supernode_tree(pattern, nested_dissection(pattern));
    schedule = make_elimination_schedule(tree);
    task_of.assign(tree.supernodes.size(), -1);
    for (int task = 0; task < static_cast<int>(schedule.tasks.size()); ++task) {
      for (int s = schedule.tasks[task].begin; s < schedule.tasks[task].end; ++s) {
        EXPECT_EQ(task_of[s], -1) << "in two tasks";
        task_of[s] = task;
      }
    }
  }
};

std::vector<Scheduled> trees() {
  return {Scheduled({80}), Scheduled({1280}), Scheduled({5120}), Scheduled({80, 1280, 320, 320, 80})};
}

TEST(EliminationSchedule, HasEachFrontInOneTaskThatWaitsForThoseBelow) {
  for (const Scheduled& one : trees()) {
    for (int s = 0; s < static_cast<int>(one.tree.supernodes.size()); ++s) {
      ASSERT_GE(one.task_of[s], 0) << "in no task";
      const int parent = one.tree.supernodes[s].parent;
      if (parent < 0) {
        EXPECT_EQ(std::ranges::count(one.schedule.last, one.task_of[s]), 1);
      } else if (one.task_of[parent] != one.task_of[s]) {
        EXPECT_EQ(std::ranges::count(one.schedule.tasks[one.task_of[parent]].waits_for, one.task_of[s]), 1);
      }
    }
  }
}

TEST(EliminationSchedule, SharesOutLargeTreesAndLeavesSmallOnesWhole) {
  EXPECT_EQ(Scheduled({80}).schedule.tasks.size(), 1U);
  EXPECT_EQ(Scheduled({80, 80}).schedule.tasks.size(), 1U);
  const Scheduled large({5120});
  EXPECT_GE(large.schedule.tasks.size(), 8U);
  EXPECT_LE(large.schedule.tasks.size(), 64U);
}

TEST(EliminationSchedule, NoUpdateLiesWhereAnotherOneWaits) {
  for (const Scheduled& one : trees()) {
    const auto& supernodes = one.tree.supernodes;
    for (int a = 0; a < static_cast<int>(supernodes.size()); ++a) {
      const auto end_of = [&](int s) {
        return one.schedule.update_begin[s] + supernodes[s].update_stride * (supernodes[s].size - supernodes[s].pivots);
      };
      const bool is_handed_over = one.schedule.is_handed_over[a] != 0;
      ASSERT_LE(end_of(a), is_handed_over ? one.schedule.handed_over_size : one.schedule.stack_size);
      if (supernodes[a].parent >= 0) {
        EXPECT_EQ(is_handed_over, one.task_of[supernodes[a].parent] != one.task_of[a]);
      }
      for (int b = a + 1; b < static_cast<int>(supernodes.size()); ++b) {
        const bool overlap = one.schedule.update_begin[a] < end_of(b) && one.schedule.update_begin[b] < end_of(a);
        const bool together = is_handed_over == (one.schedule.is_handed_over[b] != 0);
        if (!overlap || !together) continue;
        // In one stack they follow one another, and the first is taken up before the second begins; another task has
        // another stack, or the same one later.
        EXPECT_FALSE(is_handed_over);
        if (one.task_of[a] == one.task_of[b]) {
          EXPECT_LT(supernodes[a].parent, b);
        }
      }
    }
  }
}

}  // namespace
}  // namespace thinwall
