#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "renderer/camera/SceneExtent.hpp"
#include "renderer/shape/WallThickness.hpp"
#include "renderer/snapshot/Snapshot.hpp"
#include "renderer/snapshot/Vector.hpp"
#include "renderer/wound/DrawnTopology.hpp"

namespace thinwall {

/// What of a body or tool a part is.
enum class PartKind {
  kOutside,  // outer side of a wall
  kCap,      // closes the fluid where no wall is
  kRim,      // where a wall is cut through or ends
  kLining,   // inner side of a wall, once it is open somewhere, or the viewer is within
  kTool
};

/// A range of triangles of one kind.
struct ScenePart {
  PartKind kind = PartKind::kOutside;
  std::uint32_t owner = 0;  // surface of the snapshot; of kTool the tool
  std::uint32_t first_triangle = 0;
  std::uint32_t triangle_count = 0;
  bool is_hidden = false;  // the lining of a whole wall, where the viewer is not within: matter that no picture draws
};

inline constexpr std::uint32_t kNoIndex = std::numeric_limits<std::uint32_t>::max();

struct SceneTriangle {
  std::array<std::uint32_t, 3> corners{};  // points
  std::uint32_t part = 0;
  std::uint32_t wall = kNoIndex;  // triangle of the surface's mesh that it is a part of; kNoIndex of caps and tools
};

/// Every triangle that pictures of a snapshot are drawn from, the same that these have, and those of hidden parts.
struct SceneGeometry {
  std::vector<Vector3> points;          // metres
  std::vector<Vector3> normals;         // (points), of length one, as pictures are shaded
  std::vector<std::uint32_t> vertices;  // (points) of their surface as it is drawn; kNoIndex of tools
  std::vector<SceneTriangle> triangles;
  std::vector<ScenePart> parts;
  std::vector<DrawnTopology> drawn;       // (surfaces)
  std::vector<std::vector<char>> is_cut;  // (surfaces x borders as drawn), whether a cut made it
};

/// `eye`: of the viewer, as of drawn_pieces.
SceneGeometry scene_geometry(const Snapshot& snapshot, const SceneExtent& extent, DrawnEdges edges, Vector3 eye);

}  // namespace thinwall
