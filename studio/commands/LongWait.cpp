#include "studio/commands/LongWait.hpp"

#include <fmt/format.h>

#include <utility>

namespace thinwall {

LongWait::LongWait(std::string doing, Tell tell, std::string advice, Clock clock)
    : doing_(std::move(doing)),
      tell_(std::move(tell)),
      advice_(std::move(advice)),
      clock_(std::move(clock)),
      start_(clock_()) {}

void LongWait::look() {
  const auto waited = std::chrono::duration_cast<std::chrono::seconds>(clock_() - start_);
  if (waited < next_) return;
  tell_(fmt::format("{} has taken {} s so far{}", doing_, waited.count(), advice_));
  while (next_ <= waited) next_ *= 2;
}

}  // namespace thinwall
