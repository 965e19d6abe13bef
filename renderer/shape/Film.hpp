#pragma once

#include <cstdint>
#include <vector>

#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// How a film ends on its wall, a number for the shader.
inline constexpr float kFilmRun = 0;        // a drop or run, with an edge
inline constexpr float kFilmCoat = 1;       // thins to nothing: its thickness is as of inward / width
inline constexpr float kFilmEdgedCoat = 2;  // likewise, with an edge

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
  float kind = kFilmRun;
  Float3 slope{};  // how `inward` grows along the wall, 1 / metre; of what lies on the outer side
};

/// A fluid that lies on a wall.
struct Film {
  std::vector<FilmVertex> vertices;
  std::vector<std::uint32_t> corners;  // (3 x triangles), into `vertices`
};

}  // namespace thinwall
