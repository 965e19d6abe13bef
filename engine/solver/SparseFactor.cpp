#include "engine/solver/SparseFactor.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <memory>
#include <new>
#include <numeric>
#include <utility>
#include <vector>

#include "engine/solver/EliminationSchedule.hpp"
#include "engine/solver/FrontAssembly.hpp"
#include "engine/solver/FrontFactor.hpp"
#include "engine/solver/NodeOrder.hpp"
#include "engine/solver/SupernodeTree.hpp"

namespace thinwall {
namespace {

/// Right-hand sides that are solved side by side, at most.
constexpr int kMostSides = 8;

/// Numbers of the factor, times sides, from which on several threads solve: handing over costs some microseconds.
constexpr std::ptrdiff_t kWorthSharing = 60'000;

constexpr std::align_val_t kCacheLine{64};  // bytes

/// Numbers of no value yet, of which the lanes of fronts that begin at a multiple of kFrontRows fill whole cache lines.
struct FreeNumbers {
  void operator()(double* numbers) const { ::operator delete[](numbers, kCacheLine); }
};
using Numbers = std::unique_ptr<double[], FreeNumbers>;
Numbers numbers(std::ptrdiff_t count) {
  return Numbers(static_cast<double*>(::operator new[](count * sizeof(double), kCacheLine)));
}

/// A task that is one, and where its fronts are solved.
struct Subtree {
  int task = 0;
  std::ptrdiff_t local_begin = 0;  // into what all of them have for that
};

using FrontSolution = void (*)(const Front&, double*);
template <int sides>
constexpr FrontSolution forward_of() {
  return sides == 1 ? solve_forward : sides == 4 ? solve_four_forward : solve_eight_forward;
}
template <int sides>
constexpr FrontSolution backward_of() {
  return sides == 1 ? solve_backward : sides == 4 ? solve_four_backward : solve_eight_backward;
}

}  // namespace

struct SparseFactor::Implementation {
  int vertices = 0, unknowns = 0, nonzeros = 0;
  NodeGraph graph;
  std::vector<int> nodes;   // in their order
  std::vector<int> parent;  // (nodes), in the elimination tree
  SupernodeTree tree;
  EliminationSchedule schedule;
  std::vector<int> front_at;       // (unknowns), of their places
  double operations_per_node = 0;  // with the last order that was not taken over
  // None of the numbers is cleared before what is used of them is.
  Numbers factor;   // columns of all supernodes
  Numbers updates;  // that wait for other tasks
  tbb::enumerable_thread_specific<Numbers>
      stacks;                 // where those of its own task wait: of each thread, as it is near it
  std::vector<double> signs;  // (unknowns)
  std::vector<int> negative;  // (tasks), pivots below zero; -1 where one cannot be
  Numbers solution;           // (unknowns x kMostSides) by rows, in the order of elimination
  Numbers local;              // (unknowns of one front x kMostSides) by rows
  Numbers locals;             // the same of subtrees that are solved side by side
  Numbers beyond;             // (rows beyond subtrees x kMostSides) by rows, see EliminationSchedule
  std::vector<Subtree> subtrees;
  bool is_factorised = false;

  explicit Implementation(const BlockPattern& pattern, const Implementation* before = nullptr)
      : vertices(pattern.vertices),
        unknowns(pattern.unknowns()),
        nonzeros(pattern.nonzeros()),
        graph(graph_of(pattern)) {
    if (before != nullptr) {
      set_order(
          pattern,
          extended_order(
              {.graph = before->graph, .order = before->nodes, .parent = before->parent, .vertices = before->vertices},
              graph, vertices));
      operations_per_node = before->operations_per_node;
    }
    if (before == nullptr || tree.operations > kWorseOrder * operations_per_node * pattern.nodes()) {
      set_order(pattern, nested_dissection(pattern));
      operations_per_node = tree.operations / std::max(1, pattern.nodes());
    }
    // The last rows of the last front are read in whole lanes.
    factor = numbers(tree.factor_size + kFrontRows);
    std::fill_n(factor.get() + tree.factor_size, kFrontRows, 0.0);
    signs.resize(unknowns);
    schedule = make_elimination_schedule(tree);
    updates = numbers(schedule.handed_over_size);
    negative.resize(schedule.tasks.size());
    solution = numbers(static_cast<std::ptrdiff_t>(unknowns) * kMostSides);
    local = numbers((tree.largest_front + kFrontRows) * kMostSides);
    if (tree.factor_size * kMostSides >= kWorthSharing) make_room_for_sharing();
  }

  void make_room_for_sharing() {
    std::ptrdiff_t room = 0;
    for (int task = 0; task < static_cast<int>(schedule.tasks.size()); ++task) {
      const EliminationTask& own = schedule.tasks[task];
      if (!own.is_subtree()) continue;
      std::ptrdiff_t largest = 0;
      for (int s = own.begin; s < own.end; ++s) largest = std::max(largest, tree.supernodes[s].stride);
      subtrees.push_back({.task = task, .local_begin = room});
      room += largest * kMostSides;
    }
    locals = numbers(room);
    beyond = numbers(schedule.beyond_size * kMostSides);
  }

  void set_order(const BlockPattern& pattern, std::vector<int> order) {
    nodes = std::move(order);
    parent = elimination_tree(graph, nodes);
    tree = make_supernode_tree(pattern, graph, nodes, parent);
    front_at.resize(unknowns);
    for (int s = 0; s < static_cast<int>(tree.supernodes.size()); ++s) {
      std::fill_n(front_at.begin() + tree.supernodes[s].first, tree.supernodes[s].pivots, s);
    }
  }

  Front front_of(const Supernode& supernode) {
    return {.pivots = supernode.pivots,
            .size = supernode.size,
            .columns = factor.get() + supernode.factor_begin,
            .stride = supernode.stride,
            .update_stride = supernode.update_stride,
            .signs = signs.data() + supernode.first};
  }

  /// What a thread works with.
  struct Desk {
    std::array<double, kFrontColumns * kPanel> workspace;
    double* stack = nullptr;
  };

  double* update_of(int s, const Desk& desk) {
    return (schedule.is_handed_over[s] ? updates.get() : desk.stack) + schedule.update_begin[s];
  }

  /// Eliminates supernode s, whose children are done; gives what `eliminate` does.
  int eliminate_one(int s, std::span<const double> values, bool allows_negative, Desk& desk) {
    const Supernode& supernode = tree.supernodes[s];
    Front front = front_of(supernode);
    front.update = update_of(s, desk);
    front.workspace = desk.workspace.data();
    clear(front);
    enter_values(tree, supernode, values.data(), factor.get());
    for (int child = supernode.last_child; child >= 0; child = tree.supernodes[child].previous_sibling) {
      const Supernode& below = tree.supernodes[child];
      take_up(tree.runs_of(below), update_of(child, desk), below.update_stride, front);
    }
    return eliminate(front, allows_negative);
  }

  /// The same of consecutive ones.
  int eliminate_range(int begin, int end, std::span<const double> values, bool allows_negative) {
    Numbers& stack = stacks.local();
    if (!stack) stack = numbers(schedule.stack_size);
    Desk desk;
    desk.stack = stack.get();
    int all = 0;
    for (int s = begin; s < end; ++s) {
      const int own = eliminate_one(s, values, allows_negative, desk);
      if (own < 0) return -1;
      all += own;
    }
    return all;
  }

  void eliminate_task(int task, std::span<const double> values, bool allows_negative) {
    const EliminationTask& own = schedule.tasks[task];
    eliminate_tasks(own.waits_for, values, allows_negative);
    const bool is_possible = std::ranges::none_of(own.waits_for, [&](int before) { return negative[before] < 0; });
    negative[task] = is_possible ? eliminate_range(own.begin, own.end, values, allows_negative) : -1;
  }

  void eliminate_tasks(std::span<const int> tasks, std::span<const double> values, bool allows_negative) {
    if (tasks.size() == 1) return eliminate_task(tasks[0], values, allows_negative);
    tbb::parallel_for(std::size_t{0}, tasks.size(),
                      [&](std::size_t k) { eliminate_task(tasks[k], values, allows_negative); });
  }

  std::optional<int> eliminate_all(std::span<const double> values, bool allows_negative) {
    assert(static_cast<int>(values.size()) == nonzeros);
    is_factorised = false;
    eliminate_tasks(schedule.last, values, allows_negative);
    if (std::ranges::any_of(negative, [](int count) { return count < 0; })) return std::nullopt;
    is_factorised = true;
    return std::accumulate(negative.begin(), negative.end(), 0);
  }

  /// A front's part in solving for `solution`, (unknowns x sides) by rows, of which there are 1, 4 or 8: from the
  /// leaves up first. Rows past the first `within` get nothing yet: what they would get is given.
  template <int sides>
  const double* go_up(const Supernode& supernode, int within, double* front) {
    double* pivots = solution.get() + supernode.first * sides;
    double* below = std::copy_n(pivots, supernode.pivots * sides, front);
    std::fill(below, front + supernode.stride * sides, 0.0);
    // What a contact pushes is nothing to most fronts.
    if (std::all_of(front, below, [](double value) { return value == 0; })) return below + within * sides;
    forward_of<sides>()(front_of(supernode), front);
    const double* from = front;
    for (int k = 0; k < supernode.pivots; ++k) {
      for (int c = 0; c < sides; ++c) *pivots++ = signs[supernode.first + k] * *from++;
    }
    return add_to_rows<sides>(supernode, 0, within, from);
  }

  template <int sides>
  void go_up(const Supernode& supernode) {
    go_up<sides>(supernode, supernode.size - supernode.pivots, local.get());
  }

  /// Adds to a front's rows below its pivots from one to another; gives the end of what was added.
  template <int sides>
  const double* add_to_rows(const Supernode& supernode, int begin, int end, const double* from) {
    const int* rows = tree.rows.data() + supernode.rows_begin;
    for (int k = begin; k < end; ++k) {
      double* to = solution.get() + rows[k] * sides;
      for (int c = 0; c < sides; ++c) *to++ += *from++;
    }
    return from;
  }

  /// The same from the roots down, once all fronts have gone up.
  template <int sides>
  void go_down(const Supernode& supernode, double* front) {
    const int* rows = tree.rows.data() + supernode.rows_begin;
    double* pivots = solution.get() + supernode.first * sides;
    double* to = std::copy_n(pivots, supernode.pivots * sides, front);
    for (int k = supernode.pivots; k < supernode.size; ++k) {
      to = std::copy_n(solution.get() + *rows++ * sides, sides, to);
    }
    std::fill(to, front + supernode.stride * sides, 0.0);
    backward_of<sides>()(front_of(supernode), front);
    std::copy_n(front, supernode.pivots * sides, pivots);
  }

  /// All fronts, up and down.
  template <int sides>
  void go_through() {
    for (const Supernode& supernode : tree.supernodes) go_up<sides>(supernode);
    for (auto supernode = tree.supernodes.rbegin(); supernode != tree.supernodes.rend(); ++supernode) {
      go_down<sides>(*supernode, local.get());
    }
  }

  /// The same with subtrees side by side: equal to the bit.
  template <int sides>
  void go_through_shared() {
    tbb::parallel_for(std::size_t{0}, subtrees.size(), [&](std::size_t k) { go_up_subtree<sides>(subtrees[k]); });
    for (const EliminationTask& task : schedule.tasks) {
      for (int s = task.begin; s < task.end; ++s) {
        const Supernode& supernode = tree.supernodes[s];
        if (!task.is_subtree()) {
          go_up<sides>(supernode);
        } else {
          add_to_rows<sides>(supernode, schedule.rows_within[s], supernode.size - supernode.pivots,
                             beyond.get() + schedule.beyond_begin[s] * sides);
        }
      }
    }
    for (auto task = schedule.tasks.rbegin(); task != schedule.tasks.rend(); ++task) {
      if (!task->is_subtree()) go_down<sides>(tree.supernodes[task->begin], local.get());
    }
    tbb::parallel_for(std::size_t{0}, subtrees.size(), [&](std::size_t k) {
      const EliminationTask& task = schedule.tasks[subtrees[k].task];
      double* front = locals.get() + subtrees[k].local_begin;
      for (int s = task.end - 1; s >= task.begin; --s) go_down<sides>(tree.supernodes[s], front);
    });
  }

  template <int sides>
  void go_up_subtree(const Subtree& subtree) {
    const EliminationTask& task = schedule.tasks[subtree.task];
    for (int s = task.begin; s < task.end; ++s) {
      const Supernode& supernode = tree.supernodes[s];
      const int within = schedule.rows_within[s], rows = supernode.size - supernode.pivots;
      const double* left = go_up<sides>(supernode, within, locals.get() + subtree.local_begin);
      std::copy_n(left, (rows - within) * sides, beyond.get() + schedule.beyond_begin[s] * sides);
    }
  }

  /// Solves `sides` columns or fewer.
  template <int sides>
  void solve(Eigen::Ref<Eigen::MatrixXd> columns) {
    std::fill_n(solution.get(), columns.rows() * sides, 0.0);
    for (Eigen::Index k = 0; k < columns.rows(); ++k) {
      double* row = solution.get() + tree.place[k] * sides;
      for (Eigen::Index column = 0; column < columns.cols(); ++column) row[column] = columns(k, column);
    }
    const bool is_shared = tree.factor_size * sides >= kWorthSharing;
    is_shared ? go_through_shared<sides>() : go_through<sides>();
    for (Eigen::Index k = 0; k < columns.rows(); ++k) {
      const double* row = solution.get() + tree.place[k] * sides;
      for (Eigen::Index column = 0; column < columns.cols(); ++column) columns(k, column) = row[column];
    }
  }

  std::vector<int> fronts_above(std::span<const int> of_unknowns) const {
    std::vector<char> is_above(tree.supernodes.size(), 0);
    for (const int unknown : of_unknowns) {
      for (int s = front_at[tree.place[unknown]]; s >= 0 && !is_above[s]; s = tree.supernodes[s].parent)
        is_above[s] = 1;
    }
    std::vector<int> fronts;
    for (int s = 0; s < static_cast<int>(is_above.size()); ++s) {
      if (is_above[s]) fronts.push_back(s);
    }
    return fronts;
  }

  void solve_part(const Part& part, Eigen::Ref<Eigen::VectorXd>& column) {
    for (const int s : part.fronts) {
      std::fill_n(solution.get() + tree.supernodes[s].first, tree.supernodes[s].pivots, 0.0);
    }
    for (Eigen::Index k = 0; k < column.size(); ++k) solution[tree.place[part.unknowns[k]]] = column[k];
    for (const int s : part.fronts) go_up<1>(tree.supernodes[s]);
    for (auto s = part.fronts.rbegin(); s != part.fronts.rend(); ++s) go_down<1>(tree.supernodes[*s], local.get());
    for (Eigen::Index k = 0; k < column.size(); ++k) column[k] = solution[tree.place[part.unknowns[k]]];
  }
};

SparseFactor::SparseFactor(const BlockPattern& pattern) : implementation_(std::make_unique<Implementation>(pattern)) {}
SparseFactor::SparseFactor(const BlockPattern& pattern, const SparseFactor& before)
    : implementation_(std::make_unique<Implementation>(pattern, before.implementation_.get())) {}
SparseFactor::~SparseFactor() = default;
SparseFactor::SparseFactor(SparseFactor&&) noexcept = default;
SparseFactor& SparseFactor::operator=(SparseFactor&&) noexcept = default;

std::optional<int> SparseFactor::factorize(std::span<const double> values, bool may_be_indefinite) {
  return implementation_->eliminate_all(values, may_be_indefinite);
}

double SparseFactor::operations() const {
  return implementation_->tree.operations;
}

void SparseFactor::solve(Eigen::Ref<Eigen::MatrixXd> right_hand_sides) {
  assert(implementation_->is_factorised);
  const Eigen::Index columns = right_hand_sides.cols();
  Eigen::Index first = 0;
  for (; columns - first > 4; first += kMostSides) {
    implementation_->solve<kMostSides>(
        right_hand_sides.middleCols(first, std::min<Eigen::Index>(kMostSides, columns - first)));
  }
  // Two of them cost as much one by one.
  for (; columns - first > 2; first += 4) {
    implementation_->solve<4>(right_hand_sides.middleCols(first, std::min<Eigen::Index>(4, columns - first)));
  }
  for (; first < columns; ++first) implementation_->solve<1>(right_hand_sides.col(first));
}

double SparseFactor::cost_of(Eigen::Index right_hand_sides) {
  constexpr double kCostOfFour = 2, kCostOfEight = 3.5;
  const Eigen::Index eights = right_hand_sides / kMostSides, rest = right_hand_sides % kMostSides;
  const double cost_of_rest = rest > 4 ? kCostOfEight : rest > 2 ? kCostOfFour : static_cast<double>(rest);
  return kCostOfEight * static_cast<double>(eights) + cost_of_rest;
}

SparseFactor::Part SparseFactor::part_of(std::vector<int> unknowns) const {
  std::vector<int> fronts = implementation_->fronts_above(unknowns);
  return {.unknowns = std::move(unknowns), .fronts = std::move(fronts)};
}

void SparseFactor::solve_part(const Part& part, Eigen::Ref<Eigen::VectorXd> right_hand_side) {
  assert(implementation_->is_factorised && part.unknowns.size() == static_cast<std::size_t>(right_hand_side.size()));
  implementation_->solve_part(part, right_hand_side);
}

}  // namespace thinwall
