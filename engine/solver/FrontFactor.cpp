#include "engine/solver/FrontFactor.hpp"

#include <algorithm>
#include <cmath>

#include "engine/solver/Lanes.hpp"

namespace thinwall {
namespace {

static_assert(kFrontRows == kWideLanes && kFrontRows == 2 * kLanes);

/// Columns of a panel that is eliminated: `rows` points at the first row that is wanted.
struct Eliminated {
  const double* rows;
  std::ptrdiff_t stride;
  int count;
};

/// target -= eliminated * factors for as many rows as `tiles` of `Some` lanes hold and `columns` columns; `factors`,
/// (columns x eliminated).
template <typename Some, int tiles, int columns>
[[gnu::always_inline]] inline void subtract_product(const Eliminated& eliminated, const double* factors, double* target,
                                                    std::ptrdiff_t stride) {
  Some values[tiles][columns];
#pragma GCC unroll 2
  for (int t = 0; t < tiles; ++t) {
#pragma GCC unroll 6
    for (int c = 0; c < columns; ++c) load(target + c * stride + t * kLanesOf<Some>, values[t][c]);
  }
  const double* rows = eliminated.rows;
  for (int p = 0; p < eliminated.count; ++p, rows += eliminated.stride, factors += columns) {
    Some row[tiles];
#pragma GCC unroll 2
    for (int t = 0; t < tiles; ++t) load(rows + t * kLanesOf<Some>, row[t]);
#pragma GCC unroll 6
    for (int c = 0; c < columns; ++c) {
#pragma GCC unroll 2
      for (int t = 0; t < tiles; ++t) values[t][c] -= row[t] * factors[c];
    }
  }
#pragma GCC unroll 2
  for (int t = 0; t < tiles; ++t) {
#pragma GCC unroll 6
    for (int c = 0; c < columns; ++c) store(values[t][c], target + c * stride + t * kLanesOf<Some>);
  }
}

/// What some eliminated columns take from `columns` columns from row `begin` to `end`, both multiples of kFrontRows.
/// `of_columns` are the entries of the eliminated columns in the rows that the target's columns have.
template <typename Some, int columns>
[[gnu::always_inline]] inline void take_off(const Eliminated& eliminated, const double* of_columns, const double* signs,
                                            int begin, int end, double* target, std::ptrdiff_t stride,
                                            double* workspace) {
  double* factors = workspace;
  for (int p = 0; p < eliminated.count; ++p) {
#pragma GCC unroll 6
    for (int c = 0; c < columns; ++c) *factors++ = signs[p] * of_columns[p * eliminated.stride + c];
  }
  const auto from = [&](int row) { return Eliminated{eliminated.rows + row, eliminated.stride, eliminated.count}; };
  constexpr int kRows = 2 * kLanesOf<Some>;
  int row = begin;
  for (; row + kRows <= end; row += kRows) {
    subtract_product<Some, 2, columns>(from(row), workspace, target + row, stride);
  }
  if (row < end) subtract_product<Some, 1, columns>(from(row), workspace, target + row, stride);
}

template <typename Some>
[[gnu::always_inline]] inline void take_off_some(const Eliminated& eliminated, const double* of_columns,
                                                 const double* signs, int columns, int begin, int end, double* target,
                                                 std::ptrdiff_t stride, double* workspace) {
  switch (columns) {
    case 1:
      return take_off<Some, 1>(eliminated, of_columns, signs, begin, end, target, stride, workspace);
    case 2:
      return take_off<Some, 2>(eliminated, of_columns, signs, begin, end, target, stride, workspace);
    case 3:
      return take_off<Some, 3>(eliminated, of_columns, signs, begin, end, target, stride, workspace);
    case 4:
      return take_off<Some, 4>(eliminated, of_columns, signs, begin, end, target, stride, workspace);
    case 5:
      return take_off<Some, 5>(eliminated, of_columns, signs, begin, end, target, stride, workspace);
    default:
      return take_off<Some, kFrontColumns>(eliminated, of_columns, signs, begin, end, target, stride, workspace);
  }
}

#ifdef THINWALL_FOR_PROCESSORS
THINWALL_FOR_PROCESSORS("avx512f")
void take_off_columns(const Eliminated& eliminated, const double* of_columns, const double* signs, int columns,
                      int begin, int end, double* target, std::ptrdiff_t stride, double* workspace) {
  take_off_some<WideLanes>(eliminated, of_columns, signs, columns, begin, end, target, stride, workspace);
}
THINWALL_FOR_PROCESSORS("avx2,fma")
void take_off_columns(const Eliminated& eliminated, const double* of_columns, const double* signs, int columns,
                      int begin, int end, double* target, std::ptrdiff_t stride, double* workspace) {
  take_off_some<Lanes>(eliminated, of_columns, signs, columns, begin, end, target, stride, workspace);
}
THINWALL_FOR_PROCESSORS("default")
#endif
void take_off_columns(const Eliminated& eliminated, const double* of_columns, const double* signs, int columns,
                      int begin, int end, double* target, std::ptrdiff_t stride, double* workspace) {
  take_off_some<Lanes>(eliminated, of_columns, signs, columns, begin, end, target, stride, workspace);
}

/// Factorises the diagonal block of some columns that no earlier pivot bears on any more; false where it cannot be.
bool factorize_block(double* block, std::ptrdiff_t stride, int columns, bool allows_negative, double* signs) {
  for (int c = 0; c < columns; ++c) {
    double* column = block + c * stride;
    for (int p = 0; p < c; ++p) {
      const double factor = signs[p] * block[p * stride + c];
      for (int row = c; row < columns; ++row) column[row] -= block[p * stride + row] * factor;
    }
    const double pivot = column[c];
    if (!(std::abs(pivot) > 0) || !std::isfinite(pivot) || (pivot < 0 && !allows_negative)) return false;
    signs[c] = pivot < 0 ? -1 : 1;
    column[c] = std::sqrt(std::abs(pivot));
    for (int row = c + 1; row < columns; ++row) column[row] *= signs[c] / column[c];
  }
  return true;
}

/// The rows of some columns below their diagonal block, once the block is factorised: row by row x S L^T = a.
template <int columns>
[[gnu::always_inline]] inline void divide_rows(const double* block, std::ptrdiff_t stride, const double* signs,
                                               int begin, int end, double* rows) {
  double factors[columns][columns], inverse[columns];
#pragma GCC unroll 6
  for (int c = 0; c < columns; ++c) {
    for (int p = 0; p < c; ++p) factors[c][p] = signs[p] * block[p * stride + c];
    inverse[c] = signs[c] / block[c * stride + c];
  }
  for (int row = begin; row < end; row += kLanes) {
    Lanes x[columns];
#pragma GCC unroll 6
    for (int c = 0; c < columns; ++c) {
      load(rows + c * stride + row, x[c]);
      for (int p = 0; p < c; ++p) x[c] -= x[p] * factors[c][p];
      x[c] *= inverse[c];
      store(x[c], rows + c * stride + row);
    }
  }
}

THINWALL_FOR_ALL_PROCESSORS void divide_columns(const double* block, std::ptrdiff_t stride, const double* signs,
                                                int columns, int begin, int end, double* rows) {
  switch (columns) {
    case 1:
      return divide_rows<1>(block, stride, signs, begin, end, rows);
    case 2:
      return divide_rows<2>(block, stride, signs, begin, end, rows);
    case 3:
      return divide_rows<3>(block, stride, signs, begin, end, rows);
    case 4:
      return divide_rows<4>(block, stride, signs, begin, end, rows);
    case 5:
      return divide_rows<5>(block, stride, signs, begin, end, rows);
    default:
      return divide_rows<kFrontColumns>(block, stride, signs, begin, end, rows);
  }
}

int down_to_rows(int row) {
  return row / kFrontRows * kFrontRows;
}

/// Eliminates the pivots from `begin` to `end`, which those before bear on no more, within their own columns.
bool eliminate_panel(const Front& front, int begin, int end, bool allows_negative) {
  const int last_row = up_to_rows(front.size);
  for (int column = begin; column < end; column += kFrontColumns) {
    const int columns = std::min(kFrontColumns, end - column);
    double* target = front.columns + column * front.stride;
    const double* panel = front.columns + begin * front.stride;
    if (column > begin) {
      take_off_columns({panel, front.stride, column - begin}, panel + column, front.signs + begin, columns,
                       down_to_rows(column), last_row, target, front.stride, front.workspace);
    }
    double* signs = front.signs + column;
    double* block = target + column;
    if (!factorize_block(block, front.stride, columns, allows_negative, signs)) return false;
    // The first rows below the block one by one: the lanes may begin above it, where L stands already.
    const int below = column + columns, first = std::min(up_to_rows(below), front.size);
    for (int row = below; row < first; ++row) {
      for (int c = 0; c < columns; ++c) {
        double& x = target[c * front.stride + row];
        for (int p = 0; p < c; ++p) x -= target[p * front.stride + row] * (signs[p] * block[p * front.stride + c]);
        x *= signs[c] / block[c * front.stride + c];
      }
    }
    divide_columns(block, front.stride, signs, columns, up_to_rows(below), last_row, target);
  }
  return true;
}

/// What the pivots from `begin` to `end` take off the columns behind them.
void follow_panel(const Front& front, int begin, int end) {
  const double* panel = front.columns + begin * front.stride;
  const double* signs = front.signs + begin;
  for (int column = end; column < front.pivots; column += kFrontColumns) {
    take_off_columns({panel, front.stride, end - begin}, panel + column, signs,
                     std::min(kFrontColumns, front.pivots - column), down_to_rows(column), up_to_rows(front.size),
                     front.columns + column * front.stride, front.stride, front.workspace);
  }
  const int rest = front.size - front.pivots;
  const double* below = panel + front.pivots;
  for (int column = 0; column < rest; column += kFrontColumns) {
    take_off_columns({below, front.stride, end - begin}, below + column, signs, std::min(kFrontColumns, rest - column),
                     down_to_rows(column), up_to_rows(rest), front.update + column * front.update_stride,
                     front.update_stride, front.workspace);
  }
}

}  // namespace

int eliminate(const Front& front, bool allows_negative) {
  for (int begin = 0; begin < front.pivots; begin += kPanel) {
    const int end = std::min(begin + kPanel, front.pivots);
    if (!eliminate_panel(front, begin, end, allows_negative)) return -1;
    follow_panel(front, begin, end);
  }
  return static_cast<int>(std::count_if(front.signs, front.signs + front.pivots, [](double sign) { return sign < 0; }));
}

}  // namespace thinwall
