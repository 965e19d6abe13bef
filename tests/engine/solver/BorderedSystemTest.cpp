#include "engine/solver/BorderedSystem.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <optional>
#include <stdexcept>

#include "engine/solver/BorderedPart.hpp"
#include "tests/engine/solver/BlockMatrix.hpp"

namespace thinwall {
namespace {

struct Example {
  const char* name;
  double shift;            // of the sparse part; negative makes it indefinite
  Eigen::MatrixXd corner;  // D
};

std::vector<Example> examples() {
  Eigen::MatrixXd none = Eigen::MatrixXd::Zero(0, 0), one = Eigen::MatrixXd::Zero(1, 1);
  Eigen::MatrixXd soft = Eigen::MatrixXd::Constant(1, 1, -0.3);
  Eigen::MatrixXd mixed = Eigen::MatrixXd::Zero(4, 4);
  mixed(1, 1) = -2;
  mixed(3, 3) = 5;
  return {{"no border", 0.5, none},
          {"one constraint on a definite matrix", 0.5, one},
          {"one constraint on an indefinite matrix", -0.45, one},
          {"one soft constraint", 0.5, soft},
          {"several columns", 0.5, mixed},
          {"several columns on an indefinite matrix", -1.5, mixed}};
}

TEST(BorderedSystem, InertiaAndSolutionAreThoseOfTheDenseMatrix) {
  for (const Example& example : examples()) {
    const BlockMatrix matrix = random_matrix(80, example.shift, 3);
    const Eigen::Index unknowns = matrix.dense.rows(), columns = example.corner.rows();
    const Eigen::MatrixXd border = random_columns(unknowns, columns, 11);
    Eigen::MatrixXd whole(unknowns + columns, unknowns + columns);
    whole << matrix.dense, border, border.transpose(), example.corner;

    SparseFactor factor(matrix.pattern);
    const std::optional<int> negative = factor.factorize(matrix.values, true);
    ASSERT_TRUE(negative) << example.name;
    BorderedSystem system;
    system.set(factor, *negative, border, example.corner);
    const Eigen::VectorXd spectrum = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(whole).eigenvalues();
    EXPECT_EQ(system.negative_eigenvalues(), (spectrum.array() < 0).count()) << example.name;

    const Eigen::VectorXd right = random_columns(unknowns + columns, 1, 12);
    Eigen::VectorXd f = right.head(unknowns), g = right.tail(columns);
    system.solve(factor, f, g);
    Eigen::VectorXd solved(unknowns + columns);
    solved << f, g;
    // Residuals seen up to 4e-12, from the indefinite matrices, which are factorised without pivoting.
    EXPECT_LT((whole * solved - right).cwiseAbs().maxCoeff(), 1e-10) << example.name;
  }
}

TEST(BorderedSystem, ColumnsThatAreSolvedAlreadyGiveTheSame) {
  const BlockMatrix matrix = random_matrix(80, -0.45, 3);
  const Eigen::Index unknowns = matrix.dense.rows();
  const Eigen::MatrixXd border = random_columns(unknowns, 3, 11), corner = Eigen::MatrixXd::Zero(3, 3);
  SparseFactor factor(matrix.pattern);
  const std::optional<int> negative = factor.factorize(matrix.values, true);
  ASSERT_TRUE(negative);
  BorderedSystem whole, known;
  whole.set(factor, *negative, border, corner);
  known.set_solved(*negative, border, whole.solved_columns(), corner);
  EXPECT_EQ(known.negative_eigenvalues(), whole.negative_eigenvalues());
  Eigen::VectorXd f = random_columns(unknowns, 1, 12), g = random_columns(3, 1, 13), other_f = f, other_g = g;
  whole.solve(factor, f, g);
  known.solve(factor, other_f, other_g);
  EXPECT_EQ(other_f, f);
  EXPECT_EQ(other_g, g);
}

TEST(BorderedSystem, IsTheSameToTheBitOnProcessorsWithOtherCaches) {
  const BlockMatrix matrix = random_matrix(2000, 0.5, 3);
  const Eigen::Index unknowns = matrix.dense.rows();
  const Eigen::MatrixXd border = random_columns(unknowns, 4, 11), rows = random_columns(unknowns, 4, 13);
  const Eigen::MatrixXd corner = random_columns(4, 4, 14);
  SparseFactor factor(matrix.pattern);
  ASSERT_TRUE(factor.factorize(matrix.values));
  const std::ptrdiff_t first = Eigen::l1CacheSize(), second = Eigen::l2CacheSize(), third = Eigen::l3CacheSize();
  const auto solution_with = [&](std::ptrdiff_t kilobytes) {
    Eigen::setCpuCacheSizes(1024 * kilobytes, second, third);
    BorderedSystem symmetric, other;
    symmetric.set(factor, 0, border, corner + corner.transpose());
    other.set_unsymmetric(factor, 0, border, border, rows, corner);
    Eigen::VectorXd solution(2 * unknowns);
    Eigen::VectorXd f = random_columns(unknowns, 1, 12), g = random_columns(4, 1, 15), other_f = f, other_g = g;
    symmetric.solve(factor, f, g);
    other.solve(factor, other_f, other_g);
    solution << f, other_f;
    return solution;
  };
  const Eigen::VectorXd small = solution_with(32), large = solution_with(48);
  Eigen::setCpuCacheSizes(first, second, third);
  EXPECT_EQ(small, large);
}

TEST(BorderedSystem, ConstraintOnADefiniteMatrixAddsOneNegativeEigenvalueEach) {
  const BlockMatrix matrix = random_matrix(80, 0.5, 3);
  SparseFactor factor(matrix.pattern);
  ASSERT_TRUE(factor.factorize(matrix.values));
  BorderedSystem system;
  for (const int columns : {0, 1, 3}) {
    system.set(factor, 0, random_columns(matrix.dense.rows(), columns, 11), Eigen::MatrixXd::Zero(columns, columns));
    EXPECT_EQ(system.negative_eigenvalues(), columns);
  }
}

TEST(BorderedSystem, ColumnsAndRowsMayDiffer) {
  const BlockMatrix matrix = random_matrix(80, 0.5, 3);
  const Eigen::Index unknowns = matrix.dense.rows();
  const Eigen::MatrixXd columns = random_columns(unknowns, 3, 11), rows = random_columns(unknowns, 3, 13);
  const Eigen::MatrixXd corner = random_columns(3, 3, 14);
  Eigen::MatrixXd whole(unknowns + 3, unknowns + 3);
  whole << matrix.dense, columns, rows.transpose(), corner;
  SparseFactor factor(matrix.pattern);
  ASSERT_TRUE(factor.factorize(matrix.values));
  BorderedSystem system;
  system.set_unsymmetric(factor, 0, random_columns(unknowns, 3, 15), columns, rows, corner);
  EXPECT_EQ(system.negative_eigenvalues(), 3);  // of the symmetric one
  const Eigen::VectorXd right = random_columns(unknowns + 3, 1, 12);
  Eigen::VectorXd f = right.head(unknowns), g = right.tail(3);
  system.solve(factor, f, g);
  Eigen::VectorXd solved(unknowns + 3);
  solved << f, g;
  EXPECT_LT((whole * solved - right).cwiseAbs().maxCoeff(), 1e-10);
}

TEST(BorderedPart, AnswersAtSomeUnknownsAsTheWholeSystemDoes) {
  const BlockMatrix matrix = random_matrix(80, 0.5, 3);
  const Eigen::Index unknowns = matrix.dense.rows();
  const std::vector<int> part = {3, 4, 5, 60, 61, 62};
  const Eigen::MatrixXd border = random_columns(unknowns, 2, 11), columns = random_columns(unknowns, 2, 12);
  const Eigen::MatrixXd corner = random_columns(2, 2, 14);
  Eigen::MatrixXd rows = border;
  rows(part, Eigen::all) += random_columns(6, 2, 15);
  SparseFactor factor(matrix.pattern);
  ASSERT_TRUE(factor.factorize(matrix.values));
  BorderedSystem system;
  system.set(factor, 0, border, Eigen::MatrixXd::Zero(2, 2));
  for (const bool is_unsymmetric : {false, true}) {
    if (is_unsymmetric) system.set_unsymmetric(factor, 0, border, columns, rows, corner);
    Eigen::VectorXd f = Eigen::VectorXd::Zero(unknowns), g = Eigen::VectorXd::Zero(2);
    f(part) = random_columns(6, 1, 16);
    const Eigen::VectorXd answer = BorderedPart(factor, system, part).solve(f(part));
    system.solve(factor, f, g);
    EXPECT_LT((answer - f(part)).cwiseAbs().maxCoeff(), 1e-13) << is_unsymmetric;  // seen: 1e-15
    EXPECT_GT(f(part).cwiseAbs().minCoeff(), 1e-3);
  }
}

TEST(BorderedSystem, SolvesWhatIsExpectedAlongWithTheBorderWhereThatCostsLess) {
  const BlockMatrix matrix = random_matrix(80, 0.5, 3), other = random_matrix(80, 0.7, 4);
  const Eigen::Index unknowns = matrix.dense.rows();
  for (const int columns : {2, 3, 4}) {
    const Eigen::MatrixXd border = random_columns(unknowns, columns, 11);
    const Eigen::MatrixXd corner = Eigen::MatrixXd::Zero(columns, columns);
    const Eigen::VectorXd right = random_columns(unknowns, 1, 12);
    SparseFactor factor(matrix.pattern);
    ASSERT_TRUE(factor.factorize(matrix.values));
    BorderedSystem alone, together;
    alone.set(factor, 0, border, corner);
    together.expect(right);
    together.set(factor, 0, border, corner);
    EXPECT_EQ(together.negative_eigenvalues(), columns);
    Eigen::VectorXd f = right, g = random_columns(columns, 1, 13), expected_f = f, expected_g = g;
    alone.solve(factor, expected_f, expected_g);
    // With a factor that is of another matrix by now, only what was solved along comes out right.
    ASSERT_TRUE(factor.factorize(other.values));
    together.solve(factor, f, g);
    if (columns < 4) {
      EXPECT_LT((f - expected_f).cwiseAbs().maxCoeff(), 1e-13) << columns;  // seen: 1e-15
      EXPECT_LT((g - expected_g).cwiseAbs().maxCoeff(), 1e-13) << columns;
    } else {
      EXPECT_GT((f - expected_f).cwiseAbs().maxCoeff(), 1e-3) << columns;
    }
  }
}

TEST(BorderedSystem, ForgetsWhatWasExpectedOnceItIsSetAgain) {
  const BlockMatrix matrix = random_matrix(80, 0.5, 3), other = random_matrix(80, 0.7, 4);
  const Eigen::Index unknowns = matrix.dense.rows();
  const Eigen::MatrixXd border = random_columns(unknowns, 3, 11), corner = Eigen::MatrixXd::Zero(3, 3);
  const Eigen::VectorXd right = random_columns(unknowns, 1, 12);
  SparseFactor factor(matrix.pattern);
  BorderedSystem system, fresh;
  ASSERT_TRUE(factor.factorize(matrix.values));
  system.expect(right);
  system.set(factor, 0, border, corner);
  ASSERT_TRUE(factor.factorize(other.values));
  system.set(factor, 0, border, corner);
  fresh.set(factor, 0, border, corner);
  Eigen::VectorXd f = right, g = Eigen::VectorXd::Zero(3), expected_f = f, expected_g = g;
  system.solve(factor, f, g);
  fresh.solve(factor, expected_f, expected_g);
  EXPECT_EQ(f, expected_f);
  EXPECT_EQ(g, expected_g);
}

TEST(BorderedSystem, HasNoUseForColumnsOfTheBorderThatAreZero) {
  // As a chamber with air has it, whose pressure is given; with the columns that are not symmetric seven are left, and
  // the side that is expected goes along with them.
  const BlockMatrix matrix = random_matrix(80, 0.5, 3), other = random_matrix(80, 0.7, 4);
  const Eigen::Index unknowns = matrix.dense.rows();
  Eigen::MatrixXd border = random_columns(unknowns, 4, 11);
  border.col(1).setZero();
  const Eigen::MatrixXd columns = random_columns(unknowns, 4, 12), rows = random_columns(unknowns, 4, 13);
  const Eigen::MatrixXd corner = random_columns(4, 4, 14);
  const Eigen::VectorXd right = random_columns(unknowns + 4, 1, 15);
  Eigen::MatrixXd whole(unknowns + 4, unknowns + 4);
  whole << matrix.dense, columns, rows.transpose(), corner;
  SparseFactor factor(matrix.pattern);
  ASSERT_TRUE(factor.factorize(matrix.values));
  BorderedSystem system;
  system.expect(right.head(unknowns));
  system.set_unsymmetric(factor, 0, border, columns, rows, corner);
  EXPECT_TRUE(system.solved_border().col(1).isZero(0));
  const Eigen::MatrixXd border_again = matrix.dense * system.solved_border();
  EXPECT_LT((border_again - border).cwiseAbs().maxCoeff(), 1e-12);  // seen: 1e-14
  ASSERT_TRUE(factor.factorize(other.values));
  Eigen::VectorXd f = right.head(unknowns), g = right.tail(4);
  system.solve(factor, f, g);
  Eigen::VectorXd solved(unknowns + 4);
  solved << f, g;
  EXPECT_LT((whole * solved - right).cwiseAbs().maxCoeff(), 1e-10);
}

/// How far a solution with a factor in single precision is from the right-hand side, of which the first part is
/// expected, and what the system says that it missed.
struct Refined {
  double missed = 0, told_of_expected = 0, told = 0;
};
Refined refined(const BlockMatrix& matrix, bool is_unsymmetric) {
  const Eigen::Index unknowns = matrix.dense.rows();
  const Eigen::MatrixXd border = random_columns(unknowns, 3, 11), corner = random_columns(3, 3, 14);
  const Eigen::MatrixXd symmetric = corner + corner.transpose();
  const Eigen::MatrixXd columns = is_unsymmetric ? random_columns(unknowns, 3, 12) : border;
  const Eigen::MatrixXd rows = is_unsymmetric ? random_columns(unknowns, 3, 13) : border;
  Eigen::MatrixXd whole(unknowns + 3, unknowns + 3);
  whole << matrix.dense, columns, rows.transpose(), symmetric;
  const Eigen::VectorXd right = random_columns(unknowns + 3, 1, 15);
  SparseFactor factor(matrix.pattern);
  const std::optional<int> negative = factor.factorize(matrix.values, true, Precision::kSingle);
  if (!negative) throw std::runtime_error("a pivot vanished");
  BorderedSystem system;
  system.expect(right.head(unknowns));
  if (is_unsymmetric) {
    system.set_unsymmetric(factor, *negative, border, columns, rows, symmetric);
  } else {
    system.set(factor, *negative, border, symmetric);
  }
  Refined result{.told_of_expected = system.missed_part()};
  Eigen::VectorXd f = right.head(unknowns), g = right.tail(3);
  system.solve(factor, f, g);
  system.refine(factor, right.head(unknowns), right.tail(3), f, g);
  Eigen::VectorXd solved(unknowns + 3);
  solved << f, g;
  result.missed = (whole * solved - right).norm() / right.norm();
  result.told = system.missed_part();
  return result;
}

/// A matrix whose least eigenvalue is `least`, where the others are some units.
BlockMatrix with_least_eigenvalue(double least) {
  BlockMatrix matrix = random_matrix(80, 0.5, 3);
  const double before = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix.dense).eigenvalues()[0];
  for (int column = 0; column < 3 * matrix.pattern.vertices; ++column) {
    matrix.values[matrix.pattern.column_begin[column]] += least - before;
    matrix.dense(column, column) += least - before;
  }
  return matrix;
}

TEST(BorderedSystem, RefinesWhatSinglePrecisionMisses) {
  for (const bool is_unsymmetric : {false, true}) {
    for (const double least : {0.5, 1e-4}) {
      const Refined result = refined(with_least_eigenvalue(least), is_unsymmetric);
      EXPECT_GT(result.told_of_expected, 1e-8) << least << is_unsymmetric;  // seen: 4e-7 and 5e-4
      // A part of what the border takes, which may be ten times the right-hand side.
      EXPECT_LT(result.missed, 1e-9) << least << is_unsymmetric;
      EXPECT_EQ(result.told, result.told_of_expected) << least << is_unsymmetric;
    }
  }
}

TEST(BorderedSystem, TellsThatSinglePrecisionWillNotDo) {
  EXPECT_GT(refined(with_least_eigenvalue(1e-8), false).told_of_expected, 0.1);  // seen: 0.3
}

TEST(BorderedSystem, ColumnOfOneConstraintMakesAMatrixWithOneNegativeDirectionConvex) {
  // As a balloon past its limit point: K has one negative eigenvalue, along the border the whole is convex.
  BlockMatrix matrix = random_matrix(20, 0.5, 3);
  const Eigen::VectorXd lowest = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix.dense).eigenvectors().col(0);
  const double least = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix.dense).eigenvalues()[0];
  const double next = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix.dense).eigenvalues()[1];
  for (int column = 0; column < 3 * matrix.pattern.vertices; ++column) {
    matrix.values[matrix.pattern.column_begin[column]] -= 0.5 * (least + next);
  }
  SparseFactor factor(matrix.pattern);
  const std::optional<int> negative = factor.factorize(matrix.values, true);
  ASSERT_TRUE(negative);
  EXPECT_EQ(*negative, 1);
  BorderedSystem system;
  system.set(factor, *negative, lowest, Eigen::MatrixXd::Zero(1, 1));
  EXPECT_EQ(system.negative_eigenvalues(), 1);
}

}  // namespace
}  // namespace thinwall
