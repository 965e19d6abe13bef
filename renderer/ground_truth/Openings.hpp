#pragma once

#include <vector>

#include "renderer/ground_truth/Projection.hpp"
#include "renderer/ground_truth/SceneGeometry.hpp"
#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// Where the rays of the pixels' middles meet openings that cuts have made, from lip to lip on the wall's outer side.
struct Openings {
  // (height x width), 1 where it is one within a wall: a cut that runs out of a wall at its border leaves none.
  std::vector<char> within;
  // (surfaces x height x width), metres along the line of sight to the nearest one of the surface, infinite where there
  // is none; those that run out at a border are closed straight there. Empty for surfaces without a cut.
  std::vector<std::vector<double>> depth;
};

Openings rays_through_openings(const Snapshot& snapshot, const SceneGeometry& geometry, const Projection& projection);

}  // namespace thinwall
