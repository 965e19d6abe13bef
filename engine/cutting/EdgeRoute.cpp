#include "engine/cutting/EdgeRoute.hpp"

#include <algorithm>
#include <limits>
#include <queue>

#include "engine/cutting/WantedPath.hpp"

namespace thinwall {

std::vector<int> route_along_edges(const CutPatch& patch, int from, int to, std::span<const Eigen::Vector3d> polyline) {
  std::vector<double> cost(patch.positions.size(), std::numeric_limits<double>::infinity());
  std::vector<int> previous(patch.positions.size(), -1);
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> waiting;
  cost[from] = 0;
  waiting.emplace(0.0, from);
  while (!waiting.empty()) {
    const auto [value, u] = waiting.top();
    waiting.pop();
    if (u == to) break;
    if (value > cost[u]) continue;
    const PatchFan fan = patch.fan_of(u);
    if (fan.cut_off) continue;
    const auto visit = [&](int triangle, int v) {
      if (patch.frozen[triangle]) return;
      const Eigen::Vector3d &a = patch.positions[u], &b = patch.positions[v];
      const double off = distance_to(polyline, 0.5 * (a + b)) / patch.scale[triangle];
      const double off_end = distance_to(polyline, b) / patch.scale[triangle];
      const double next = value + (b - a).norm() * (1 + 4 * (off * off + off_end * off_end));
      if (next >= cost[v]) return;
      cost[v] = next;
      previous[v] = u;
      waiting.emplace(next, v);
    };
    for (const PatchCorner& corner : fan.corners) {
      const Eigen::Vector3i& t = patch.triangles[corner.triangle];
      visit(corner.triangle, t[(corner.corner + 1) % 3]);
      visit(corner.triangle, t[(corner.corner + 2) % 3]);
    }
  }
  if (from != to && previous[to] < 0) return {};
  std::vector<int> route;
  for (int v = to; v >= 0; v = previous[v]) route.push_back(v);
  std::reverse(route.begin(), route.end());
  return route;
}

}  // namespace thinwall
