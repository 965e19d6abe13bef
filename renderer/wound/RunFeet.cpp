#include "renderer/wound/RunFeet.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace thinwall {

std::vector<double> run_feet(const SnapshotTopology& topology, std::span<const BorderEdge> borders,
                             std::span<const char> is_lip, std::span<const FluidRun> runs) {
  constexpr double kReach = 0.0015;  // metres, at which there is e times less
  std::vector<double> ways(is_lip.size(), std::numeric_limits<double>::infinity());
  for (const FluidRun& run : runs) {
    const WallPlace& start = run.path.front();
    for (std::size_t k = 0; k < 3; ++k) {
      if (start.weights[k] > 0) ways[start.corners[k]] = 0;
    }
  }
  // Until no way along the lips is shorter.
  for (bool changes = true; changes;) {
    changes = false;
    for (const auto& [start, end, triangle] : borders) {
      if (!is_lip[start] || !is_lip[end]) continue;
      const double edge =
          length(vector3(topology.rest_positions[end]) - vector3(topology.rest_positions[start])) * (1 + 1e-12);
      double &a = ways[start], &b = ways[end];
      changes = changes || a > b + edge || b > a + edge;
      a = std::min(a, b + edge);
      b = std::min(b, a + edge);
    }
  }
  std::vector<double> feet;
  feet.reserve(ways.size());
  for (const double way : ways) feet.push_back(std::exp(-way * way / (kReach * kReach)));
  return feet;
}

}  // namespace thinwall
