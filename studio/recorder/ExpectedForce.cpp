#include "studio/recorder/ExpectedForce.hpp"

#include <algorithm>

#include "renderer/snapshot/ActingSurfaces.hpp"
#include "renderer/snapshot/RestDiagonal.hpp"

namespace thinwall {
double expected_force(const Snapshot& snapshot) {
  constexpr double kSoftTissue = 50e3;  // pascal, shear modulus
  double largest = 0;
  for (const SnapshotSurface* surface : acting_surfaces(snapshot)) {
    const std::vector<float>& thickness = surface->topology->thickness;
    if (thickness.empty()) continue;
    largest = std::max(largest, kSoftTissue * double{std::ranges::max(thickness)} * 0.5 * rest_diagonal({surface, 1}));
  }
  return largest > 0 ? largest : 1;
}

}  // namespace thinwall
