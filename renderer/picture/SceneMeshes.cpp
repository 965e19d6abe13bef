#include "renderer/picture/SceneMeshes.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include "renderer/image/PictureFailure.hpp"
#include "renderer/look/FluidLooks.hpp"
#include "renderer/shape/CreaseShade.hpp"
#include "renderer/shape/DrawnPieces.hpp"
#include "renderer/shape/FallingDrops.hpp"
#include "renderer/shape/MeetingLines.hpp"
#include "renderer/shape/SeenLining.hpp"
#include "renderer/shape/SurfaceVertices.hpp"
#include "renderer/shape/TissuePieces.hpp"
#include "renderer/shape/WoundBed.hpp"
#include "renderer/snapshot/ActingSurfaces.hpp"
#include "renderer/snapshot/SurfaceFields.hpp"

namespace thinwall {

namespace {

/// Where walls of two bodies meet they are as dark as in a dent whose curvature is this over the scene's size:
/// surface.vert takes 0.03 of it, and tissue.glsl darkens no more from 0.8 on. The shade reaches as far as this part of
/// the size of what is shown.
constexpr double kCreaseBend = 26;
constexpr double kCreaseReach = 0.03;

/// Puts the numbers of a data view where the tissue's pattern has its places: x from 0 to 1 between the ends, y 1 where
/// there is a number: not on caps, nor where all is held and nothing is computed.
void show_data(const SnapshotSurface& surface, const DataView& data, bool is_computed,
               std::span<const BorderEdge> borders, std::vector<TissuePiece>& pieces) {
  const std::vector<float> values = data_values(surface, data.quantity);
  if (!data.from || !data.to) throw PictureFailure("a data view needs both ends of its colours");
  const double span = *data.to - *data.from;
  for (TissuePiece& piece : pieces) {
    const std::vector<std::uint32_t> vertices = surface_vertices(piece, *surface.topology, borders);
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      const double number = span > 0 ? (values[vertices[v]] - *data.from) / span : 0;
      const bool has_number = is_computed && piece.side != TissueSide::kCap;
      piece.vertices[v].rest = {static_cast<float>(number), has_number ? 1.0F : 0.0F, 0};
    }
  }
}

/// Of all stress-free places, in as many steps as 16 bits tell apart.
std::array<float, 4> rest_grid_of(std::span<const SurfaceVertex> vertices) {
  constexpr float kSteps = 65535, kLeast = 1e-9F;
  Float3 least{}, most{};
  if (!vertices.empty()) least = most = vertices.front().rest;
  float extent = kLeast;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const SurfaceVertex& vertex : vertices) {
      least[axis] = std::min(least[axis], vertex.rest[axis]);
      most[axis] = std::max(most[axis], vertex.rest[axis]);
    }
    extent = std::max(extent, most[axis] - least[axis]);
  }
  return {least[0], least[1], least[2], extent / kSteps};
}

}  // namespace

SceneMeshes::SceneMeshes()
    : tissue_(sizeof(SurfaceVertex), {{0, 3, offsetof(SurfaceVertex, position)},
                                      {1, 3, offsetof(SurfaceVertex, normal)},
                                      {2, 3, offsetof(SurfaceVertex, rest)},
                                      {3, 4, offsetof(SurfaceVertex, blanch)}}),
      tools_(sizeof(ToolVertex), {{0, 3, offsetof(ToolVertex, position)},
                                  {1, 3, offsetof(ToolVertex, normal)},
                                  {2, 3, offsetof(ToolVertex, roughness)},
                                  {3, 2, offsetof(ToolVertex, side)},
                                  {4, 3, offsetof(ToolVertex, narrow)},
                                  {5, 2, offsetof(ToolVertex, broad_hollow)}}) {}

void SceneMeshes::upload(const Snapshot& snapshot, const SceneExtent& extent, const LookDefinition& look, Vector3 eye,
                         SecondThread& second) {
  find_edges(snapshot, drawn_edges(look));
  smooth_surfaces(snapshot);
  WoundBeds beds = lay_on_beds(snapshot, look, drawn_topologies_, drawn_);
  bed_depths_ = std::move(beds.depths);
  if (beds.laid) smooth_surfaces(*beds.laid);
  second.share([&] { make_tissue(beds.laid ? *beds.laid : snapshot, extent, look, eye); },
               [&] { make_tools(snapshot, extent); });
  tissue_.upload(std::span<const SurfaceVertex>(tissue_vertices_), tissue_corners_);
  tools_.upload(std::span<const ToolVertex>(tool_vertices_), tool_corners_);
}

std::vector<TissuePiece> SceneMeshes::dressed_pieces(const Snapshot& snapshot, const LookDefinition& look,
                                                     std::size_t k, const TissueLook& body_look, Vector3 eye) {
  const SnapshotSurface& surface = drawn_[k];
  const DrawnTopology& drawn = drawn_topologies_[k];
  std::vector<TissuePiece> pieces = drawn_pieces(snapshot.surfaces[k], drawn, surface, eye);
  if (look.data) {
    const bool is_computed = std::ranges::count(acting_surfaces(snapshot), &snapshot.surfaces[k]) > 0;
    show_data(snapshot.surfaces[k], *look.data, is_computed, drawn.borders, pieces);
  } else {
    // Skin has been cut off where it ends, and shows its layers there.
    if (!(body_look.bed > 0)) cover_open_borders(drawn.borders, drawn.is_lip, pieces);
    if (bed_depths_[k] > 0) {
      TissuePiece bed = wound_bed(surface, drawn.borders, drawn.is_lip, bed_depths_[k]);
      if (!bed.corners.empty()) pieces.push_back(std::move(bed));
    }
    find_fluid(snapshot, k, body_look, pieces);
    find_films(snapshot, k, body_look, pieces);
  }
  // Caps are seen from within where the wall is.
  if (std::ranges::find(pieces, TissueSide::kLining, &TissuePiece::side) == pieces.end() && drawn.borders.empty()) {
    return pieces;
  }
  if (auto lining = cap_lining(pieces)) pieces.push_back(std::move(*lining));
  return pieces;
}

void SceneMeshes::make_tissue(const Snapshot& snapshot, const SceneExtent& extent, const LookDefinition& look,
                              Vector3 eye) {
  std::vector<SurfaceVertex>& vertices = tissue_vertices_;
  std::vector<std::uint32_t>& indices = tissue_corners_;
  vertices.clear();
  indices.clear();
  parts_.clear();
  inner_borders_.clear();
  fluids_.clear();
  films_.clear();
  for (std::size_t k = 0; k < snapshot.surfaces.size(); ++k) {
    const SnapshotSurface& surface = drawn_[k];
    const auto found = look.bodies.find(surface.body);
    const TissueLook body_look = found == look.bodies.end() ? TissueLook{} : found->second;
    const DrawnTopology& drawn = drawn_topologies_[k];
    const std::vector<TissuePiece> pieces = dressed_pieces(snapshot, look, k, body_look, eye);
    if (pieces.empty()) continue;
    const bool is_closed = encloses_its_inside(surface, drawn.borders, pieces);
    Bounds body_bounds = bounds_of(pieces.front().vertices);
    for (const TissuePiece& piece : pieces) body_bounds = around(body_bounds, bounds_of(piece.vertices));
    const auto rim = std::ranges::find(pieces, TissueSide::kRim, &TissuePiece::side);
    for (const TissuePiece& piece : pieces) {
      parts_.push_back({surface.body, piece.side, look_uniforms(body_look, piece.side, vessel_trees_[k]),
                        indices.size(), piece.corners.size(), bounds_of(piece.vertices),
                        is_closed && piece.side != TissueSide::kBed, body_bounds});
      if (is_closed && piece.side == TissueSide::kLining && rim != pieces.end()) {
        parts_.back().opening = bounds_of(rim->vertices);
      }
      const auto offset = static_cast<std::uint32_t>(vertices.size());
      for (const std::uint32_t corner : piece.corners) indices.push_back(offset + corner);
      vertices.insert(vertices.end(), piece.vertices.begin(), piece.vertices.end());
      if (piece.side != TissueSide::kLining) continue;
      for (const BorderEdge& edge : drawn.borders) {
        inner_borders_.push_back({piece.vertices[edge.start].position, piece.vertices[edge.end].position});
      }
    }
  }
  if (!look.data) {
    const double reach = kCreaseReach * extent.subject().size;
    shade_creases(outer_walls(), {.reach = reach, .curvature = kCreaseBend / extent.size});
  }
  rest_grid_ = rest_grid_of(vertices);
}

std::vector<std::span<SurfaceVertex>> SceneMeshes::outer_walls() {
  std::vector<std::span<SurfaceVertex>> walls;
  for (const TissuePart& part : parts_) {
    if (part.side != TissueSide::kOutside) continue;
    const auto corners = std::span(tissue_corners_).subspan(part.first_index, part.index_count);
    const auto [first, last] = std::ranges::minmax(corners);
    walls.push_back(std::span(tissue_vertices_).subspan(first, last - first + 1));
  }
  return walls;
}

bool SceneMeshes::is_seen_through_opening(const TissuePart& part, const std::array<float, 16>& matrix) {
  return part.opening && lies_ahead(part.body_bounds, matrix);
}

void SceneMeshes::draw_seen_lining(const TissuePart& part, const std::array<float, 16>& matrix) const {
  const auto corners = std::span(tissue_corners_).subspan(part.first_index, part.index_count);
  tissue_.draw_others(seen_lining(tissue_vertices_, corners, *part.opening, matrix));
}

void SceneMeshes::draw_nearest(const std::array<float, 16>& matrix, bool with_tools) const {
  glCullFace(GL_BACK);
  const auto shows_one_side = [&](const TissuePart& part) {
    return part.is_closed && lies_ahead(part.body_bounds, matrix);
  };
  for (std::size_t i = 0; i < parts_.size();) {
    const bool one_side = shows_one_side(parts_[i]);
    (one_side ? glEnable : glDisable)(GL_CULL_FACE);
    if (one_side && parts_[i].opening) {
      draw_seen_lining(parts_[i++], matrix);
      continue;
    }
    const auto goes_along = [&](const TissuePart& part) {
      return shows_one_side(part) == one_side && !(one_side && part.opening);
    };
    const std::size_t first = parts_[i].first_index;
    std::size_t count = 0;
    for (; i < parts_.size() && goes_along(parts_[i]); ++i) count += parts_[i].index_count;
    tissue_.draw(first, count);
  }
  glEnable(GL_CULL_FACE);
  if (with_tools) tools_.draw();
  glDisable(GL_CULL_FACE);
}

/// Of surface `k`, that `pieces` were made of.
void SceneMeshes::find_fluid(const Snapshot& snapshot, std::size_t k, const TissueLook& look,
                             std::span<const TissuePiece> pieces) {
  const std::vector<BorderEdge>& borders = drawn_topologies_[k].borders;
  if (borders.empty() || !(look.contents.clarity > 0)) return;
  const auto lining = std::ranges::find(pieces, TissueSide::kLining, &TissuePiece::side);
  if (lining == pieces.end()) return;
  const std::vector<SurfaceVertex>& wall = pieces.front().vertices;
  std::vector<Vector3> normals;
  std::vector<double> thickness;
  for (std::size_t v = 0; v < wall.size(); ++v) {
    normals.push_back(vector3(wall[v].normal));
    thickness.push_back(length(vector3(wall[v].position) - vector3(lining->vertices[v].position)));
  }
  const SnapshotSurface& surface = drawn_[k];
  FluidSurface fluid =
      fluid_surface(snapshot, surface, find_wall_holes(surface.positions, borders), normals, thickness);
  if (fluid.lid.empty() && fluid.level.empty()) return;
  fluids_.push_back({.surface = std::move(fluid), .look = look.contents});
}

void SceneMeshes::find_films(const Snapshot& snapshot, std::size_t k, const TissueLook& look,
                             std::span<const TissuePiece> pieces) {
  if (!wounds_[k]) return;
  const SnapshotSurface& surface = drawn_[k];
  const std::vector<BorderEdge>& borders = drawn_topologies_[k].borders;
  const auto add = [&](Film film, const FluidLook& fluid, bool is_falling = false) {
    if (!film.corners.empty()) films_.push_back({.film = std::move(film), .look = fluid, .is_falling = is_falling});
  };
  add(bare_edge_film(surface, borders, pieces, *wounds_[k], snapshot.time), bare_flesh(look));
  const double leaked = look.contents.clarity > 0 ? find_scalar(snapshot, surface.body, kLeakedScalar).value_or(0) : 0;
  if (look.contents.clarity > 0) {
    add(runoff_film(surface, borders, pieces, *wounds_[k], leaked, snapshot.time), look.contents);
    add(falling_drops(surface, *wounds_[k], gravity_of_drops(snapshot), leaked, snapshot.time), look.contents, true);
  }
  if (look.bleeding > 0) {
    const Bleeding bleeding{.strength = look.bleeding, .leaked = leaked};
    add(blood_film(surface, borders, pieces, *wounds_[k], bleeding, snapshot.time), kFreshBlood);
  }
}

/// Edges change with the topology alone, and finding them takes longer than drawing.
void SceneMeshes::find_edges(const Snapshot& snapshot, DrawnEdges edges) {
  std::vector<std::shared_ptr<const SnapshotTopology>> topologies;
  for (const SnapshotSurface& surface : snapshot.surfaces) topologies.push_back(surface.topology);
  if (topologies == topologies_ && edges == edges_) return;
  std::vector<std::uint32_t> corners;
  drawn_topologies_.clear();
  wounds_.clear();
  vessel_trees_.clear();
  ends_.clear();
  std::uint32_t offset = 0;
  for (const auto& topology : topologies) {
    const DrawnTopology& surface = drawn_topologies_.emplace_back(drawn_topology(topology, edges));
    wounds_.emplace_back();
    ends_.emplace_back();
    std::ranges::copy_if(surface.mesh_borders, std::back_inserter(ends_.back()), [&](const BorderEdge& edge) {
      return !surface.is_lip[edge.start] || !surface.is_lip[edge.end];
    });
    vessel_trees_.push_back(vessel_tree(*topology));
    const std::span<const char> is_lip(surface.is_lip.data(), topology->rest_positions.size());
    if (std::ranges::any_of(is_lip, [](char lip) { return lip != 0; })) {
      WoundLayout layout = lay_out_wounds(*topology, surface.mesh_borders, is_lip, downward(snapshot));
      layout.map = refined(std::move(layout.map), surface.smooth);
      for (std::vector<double>* values : {&layout.fall, &layout.blood_feet, &layout.fluid_feet}) {
        *values = refined(std::move(*values), surface.smooth);
      }
      layout.fringe = fringe_mesh(surface.topology(), surface.borders, surface.is_lip, layout.map);
      wounds_.back() = std::move(layout);
    }
    // Wall and caps together: where they meet is no border.
    const SnapshotTopology& drawn = surface.topology();
    for (const auto* triangles : {&drawn.triangles, &drawn.cap_triangles}) {
      for (const Triangle& triangle : *triangles) {
        for (const std::uint32_t vertex : triangle) corners.push_back(offset + vertex);
      }
    }
    offset += static_cast<std::uint32_t>(drawn.rest_positions.size());
  }
  tissue_edges_ = mesh_edges(corners);
  topologies_ = std::move(topologies);
  edges_ = edges;
}

void SceneMeshes::smooth_surfaces(const Snapshot& snapshot) {
  drawn_.clear();
  for (std::size_t k = 0; k < snapshot.surfaces.size(); ++k) {
    drawn_.push_back(drawn_surface(drawn_topologies_[k], snapshot.surfaces[k]));
  }
}

bool SceneMeshes::has_sheet() const {
  return std::ranges::any_of(ends_, [](const std::vector<BorderEdge>& ends) { return !ends.empty(); });
}

void SceneMeshes::make_tools(const Snapshot& snapshot, const SceneExtent& extent) {
  std::vector<ToolVertex>& vertices = tool_vertices_;
  std::vector<std::uint32_t>& indices = tool_corners_;
  vertices.clear();
  indices.clear();
  rods_.clear();
  for (const SnapshotTool& tool : snapshot.tools) {
    if (tool.is_set_aside) continue;
    const ToolShape shape = tool_shape(tool, extent.subject().size, ToolDetail::kSeen);
    const auto offset = static_cast<std::uint32_t>(vertices.size());
    vertices.insert(vertices.end(), shape.vertices.begin(), shape.vertices.end());
    for (const std::uint32_t index : shape.indices) indices.push_back(offset + index);
    rods_.insert(rods_.end(), shape.rods.begin(), shape.rods.end());
  }
}

ScreenArea SceneMeshes::tissue_area(const std::array<float, 16>& view_projection, ImageSize size) const {
  ScreenArea area;
  for (const TissuePart& part : parts_) area = around(area, screen_area(part.bounds, view_projection, size));
  return area;
}

ScreenArea SceneMeshes::tool_area(const std::array<float, 16>& view_projection, ImageSize size) const {
  return screen_area(tool_vertices_, tool_corners_, view_projection, size);
}

std::vector<MeshLine> SceneMeshes::mesh_lines() const {
  std::vector<Float3> points;
  std::vector<char> is_lip;
  for (std::size_t k = 0; k < drawn_.size(); ++k) {
    const std::vector<Float3>& positions = drawn_[k].positions;
    points.insert(points.end(), positions.begin(), positions.end());
    is_lip.insert(is_lip.end(), drawn_topologies_[k].is_lip.begin(), drawn_topologies_[k].is_lip.end());
  }
  std::vector<MeshLine> lines;
  for (const MeshEdge& edge : tissue_edges_) {
    const bool is_cut = edge.right == MeshEdge::kNone && is_lip[edge.start] && is_lip[edge.end];
    lines.push_back({points[edge.start], points[edge.end], is_cut ? 1.0F : 0.0F});
  }
  return lines;
}

std::vector<MeshLine> SceneMeshes::cut_lines() const {
  std::vector<MeshLine> lines = mesh_lines();
  std::erase_if(lines, [](const MeshLine& line) { return line.is_cut == 0; });
  return lines;
}

void SceneMeshes::append_lines_between_bodies(Vector3 eye, std::vector<OutlineSegment>& lines) const {
  std::vector<MeetingWall> walls;
  for (const TissuePart& part : parts_) {
    if (part.side != TissueSide::kOutside) continue;
    const MeetingWall wall{std::span(tissue_corners_).subspan(part.first_index, part.index_count), part.bounds};
    for (const MeetingWall& other : walls) append_meeting_lines(tissue_vertices_, other, wall, eye, lines);
    walls.push_back(wall);
  }
}

std::vector<OutlineSegment> SceneMeshes::outline(Vector3 eye, double pixel) {
  std::vector<Vector3> points;
  for (const SnapshotSurface& surface : drawn_) {
    for (const Float3& position : surface.positions) points.push_back(vector3(position));
  }
  std::vector<OutlineSegment> segments = inner_borders_;
  append_outline(
      tissue_edges_, [&](std::uint32_t i) { return points[i]; }, eye, segments);
  append_lines_between_bodies(eye, segments);
  tool_outline_.set(tool_vertices_, tool_corners_);
  tool_outline_.append(tool_vertices_, eye, pixel, segments);
  const auto squared_distance = [&](const OutlineSegment& segment) {
    const Vector3 offset = 0.5 * (vector3(segment.start) + vector3(segment.end)) - eye;
    return dot(offset, offset);
  };
  std::ranges::stable_sort(segments, {}, squared_distance);
  return segments;
}

}  // namespace thinwall
