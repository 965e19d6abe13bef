#pragma once

#include <cstdint>
#include <vector>

#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// What the metal shader reads of a vertex.
struct ToolVertex {
  Float3 position{};    // metres
  Float3 normal{};      // of length one, outward
  float roughness = 0;  // 0 to 1; of flat faces below 0
  float along = 0;      // distance from the tip against the direction, in units of the scene's size
  float grip = 0;  // 0 to 1: how deep the rings of the handle are; below 0: part of the light that parts close by take
  float side = 0;  // distances from the middle line along x' and y', in units of the scene's size
  float aside = 0;
  Float3 narrow{};  // of a face between two others that it is not seen beside where it is narrower than a pixel: out of
                    // one of these, as long as it is wide, metres
  float broad_hollow = 0;     // and by which that one leans there
  float broad_roughness = 0;  // and its roughness
};

/// A round rod, for the shade that a tool leaves on what is near.
struct ToolRod {
  Float3 start{};    // metres
  Float3 end{};      // metres
  float radius = 0;  // metres
};

struct ToolShape {
  std::vector<ToolVertex> vertices;
  std::vector<std::uint32_t> indices;  // (3 x triangles), counter-clockwise from outside; they close volumes
  std::vector<ToolRod> rods;
};

enum class ToolDetail {
  kAll,  // the cutting edge of a scalpel has the width that grinding leaves, some micrometres, and its tang some room
  kSeen  // not so: in a picture what is so narrow would be hit by a pixel here and there, which shows as dashes
};

/// The metal around a tool's pose, in the world; `scene_size` is SceneExtent::size. The foremost point along the
/// direction is exactly the tip: of a rounded probe (point), of a straight edge (line), of a ball (sphere), of a rod
/// (capsule), plate, needle or blade (scalpel), or lies between those of two jaws (forceps); each has a shaft behind.
ToolShape tool_shape(const SnapshotTool& tool, double scene_size, ToolDetail detail = ToolDetail::kAll);

}  // namespace thinwall
