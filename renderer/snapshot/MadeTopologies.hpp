#pragma once

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// What the topologies of snapshots are made into, one snapshot after the other: of one that stays the same it is the
/// same, as what follows from a topology is kept by that.
class MadeTopologies {
 public:
  using Shared = std::shared_ptr<const SnapshotTopology>;

  /// Puts what `make` makes of the topologies of a snapshot in their place, but of those that the last one had too.
  void replace_in(Snapshot& snapshot, const std::function<SnapshotTopology(const SnapshotTopology&)>& make);
  void clear() { made_.clear(); }

 private:
  std::vector<std::pair<Shared, Shared>> made_;  // as given, made; of the snapshot before
};

}  // namespace thinwall
