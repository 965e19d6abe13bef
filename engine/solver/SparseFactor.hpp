#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/solver/BlockPattern.hpp"

namespace thinwall {

/// Of the numbers of a factor. Single precision takes 0.6 times the time of double, and its solutions a third to two
/// thirds; what it misses by the condition number tells, and what is left then, found in double precision, may be
/// solved for again (Wilkinson 1963, iterative refinement).
enum class Precision { kDouble, kSingle };

/// Analyse once, factorize and solve often: a multifrontal L S L^T with S = +-1 on the diagonal (Duff and Reid 1983),
/// without interchanges. Fronts are dense and eliminated by FrontFactor; the pattern of 3 x 3 blocks is analysed as a
/// graph of vertices. The threads that there are share a factorisation (see EliminationSchedule), one solves; what is
/// computed from what, and in which order, the pattern alone decides.
class SparseFactor {
 public:
  /// Orders the graph of nodes by nested dissection and expands the order to their unknowns, three for each vertex,
  /// which costs a third of ordering the unknowns.
  explicit SparseFactor(const BlockPattern& pattern);

  /// Takes over the order of an earlier pattern, whose vertices come first, and puts further ones and the single
  /// unknowns where they fit in (see `extended_order`), as long as that costs no more than `kWorseOrder` times the
  /// operations per node that the last order of its own cost.
  SparseFactor(const BlockPattern& pattern, const SparseFactor& before);
  static constexpr double kWorseOrder = 1.25;
  ~SparseFactor();
  SparseFactor(SparseFactor&&) noexcept;
  SparseFactor& operator=(SparseFactor&&) noexcept;

  /// The number of negative pivots, which is that of the negative eigenvalues; nothing when a pivot vanished, or when
  /// one was negative and the matrix may not be indefinite.
  std::optional<int> factorize(std::span<const double> values, bool may_be_indefinite = false,
                               Precision precision = Precision::kDouble);

  /// Of the last factorisation.
  Precision precision() const;

  /// Whether the factor is so large that single precision gains more time than refinement takes.
  bool is_worth_single_precision() const;

  /// from -= A x with the matrix of the last factorisation, which was in single precision. (unknowns) each.
  void subtract_product(const Eigen::VectorXd& x, Eigen::VectorXd& from) const;

  /// Floating-point operations of a factorisation, as analysed: the squares of the columns' lengths.
  double operations() const;

  /// Solves with the last successful factorisation. (unknowns x right-hand sides), in place.
  void solve(Eigen::Ref<Eigen::MatrixXd> right_hand_sides);

  /// About how many times as long as one so many right-hand sides take together.
  static double cost_of(Eigen::Index right_hand_sides);

  /// Some unknowns, and the fronts that hold them with all that are above these.
  struct Part {
    std::vector<int> unknowns;
    std::vector<int> fronts;  // ascending
  };
  Part part_of(std::vector<int> unknowns) const;

  /// Solves for a right-hand side that is zero but at the unknowns of a part, and finds the solution there alone, which
  /// asks for the fronts of the part only. (unknowns of the part), in place.
  void solve_part(const Part& part, Eigen::Ref<Eigen::VectorXd> right_hand_side);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace thinwall
