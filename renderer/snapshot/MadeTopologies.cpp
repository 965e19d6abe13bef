#include "renderer/snapshot/MadeTopologies.hpp"

#include <algorithm>

namespace thinwall {

void MadeTopologies::replace_in(Snapshot& snapshot,
                                const std::function<SnapshotTopology(const SnapshotTopology&)>& make) {
  std::vector<std::pair<Shared, Shared>> made;
  for (SnapshotSurface& surface : snapshot.surfaces) {
    if (!surface.topology) continue;
    const auto known = std::ranges::find(made_, surface.topology, &std::pair<Shared, Shared>::first);
    made.emplace_back(surface.topology, known != made_.end()
                                            ? known->second
                                            : std::make_shared<const SnapshotTopology>(make(*surface.topology)));
    surface.topology = made.back().second;
  }
  made_ = std::move(made);
}

}  // namespace thinwall
