#pragma once

#include <cstddef>

namespace thinwall {

/// Rows in which fronts are worked on: the leading dimensions of fronts and updates are multiples of it.
constexpr int kFrontRows = 8;
constexpr int up_to_rows(int rows) {
  return (rows + kFrontRows - 1) / kFrontRows * kFrontRows;
}

/// A dense symmetric matrix of which the first unknowns are eliminated. By columns, of which only what is on and below
/// the diagonal is read as data; what stands above it, and in rows past the last, is of no meaning. Of numbers of
/// double or of single precision.
template <typename Number>
struct Front {
  int pivots = 0;             // unknowns to eliminate
  int size = 0;               // all unknowns
  Number* columns = nullptr;  // (stride x pivots), the first columns: in, the matrix; out, L
  std::ptrdiff_t stride = 0;  // of `columns`, a multiple of kFrontRows that is at least `size`
  // (update_stride x size - pivots), the other columns from row `pivots` on: in, the matrix; out, what is left of it
  Number* update = nullptr;
  std::ptrdiff_t update_stride = 0;  // a multiple of kFrontRows that is at least size - pivots
  Number* signs = nullptr;           // (pivots), out: 1 or -1
  Number* workspace = nullptr;       // kFrontColumns * kPanel
};

/// Columns that are worked on together, and pivots after whose elimination the columns behind them follow.
constexpr int kFrontColumns = 6;
constexpr int kPanel = 96;

/// Eliminates the pivots: A = L S L^T with S = diag(signs), without interchanges. Gives the number of negative pivots,
/// or -1 where a pivot vanishes or is no number, or where it is negative and that is not allowed. The order of the
/// operations on each entry depends on the sizes alone: the same bits on every processor that fuses a multiplication
/// with a subtraction, as is done in products of panels and for several right-hand sides, and on every other one.
int eliminate(const Front<double>& front, bool allows_negative);
int eliminate(const Front<float>& front, bool allows_negative);

/// Solves L y = b for the pivots and takes what they bear on off the rows below them, for 1, 4 or 8 right-hand sides
/// that stand side by side: `values`, (stride x sides) by rows, in place. Each has the same bits among four and among
/// eight; four take about twice the time of one, and eight less than twice that.
void solve_forward(const Front<double>& front, int sides, double* values);
void solve_forward(const Front<float>& front, int sides, float* values);

/// The same of L^T x = y, with the rows below the pivots known; what stands past the last row is zero.
void solve_backward(const Front<double>& front, int sides, double* values);
void solve_backward(const Front<float>& front, int sides, float* values);

}  // namespace thinwall
