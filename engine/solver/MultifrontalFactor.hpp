#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/solver/EliminationSchedule.hpp"
#include "engine/solver/FrontFactor.hpp"
#include "engine/solver/SupernodeTree.hpp"

namespace thinwall {

/// Numbers of no value yet, of which the lanes of fronts that begin at a multiple of kFrontRows fill whole cache lines.
struct FreeNumbers {
  void operator()(void* numbers) const;
};
template <typename Number>
using Numbers = std::unique_ptr<Number[], FreeNumbers>;

/// The numbers of a factor L S L^T, of double or of single precision, over a tree and a schedule that were made before
/// and must outlive it: fronts are eliminated from the leaves up (Duff and Reid 1983), and right-hand sides go up and
/// down the tree.
template <typename Number>
class MultifrontalFactor {
 public:
  MultifrontalFactor(const SupernodeTree& tree, const EliminationSchedule& schedule);

  /// `values` as the pattern has them; gives what SparseFactor::factorize does.
  std::optional<int> factorize(std::span<const double> values, bool may_be_indefinite);
  bool is_factorised() const { return is_factorised_; }

  /// Right-hand sides that are solved side by side, at most.
  static constexpr int kMostSides = 8;

  /// (unknowns x right-hand sides), in place.
  void solve(Eigen::Ref<Eigen::MatrixXd>& right_hand_sides);

  /// Solves with some fronts alone: (unknowns), which they hold, in place. `fronts`: ascending.
  void solve_part(std::span<const int> unknowns, std::span<const int> fronts,
                  Eigen::Ref<Eigen::VectorXd>& right_hand_side);

 private:
  /// A task that is one, and where its fronts are solved.
  struct Subtree {
    int task = 0;
    std::ptrdiff_t local_begin = 0;  // into what all of them have for that
  };
  /// What a thread works with.
  struct Desk;

  void make_room_for_sharing();
  Front<Number> front_of(const Supernode& supernode);
  Number* update_of(int s, const Desk& desk);
  int eliminate_one(int s, std::span<const double> values, bool allows_negative, Desk& desk);
  int eliminate_range(int begin, int end, std::span<const double> values, bool allows_negative);
  void eliminate_task(int task, std::span<const double> values, bool allows_negative);
  void eliminate_tasks(std::span<const int> tasks, std::span<const double> values, bool allows_negative);
  template <int sides>
  const Number* go_up(const Supernode& supernode, int within, Number* front);
  template <int sides>
  void go_up(const Supernode& supernode);
  template <int sides>
  const Number* add_to_rows(const Supernode& supernode, int begin, int end, const Number* from);
  template <int sides>
  void go_down(const Supernode& supernode, Number* front);
  template <int sides>
  void go_through();
  template <int sides>
  void go_through_shared();
  template <int sides>
  void go_up_subtree(const Subtree& subtree);
  template <int sides>
  void solve_some(Eigen::Ref<Eigen::MatrixXd> columns);

  const SupernodeTree& tree_;
  const EliminationSchedule& schedule_;
  // None of the numbers is cleared before what is used of them is.
  Numbers<Number> factor_;   // columns of all supernodes
  Numbers<Number> updates_;  // that wait for other tasks
  tbb::enumerable_thread_specific<Numbers<Number>>
      stacks_;                 // where those of its own task wait: of each thread, as it is near it
  std::vector<Number> signs_;  // (unknowns)
  std::vector<int> negative_;  // (tasks), pivots below zero; -1 where one cannot be
  Numbers<Number> solution_;   // (unknowns x kMostSides) by rows, in the order of elimination
  Numbers<Number> local_;      // (unknowns of one front x kMostSides) by rows
  Numbers<Number> locals_;     // the same of subtrees that are solved side by side
  Numbers<Number> beyond_;     // (rows beyond subtrees x kMostSides) by rows, see EliminationSchedule
  std::vector<Subtree> subtrees_;
  bool is_factorised_ = false;
};

}  // namespace thinwall
