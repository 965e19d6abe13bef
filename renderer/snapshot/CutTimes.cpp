#include "renderer/snapshot/CutTimes.hpp"

#include "renderer/snapshot/BorderEdges.hpp"

namespace thinwall {

std::vector<float> cut_times(const SnapshotTopology& now, const SnapshotTopology& before, double time) {
  const std::vector<char> is_lip = cut_lips(now, border_edges(now));
  std::vector<float> times(is_lip.size(), kNeverCut);
  for (std::size_t v = 0; v < times.size(); ++v) {
    if (!is_lip[v]) continue;
    const bool was_cut = v < before.cut_times.size() && before.cut_times[v] != kNeverCut;
    times[v] = was_cut ? before.cut_times[v] : static_cast<float>(time);
  }
  return times;
}

}  // namespace thinwall
