#pragma once

#include <span>
#include <vector>

#include "engine/cutting/Cut.hpp"
#include "engine/cutting/CutPatch.hpp"

namespace thinwall {

/// A vertex of the surface's border that a cut has split.
struct RimOpening {
  int before = 0, vertex = 0, after = 0;  // along the border, as numbered before the opening
  int last = 0;  // stands in the place of `vertex` towards `before`; `vertex` itself does so towards `after`
};

/// What opening a path did to a patch.
struct OpenedLips {
  std::vector<int> originals;  // of each new vertex, in order
  std::vector<Lips> lips;
  std::vector<RimOpening> rims;
  double length = 0;          // metres, rest
  int euler_change = 0;       // predicted
  bool may_separate = false;  // the path closes a loop or joins borders
};

/// Opens a patch along the marked edges. The fan of each vertex falls into sectors between marked edges and borders;
/// each gets a vertex of its own, the first one keeps the number, so no vertex is left where fans touch in a point. The
/// end of a path within the wall has one sector and stays single. `path`: the vertices of the path in order.
/// The Euler characteristic changes by the new vertices less the marked edges.
OpenedLips open_lips(CutPatch& patch, std::span<const int> path);

}  // namespace thinwall
