#pragma once

#include <array>
#include <memory>
#include <vector>

#include "renderer/snapshot/BorderEdges.hpp"
#include "renderer/snapshot/SurfacePlace.hpp"
#include "renderer/wound/SmoothLips.hpp"

namespace thinwall {

/// What the lips of wounds are drawn as.
enum class DrawnLips {
  kCurves,  // through the vertices of the mesh
  kEdges    // of the mesh
};

/// The triangles that a surface is drawn from, and what of its mesh they show. Pictures and their ground truth have
/// them from here, so that both have the same outlines.
struct DrawnTopology {
  /// Of a triangle that is drawn: the mesh's that it is a part of.
  struct Part {
    std::uint32_t triangle = 0;     // of the mesh
    std::uint32_t corner = kWhole;  // where the lip's edge starts that it is cut into a fan along; kWhole: not cut
    std::uint32_t piece = 0;        // of the fan, from that corner on
  };
  /// Of a border that is drawn: the mesh's that it is a part of.
  struct BorderPart {
    std::uint32_t border = 0;  // of the mesh
    double from = 0, to = 1;   // parts of its length
  };
  static constexpr std::uint32_t kWhole = 3;

  SmoothLips lips;                       // with the topology that is drawn; its vertices begin with the mesh's
  std::vector<BorderEdge> mesh_borders;  // of the mesh
  std::vector<BorderEdge> borders;       // as drawn
  std::vector<char> is_lip;              // (vertices as drawn), whether at a cut
  std::vector<Part> parts;               // (triangles of the wall as drawn)
  std::vector<BorderPart> border_parts;  // (borders)
  std::vector<std::array<std::uint32_t, kLipPieces>> triangles_of;  // (triangles of the mesh), piece after piece
  std::vector<std::array<std::uint32_t, kLipPieces>> borders_of;    // (borders of the mesh), piece after piece

  const SnapshotTopology& topology() const { return *lips.topology; }
};

DrawnTopology drawn_topology(const std::shared_ptr<const SnapshotTopology>& mesh, DrawnLips lips);

/// The positions of `mesh`, whose topology `drawn` was made of, on what is drawn; without fields.
SnapshotSurface drawn_surface(const DrawnTopology& drawn, const SnapshotSurface& mesh);

/// The place of the mesh that is shown at a place that is drawn: the same matter.
SurfacePlace mesh_place(const DrawnTopology& drawn, const SurfacePlace& place);
BorderPlace mesh_place(const DrawnTopology& drawn, const BorderPlace& place);

/// Where a place of the mesh is drawn.
SurfacePlace drawn_place(const DrawnTopology& drawn, const SurfacePlace& place);
BorderPlace drawn_place(const DrawnTopology& drawn, const BorderPlace& place);

}  // namespace thinwall
