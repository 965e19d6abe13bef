#pragma once

#include <cstdint>
#include <vector>

#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// What the shader of films reads of a vertex.
struct FilmVertex {
  Float3 position{};  // metres
  Float3 normal{};    // of length one, outward
  Float3 rest{};      // metres, stress-free: where its unevenness sticks
  float inward = 0;   // metres from the film's edge inwards, negative outside
  float width = 0;    // metres from the edge to where it is thickest
  float height = 0;   // metres, there
  float dry = 0;      // 0 to 1
  float lift = 0;     // metres towards the eye by which it is drawn in front of the wall that it lies on
  float coat = 0;  // 0: a drop or run; 1: thins to nothing, thickness as of inward / width; 2: likewise, with an edge
  Float3 slope{};  // how `inward` grows along the wall, 1 / metre; only of drops and runs
};

/// A fluid that lies on a wall.
struct Film {
  std::vector<FilmVertex> vertices;
  std::vector<std::uint32_t> corners;  // (3 x triangles), into `vertices`
};

}  // namespace thinwall
