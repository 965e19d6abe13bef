#include "renderer/snapshot/ActingSurfaces.hpp"

namespace thinwall {

std::vector<const SnapshotSurface*> acting_surfaces(const Snapshot& snapshot) {
  std::vector<const SnapshotSurface*> all, acting;
  for (const SnapshotSurface& surface : snapshot.surfaces) {
    all.push_back(&surface);
    if (!surface.topology || !surface.topology->is_scenery) acting.push_back(&surface);
  }
  return acting.empty() ? all : acting;
}

}  // namespace thinwall
