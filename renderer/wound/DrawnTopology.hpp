#pragma once

#include <memory>
#include <vector>

#include "renderer/snapshot/BorderEdges.hpp"
#include "renderer/snapshot/SurfacePlace.hpp"
#include "renderer/wound/SmoothSurface.hpp"

namespace thinwall {

/// Which edges of the mesh are drawn as curves through its vertices.
enum class DrawnEdges {
  kCurves,      // those of round walls, and the lips of wounds
  kCurvedLips,  // the lips of wounds: the wall elsewhere is where its triangles are
  kStraight     // none
};

/// The triangles that a surface is drawn from, and what of its mesh they show. Pictures and their ground truth have
/// them from here, so that both have the same outlines.
struct DrawnTopology {
  /// Of a border that is drawn: the mesh's that it is a part of.
  struct BorderPart {
    std::uint32_t border = 0;  // of the mesh
    double from = 0, to = 1;   // parts of its length
  };

  SmoothSurface smooth;                   // with the topology that is drawn; its vertices begin with the mesh's
  std::vector<BorderEdge> mesh_borders;   // of the mesh
  std::vector<BorderEdge> borders;        // as drawn
  std::vector<char> is_lip;               // (vertices as drawn), whether at a cut
  std::vector<BorderPart> border_parts;   // (borders)
  std::vector<std::uint32_t> first_part;  // (triangles of the mesh + 1), first of the triangles drawn of each
  std::vector<std::vector<std::uint32_t>> borders_of;  // (borders of the mesh), as drawn, in their order along it

  const SnapshotTopology& topology() const { return *smooth.topology; }
  const std::vector<TrianglePart>& parts() const { return smooth.parts; }  // (triangles of the wall as drawn)
};

DrawnTopology drawn_topology(const std::shared_ptr<const SnapshotTopology>& mesh, DrawnEdges edges);

/// The positions of `mesh`, whose topology `drawn` was made of, on what is drawn; without fields.
SnapshotSurface drawn_surface(const DrawnTopology& drawn, const SnapshotSurface& mesh);

/// The place of the mesh that is shown at a place that is drawn: the same matter.
SurfacePlace mesh_place(const DrawnTopology& drawn, const SurfacePlace& place);
BorderPlace mesh_place(const DrawnTopology& drawn, const BorderPlace& place);

/// Where a place of the mesh is drawn.
SurfacePlace drawn_place(const DrawnTopology& drawn, const SurfacePlace& place);
BorderPlace drawn_place(const DrawnTopology& drawn, const BorderPlace& place);

}  // namespace thinwall
