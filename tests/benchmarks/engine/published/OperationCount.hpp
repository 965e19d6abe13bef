#pragma once

#include <functional>

namespace thinwall {

/// Counts the floating-point operations that a piece of work does, by executing it: a copy of the process does the work
/// instruction by instruction, and each is decoded (SSE2, AVX, FMA and AVX-512; double precision; a fused multiply-add
/// counts as two, a packed one as many times as it has lanes, masked ones as if they were not). Additions,
/// subtractions, multiplications, divisions and square roots count as one. Nothing of the work stays; it must be of one
/// thread. Throws std::runtime_error when the system does not permit tracing.
double count_operations(const std::function<void()>& work);

}  // namespace thinwall
