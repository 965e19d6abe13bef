#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cstddef>

namespace thinwall {

/// The least of `start` and of(k) for all k below `count`, which are asked by several threads where there are many.
template <typename Of>
double least_of(std::size_t count, double start, const Of& of) {
  constexpr std::size_t kAtOnce = 256;
  const auto within = [&](const tbb::blocked_range<std::size_t>& range, double least) {
    for (std::size_t k = range.begin(); k < range.end(); ++k) least = std::min(least, of(k));
    return least;
  };
  const tbb::blocked_range<std::size_t> all(0, count, kAtOnce);
  if (count <= kAtOnce) return within(all, start);
  return tbb::parallel_reduce(all, start, within, [](double one, double other) { return std::min(one, other); });
}

}  // namespace thinwall
