#pragma once

#include <cstring>

/// Four numbers at once. As each lane is computed alone, and nothing is contracted but the products of FrontFactor.hpp,
/// the results are the same to the last bit on every width of a processor's registers.
namespace thinwall {

using Lanes = double __attribute__((vector_size(32)));
constexpr int kLanes = 4;

/// Eight, for processors that hold them in one register: for others they are compiled badly.
using WideLanes = double __attribute__((vector_size(64)));
constexpr int kWideLanes = 8;

template <typename Some>
constexpr int kLanesOf = static_cast<int>(sizeof(Some) / sizeof(double));

// Inlined always, so that they are compiled for the processor that the calling function is compiled for. Lanes go
// through references: as values they would be handed over unlike on unlike processors.
template <typename Some>
[[gnu::always_inline]] inline void load(const double* from, Some& lanes) {
  std::memcpy(&lanes, from, sizeof lanes);
}

template <typename Some>
[[gnu::always_inline]] inline void store(const Some& lanes, double* to) {
  std::memcpy(to, &lanes, sizeof lanes);
}

}  // namespace thinwall

/// Compiles a function for several processors; which one is taken is decided when the program starts. Where they are to
/// take lanes of their own, THINWALL_FOR_PROCESSORS goes before each definition of a function of one file.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__)
#define THINWALL_FOR_ALL_PROCESSORS __attribute__((target_clones("avx2", "default")))
#define THINWALL_FOR_PROCESSORS(processors) __attribute__((target(processors)))
#else
#define THINWALL_FOR_ALL_PROCESSORS
#endif
