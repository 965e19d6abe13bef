#pragma once

#include <optional>
#include <string>
#include <vector>

#include "renderer/camera/SceneExtent.hpp"
#include "renderer/camera/View.hpp"
#include "renderer/picture/LookUniforms.hpp"
#include "renderer/picture/MeshLinePass.hpp"
#include "renderer/picture/SecondThread.hpp"
#include "renderer/picture/TriangleBuffer.hpp"
#include "renderer/shape/Outline.hpp"
#include "renderer/shape/ScreenArea.hpp"
#include "renderer/shape/TissuePieces.hpp"
#include "renderer/shape/ToolOutline.hpp"
#include "renderer/shape/ToolShape.hpp"
#include "renderer/shape/WallThickness.hpp"
#include "renderer/shape/WoundFilm.hpp"
#include "renderer/snapshot/Snapshot.hpp"
#include "renderer/wound/DrawnTopology.hpp"
#include "renderer/wound/FluidSurface.hpp"

namespace thinwall {

/// A body's wall, caps, rims or lining within the buffer of all tissue.
struct TissuePart {
  std::string body = {};
  TissueSide side = TissueSide::kOutside;
  LookUniforms look;
  std::size_t first_index = 0;
  std::size_t index_count = 0;
  Bounds bounds = {};
  bool is_closed = false;  // seen from outside `body_bounds`, its triangles that face away are hidden
  Bounds body_bounds = {};
  std::optional<Bounds> opening = {};  // of the lining of a closed body: through which alone it is seen from outside
};

/// The fluid that is seen in an opened body, and how it looks.
struct BodyFluid {
  FluidSurface surface;
  FluidLook look;
};

/// A fluid on the wall of a body or falling from it, and how it looks.
struct BodyFilm {
  Film film;
  FluidLook look;
  bool is_falling = false;
};

/// A snapshot's surfaces and tools on the device, as all passes draw them.
class SceneMeshes {
 public:
  SceneMeshes();
  /// `eye`: of the viewer, who may be within a body.
  void upload(const Snapshot& snapshot, const SceneExtent& extent, const LookDefinition& look, Vector3 eye,
              SecondThread& second);

  const TriangleBuffer& tissue() const { return tissue_; }

  /// Whether the part is the lining of a closed body that is seen from outside it through `matrix` (world to clip
  /// coordinates).
  static bool is_seen_through_opening(const TissuePart& part, const std::array<float, 16>& matrix);

  /// Draws what of such a part may be seen.
  void draw_seen_lining(const TissuePart& part, const std::array<float, 16>& matrix) const;

  const TriangleBuffer& tools() const { return tools_; }

  /// What is in both buffers, as uploaded; corners: (3 x triangles).
  std::span<const SurfaceVertex> tissue_vertices() const { return tissue_vertices_; }
  std::span<const std::uint32_t> tissue_corners() const { return tissue_corners_; }
  std::span<const ToolVertex> tool_vertices() const { return tool_vertices_; }
  std::span<const std::uint32_t> tool_corners() const { return tool_corners_; }

  /// Draws tissue and, `with_tools`, tools for a pass in which the nearest counts, without the sides that are hidden,
  /// as seen through `matrix` (world to clip coordinates).
  void draw_nearest(const std::array<float, 16>& matrix, bool with_tools) const;

  /// As of FrameUniforms.
  const std::array<float, 4>& rest_grid() const { return rest_grid_; }

  const std::vector<TissuePart>& parts() const { return parts_; }
  const std::vector<ToolRod>& rods() const { return rods_; }

  /// All pixels that show something of the tissue. `view_projection`: world to clip coordinates.
  ScreenArea tissue_area(const std::array<float, 16>& view_projection, ImageSize size) const;

  /// All pixels that show something of the tools. `view_projection`: world to clip coordinates.
  ScreenArea tool_area(const std::array<float, 16>& view_projection, ImageSize size) const;

  /// (surfaces), their borders that no cut has made.
  std::span<const std::vector<BorderEdge>> ends() const { return ends_; }

  /// Whether any surface is a sheet, or otherwise open without a cut.
  bool has_sheet() const;

  const std::vector<BodyFluid>& fluids() const { return fluids_; }

  const std::vector<BodyFilm>& films() const { return films_; }

  /// The edges of all walls' triangles and of their caps.
  std::vector<MeshLine> mesh_lines() const;

  /// Those of them at which cuts have opened the walls.
  std::vector<MeshLine> cut_lines() const;

  /// Of everything that was uploaded, seen from `eye`, the nearest first. `pixel`: height of one over the distance.
  std::vector<OutlineSegment> outline(Vector3 eye, double pixel);

 private:
  void make_tissue(const Snapshot& snapshot, const SceneExtent& extent, const LookDefinition& look, Vector3 eye);
  /// Where outer walls go through each other.
  void append_lines_between_bodies(Vector3 eye, std::vector<OutlineSegment>& lines) const;
  /// Outer walls of bodies, of what `make_tissue` has made.
  std::vector<std::span<SurfaceVertex>> outer_walls();
  /// What is drawn of body k, with what its look adds.
  std::vector<TissuePiece> dressed_pieces(const Snapshot& snapshot, const LookDefinition& look, std::size_t k,
                                          const TissueLook& body_look, Vector3 eye);
  void find_fluid(const Snapshot& snapshot, std::size_t k, const TissueLook& look, std::span<const TissuePiece> pieces);
  void find_films(const Snapshot& snapshot, std::size_t k, const TissueLook& look, std::span<const TissuePiece> pieces);
  void find_edges(const Snapshot& snapshot, DrawnEdges edges);
  void smooth_surfaces(const Snapshot& snapshot);
  void make_tools(const Snapshot& snapshot, const SceneExtent& extent);

  TriangleBuffer tissue_;
  // Memory that is used again: what is new to a process takes the processor as long as filling it does.
  std::vector<SurfaceVertex> tissue_vertices_;
  std::array<float, 4> rest_grid_{};
  std::vector<std::uint32_t> tissue_corners_;  // (3 x triangles)
  TriangleBuffer tools_;
  std::vector<TissuePart> parts_;
  std::vector<double> bed_depths_;             // (surfaces), metres below the stress-free sheet; 0: there is none
  std::vector<OutlineSegment> inner_borders_;  // where rims meet linings
  std::vector<BodyFluid> fluids_;
  std::vector<BodyFilm> films_;
  std::vector<ToolRod> rods_;
  std::vector<ToolVertex> tool_vertices_;
  std::vector<std::uint32_t> tool_corners_;  // (3 x triangles)
  ToolOutline tool_outline_;
  std::vector<std::shared_ptr<const SnapshotTopology>> topologies_;  // that the edges belong to
  DrawnEdges edges_ = DrawnEdges::kCurves;                           // and what they were found for
  std::vector<DrawnTopology> drawn_topologies_;                      // (surfaces)
  std::vector<std::vector<BorderEdge>> ends_;                        // (surfaces), of the mesh, that no cut has made
  std::vector<SnapshotSurface> drawn_;                               // (surfaces), as drawn
  std::vector<MeshEdge> tissue_edges_;
  std::vector<VesselTree> vessel_trees_;            // (surfaces)
  std::vector<std::optional<WoundLayout>> wounds_;  // (surfaces), of those with cuts
};

}  // namespace thinwall
