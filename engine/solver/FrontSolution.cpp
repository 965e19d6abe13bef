#include "engine/solver/FrontFactor.hpp"
#include "engine/solver/Lanes.hpp"

namespace thinwall {
namespace {

static_assert(kSolutions == kLanes);

/// Pivots that a solution takes together.
constexpr int kSolved = 4;

/// values -= matrix * known, for the rows from `begin` to `end`, a multiple of the lanes.
template <int columns>
[[gnu::always_inline]] inline void subtract_columns(const double* matrix, std::ptrdiff_t stride, const double* known,
                                                    int begin, int end, double* values) {
  int row = begin;
  for (; row % kLanes != 0; ++row) {
    for (int c = 0; c < columns; ++c) values[row] -= matrix[c * stride + row] * known[c];
  }
  for (; row < end; row += kLanes) {
    Lanes value, column;
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
template <int columns>
[[gnu::always_inline]] inline void subtract_dots(const double* matrix, std::ptrdiff_t stride, const double* values,
                                                 int begin, int end, double* sums) {
  int row = begin;
  for (; row % kLanes != 0; ++row) {
    for (int c = 0; c < columns; ++c) sums[c] -= matrix[c * stride + row] * values[row];
  }
  Lanes lanes[columns] = {};
  for (; row < end; row += kLanes) {
    Lanes value, column;
    load(values + row, value);
#pragma GCC unroll 4
    for (int c = 0; c < columns; ++c) {
      load(matrix + c * stride + row, column);
      lanes[c] += column * value;
    }
  }
  for (int c = 0; c < columns; ++c) sums[c] -= (lanes[c][0] + lanes[c][1]) + (lanes[c][2] + lanes[c][3]);
}

template <int columns>
[[gnu::always_inline]] inline void forward_single(const Front& front, int column, double* values) {
  const double* matrix = front.columns + column * front.stride;
  double* pivots = values + column;
  for (int c = 0; c < columns; ++c) {
    for (int p = 0; p < c; ++p) pivots[c] -= matrix[p * front.stride + column + c] * pivots[p];
    pivots[c] /= matrix[c * front.stride + column + c];
  }
  subtract_columns<columns>(matrix, front.stride, pivots, column + columns, static_cast<int>(front.stride), values);
}

template <int columns>
[[gnu::always_inline]] inline void backward_single(const Front& front, int column, double* values) {
  const double* matrix = front.columns + column * front.stride;
  double* pivots = values + column;
  subtract_dots<columns>(matrix, front.stride, values, column + columns, static_cast<int>(front.stride), pivots);
  for (int c = columns - 1; c >= 0; --c) {
    for (int p = c + 1; p < columns; ++p) pivots[c] -= matrix[c * front.stride + column + p] * pivots[p];
    pivots[c] /= matrix[c * front.stride + column + c];
  }
}

/// What `columns` pivots, whose solution is `known`, (columns x kSolutions), bear on in the rows from `begin` to `end`.
template <int columns>
[[gnu::always_inline]] inline void subtract_known(const double* matrix, std::ptrdiff_t stride, const double* known,
                                                  int begin, int end, double* values) {
  Lanes factors[columns];
#pragma GCC unroll 4
  for (int c = 0; c < columns; ++c) load(known + c * kSolutions, factors[c]);
  for (int row = begin; row < end; ++row) {
    Lanes value;
    load(values + row * kSolutions, value);
#pragma GCC unroll 4
    for (int c = 0; c < columns; ++c) value -= factors[c] * matrix[c * stride + row];
    store(value, values + row * kSolutions);
  }
}

/// What the rows from `begin` to `end`, which are known, bear on in `columns` pivots.
template <int columns>
[[gnu::always_inline]] inline void subtract_rows(const double* matrix, std::ptrdiff_t stride, const double* values,
                                                 int begin, int end, double* pivots) {
  Lanes sums[columns];
#pragma GCC unroll 4
  for (int c = 0; c < columns; ++c) load(pivots + c * kSolutions, sums[c]);
  for (int row = begin; row < end; ++row) {
    Lanes value;
    load(values + row * kSolutions, value);
#pragma GCC unroll 4
    for (int c = 0; c < columns; ++c) sums[c] -= value * matrix[c * stride + row];
  }
#pragma GCC unroll 4
  for (int c = 0; c < columns; ++c) store(sums[c], pivots + c * kSolutions);
}

/// One pivot after the other, from the first or from the last on.
template <int columns>
[[gnu::always_inline]] inline void forward_several(const Front& front, int column, double* values) {
  const double* matrix = front.columns + column * front.stride;
  double* pivots = values + column * kSolutions;
  for (int c = 0; c < columns; ++c) {
    Lanes value;
    load(pivots + c * kSolutions, value);
    value /= matrix[c * front.stride + column + c];
    store(value, pivots + c * kSolutions);
    subtract_known<1>(matrix + c * front.stride, front.stride, pivots + c * kSolutions, column + c + 1,
                      column + columns, values);
  }
  subtract_known<columns>(matrix, front.stride, pivots, column + columns, front.size, values);
}

template <int columns>
[[gnu::always_inline]] inline void backward_several(const Front& front, int column, double* values) {
  const double* matrix = front.columns + column * front.stride;
  double* pivots = values + column * kSolutions;
  subtract_rows<columns>(matrix, front.stride, values, column + columns, front.size, pivots);
  for (int c = columns - 1; c >= 0; --c) {
    subtract_rows<1>(matrix + c * front.stride, front.stride, values, column + c + 1, column + columns,
                     pivots + c * kSolutions);
    Lanes value;
    load(pivots + c * kSolutions, value);
    value /= matrix[c * front.stride + column + c];
    store(value, pivots + c * kSolutions);
  }
}

}  // namespace

THINWALL_FOR_ALL_PROCESSORS void solve_forward(const Front& front, double* values) {
  const int whole = front.pivots / kSolved * kSolved;
  for (int column = 0; column < whole; column += kSolved) forward_single<kSolved>(front, column, values);
  for (int column = whole; column < front.pivots; ++column) forward_single<1>(front, column, values);
}

THINWALL_FOR_ALL_PROCESSORS void solve_backward(const Front& front, double* values) {
  const int whole = front.pivots / kSolved * kSolved;
  for (int column = front.pivots - 1; column >= whole; --column) backward_single<1>(front, column, values);
  for (int column = whole - kSolved; column >= 0; column -= kSolved) backward_single<kSolved>(front, column, values);
}

THINWALL_FOR_ALL_PROCESSORS void solve_several_forward(const Front& front, double* values) {
  const int whole = front.pivots / kSolved * kSolved;
  for (int column = 0; column < whole; column += kSolved) forward_several<kSolved>(front, column, values);
  for (int column = whole; column < front.pivots; ++column) forward_several<1>(front, column, values);
}

THINWALL_FOR_ALL_PROCESSORS void solve_several_backward(const Front& front, double* values) {
  const int whole = front.pivots / kSolved * kSolved;
  for (int column = front.pivots - 1; column >= whole; --column) backward_several<1>(front, column, values);
  for (int column = whole - kSolved; column >= 0; column -= kSolved) backward_several<kSolved>(front, column, values);
}

}  // namespace thinwall
