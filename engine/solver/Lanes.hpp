#pragma once

#include <cstring>
#include <type_traits>
#include <utility>

/// Several numbers at once: four of double precision, eight of single. As each lane is computed alone, and nothing is
/// contracted but the products of FrontFactor.hpp, the results are the same to the last bit on every width of a
/// processor's registers.
namespace thinwall {

template <typename Number, int bytes>
struct LanesOfBytes {
  using Type [[gnu::vector_size(bytes)]] = Number;
};
using Lanes = LanesOfBytes<double, 32>::Type;
constexpr int kLanes = 4;

/// Twice as many, for processors that hold them in one register: for others they are compiled badly.
template <typename Number>
using WideLanes = typename LanesOfBytes<Number, 64>::Type;

/// The number that lanes are of, and how many of it.
template <typename Some>
using NumberOf = std::remove_cvref_t<decltype(std::declval<Some&>()[0])>;
template <typename Some>
constexpr int kLanesOf = static_cast<int>(sizeof(Some) / sizeof(NumberOf<Some>));

// Inlined always, so that they are compiled for the processor that the calling function is compiled for. Lanes go
// through references: as values they would be handed over unlike on unlike processors.
template <typename Some>
[[gnu::always_inline]] inline void load(const NumberOf<Some>* from, Some& lanes) {
  std::memcpy(&lanes, from, sizeof lanes);
}

template <typename Some>
[[gnu::always_inline]] inline void store(const Some& lanes, NumberOf<Some>* to) {
  std::memcpy(to, &lanes, sizeof lanes);
}

/// The cross product of two vectors of three.
template <typename Some>
[[gnu::always_inline]] inline void cross(const Some* one, const Some* other, Some (&product)[3]) {
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3, last = (k + 2) % 3;
    product[k] = one[next] * other[last] - one[last] * other[next];
  }
}

}  // namespace thinwall

/// Compiles a function for several processors; which one is taken is decided when the program starts. Where they are to
/// take lanes of their own, THINWALL_FOR_PROCESSORS goes before each definition of a function of one file.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define THINWALL_FOR_ALL_PROCESSORS __attribute__((target_clones("avx2", "default")))
#define THINWALL_FOR_PROCESSORS(processors) __attribute__((target(processors)))
#else
#define THINWALL_FOR_ALL_PROCESSORS
#endif
