#include "engine/solver/FrontFactor.hpp"

#include <algorithm>
#include <cmath>

#include "engine/solver/Lanes.hpp"

namespace thinwall {
namespace {

/// Lanes of which the rows of a front are a multiple.
template <typename Number>
using Usual = typename LanesOfBytes<Number, 32>::Type;
static_assert(kFrontRows % kLanesOf<Usual<double>> == 0 && kFrontRows % kLanesOf<Usual<float>> == 0);

/// Columns of a panel that is eliminated: `rows` points at the first row that is wanted.
template <typename Number>
struct Eliminated {
  const Number* rows;
  std::ptrdiff_t stride;
  int count;
};

/// What some eliminated columns take from `columns` others from row `begin` to `end`, both multiples of kFrontRows.
/// `of_columns` are the entries of the eliminated columns in the rows that the target's columns have.
template <typename Number>
struct Product {
  Eliminated<Number> eliminated;
  const Number* of_columns;
  const Number* signs;
  int columns;
  int begin, end;
  Number* target;
  std::ptrdiff_t stride;  // of the target
  Number* workspace;
};

/// target -= eliminated * factors for as many rows as `tiles` of `Some` lanes hold and `columns` columns; `factors`,
/// (columns x eliminated).
template <typename Some, int tiles, int columns, typename Number>
[[gnu::always_inline]] inline void subtract_product(const Eliminated<Number>& eliminated, const Number* factors,
                                                    Number* target, std::ptrdiff_t stride) {
  Some values[tiles][columns];
#pragma GCC unroll 2
  for (int t = 0; t < tiles; ++t) {
#pragma GCC unroll 6
    for (int c = 0; c < columns; ++c) load(target + c * stride + t * kLanesOf<Some>, values[t][c]);
  }
  const Number* rows = eliminated.rows;
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

template <typename Some, int columns, typename Number>
[[gnu::always_inline]] inline void take_off(const Product<Number>& product) {
  const Eliminated<Number>& eliminated = product.eliminated;
  Number* factors = product.workspace;
  for (int p = 0; p < eliminated.count; ++p) {
#pragma GCC unroll 6
    for (int c = 0; c < columns; ++c) {
      *factors++ = product.signs[p] * product.of_columns[p * eliminated.stride + c];
    }
  }
  const auto from = [&](int row) {
    return Eliminated<Number>{eliminated.rows + row, eliminated.stride, eliminated.count};
  };
  constexpr int kRows = kLanesOf<Some>;
  int row = product.begin;
  for (; row + 2 * kRows <= product.end; row += 2 * kRows) {
    subtract_product<Some, 2, columns>(from(row), product.workspace, product.target + row, product.stride);
  }
  if (row + kRows <= product.end) {
    subtract_product<Some, 1, columns>(from(row), product.workspace, product.target + row, product.stride);
    row += kRows;
  }
  if constexpr (kRows > kFrontRows) {
    if (row == product.end) return;
    subtract_product<Usual<Number>, 1, columns>(from(row), product.workspace, product.target + row, product.stride);
  }
}

template <typename Some, typename Number>
[[gnu::always_inline]] inline void take_off_some(const Product<Number>& product) {
  switch (product.columns) {
    case 1:
      return take_off<Some, 1>(product);
    case 2:
      return take_off<Some, 2>(product);
    case 3:
      return take_off<Some, 3>(product);
    case 4:
      return take_off<Some, 4>(product);
    case 5:
      return take_off<Some, 5>(product);
    default:
      return take_off<Some, kFrontColumns>(product);
  }
}

#ifdef THINWALL_FOR_PROCESSORS
THINWALL_FOR_PROCESSORS("avx512f")
void take_off_columns(const Product<double>& product) {
  take_off_some<WideLanes<double>>(product);
}
THINWALL_FOR_PROCESSORS("avx512f")
void take_off_columns(const Product<float>& product) {
  take_off_some<WideLanes<float>>(product);
}
THINWALL_FOR_PROCESSORS("avx2,fma")
void take_off_columns(const Product<double>& product) {
  take_off_some<Usual<double>>(product);
}
THINWALL_FOR_PROCESSORS("avx2,fma")
void take_off_columns(const Product<float>& product) {
  take_off_some<Usual<float>>(product);
}
THINWALL_FOR_PROCESSORS("default")
#endif
void take_off_columns(const Product<double>& product) {
  take_off_some<Usual<double>>(product);
}
#ifdef THINWALL_FOR_PROCESSORS
THINWALL_FOR_PROCESSORS("default")
#endif
void take_off_columns(const Product<float>& product) {
  take_off_some<Usual<float>>(product);
}

/// Factorises the diagonal block of some columns that no earlier pivot bears on any more; false where it cannot be.
template <typename Number>
bool factorize_block(Number* block, std::ptrdiff_t stride, int columns, bool allows_negative, Number* signs) {
  for (int c = 0; c < columns; ++c) {
    Number* column = block + c * stride;
    for (int p = 0; p < c; ++p) {
      const Number factor = signs[p] * block[p * stride + c];
      for (int row = c; row < columns; ++row) column[row] -= block[p * stride + row] * factor;
    }
    const Number pivot = column[c];
    if (!(std::abs(pivot) > 0) || !std::isfinite(pivot) || (pivot < 0 && !allows_negative)) return false;
    signs[c] = static_cast<Number>(pivot < 0 ? -1 : 1);
    column[c] = std::sqrt(std::abs(pivot));
    for (int row = c + 1; row < columns; ++row) column[row] *= signs[c] / column[c];
  }
  return true;
}

/// The rows of some columns below their diagonal block, once the block is factorised: row by row x S L^T = a.
template <int columns, typename Number>
[[gnu::always_inline]] inline void divide_rows(const Number* block, std::ptrdiff_t stride, const Number* signs,
                                               int begin, int end, Number* rows) {
  Number factors[columns][columns], inverse[columns];
#pragma GCC unroll 6
  for (int c = 0; c < columns; ++c) {
    for (int p = 0; p < c; ++p) factors[c][p] = signs[p] * block[p * stride + c];
    inverse[c] = signs[c] / block[c * stride + c];
  }
  for (int row = begin; row < end; row += kLanesOf<Usual<Number>>) {
    Usual<Number> x[columns];
#pragma GCC unroll 6
    for (int c = 0; c < columns; ++c) {
      load(rows + c * stride + row, x[c]);
      for (int p = 0; p < c; ++p) x[c] -= x[p] * factors[c][p];
      x[c] *= inverse[c];
      store(x[c], rows + c * stride + row);
    }
  }
}

template <typename Number>
[[gnu::always_inline]] inline void divide_some(const Number* block, std::ptrdiff_t stride, const Number* signs,
                                               int columns, int begin, int end, Number* rows) {
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

THINWALL_FOR_ALL_PROCESSORS void divide_columns(const double* block, std::ptrdiff_t stride, const double* signs,
                                                int columns, int begin, int end, double* rows) {
  divide_some(block, stride, signs, columns, begin, end, rows);
}
THINWALL_FOR_ALL_PROCESSORS void divide_columns(const float* block, std::ptrdiff_t stride, const float* signs,
                                                int columns, int begin, int end, float* rows) {
  divide_some(block, stride, signs, columns, begin, end, rows);
}

int down_to_rows(int row) {
  return row / kFrontRows * kFrontRows;
}

/// Eliminates the pivots from `begin` to `end`, which those before bear on no more, within their own columns.
template <typename Number>
bool eliminate_panel(const Front<Number>& front, int begin, int end, bool allows_negative) {
  const int last_row = up_to_rows(front.size);
  for (int column = begin; column < end; column += kFrontColumns) {
    const int columns = std::min(kFrontColumns, end - column);
    Number* target = front.columns + column * front.stride;
    const Number* panel = front.columns + begin * front.stride;
    if (column > begin) {
      take_off_columns(Product<Number>{.eliminated = {panel, front.stride, column - begin},
                                       .of_columns = panel + column,
                                       .signs = front.signs + begin,
                                       .columns = columns,
                                       .begin = down_to_rows(column),
                                       .end = last_row,
                                       .target = target,
                                       .stride = front.stride,
                                       .workspace = front.workspace});
    }
    Number* signs = front.signs + column;
    Number* block = target + column;
    if (!factorize_block(block, front.stride, columns, allows_negative, signs)) return false;
    // The first rows below the block one by one: the lanes may begin above it, where L stands already.
    const int below = column + columns, first = std::min(up_to_rows(below), front.size);
    for (int row = below; row < first; ++row) {
      for (int c = 0; c < columns; ++c) {
        Number& x = target[c * front.stride + row];
        for (int p = 0; p < c; ++p) x -= target[p * front.stride + row] * (signs[p] * block[p * front.stride + c]);
        x *= signs[c] / block[c * front.stride + c];
      }
    }
    divide_columns(block, front.stride, signs, columns, up_to_rows(below), last_row, target);
  }
  return true;
}

/// What the pivots from `begin` to `end` take off the columns behind them.
template <typename Number>
void follow_panel(const Front<Number>& front, int begin, int end) {
  const Number* panel = front.columns + begin * front.stride;
  const auto take_off_behind = [&](const Number* rows, int column, int columns, int size, Number* target,
                                   std::ptrdiff_t stride) {
    take_off_columns(Product<Number>{.eliminated = {rows, front.stride, end - begin},
                                     .of_columns = rows + column,
                                     .signs = front.signs + begin,
                                     .columns = std::min(kFrontColumns, columns - column),
                                     .begin = down_to_rows(column),
                                     .end = up_to_rows(size),
                                     .target = target + column * stride,
                                     .stride = stride,
                                     .workspace = front.workspace});
  };
  for (int column = end; column < front.pivots; column += kFrontColumns) {
    take_off_behind(panel, column, front.pivots, front.size, front.columns, front.stride);
  }
  const int rest = front.size - front.pivots;
  for (int column = 0; column < rest; column += kFrontColumns) {
    take_off_behind(panel + front.pivots, column, rest, rest, front.update, front.update_stride);
  }
}

template <typename Number>
int eliminate_all(const Front<Number>& front, bool allows_negative) {
  for (int begin = 0; begin < front.pivots; begin += kPanel) {
    const int end = std::min(begin + kPanel, front.pivots);
    if (!eliminate_panel(front, begin, end, allows_negative)) return -1;
    follow_panel(front, begin, end);
  }
  return static_cast<int>(std::count_if(front.signs, front.signs + front.pivots, [](Number sign) { return sign < 0; }));
}

}  // namespace

int eliminate(const Front<double>& front, bool allows_negative) {
  return eliminate_all(front, allows_negative);
}
int eliminate(const Front<float>& front, bool allows_negative) {
  return eliminate_all(front, allows_negative);
}

}  // namespace thinwall
