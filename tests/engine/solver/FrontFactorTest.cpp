// Fronts: elimination of the first unknowns of dense symmetric matrices, and solutions with what it leaves.

#include "engine/solver/FrontFactor.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <limits>
#include <utility>
#include <vector>

#include "tests/engine/solver/BlockMatrix.hpp"

namespace thinwall {
namespace {

template <typename Number>
using MatrixOf = Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic>;

/// A front with room of its own.
template <typename Number>
struct OwnFront {
  MatrixOf<Number> columns, update;
  Eigen::VectorX<Number> signs;
  std::vector<Number> workspace = std::vector<Number>(kFrontColumns * kPanel);
  int pivots, size;

  OwnFront(const MatrixOf<Number>& matrix, int the_pivots)
      : signs(the_pivots), pivots(the_pivots), size(static_cast<int>(matrix.rows())) {
    const int rest = size - pivots;
    // One column more than there is: whole lanes are read past the last row.
    columns.setZero(up_to_rows(size), pivots + 1);
    update.setZero(up_to_rows(rest), rest);
    for (int c = 0; c < pivots; ++c) columns.col(c).segment(c, size - c) = matrix.col(c).tail(size - c);
    for (int c = 0; c < rest; ++c) update.col(c).segment(c, rest - c) = matrix.col(pivots + c).tail(rest - c);
  }
  Front<Number> view() {
    return {.pivots = pivots,
            .size = size,
            .columns = columns.data(),
            .stride = columns.rows(),
            .update = update.data(),
            .update_stride = update.rows(),
            .signs = signs.data(),
            .workspace = workspace.data()};
  }
  MatrixOf<Number> lower() const {
    MatrixOf<Number> l = columns.topLeftCorner(size, pivots);
    for (int c = 0; c < pivots; ++c) l.col(c).head(c).setZero();
    return l;
  }
};

/// Symmetric with eigenvalues of either sign, or none below zero, and a diagonal that needs no interchanges.
Eigen::MatrixXd random_symmetric(int size, bool definite, unsigned seed) {
  const Eigen::MatrixXd random = random_columns(size, size, seed);
  Eigen::MatrixXd matrix = random + random.transpose();
  for (int k = 0; k < size; ++k) matrix(k, k) += (definite || k % 3 != 1 ? 2.5 : -2.5) * size;
  return matrix;
}

template <typename Number>
class FrontFactor : public testing::Test {
 public:
  using Matrix = MatrixOf<Number>;

  /// Of sums of some products of numbers of the order of one: residuals seen up to 10 units of round-off.
  static constexpr Number kTolerance = 50 * std::numeric_limits<Number>::epsilon();
};
using Precisions = testing::Types<double, float>;
TYPED_TEST_SUITE(FrontFactor, Precisions);

/// Sizes around those of lanes, columns that are worked on together and panels.
const std::vector<std::pair<int, int>> kSizes = {{1, 1},   {3, 3},   {3, 12},  {5, 6},    {6, 13},    {9, 9},
                                                 {12, 20}, {21, 40}, {96, 96}, {97, 111}, {100, 107}, {200, 260}};

TYPED_TEST(FrontFactor, LeavesWhatEliminationByTheBookLeaves) {
  for (const bool definite : {true, false}) {
    for (const auto& [pivots, size] : kSizes) {
      const auto matrix = random_symmetric(size, definite, 5).template cast<TypeParam>().eval();
      OwnFront<TypeParam> front(matrix, pivots);
      const int negative = eliminate(front.view(), true);
      EXPECT_EQ(negative, definite ? 0 : (pivots + 1) / 3) << pivots << " of " << size;
      const int rest = size - pivots;
      const typename TestFixture::Matrix product = front.lower() * front.signs.asDiagonal() * front.lower().transpose();
      const TypeParam tolerance = TestFixture::kTolerance * matrix.cwiseAbs().maxCoeff();
      EXPECT_LT((product - matrix).leftCols(pivots).cwiseAbs().maxCoeff(), tolerance) << pivots << " of " << size;
      const typename TestFixture::Matrix left =
          matrix.bottomRightCorner(rest, rest) - product.bottomRightCorner(rest, rest);
      for (int c = 0; c < rest; ++c) {
        EXPECT_LT((front.update.col(c).segment(c, rest - c) - left.col(c).tail(rest - c)).cwiseAbs().maxCoeff(),
                  tolerance)
            << pivots << " of " << size;
      }
    }
  }
}

TYPED_TEST(FrontFactor, SolvesForOneFourAndEightRightHandSidesWithTheRowsBelow) {
  using Dense = typename TestFixture::Matrix;
  const TypeParam tolerance = 10 * TestFixture::kTolerance;  // solutions grow to some ten
  for (const auto& [pivots, size] : kSizes) {
    OwnFront<TypeParam> front(random_symmetric(size, false, 6).template cast<TypeParam>(), pivots);
    ASSERT_GE(eliminate(front.view(), true), 0);
    const Dense lower = front.lower(), right = random_columns(size, 8, 7).template cast<TypeParam>();
    const auto top = lower.topRows(pivots).template triangularView<Eigen::Lower>();
    Dense forward = right, backward = right;
    forward.topRows(pivots) = top.solve(right.topRows(pivots));
    forward.bottomRows(size - pivots) -= lower.bottomRows(size - pivots) * forward.topRows(pivots);
    backward.topRows(pivots) -= lower.bottomRows(size - pivots).transpose() * right.bottomRows(size - pivots);
    backward.topRows(pivots) = top.transpose().solve(backward.topRows(pivots).eval());
    Dense four = right.leftCols(4).transpose(), eight = right.transpose();
    solve_forward(front.view(), 4, four.data());
    solve_forward(front.view(), 8, eight.data());
    EXPECT_LT((eight.transpose() - forward).cwiseAbs().maxCoeff(), tolerance) << pivots << " of " << size;
    EXPECT_EQ(four, eight.topRows(4)) << pivots << " of " << size;
    four = right.leftCols(4).transpose(), eight = right.transpose();
    solve_backward(front.view(), 4, four.data());
    solve_backward(front.view(), 8, eight.data());
    EXPECT_LT((eight.transpose() - backward).cwiseAbs().maxCoeff(), tolerance) << pivots << " of " << size;
    EXPECT_EQ(four, eight.topRows(4)) << pivots << " of " << size;
    Eigen::VectorX<TypeParam> one = Eigen::VectorX<TypeParam>::Zero(up_to_rows(size));
    one.head(size) = right.col(0);
    solve_forward(front.view(), 1, one.data());
    EXPECT_LT((one.head(size) - forward.col(0)).cwiseAbs().maxCoeff(), tolerance) << pivots << " of " << size;
    one.setZero();
    one.head(size) = right.col(0);
    solve_backward(front.view(), 1, one.data());
    EXPECT_LT((one.head(size) - backward.col(0)).cwiseAbs().maxCoeff(), tolerance) << pivots << " of " << size;
  }
}

TYPED_TEST(FrontFactor, RefusesPivotsThatVanishAreNoNumbersOrMayNotBeNegative) {
  const auto good = random_symmetric(20, true, 8).template cast<TypeParam>().eval();
  for (const int at : {0, 4, 11}) {
    for (const TypeParam pivot :
         {std::numeric_limits<TypeParam>::quiet_NaN(), std::numeric_limits<TypeParam>::infinity()}) {
      auto matrix = good;
      matrix(at, at) = pivot;
      EXPECT_EQ(eliminate(OwnFront<TypeParam>(matrix, 12).view(), true), -1) << at << " " << pivot;
    }
    auto matrix = good;
    matrix.row(at).setZero();
    matrix.col(at).setZero();
    EXPECT_EQ(eliminate(OwnFront<TypeParam>(matrix, 12).view(), true), -1) << at;
    matrix(at, at) = -1;
    EXPECT_EQ(eliminate(OwnFront<TypeParam>(matrix, 12).view(), true), 1) << at;
    EXPECT_EQ(eliminate(OwnFront<TypeParam>(matrix, 12).view(), false), -1) << at;
  }
}

}  // namespace
}  // namespace thinwall
