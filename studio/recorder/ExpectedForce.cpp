#include "studio/recorder/ExpectedForce.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace thinwall {
namespace {

/// Half the diagonal of the box around the stress-free wall, metres.
double reach_of(const SnapshotTopology& topology) {
  double squared = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    for (const Float3& position : topology.rest_positions) {
      lowest = std::min(lowest, double{position[axis]});
      highest = std::max(highest, double{position[axis]});
    }
    squared += std::pow(std::max(0.0, highest - lowest), 2);
  }
  return 0.5 * std::sqrt(squared);
}

}  // namespace

double expected_force(const Snapshot& snapshot) {
  constexpr double kSoftTissue = 50e3;  // pascal, shear modulus
  double largest = 0;
  for (const SnapshotSurface& surface : snapshot.surfaces) {
    const std::vector<float>& thickness = surface.topology->thickness;
    if (thickness.empty()) continue;
    largest = std::max(largest, kSoftTissue * double{std::ranges::max(thickness)} * reach_of(*surface.topology));
  }
  return largest > 0 ? largest : 1;
}

}  // namespace thinwall
