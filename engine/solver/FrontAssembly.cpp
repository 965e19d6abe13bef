#include "engine/solver/FrontAssembly.hpp"

#include "engine/solver/Lanes.hpp"

namespace thinwall {
namespace {

/// The lower triangle of a square of `columns`, with the rows below it down to `stride`.
[[gnu::always_inline]] inline void clear_columns(int columns, std::ptrdiff_t stride, double* first) {
  const Lanes zero{};
  for (int block = 0; block < columns; block += kFrontRows) {
    const int end = block + kFrontRows < columns ? block + kFrontRows : columns;
    for (int column = block; column < end; ++column) {
      double* rows = first + column * stride;
      for (std::ptrdiff_t row = block; row < stride; row += kLanes) store(zero, rows + row);
    }
  }
}

/// to += from.
[[gnu::always_inline]] inline void add_rows(const double* from, int count, double* to) {
  if (count < kLanes) {
    for (int row = 0; row < count; ++row) to[row] += from[row];
    return;
  }
  // The last lanes may overlap those before: they are read before anything is written.
  Lanes last, addend;
  load(to + count - kLanes, last);
  load(from + count - kLanes, addend);
  last += addend;
  for (int row = 0; row < count - kLanes; row += kLanes) {
    Lanes sum;
    load(to + row, sum);
    load(from + row, addend);
    sum += addend;
    store(sum, to + row);
  }
  store(last, to + count - kLanes);
}

}  // namespace

THINWALL_FOR_ALL_PROCESSORS void clear(const Front& front) {
  clear_columns(front.pivots, front.stride, front.columns);
  clear_columns(front.size - front.pivots, front.update_stride, front.update);
}

THINWALL_FOR_ALL_PROCESSORS void take_up(std::span<const RowRun> runs, const double* update,
                                         std::ptrdiff_t update_stride, const Front& front) {
  for (std::size_t first = 0; first < runs.size(); ++first) {
    const RowRun& columns = runs[first];
    const bool is_eliminated = columns.to < front.pivots;
    const std::ptrdiff_t stride = is_eliminated ? front.stride : front.update_stride;
    double* target = is_eliminated ? front.columns + columns.to * stride
                                   : front.update + (columns.to - front.pivots) * stride - front.pivots;
    const double* source = update + columns.from * update_stride;
    for (int k = 0; k < columns.count; ++k, source += update_stride, target += stride) {
      add_rows(source + columns.from + k, columns.count - k, target + columns.to + k);
      for (const RowRun& rows : runs.subspan(first + 1)) add_rows(source + rows.from, rows.count, target + rows.to);
    }
  }
}

}  // namespace thinwall
