#pragma once

#include <cstring>

/// Four numbers at once. As each lane is computed alone and nothing is contracted, the results are the same to the last
/// bit on every width of a processor's registers.
namespace thinwall {

using Lanes = double __attribute__((vector_size(32)));
constexpr int kLanes = 4;

// Inlined always, so that they are compiled for the processor that the calling function is compiled for. Lanes go
// through references: as values they would be handed over unlike on unlike processors.
[[gnu::always_inline]] inline void load(const double* from, Lanes& lanes) {
  std::memcpy(&lanes, from, sizeof lanes);
}

[[gnu::always_inline]] inline void store(const Lanes& lanes, double* to) {
  std::memcpy(to, &lanes, sizeof lanes);
}

}  // namespace thinwall

/// Compiles a function for several processors; which one is taken is decided when the program starts.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__)
#define THINWALL_FOR_ALL_PROCESSORS __attribute__((target_clones("avx2", "default")))
#else
#define THINWALL_FOR_ALL_PROCESSORS
#endif
