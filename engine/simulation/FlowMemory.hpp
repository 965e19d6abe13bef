#pragma once

#include <cstddef>
#include <vector>

#include "engine/simulation/BackwardDifference.hpp"

namespace thinwall {

/// Volumes that flow by ways of their own, by the second-order backward difference: with the volume D that flows in a
/// step h, and in the one before, now D1 = earlier D0 + h Q1 with the flow Q1 at the end. However stiff the pressure
/// follows the volume it does not ring, as the trapezoidal rule does. The first step is of first order, as is the next
/// one after the memory was emptied.
struct FlowMemory {
  std::vector<double> volumes = {};  // (ways), metres^3, in the last step; none at first, or where they do not count
  double step = 0;                   // seconds, of that step

  /// What flows in a step of this duration whatever the flow at its end, metres^3.
  double share(std::size_t way, double duration) const {
    if (volumes.empty()) return 0;
    const BackwardDifference difference = backward_difference(duration, step);
    return difference.earlier / difference.now * volumes[way];
  }

  /// Time for which the flow at the end counts, seconds.
  double time(double duration) const {
    return duration / backward_difference(duration, volumes.empty() ? 0 : step).now;
  }
};

}  // namespace thinwall
