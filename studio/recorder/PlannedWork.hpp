#pragma once

#include <optional>
#include <string>
#include <vector>

#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// Where a clip is to work, as far as its scenario tells that before anything has happened.
struct PlannedWork {
  std::string tool = {};
  std::string body = {};                  // that it works on; empty: none
  std::vector<Double3> places = {};       // metres, near the wall, in the order in which the tool comes there
  std::optional<Double3> direction = {};  // unit, along which the places come to the wall; to the nearest when absent
  double depth = 0;                       // metres beyond the wall along the direction
  double begin = 0;                       // seconds, about
  double end = 0;
};

/// The work of a resolved scenario's clips, in their order. When it is done is estimated from ways and speeds, as the
/// run alone tells how far the tools are from the walls; none where it is no JSON. Throws TakeError when a clip
/// lacks something.
std::vector<PlannedWork> planned_work(const std::string& resolved);

/// Where it is done (metres), on the walls as they are in `first`, the first moment.
std::vector<Double3> places_of(const PlannedWork& work, const Snapshot& first);

}  // namespace thinwall
