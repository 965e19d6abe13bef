// Fixed points of linear maps that are known by their products only.

#include "engine/solver/MinimalResidual.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

namespace thinwall {
namespace {

constexpr int kSize = 12;

/// Entries between -1 and 1, the same on every machine.
Eigen::MatrixXd some_matrix(int rows, int columns) {
  Eigen::MatrixXd matrix(rows, columns);
  unsigned state = 7;
  for (double& entry : matrix.reshaped()) {
    state = state * 1664525u + 1013904223u;
    entry = static_cast<double>(state >> 8) / (1 << 23) - 1;
  }
  return matrix;
}

Eigen::VectorXd exact(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  return (Eigen::MatrixXd::Identity(a.rows(), a.cols()) - a).partialPivLu().solve(b);
}

MinimalResidual solve(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, double accuracy, int most) {
  return solve_by_minimal_residual(
      b, [&](const Eigen::VectorXd& y) -> Eigen::VectorXd { return a * y; }, accuracy, most);
}

TEST(MinimalResidual, SolvesWhatRepeatingTheMapWouldNever) {
  const Eigen::MatrixXd a = 30 * some_matrix(kSize, kSize);
  const Eigen::VectorXd b = some_matrix(kSize, 1);
  const MinimalResidual found = solve(a, b, 1e-12, kSize);
  EXPECT_LE(found.products, kSize);
  EXPECT_LE((found.solution - exact(a, b)).norm(), 1e-9 * found.solution.norm());
}

TEST(MinimalResidual, SolvesASkewMapThatTurnsWithoutShrinking) {
  const Eigen::MatrixXd part = 5 * some_matrix(kSize, kSize);
  const Eigen::MatrixXd a = part - part.transpose();
  const Eigen::VectorXd b = some_matrix(kSize, 1);
  const MinimalResidual found = solve(a, b, 1e-12, kSize);
  EXPECT_LE((found.solution - exact(a, b)).norm(), 1e-9 * found.solution.norm());
}

TEST(MinimalResidual, NeedsAsManyProductsAsTheMapHasRanksAndOneMore) {
  const Eigen::MatrixXd a = some_matrix(kSize, 2) * some_matrix(2, kSize);
  const MinimalResidual found = solve(a, some_matrix(kSize, 1), 1e-10, kSize);
  EXPECT_LE(found.products, 3);
  EXPECT_LE(found.residual, 1e-10);
}

TEST(MinimalResidual, TellsWhatIsLeftWhereItEndsEarly) {
  const Eigen::MatrixXd a = 3 * some_matrix(kSize, kSize);
  const Eigen::VectorXd b = some_matrix(kSize, 1);
  double last = 1;
  for (int most = 1; most < kSize; ++most) {
    const MinimalResidual found = solve(a, b, 0, most);
    EXPECT_EQ(found.products, most);
    EXPECT_NEAR(found.residual, (b - found.solution + a * found.solution).norm() / b.norm(), 1e-12);
    EXPECT_LE(found.residual, last + 1e-12);
    last = found.residual;
  }
}

TEST(MinimalResidual, OfNothingIsNothing) {
  const MinimalResidual found = solve(some_matrix(kSize, kSize), Eigen::VectorXd::Zero(kSize), 1e-3, 5);
  EXPECT_TRUE(found.solution.isZero(0));
  EXPECT_EQ(found.products, 0);
}

}  // namespace
}  // namespace thinwall
