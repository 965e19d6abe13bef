#include "engine/solver/FrontFactor.hpp"
#include "engine/solver/Lanes.hpp"

namespace thinwall {
namespace {

/// Pivots that a solution takes together.
constexpr int kSolved = 4;

/// Rows that are taken together for one right-hand side.
template <typename Number>
using Rows = typename LanesOfBytes<Number, 32>::Type;

double sum_of(const Rows<double>& lanes) {
  return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
}
float sum_of(const Rows<float>& lanes) {
  return ((lanes[0] + lanes[1]) + (lanes[2] + lanes[3])) + ((lanes[4] + lanes[5]) + (lanes[6] + lanes[7]));
}

/// values -= matrix * known, for the rows from `begin` to `end`, a multiple of the lanes.
template <int columns, typename Number>
[[gnu::always_inline]] inline void subtract_columns(const Number* matrix, std::ptrdiff_t stride, const Number* known,
                                                    int begin, int end, Number* values) {
  int row = begin;
  for (; row % kLanesOf<Rows<Number>> != 0; ++row) {
    for (int c = 0; c < columns; ++c) values[row] -= matrix[c * stride + row] * known[c];
  }
  for (; row < end; row += kLanesOf<Rows<Number>>) {
    Rows<Number> value, column;
    load(values + row, value);
#pragma GCC unroll 4
    for (int c = 0; c < columns; ++c) {
      load(matrix + c * stride + row, column);
      value -= column * known[c];
    }
    store(value, values + row);
  }
}

/// sums -= matrix^T * values, over the rows from `begin` to `end`, a multiple of the lanes.
template <int columns, typename Number>
[[gnu::always_inline]] inline void subtract_dots(const Number* matrix, std::ptrdiff_t stride, const Number* values,
                                                 int begin, int end, Number* sums) {
  int row = begin;
  for (; row % kLanesOf<Rows<Number>> != 0; ++row) {
    for (int c = 0; c < columns; ++c) sums[c] -= matrix[c * stride + row] * values[row];
  }
  Rows<Number> lanes[columns] = {};
  for (; row < end; row += kLanesOf<Rows<Number>>) {
    Rows<Number> value, column;
    load(values + row, value);
#pragma GCC unroll 4
    for (int c = 0; c < columns; ++c) {
      load(matrix + c * stride + row, column);
      lanes[c] += column * value;
    }
  }
  for (int c = 0; c < columns; ++c) sums[c] -= sum_of(lanes[c]);
}

template <int columns, typename Number>
[[gnu::always_inline]] inline void forward_single(const Front<Number>& front, int column, Number* values) {
  const Number* matrix = front.columns + column * front.stride;
  Number* pivots = values + column;
  for (int c = 0; c < columns; ++c) {
    for (int p = 0; p < c; ++p) pivots[c] -= matrix[p * front.stride + column + c] * pivots[p];
    pivots[c] /= matrix[c * front.stride + column + c];
  }
  subtract_columns<columns>(matrix, front.stride, pivots, column + columns, static_cast<int>(front.stride), values);
}

template <int columns, typename Number>
[[gnu::always_inline]] inline void backward_single(const Front<Number>& front, int column, Number* values) {
  const Number* matrix = front.columns + column * front.stride;
  Number* pivots = values + column;
  subtract_dots<columns>(matrix, front.stride, values, column + columns, static_cast<int>(front.stride), pivots);
  for (int c = columns - 1; c >= 0; --c) {
    for (int p = c + 1; p < columns; ++p) pivots[c] -= matrix[c * front.stride + column + p] * pivots[p];
    pivots[c] /= matrix[c * front.stride + column + c];
  }
}

/// Several solutions side by side, as many as `parts` of `Some` lanes hold: `known`, `values` and `pivots` have a row
/// of them each.
template <typename Some, int parts>
struct Sides {
  using Number = NumberOf<Some>;
  static constexpr int kCount = parts * kLanesOf<Some>;
  Some part[parts];
};

template <typename Some, int parts>
[[gnu::always_inline]] inline void load_sides(const NumberOf<Some>* from, Sides<Some, parts>& sides) {
  for (int p = 0; p < parts; ++p) load(from + p * kLanesOf<Some>, sides.part[p]);
}

template <typename Some, int parts>
[[gnu::always_inline]] inline void store_sides(const Sides<Some, parts>& sides, NumberOf<Some>* to) {
  for (int p = 0; p < parts; ++p) store(sides.part[p], to + p * kLanesOf<Some>);
}

template <typename Some, int parts>
[[gnu::always_inline]] inline void subtract_scaled(const Sides<Some, parts>& sides, NumberOf<Some> scale,
                                                   Sides<Some, parts>& from) {
  for (int p = 0; p < parts; ++p) from.part[p] -= sides.part[p] * scale;
}

/// What `columns` pivots, whose solution is `known`, bear on in the rows from `begin` to `end`.
template <int columns, typename All>
[[gnu::always_inline]] inline void subtract_known(const typename All::Number* matrix, std::ptrdiff_t stride,
                                                  const typename All::Number* known, int begin, int end,
                                                  typename All::Number* values) {
  All factors[columns];
#pragma GCC unroll 4
  for (int c = 0; c < columns; ++c) load_sides(known + c * All::kCount, factors[c]);
  for (int row = begin; row < end; ++row) {
    All value;
    load_sides(values + row * All::kCount, value);
#pragma GCC unroll 4
    for (int c = 0; c < columns; ++c) subtract_scaled(factors[c], matrix[c * stride + row], value);
    store_sides(value, values + row * All::kCount);
  }
}

/// What the rows from `begin` to `end`, which are known, bear on in `columns` pivots.
template <int columns, typename All>
[[gnu::always_inline]] inline void subtract_rows(const typename All::Number* matrix, std::ptrdiff_t stride,
                                                 const typename All::Number* values, int begin, int end,
                                                 typename All::Number* pivots) {
  All sums[columns];
#pragma GCC unroll 4
  for (int c = 0; c < columns; ++c) load_sides(pivots + c * All::kCount, sums[c]);
  for (int row = begin; row < end; ++row) {
    All value;
    load_sides(values + row * All::kCount, value);
#pragma GCC unroll 4
    for (int c = 0; c < columns; ++c) subtract_scaled(value, matrix[c * stride + row], sums[c]);
  }
#pragma GCC unroll 4
  for (int c = 0; c < columns; ++c) store_sides(sums[c], pivots + c * All::kCount);
}

template <typename All>
[[gnu::always_inline]] inline void divide(typename All::Number pivot, typename All::Number* values) {
  All value;
  load_sides(values, value);
  for (auto& part : value.part) part /= pivot;
  store_sides(value, values);
}

/// One pivot after the other, from the first or from the last on.
template <int columns, typename All>
[[gnu::always_inline]] inline void forward_several(const Front<typename All::Number>& front, int column,
                                                   typename All::Number* values) {
  const typename All::Number* matrix = front.columns + column * front.stride;
  typename All::Number* pivots = values + column * All::kCount;
  for (int c = 0; c < columns; ++c) {
    divide<All>(matrix[c * front.stride + column + c], pivots + c * All::kCount);
    subtract_known<1, All>(matrix + c * front.stride, front.stride, pivots + c * All::kCount, column + c + 1,
                           column + columns, values);
  }
  subtract_known<columns, All>(matrix, front.stride, pivots, column + columns, front.size, values);
}

template <int columns, typename All>
[[gnu::always_inline]] inline void backward_several(const Front<typename All::Number>& front, int column,
                                                    typename All::Number* values) {
  const typename All::Number* matrix = front.columns + column * front.stride;
  typename All::Number* pivots = values + column * All::kCount;
  subtract_rows<columns, All>(matrix, front.stride, values, column + columns, front.size, pivots);
  for (int c = columns - 1; c >= 0; --c) {
    subtract_rows<1, All>(matrix + c * front.stride, front.stride, values, column + c + 1, column + columns,
                          pivots + c * All::kCount);
    divide<All>(matrix[c * front.stride + column + c], pivots + c * All::kCount);
  }
}

template <typename All>
[[gnu::always_inline]] inline void forward_all(const Front<typename All::Number>& front, typename All::Number* values) {
  const int whole = front.pivots / kSolved * kSolved;
  for (int column = 0; column < whole; column += kSolved) forward_several<kSolved, All>(front, column, values);
  for (int column = whole; column < front.pivots; ++column) forward_several<1, All>(front, column, values);
}

template <typename All>
[[gnu::always_inline]] inline void backward_all(const Front<typename All::Number>& front,
                                                typename All::Number* values) {
  const int whole = front.pivots / kSolved * kSolved;
  for (int column = front.pivots - 1; column >= whole; --column) backward_several<1, All>(front, column, values);
  for (int column = whole - kSolved; column >= 0; column -= kSolved) {
    backward_several<kSolved, All>(front, column, values);
  }
}

enum class Direction { kForward, kBackward };

template <typename All>
[[gnu::always_inline]] inline void solve_all(const Front<typename All::Number>& front, Direction direction,
                                             typename All::Number* values) {
  direction == Direction::kForward ? forward_all<All>(front, values) : backward_all<All>(front, values);
}

/// Four right-hand sides, or eight in lanes of their own kind.
template <typename Eight>
[[gnu::always_inline]] inline void solve_four_or_eight(const Front<typename Eight::Number>& front, Direction direction,
                                                       int sides, typename Eight::Number* values) {
  using Number = typename Eight::Number;
  using Four = Sides<typename LanesOfBytes<Number, 4 * sizeof(Number)>::Type, 1>;
  sides == Eight::kCount ? solve_all<Eight>(front, direction, values) : solve_all<Four>(front, direction, values);
}
using EightOfSingle = Sides<Rows<float>, 1>;

#ifdef THINWALL_FOR_PROCESSORS
THINWALL_FOR_PROCESSORS("avx512f,fma")
void solve_several(const Front<double>& front, Direction direction, int sides, double* values) {
  solve_four_or_eight<Sides<WideLanes<double>, 1>>(front, direction, sides, values);
}
THINWALL_FOR_PROCESSORS("avx2,fma")
void solve_several(const Front<double>& front, Direction direction, int sides, double* values) {
  solve_four_or_eight<Sides<Rows<double>, 2>>(front, direction, sides, values);
}
THINWALL_FOR_PROCESSORS("avx2,fma")
void solve_several(const Front<float>& front, Direction direction, int sides, float* values) {
  solve_four_or_eight<EightOfSingle>(front, direction, sides, values);
}
THINWALL_FOR_PROCESSORS("default")
#endif
void solve_several(const Front<double>& front, Direction direction, int sides, double* values) {
  solve_four_or_eight<Sides<Rows<double>, 2>>(front, direction, sides, values);
}
#ifdef THINWALL_FOR_PROCESSORS
THINWALL_FOR_PROCESSORS("default")
#endif
void solve_several(const Front<float>& front, Direction direction, int sides, float* values) {
  solve_four_or_eight<EightOfSingle>(front, direction, sides, values);
}

template <typename Number>
[[gnu::always_inline]] inline void solve_single(const Front<Number>& front, Direction direction, Number* values) {
  const int whole = front.pivots / kSolved * kSolved;
  if (direction == Direction::kForward) {
    for (int column = 0; column < whole; column += kSolved) forward_single<kSolved>(front, column, values);
    for (int column = whole; column < front.pivots; ++column) forward_single<1>(front, column, values);
    return;
  }
  for (int column = front.pivots - 1; column >= whole; --column) backward_single<1>(front, column, values);
  for (int column = whole - kSolved; column >= 0; column -= kSolved) backward_single<kSolved>(front, column, values);
}
THINWALL_FOR_ALL_PROCESSORS void solve_one(const Front<double>& front, Direction direction, double* values) {
  solve_single(front, direction, values);
}
THINWALL_FOR_ALL_PROCESSORS void solve_one(const Front<float>& front, Direction direction, float* values) {
  solve_single(front, direction, values);
}

template <typename Number>
void solve(const Front<Number>& front, Direction direction, int sides, Number* values) {
  sides == 1 ? solve_one(front, direction, values) : solve_several(front, direction, sides, values);
}

}  // namespace

void solve_forward(const Front<double>& front, int sides, double* values) {
  solve(front, Direction::kForward, sides, values);
}
void solve_forward(const Front<float>& front, int sides, float* values) {
  solve(front, Direction::kForward, sides, values);
}
void solve_backward(const Front<double>& front, int sides, double* values) {
  solve(front, Direction::kBackward, sides, values);
}
void solve_backward(const Front<float>& front, int sides, float* values) {
  solve(front, Direction::kBackward, sides, values);
}

}  // namespace thinwall
