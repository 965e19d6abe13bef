#pragma once

#include <cstddef>
#include <vector>

#include "engine/solver/SupernodeTree.hpp"

namespace thinwall {

/// Consecutive supernodes that are eliminated one after the other, once the tasks that it waits for are done.
struct EliminationTask {
  int begin = 0, end = 0;      // supernodes
  std::vector<int> waits_for;  // tasks, of which none waits for another one: they may go side by side

  bool is_subtree() const { return waits_for.empty(); }
};

/// How a tree is eliminated by several threads: subtrees of a fair part of the work each, and one by one the fronts
/// above them. What each front computes, and from what, is the same with any number of threads. In a solution subtrees
/// go side by side too: what their fronts bring to rows above waits until they are done, and is then added in the order
/// of the fronts, as one after the other would add it.
struct EliminationSchedule {
  std::vector<EliminationTask> tasks;
  std::vector<int> last;                     // tasks that no other waits for
  std::vector<char> is_handed_over;          // (supernodes), whether another task takes its update up
  std::vector<std::ptrdiff_t> update_begin;  // (supernodes), where each leaves its update for the front above
  std::ptrdiff_t handed_over_size = 0;       // room for all that are handed over
  std::ptrdiff_t stack_size = 0;             // room for the others of one task, whatever it was used for before
  std::vector<int> rows_within;              // (supernodes), rows below its pivots that its own task eliminates
  std::vector<std::ptrdiff_t> beyond_begin;  // (supernodes), where what it brings to its other rows waits
  std::ptrdiff_t beyond_size = 0;            // room for all of it
};
EliminationSchedule make_elimination_schedule(const SupernodeTree& tree);

}  // namespace thinwall
