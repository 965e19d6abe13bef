#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <vector>

namespace thinwall {

/// Does both, by two threads where that is worth it.
template <typename One, typename Other>
void side_by_side(bool is_worth_it, const One& one, const Other& other) {
  if (is_worth_it) {
    tbb::parallel_invoke(one, other);
  } else {
    one();
    other();
  }
}

/// Triangles whose terms are computed side by side before they are added one after the other: enough to share out,
/// few enough to stay in the cache.
constexpr int kTrianglesAtOnce = 512;

/// Computes the terms of `count` members side by side, and adds them one after the other, `batch` at a time: in their
/// order, so that the number of threads cannot change a bit. `buffer`: memory.
template <typename Compute, typename Add, typename Terms>
void for_each(int count, int batch, std::vector<Terms>& buffer, const Compute& compute, const Add& add) {
  buffer.resize(batch);
  for (int begin = 0; begin < count; begin += batch) {
    const int end = std::min(count, begin + batch);
    tbb::parallel_for(tbb::blocked_range<int>(begin, end, batch / 8), [&](const tbb::blocked_range<int>& range) {
      for (int k = range.begin(); k < range.end(); ++k) compute(k, buffer[k - begin]);
    });
    for (int k = begin; k < end; ++k) add(k, buffer[k - begin]);
  }
}

}  // namespace thinwall
