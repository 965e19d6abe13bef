#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <span>

#include "engine/solver/BlockPattern.hpp"

namespace thinwall {

/// Analyse once, factorize and solve often: the only place that knows the sparse direct solver.
class SparseFactor {
 public:
  /// Orders the graph of nodes by nested dissection and expands the order to their unknowns, three for each vertex,
  /// which costs a third of ordering the unknowns.
  explicit SparseFactor(const BlockPattern& pattern);

  /// Takes over the order of an earlier pattern, whose vertices come first, and puts further ones where they fit in
  /// (see `extended_order`), as long as that costs no more than `kWorseOrder` times the operations per unknown that the
  /// last order of its own cost, and both patterns have no single unknowns.
  SparseFactor(const BlockPattern& pattern, const SparseFactor& before);
  static constexpr double kWorseOrder = 1.25;
  ~SparseFactor();
  SparseFactor(SparseFactor&&) noexcept;
  SparseFactor& operator=(SparseFactor&&) noexcept;

  /// Supernodal L L^T; false when the matrix is not positive definite.
  bool factorize(std::span<const double> values);

  /// Simplicial L D L^T of an indefinite matrix: the number of negative pivots, or nothing when a pivot vanished.
  std::optional<int> factorize_indefinite(std::span<const double> values);

  /// Floating-point operations of a factorisation, as analysed.
  double operations() const;

  /// Solves with the last successful factorisation. (unknowns x right-hand sides), in place.
  void solve(Eigen::Ref<Eigen::MatrixXd> right_hand_sides);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace thinwall
