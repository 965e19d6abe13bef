#include "engine/solver/FrontAssembly.hpp"

#include "engine/solver/Lanes.hpp"

namespace thinwall {
namespace {

template <typename Number>
using Row = typename LanesOfBytes<Number, 32>::Type;

/// The lower triangle of a square of `columns`, with the rows below it down to `stride`.
template <typename Number>
[[gnu::always_inline]] inline void clear_columns(int columns, std::ptrdiff_t stride, Number* first) {
  const Row<Number> zero{};
  for (int block = 0; block < columns; block += kFrontRows) {
    const int end = block + kFrontRows < columns ? block + kFrontRows : columns;
    for (int column = block; column < end; ++column) {
      Number* rows = first + column * stride;
      for (std::ptrdiff_t row = block; row < stride; row += kLanesOf<Row<Number>>) store(zero, rows + row);
    }
  }
}

template <typename Number>
[[gnu::always_inline]] inline void clear_front(const Front<Number>& front) {
  clear_columns(front.pivots, front.stride, front.columns);
  clear_columns(front.size - front.pivots, front.update_stride, front.update);
}

/// to += from, of at least as many as lanes are.
template <typename Some>
[[gnu::always_inline]] inline void add_lanes(const NumberOf<Some>* from, int count, NumberOf<Some>* to) {
  constexpr int kWidth = kLanesOf<Some>;
  // The last lanes may overlap those before: they are read before anything is written.
  Some last, addend;
  load(to + count - kWidth, last);
  load(from + count - kWidth, addend);
  last += addend;
  for (int row = 0; row < count - kWidth; row += kWidth) {
    Some sum;
    load(to + row, sum);
    load(from + row, addend);
    sum += addend;
    store(sum, to + row);
  }
  store(last, to + count - kWidth);
}

/// to += from.
template <typename Number>
[[gnu::always_inline]] inline void add_rows(const Number* from, int count, Number* to) {
  constexpr int kFewest = 4;
  if (count >= kLanesOf<Row<Number>>) return add_lanes<Row<Number>>(from, count, to);
  if (count >= kFewest)
    return add_lanes<typename LanesOfBytes<Number, kFewest * sizeof(Number)>::Type>(from, count, to);
  for (int row = 0; row < count; ++row) to[row] += from[row];
}

template <typename Number>
[[gnu::always_inline]] inline void take_up_update(std::span<const RowRun> runs, const Number* update,
                                                  std::ptrdiff_t update_stride, const Front<Number>& front) {
  for (std::size_t first = 0; first < runs.size(); ++first) {
    const RowRun& columns = runs[first];
    const bool is_eliminated = columns.to < front.pivots;
    const std::ptrdiff_t stride = is_eliminated ? front.stride : front.update_stride;
    Number* target = is_eliminated ? front.columns + columns.to * stride
                                   : front.update + (columns.to - front.pivots) * stride - front.pivots;
    const Number* source = update + columns.from * update_stride;
    for (int k = 0; k < columns.count; ++k, source += update_stride, target += stride) {
      add_rows(source + columns.from + k, columns.count - k, target + columns.to + k);
      for (const RowRun& rows : runs.subspan(first + 1)) add_rows(source + rows.from, rows.count, target + rows.to);
    }
  }
}

}  // namespace

THINWALL_FOR_ALL_PROCESSORS void clear(const Front<double>& front) {
  clear_front(front);
}
THINWALL_FOR_ALL_PROCESSORS void clear(const Front<float>& front) {
  clear_front(front);
}

THINWALL_FOR_ALL_PROCESSORS void take_up(std::span<const RowRun> runs, const double* update,
                                         std::ptrdiff_t update_stride, const Front<double>& front) {
  take_up_update(runs, update, update_stride, front);
}
THINWALL_FOR_ALL_PROCESSORS void take_up(std::span<const RowRun> runs, const float* update,
                                         std::ptrdiff_t update_stride, const Front<float>& front) {
  take_up_update(runs, update, update_stride, front);
}

}  // namespace thinwall
