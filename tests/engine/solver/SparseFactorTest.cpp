#include "engine/solver/SparseFactor.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <array>
#include <vector>

#include "tests/engine/solver/BlockMatrix.hpp"

namespace thinwall {
namespace {

int negative_eigenvalues(const Eigen::MatrixXd& matrix) {
  const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues();
  return static_cast<int>((values.array() < 0).count());
}

TEST(SparseFactor, SolvesADefiniteMatrixLikeADenseOne) {
  for (const int triangles : {20, 80, 320, 1280}) {
    const BlockMatrix matrix = random_matrix(triangles, 0.5, 3);
    SparseFactor factor(matrix.pattern);
    ASSERT_TRUE(factor.factorize(matrix.values));
    const Eigen::MatrixXd right = random_columns(matrix.dense.rows(), 3, 8);
    Eigen::MatrixXd solved = right;
    factor.solve(solved);
    // Condition number about 50; residuals seen 3e-15.
    EXPECT_LT((matrix.dense * solved - right).cwiseAbs().maxCoeff(), 1e-13) << triangles;
    EXPECT_LT((solved - matrix.dense.lu().solve(right)).cwiseAbs().maxCoeff(), 1e-13) << triangles;
  }
}

TEST(SparseFactor, SolvesSomeColumnsOfALargerMatrixInPlace) {
  const BlockMatrix matrix = random_matrix(80, 0.5, 3);
  SparseFactor factor(matrix.pattern);
  ASSERT_TRUE(factor.factorize(matrix.values));
  const Eigen::MatrixXd right = random_columns(matrix.dense.rows(), 4, 8);
  Eigen::MatrixXd all = right;
  factor.solve(all.middleCols(1, 2));
  EXPECT_EQ(all.col(0), right.col(0));
  EXPECT_EQ(all.col(3), right.col(3));
  EXPECT_LT((matrix.dense * all.middleCols(1, 2) - right.middleCols(1, 2)).cwiseAbs().maxCoeff(), 1e-13);
}

TEST(SparseFactor, ForcesOnFewUnknownsReachAllAsADenseSolutionHasThem) {
  const BlockMatrix matrix = random_matrix(320, 0.5, 3);
  SparseFactor factor(matrix.pattern);
  ASSERT_TRUE(factor.factorize(matrix.values));
  const Eigen::Index size = matrix.dense.rows();
  for (const Eigen::Index sides : {1, 4, 8}) {
    for (Eigen::Index first = 0; first + sides <= size; first += sides) {
      Eigen::MatrixXd right = Eigen::MatrixXd::Zero(size, sides);
      for (Eigen::Index k = 0; k < sides; ++k) right(first + k, k) = 1;
      Eigen::MatrixXd solved = right;
      factor.solve(solved);
      // Residuals seen 2e-15.
      EXPECT_LT((matrix.dense * solved - right).cwiseAbs().maxCoeff(), 1e-13) << first << " of " << sides;
    }
  }
}

TEST(SparseFactor, SolvesForAPartOfItsUnknownsAsForAll) {
  const BlockMatrix matrix = random_matrix(320, 0.5, 3);
  SparseFactor factor(matrix.pattern);
  ASSERT_TRUE(factor.factorize(matrix.values));
  const SparseFactor::Part whole = factor.part_of({5, 17, 16, 200}), few = factor.part_of({16, 17});
  EXPECT_LT(few.fronts.size(), whole.fronts.size());
  Eigen::VectorXd right = Eigen::VectorXd::Zero(matrix.dense.rows());
  right(whole.unknowns) = random_columns(4, 1, 8);
  Eigen::VectorXd part = right(whole.unknowns);
  factor.solve_part(whole, part);
  Eigen::VectorXd all = right;
  factor.solve(all);
  EXPECT_EQ(part, Eigen::VectorXd(all(whole.unknowns)));
}

TEST(SparseFactor, InSinglePrecisionMissesWhatItsRoundOffMakes) {
  for (const int triangles : {20, 80, 320, 1280}) {
    const BlockMatrix matrix = random_matrix(triangles, 0.5, 3);
    SparseFactor factor(matrix.pattern);
    ASSERT_EQ(factor.factorize(matrix.values, false, Precision::kSingle), 0);
    EXPECT_EQ(factor.precision(), Precision::kSingle);
    for (const Eigen::Index sides : {1, 4, 8}) {
      const Eigen::MatrixXd right = random_columns(matrix.dense.rows(), sides, 8);
      Eigen::MatrixXd solved = right;
      factor.solve(solved);
      const double missed = (matrix.dense * solved - right).cwiseAbs().maxCoeff();
      // Seen: 4e-7 to 2e-6, of numbers whose last digit is 6e-8 of them.
      EXPECT_LT(missed, 1e-5) << triangles << " " << sides;
      EXPECT_GT(missed, 1e-8) << triangles << " " << sides;
    }
    const SparseFactor::Part part = factor.part_of({5, 17, 16});
    Eigen::VectorXd of_part = Eigen::VectorXd::Ones(3), all = Eigen::VectorXd::Zero(matrix.dense.rows());
    all(part.unknowns).setOnes();
    factor.solve_part(part, of_part);
    factor.solve(all);
    EXPECT_EQ(of_part, Eigen::VectorXd(all(part.unknowns))) << triangles;
  }
}

TEST(SparseFactor, TellsWhatASolutionInSinglePrecisionLeavesByTheMatrixInDouble) {
  // With single unknowns behind the vertices, of which one is coupled with a vertex and one with the other.
  BlockMatrix matrix = random_matrix(80, 0.5, 3);
  const int vertices = matrix.pattern.vertices;
  const ExtendedPattern extended =
      extend_block_pattern(matrix.pattern, std::vector<std::array<int, 2>>{{3, vertices}, {vertices, vertices + 1}}, 2);
  std::vector<double> values(extended.pattern.nonzeros(), 0.1);
  for (std::size_t k = 0; k < matrix.values.size(); ++k) values[extended.entries[k]] = matrix.values[k];
  for (const int single : {3 * vertices, 3 * vertices + 1}) values[extended.pattern.column_begin[single]] = 2;
  SparseFactor factor(extended.pattern);
  ASSERT_TRUE(factor.factorize(values, false, Precision::kSingle));
  const Eigen::VectorXd x = random_columns(extended.pattern.unknowns(), 1, 8);
  Eigen::VectorXd product, left = Eigen::VectorXd::Ones(x.size());
  multiply(extended.pattern, values, x, product);
  factor.subtract_product(x, left);
  EXPECT_LT(((left + product).array() - 1).abs().maxCoeff(), 1e-13);  // seen: 2e-15
}

TEST(SparseFactor, GoesFromOnePrecisionToTheOtherAndBack) {
  const BlockMatrix matrix = random_matrix(320, 0.5, 3), indefinite = random_matrix(320, -1.5, 3);
  const Eigen::MatrixXd right = random_columns(matrix.dense.rows(), 1, 8);
  SparseFactor factor(matrix.pattern);
  for (int turn = 0; turn < 2; ++turn) {
    Eigen::MatrixXd in_double = right, in_single = right;
    EXPECT_FALSE(factor.factorize(indefinite.values, false, Precision::kSingle));
    ASSERT_TRUE(factor.factorize(matrix.values));
    factor.solve(in_double);
    ASSERT_TRUE(factor.factorize(matrix.values, false, Precision::kSingle));
    factor.solve(in_single);
    EXPECT_LT((matrix.dense * in_double - right).cwiseAbs().maxCoeff(), 1e-13);
    EXPECT_GT((matrix.dense * in_single - right).cwiseAbs().maxCoeff(), 1e-8);
    EXPECT_EQ(factor.factorize(indefinite.values, true, Precision::kSingle), negative_eigenvalues(indefinite.dense));
  }
}

TEST(SparseFactor, RefusesAnIndefiniteMatrixAsDefinite) {
  const BlockMatrix matrix = random_matrix(80, -1.5, 3);
  ASSERT_GT(negative_eigenvalues(matrix.dense), 0);
  SparseFactor factor(matrix.pattern);
  EXPECT_FALSE(factor.factorize(matrix.values));
}

TEST(SparseFactor, CountsTheNegativeEigenvaluesOfAnIndefiniteMatrixAndSolvesIt) {
  for (const double shift : {0.5, -0.4, -1.5, -4.0, -30.0}) {
    const BlockMatrix matrix = random_matrix(80, shift, 3);
    SparseFactor factor(matrix.pattern);
    const std::optional<int> negative = factor.factorize(matrix.values, true);
    ASSERT_TRUE(negative) << shift;
    EXPECT_EQ(*negative, negative_eigenvalues(matrix.dense)) << shift;
    const Eigen::MatrixXd right = random_columns(matrix.dense.rows(), 2, 8);
    Eigen::MatrixXd solved = right;
    factor.solve(solved);
    // Without pivoting the digits lost grow with the pivots; residuals seen up to 2e-12.
    EXPECT_LT((matrix.dense * solved - right).cwiseAbs().maxCoeff(), 1e-10) << shift;
  }
}

TEST(SparseFactor, SaysThatASingularMatrixIsSingular) {
  BlockMatrix matrix = random_matrix(20, 0.5, 3);
  // A vertex without any stiffness.
  const std::vector<double> zero(matrix.values.size(), 0);
  SparseFactor factor(matrix.pattern);
  EXPECT_FALSE(factor.factorize(zero));
  EXPECT_FALSE(factor.factorize(zero, true));
}

TEST(SparseFactor, GoesOnAfterAFailureAndBetweenTheTwoKinds) {
  const BlockMatrix definite = random_matrix(80, 0.5, 3), indefinite = random_matrix(80, -1.5, 3);
  const Eigen::MatrixXd right = random_columns(definite.dense.rows(), 1, 8);
  SparseFactor factor(definite.pattern);
  for (int turn = 0; turn < 3; ++turn) {
    Eigen::MatrixXd solved = right;
    ASSERT_TRUE(factor.factorize(definite.values));
    factor.solve(solved);
    EXPECT_LT((definite.dense * solved - right).cwiseAbs().maxCoeff(), 1e-13);
    EXPECT_FALSE(factor.factorize(indefinite.values));
    ASSERT_TRUE(factor.factorize(indefinite.values, true));
    solved = right;
    factor.solve(solved);
    EXPECT_LT((indefinite.dense * solved - right).cwiseAbs().maxCoeff(), 1e-10);
  }
}

TEST(SparseFactor, AnyNumberOfThreadsGivesEqualBits) {
  const BlockMatrix matrix = random_matrix(1280, -0.5, 3);
  const Eigen::MatrixXd right = random_columns(matrix.dense.rows(), 8, 8);
  for (const Precision precision : {Precision::kDouble, Precision::kSingle}) {
    std::vector<Eigen::MatrixXd> solved;
    for (const std::size_t threads : {1, 2, 4}) {
      const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
      SparseFactor factor(matrix.pattern);
      for (int turn = 0; turn < 20; ++turn) {
        const std::optional<int> negative = factor.factorize(matrix.values, true, precision);
        ASSERT_TRUE(negative);
        solved.emplace_back(right);
        factor.solve(solved.back());
      }
    }
    for (const Eigen::MatrixXd& one : solved) EXPECT_EQ(one, solved.front());
  }
}

TEST(SparseFactor, SubtreesSolvedSideBySideGiveTheBitsOfFrontsSolvedOneAfterTheOther) {
  // Four columns of this size are solved by one thread, eight are worth sharing.
  const BlockMatrix matrix = random_matrix(720, -0.5, 3);
  const Eigen::MatrixXd right = random_columns(matrix.dense.rows(), 8, 8);
  SparseFactor factor(matrix.pattern);
  ASSERT_TRUE(factor.factorize(matrix.values, true));
  Eigen::MatrixXd eight = right, four = right.rightCols(4);
  factor.solve(eight);
  factor.solve(four);
  EXPECT_EQ(eight.rightCols(4), four);
}

TEST(SparseFactor, EqualValuesGiveEqualBits) {
  const BlockMatrix matrix = random_matrix(320, 0.5, 3);
  const Eigen::MatrixXd right = random_columns(matrix.dense.rows(), 2, 8);
  Eigen::MatrixXd first = right, second = right;
  SparseFactor one(matrix.pattern), other(matrix.pattern);
  ASSERT_TRUE(one.factorize(matrix.values));
  ASSERT_TRUE(other.factorize(matrix.values));
  one.solve(first);
  other.solve(second);
  EXPECT_EQ(first, second);
}

}  // namespace
}  // namespace thinwall
