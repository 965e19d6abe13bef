#pragma once

#include <cstddef>
#include <vector>

namespace thinwall {

/// One direction of a separable filter that is even or odd about its centre.
struct Kernel {
  std::vector<float> weights;  // (radius + 1), of the distances 0 to radius in pixels
  bool odd = false;            // the weight of -k is minus that of k
  int radius() const { return static_cast<int>(weights.size()) - 1; }
};

/// Rows of values that a kernel passes over.
struct FilterPass {
  const float* from = nullptr;  // the value in the middle of the kernel of the first result
  std::ptrdiff_t pitch = 0;     // from a row to the next
  std::ptrdiff_t stride = 1;    // from a value to the next one along the kernel: 1, or the pitch for columns
  float* to = nullptr;          // (rows x width)
  int width = 0;                // a multiple of kFilterStep
  int rows = 0;
};

inline constexpr int kFilterStep = 32;

/// All that the kernel reaches from the first to the last result must be there to be read.
void filter(const FilterPass& pass, const Kernel& kernel);

}  // namespace thinwall
