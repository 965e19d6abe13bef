#include "renderer/image/Opaque.hpp"

#include <cstring>

#include "renderer/image/AllProcessors.hpp"

namespace thinwall {

THINWALL_FOR_ALL_PROCESSORS
void leave_out_alpha(const std::uint8_t* from, std::uint8_t* to, std::size_t pixels) {
  using Bytes = std::uint8_t __attribute__((vector_size(16)));
  using Order = std::int8_t __attribute__((vector_size(16)));
  constexpr Order kColorsFirst = {0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14, 3, 7, 11, 15};
  std::size_t i = 0;
  // Four pixels at once; the next ones take the place of what was between.
  for (; i + 6 <= pixels; i += 4) {
    Bytes four;
    std::memcpy(&four, from + 4 * i, sizeof(four));
    four = __builtin_shuffle(four, kColorsFirst);
    std::memcpy(to + 3 * i, &four, sizeof(four));
  }
  for (; i < pixels; ++i) std::memcpy(to + 3 * i, from + 4 * i, 3);
}

}  // namespace thinwall
