// Fronts before anything is eliminated: cleared, and what fronts below have left added.

#include "engine/solver/FrontAssembly.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "tests/engine/solver/BlockMatrix.hpp"

namespace thinwall {
namespace {

constexpr int kPivots = 13, kSize = 45;

/// A front whose numbers are none.
template <typename Number>
struct EmptyFront {
  Eigen::MatrixX<Number> columns, update;

  EmptyFront() {
    const Number none = std::numeric_limits<Number>::quiet_NaN();
    columns.setConstant(up_to_rows(kSize), kPivots, none);
    update.setConstant(up_to_rows(kSize - kPivots), kSize - kPivots, none);
  }
  Front<Number> view() {
    return {.pivots = kPivots,
            .size = kSize,
            .columns = columns.data(),
            .stride = columns.rows(),
            .update = update.data(),
            .update_stride = update.rows()};
  }
  Number at(int row, int column) const {
    return column < kPivots ? columns(row, column) : update(row - kPivots, column - kPivots);
  }
};

template <typename Number>
class FrontAssembly : public testing::Test {};
using Precisions = testing::Types<double, float>;
TYPED_TEST_SUITE(FrontAssembly, Precisions);

TYPED_TEST(FrontAssembly, ClearsAllThatIsReadOfAFront) {
  EmptyFront<TypeParam> front;
  clear(front.view());
  for (int column = 0; column < kSize; ++column) {
    for (int row = column; row < kSize; ++row) EXPECT_EQ(front.at(row, column), 0) << row << ", " << column;
  }
  // Whole lanes are read from the block of the diagonal on, and past the last row.
  for (const Eigen::MatrixX<TypeParam>* part : {&front.columns, &front.update}) {
    for (Eigen::Index column = 0; column < part->cols(); ++column) {
      const Eigen::Index first = column / kFrontRows * kFrontRows;
      EXPECT_TRUE(part->col(column).tail(part->rows() - first).isZero(0)) << column;
    }
  }
}

TYPED_TEST(FrontAssembly, AddsTheLowerTriangleOfAnUpdateByRunsOfAnyLength) {
  // Of one to twelve rows, within the pivots and behind them.
  const std::vector<RowRun> runs = {{.from = 0, .to = 1, .count = 1},   {.from = 1, .to = 3, .count = 2},
                                    {.from = 3, .to = 6, .count = 4},   {.from = 7, .to = 10, .count = 3},
                                    {.from = 10, .to = 13, .count = 5}, {.from = 15, .to = 20, .count = 12},
                                    {.from = 27, .to = 33, .count = 3}, {.from = 30, .to = 37, .count = 8}};
  constexpr int kRows = 38;
  Eigen::MatrixX<TypeParam> update = random_columns(up_to_rows(kRows), kRows, 5).template cast<TypeParam>();
  // What stands above the diagonal is no data.
  update.topRows(kRows).template triangularView<Eigen::StrictlyUpper>().setConstant(
      std::numeric_limits<TypeParam>::quiet_NaN());
  std::vector<int> place(kRows);
  for (const RowRun& run : runs) {
    for (int k = 0; k < run.count; ++k) place[run.from + k] = run.to + k;
  }
  EmptyFront<TypeParam> front;
  clear(front.view());
  take_up(runs, update.data(), update.rows(), front.view());
  take_up(runs, update.data(), update.rows(), front.view());
  Eigen::MatrixX<TypeParam> expected = Eigen::MatrixX<TypeParam>::Zero(kSize, kSize);
  for (int column = 0; column < kRows; ++column) {
    for (int row = column; row < kRows; ++row) expected(place[row], place[column]) = 2 * update(row, column);
  }
  for (int column = 0; column < kSize; ++column) {
    for (int row = column; row < kSize; ++row) {
      EXPECT_EQ(front.at(row, column), expected(row, column)) << row << ", " << column;
    }
  }
}

}  // namespace
}  // namespace thinwall
