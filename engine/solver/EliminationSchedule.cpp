#include "engine/solver/EliminationSchedule.hpp"

#include <algorithm>
#include <numeric>
#include <span>

namespace thinwall {
namespace {

/// Operations of a task at most: a part of all of them, and what is worth to be handed over to another thread.
constexpr double kLargestPart = 0.125;
constexpr double kWorthSharing = 1e6;

/// Operations of the subtree below each supernode, itself included, and the subtree's first supernode.
struct Subtrees {
  std::vector<double> operations;
  std::vector<int> first;
  double all = 0;

  explicit Subtrees(const SupernodeTree& tree) : operations(tree.supernodes.size(), 0), first(tree.supernodes.size()) {
    std::iota(first.begin(), first.end(), 0);
    for (int s = 0; s < static_cast<int>(tree.supernodes.size()); ++s) {
      const Supernode& supernode = tree.supernodes[s];
      for (int k = 0; k < supernode.pivots; ++k) {
        operations[s] += static_cast<double>(supernode.size - k) * (supernode.size - k);
      }
      if (supernode.parent < 0) {
        all += operations[s];
        continue;
      }
      operations[supernode.parent] += operations[s];
      first[supernode.parent] = std::min(first[supernode.parent], first[s]);
    }
  }
};

/// Updates of a task's fronts wait in two stacks: those of a front's children lie on top of one when its own goes on
/// top of the other. Those that another task takes up lie elsewhere.
void place_updates(const SupernodeTree& tree, const EliminationTask& task, EliminationSchedule& schedule) {
  std::ptrdiff_t used[2] = {0, 0}, most[2] = {0, 0};
  for (int s = task.begin; s < task.end; ++s) {
    const Supernode& supernode = tree.supernodes[s];
    const int parity = supernode.depth % 2;
    const std::ptrdiff_t size = supernode.update_stride * (supernode.size - supernode.pivots);
    schedule.is_handed_over[s] = supernode.parent < 0 || supernode.parent >= task.end;
    std::ptrdiff_t& end = schedule.is_handed_over[s] ? schedule.handed_over_size : used[parity];
    schedule.update_begin[s] = end;
    end += size;
    most[parity] = std::max(most[parity], used[parity]);
    for (int child = supernode.last_child; child >= task.begin; child = tree.supernodes[child].previous_sibling) {
      used[1 - parity] = std::min(used[1 - parity], schedule.update_begin[child]);
    }
  }
  for (int s = task.begin; s < task.end; ++s) {
    if (!schedule.is_handed_over[s] && tree.supernodes[s].depth % 2 == 1) schedule.update_begin[s] += most[0];
  }
  schedule.stack_size = std::max(schedule.stack_size, most[0] + most[1]);
}

/// Which rows of a subtree's fronts lie above it.
void place_beyond(const SupernodeTree& tree, const EliminationTask& task, EliminationSchedule& schedule) {
  const Supernode& last = tree.supernodes[task.end - 1];
  for (int s = task.begin; s < task.end; ++s) {
    const Supernode& supernode = tree.supernodes[s];
    const std::span<const int> rows =
        std::span(tree.rows).subspan(supernode.rows_begin, supernode.size - supernode.pivots);
    const auto beyond = std::ranges::lower_bound(rows, last.first + last.pivots);
    schedule.rows_within[s] = static_cast<int>(beyond - rows.begin());
    schedule.beyond_begin[s] = schedule.beyond_size;
    schedule.beyond_size += rows.end() - beyond;
  }
}

}  // namespace

EliminationSchedule make_elimination_schedule(const SupernodeTree& tree) {
  const Subtrees subtrees(tree);
  const auto supernodes = static_cast<int>(tree.supernodes.size());
  const double most = std::max(kWorthSharing, kLargestPart * subtrees.all);
  EliminationSchedule schedule;
  schedule.is_handed_over.resize(tree.supernodes.size());
  schedule.update_begin.resize(tree.supernodes.size());
  schedule.rows_within.resize(tree.supernodes.size());
  schedule.beyond_begin.resize(tree.supernodes.size());
  std::vector<std::vector<int>> below(supernodes + 1);  // tasks, by the front that waits for them; last: by none
  double gathered = 0;                                  // operations of the last task
  int gathered_for = -1;                                // front that waits for it, where more may join it
  for (int s = 0; s < supernodes; ++s) {
    const int parent = tree.supernodes[s].parent, waiting = parent < 0 ? supernodes : parent;
    const auto task = static_cast<int>(schedule.tasks.size());
    if (subtrees.operations[s] > most) {
      below[waiting].push_back(task);
      schedule.tasks.push_back({.begin = s, .end = s + 1, .waits_for = below[s]});
      gathered_for = -1;
      continue;
    }
    if (parent >= 0 && subtrees.operations[parent] <= most) continue;
    if (gathered_for == waiting && gathered + subtrees.operations[s] <= most) {
      gathered += subtrees.operations[s];
      schedule.tasks.back().end = s + 1;
      continue;
    }
    gathered = subtrees.operations[s];
    gathered_for = waiting;
    below[waiting].push_back(task);
    schedule.tasks.push_back({.begin = subtrees.first[s], .end = s + 1, .waits_for = {}});
  }
  schedule.last = below[supernodes];
  for (const EliminationTask& task : schedule.tasks) {
    place_updates(tree, task, schedule);
    if (task.is_subtree()) place_beyond(tree, task, schedule);
  }
  return schedule;
}

}  // namespace thinwall
