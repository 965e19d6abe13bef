#include "renderer/snapshot/RestDiagonal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace thinwall {

double rest_diagonal(std::span<const SnapshotSurface> surfaces) {
  double squared = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    for (const SnapshotSurface& surface : surfaces) {
      if (!surface.topology) continue;
      for (const Float3& position : surface.topology->rest_positions) {
        lowest = std::min(lowest, double{position[axis]});
        highest = std::max(highest, double{position[axis]});
      }
    }
    squared += std::pow(std::max(0.0, highest - lowest), 2);
  }
  return std::sqrt(squared);
}

}  // namespace thinwall
