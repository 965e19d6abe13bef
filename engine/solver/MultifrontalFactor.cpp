#include "engine/solver/MultifrontalFactor.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <new>
#include <numeric>

#include "engine/solver/FrontAssembly.hpp"

namespace thinwall {
namespace {

/// Numbers of the factor, times sides, from which on several threads solve: handing over costs some microseconds.
constexpr std::ptrdiff_t kWorthSharing = 60'000;

constexpr std::align_val_t kCacheLine{64};  // bytes

template <typename Number>
Numbers<Number> numbers(std::ptrdiff_t count) {
  return Numbers<Number>(static_cast<Number*>(::operator new[](count * sizeof(Number), kCacheLine)));
}

}  // namespace

void FreeNumbers::operator()(void* numbers) const {
  ::operator delete[](numbers, kCacheLine);
}

template <typename Number>
struct MultifrontalFactor<Number>::Desk {
  std::array<Number, kFrontColumns * kPanel> workspace;
  Number* stack = nullptr;
};

template <typename Number>
MultifrontalFactor<Number>::MultifrontalFactor(const SupernodeTree& tree, const EliminationSchedule& schedule)
    : tree_(tree), schedule_(schedule), signs_(tree.place.size()), negative_(schedule.tasks.size()) {
  // The last rows of the last front are read in whole lanes.
  factor_ = numbers<Number>(tree.factor_size + kFrontRows);
  std::fill_n(factor_.get() + tree.factor_size, kFrontRows, Number{0});
  updates_ = numbers<Number>(schedule.handed_over_size);
  solution_ = numbers<Number>(static_cast<std::ptrdiff_t>(tree.place.size()) * kMostSides);
  local_ = numbers<Number>((tree.largest_front + kFrontRows) * kMostSides);
  if (tree.factor_size * kMostSides >= kWorthSharing) make_room_for_sharing();
}

template <typename Number>
void MultifrontalFactor<Number>::make_room_for_sharing() {
  std::ptrdiff_t room = 0;
  for (int task = 0; task < static_cast<int>(schedule_.tasks.size()); ++task) {
    const EliminationTask& own = schedule_.tasks[task];
    if (!own.is_subtree()) continue;
    std::ptrdiff_t largest = 0;
    for (int s = own.begin; s < own.end; ++s) largest = std::max(largest, tree_.supernodes[s].stride);
    subtrees_.push_back({.task = task, .local_begin = room});
    room += largest * kMostSides;
  }
  locals_ = numbers<Number>(room);
  beyond_ = numbers<Number>(schedule_.beyond_size * kMostSides);
}

template <typename Number>
Front<Number> MultifrontalFactor<Number>::front_of(const Supernode& supernode) {
  return {.pivots = supernode.pivots,
          .size = supernode.size,
          .columns = factor_.get() + supernode.factor_begin,
          .stride = supernode.stride,
          .update_stride = supernode.update_stride,
          .signs = signs_.data() + supernode.first};
}

template <typename Number>
Number* MultifrontalFactor<Number>::update_of(int s, const Desk& desk) {
  return (schedule_.is_handed_over[s] ? updates_.get() : desk.stack) + schedule_.update_begin[s];
}

/// Eliminates supernode s, whose children are done; gives what `eliminate` does.
template <typename Number>
int MultifrontalFactor<Number>::eliminate_one(int s, std::span<const double> values, bool allows_negative, Desk& desk) {
  const Supernode& supernode = tree_.supernodes[s];
  Front<Number> front = front_of(supernode);
  front.update = update_of(s, desk);
  front.workspace = desk.workspace.data();
  clear(front);
  enter_values(tree_, supernode, values.data(), factor_.get());
  for (int child = supernode.last_child; child >= 0; child = tree_.supernodes[child].previous_sibling) {
    const Supernode& below = tree_.supernodes[child];
    take_up(tree_.runs_of(below), update_of(child, desk), below.update_stride, front);
  }
  return eliminate(front, allows_negative);
}

/// The same of consecutive ones.
template <typename Number>
int MultifrontalFactor<Number>::eliminate_range(int begin, int end, std::span<const double> values,
                                                bool allows_negative) {
  Numbers<Number>& stack = stacks_.local();
  if (!stack) stack = numbers<Number>(schedule_.stack_size);
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

template <typename Number>
void MultifrontalFactor<Number>::eliminate_task(int task, std::span<const double> values, bool allows_negative) {
  const EliminationTask& own = schedule_.tasks[task];
  eliminate_tasks(own.waits_for, values, allows_negative);
  const bool is_possible = std::ranges::none_of(own.waits_for, [&](int before) { return negative_[before] < 0; });
  negative_[task] = is_possible ? eliminate_range(own.begin, own.end, values, allows_negative) : -1;
}

template <typename Number>
void MultifrontalFactor<Number>::eliminate_tasks(std::span<const int> tasks, std::span<const double> values,
                                                 bool allows_negative) {
  if (tasks.size() == 1) return eliminate_task(tasks[0], values, allows_negative);
  tbb::parallel_for(std::size_t{0}, tasks.size(),
                    [&](std::size_t k) { eliminate_task(tasks[k], values, allows_negative); });
}

template <typename Number>
std::optional<int> MultifrontalFactor<Number>::factorize(std::span<const double> values, bool may_be_indefinite) {
  is_factorised_ = false;
  eliminate_tasks(schedule_.last, values, may_be_indefinite);
  if (std::ranges::any_of(negative_, [](int count) { return count < 0; })) return std::nullopt;
  is_factorised_ = true;
  return std::accumulate(negative_.begin(), negative_.end(), 0);
}

/// A front's part in solving for `solution_`, (unknowns x sides) by rows, of which there are 1, 4 or 8: from the
/// leaves up first. Rows past the first `within` get nothing yet: what they would get is given.
template <typename Number>
template <int sides>
const Number* MultifrontalFactor<Number>::go_up(const Supernode& supernode, int within, Number* front) {
  Number* pivots = solution_.get() + supernode.first * sides;
  Number* below = std::copy_n(pivots, supernode.pivots * sides, front);
  std::fill(below, front + supernode.stride * sides, Number{0});
  // What a contact pushes is nothing to most fronts.
  if (std::all_of(front, below, [](Number value) { return value == 0; })) return below + within * sides;
  solve_forward(front_of(supernode), sides, front);
  const Number* from = front;
  for (int k = 0; k < supernode.pivots; ++k) {
    for (int c = 0; c < sides; ++c) *pivots++ = signs_[supernode.first + k] * *from++;
  }
  return add_to_rows<sides>(supernode, 0, within, from);
}

template <typename Number>
template <int sides>
void MultifrontalFactor<Number>::go_up(const Supernode& supernode) {
  go_up<sides>(supernode, supernode.size - supernode.pivots, local_.get());
}

/// Adds to a front's rows below its pivots from one to another; gives the end of what was added.
template <typename Number>
template <int sides>
const Number* MultifrontalFactor<Number>::add_to_rows(const Supernode& supernode, int begin, int end,
                                                      const Number* from) {
  const int* rows = tree_.rows.data() + supernode.rows_begin;
  for (int k = begin; k < end; ++k) {
    Number* to = solution_.get() + rows[k] * sides;
    for (int c = 0; c < sides; ++c) *to++ += *from++;
  }
  return from;
}

/// The same from the roots down, once all fronts have gone up.
template <typename Number>
template <int sides>
void MultifrontalFactor<Number>::go_down(const Supernode& supernode, Number* front) {
  const int* rows = tree_.rows.data() + supernode.rows_begin;
  Number* pivots = solution_.get() + supernode.first * sides;
  Number* to = std::copy_n(pivots, supernode.pivots * sides, front);
  for (int k = supernode.pivots; k < supernode.size; ++k) {
    to = std::copy_n(solution_.get() + *rows++ * sides, sides, to);
  }
  std::fill(to, front + supernode.stride * sides, Number{0});
  solve_backward(front_of(supernode), sides, front);
  std::copy_n(front, supernode.pivots * sides, pivots);
}

/// All fronts, up and down.
template <typename Number>
template <int sides>
void MultifrontalFactor<Number>::go_through() {
  for (const Supernode& supernode : tree_.supernodes) go_up<sides>(supernode);
  for (auto supernode = tree_.supernodes.rbegin(); supernode != tree_.supernodes.rend(); ++supernode) {
    go_down<sides>(*supernode, local_.get());
  }
}

/// The same with subtrees side by side: equal to the bit.
template <typename Number>
template <int sides>
void MultifrontalFactor<Number>::go_through_shared() {
  tbb::parallel_for(std::size_t{0}, subtrees_.size(), [&](std::size_t k) { go_up_subtree<sides>(subtrees_[k]); });
  for (const EliminationTask& task : schedule_.tasks) {
    for (int s = task.begin; s < task.end; ++s) {
      const Supernode& supernode = tree_.supernodes[s];
      if (!task.is_subtree()) {
        go_up<sides>(supernode);
      } else {
        add_to_rows<sides>(supernode, schedule_.rows_within[s], supernode.size - supernode.pivots,
                           beyond_.get() + schedule_.beyond_begin[s] * sides);
      }
    }
  }
  for (auto task = schedule_.tasks.rbegin(); task != schedule_.tasks.rend(); ++task) {
    if (!task->is_subtree()) go_down<sides>(tree_.supernodes[task->begin], local_.get());
  }
  tbb::parallel_for(std::size_t{0}, subtrees_.size(), [&](std::size_t k) {
    const EliminationTask& task = schedule_.tasks[subtrees_[k].task];
    Number* front = locals_.get() + subtrees_[k].local_begin;
    for (int s = task.end - 1; s >= task.begin; --s) go_down<sides>(tree_.supernodes[s], front);
  });
}

template <typename Number>
template <int sides>
void MultifrontalFactor<Number>::go_up_subtree(const Subtree& subtree) {
  const EliminationTask& task = schedule_.tasks[subtree.task];
  for (int s = task.begin; s < task.end; ++s) {
    const Supernode& supernode = tree_.supernodes[s];
    const int within = schedule_.rows_within[s], rows = supernode.size - supernode.pivots;
    const Number* left = go_up<sides>(supernode, within, locals_.get() + subtree.local_begin);
    std::copy_n(left, (rows - within) * sides, beyond_.get() + schedule_.beyond_begin[s] * sides);
  }
}

/// Solves `sides` columns or fewer.
template <typename Number>
template <int sides>
void MultifrontalFactor<Number>::solve_some(Eigen::Ref<Eigen::MatrixXd> columns) {
  std::fill_n(solution_.get(), columns.rows() * sides, Number{0});
  for (Eigen::Index k = 0; k < columns.rows(); ++k) {
    Number* row = solution_.get() + tree_.place[k] * sides;
    for (Eigen::Index column = 0; column < columns.cols(); ++column) {
      row[column] = static_cast<Number>(columns(k, column));
    }
  }
  const bool is_shared = tree_.factor_size * sides >= kWorthSharing;
  is_shared ? go_through_shared<sides>() : go_through<sides>();
  for (Eigen::Index k = 0; k < columns.rows(); ++k) {
    const Number* row = solution_.get() + tree_.place[k] * sides;
    for (Eigen::Index column = 0; column < columns.cols(); ++column) columns(k, column) = row[column];
  }
}

template <typename Number>
void MultifrontalFactor<Number>::solve(Eigen::Ref<Eigen::MatrixXd>& right_hand_sides) {
  const Eigen::Index columns = right_hand_sides.cols();
  Eigen::Index first = 0;
  for (; columns - first > 4; first += kMostSides) {
    solve_some<kMostSides>(right_hand_sides.middleCols(first, std::min<Eigen::Index>(kMostSides, columns - first)));
  }
  // Two of them cost as much one by one.
  for (; columns - first > 2; first += 4) {
    solve_some<4>(right_hand_sides.middleCols(first, std::min<Eigen::Index>(4, columns - first)));
  }
  for (; first < columns; ++first) solve_some<1>(right_hand_sides.col(first));
}

template <typename Number>
void MultifrontalFactor<Number>::solve_part(std::span<const int> unknowns, std::span<const int> fronts,
                                            Eigen::Ref<Eigen::VectorXd>& right_hand_side) {
  for (const int s : fronts) {
    std::fill_n(solution_.get() + tree_.supernodes[s].first, tree_.supernodes[s].pivots, Number{0});
  }
  for (Eigen::Index k = 0; k < right_hand_side.size(); ++k) {
    solution_[tree_.place[unknowns[k]]] = static_cast<Number>(right_hand_side[k]);
  }
  for (const int s : fronts) go_up<1>(tree_.supernodes[s]);
  for (auto s = fronts.rbegin(); s != fronts.rend(); ++s) go_down<1>(tree_.supernodes[*s], local_.get());
  for (Eigen::Index k = 0; k < right_hand_side.size(); ++k) {
    right_hand_side[k] = solution_[tree_.place[unknowns[k]]];
  }
}

template class MultifrontalFactor<double>;
template class MultifrontalFactor<float>;

}  // namespace thinwall
