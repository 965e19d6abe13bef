#include "renderer/shape/BloodRun.hpp"

#include <algorithm>
#include <cmath>

#include "renderer/wound/Bleeding.hpp"

namespace thinwall {

double blood_half_width(const FluidRun& run, double thickness) {
  constexpr double kThin = 0.001, kMost = 2;  // metres, and of the width in a wall that is so thin
  return (0.00030 + 0.00025 * run.chance) * std::clamp(std::sqrt(thickness / kThin), 1.0, kMost);
}

RunShape blood_run(const BloodRun& run) {
  constexpr double kDepth = 0.35;                         // over half the width: it wets the wall
  constexpr double kSlender = 0.05, kSlenderLevel = 0.3;  // half the width over the length, of one that has just begun
  constexpr double kWiderLevel = 4;                       // than a line
  constexpr double kLongLevel = 1.2;                      // at most, over half the width: a pool, and no finger
  constexpr double kLineEnds = 0.02;                      // metres, length from which on it ends in a whole drop
  constexpr double kMostDrop = 0.7;                       // by which that is wider than the line
  constexpr double kSpeed = 0.03, kSpeedLevel = 0.01;     // metres/second
  const double slender = run.creeps ? kSlenderLevel : kSlender, speed = run.creeps ? kSpeedLevel : kSpeed;
  const double most = (run.creeps ? kWiderLevel : 1) * run.most_half_width;
  const double half_width = std::min(most, std::cbrt(slender * run.volume / (2 * kDepth)));
  if (!(half_width > 0)) return {};
  const double height = kDepth * half_width;
  const double way = run.creeps ? std::min(run.way, kLongLevel * half_width) : run.way;
  const double length = std::min(way, run_length(run.volume, 2 * half_width, height, run.age, speed));
  return {.half_width = half_width,
          .length = length,
          .height = height,
          .dry = dryness(run.age),
          .drop = 1 + kMostDrop * std::min(1.0, length / kLineEnds)};
}

}  // namespace thinwall
