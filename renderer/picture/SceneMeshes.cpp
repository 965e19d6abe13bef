#include "renderer/picture/SceneMeshes.hpp"

#include <cstddef>
#include <utility>

#include "renderer/picture/CutLips.hpp"
#include "renderer/picture/SurfaceVertices.hpp"

namespace thinwall {

SceneMeshes::SceneMeshes()
    : tissue_(sizeof(SurfaceVertex), {{0, 3, offsetof(SurfaceVertex, position)},
                                      {1, 3, offsetof(SurfaceVertex, normal)},
                                      {2, 3, offsetof(SurfaceVertex, rest)},
                                      {3, 4, offsetof(SurfaceVertex, blanch)}}),
      tools_(sizeof(ToolVertex), {{0, 3, offsetof(ToolVertex, position)},
                                  {1, 3, offsetof(ToolVertex, normal)},
                                  {2, 3, offsetof(ToolVertex, roughness)}}) {}

void SceneMeshes::upload(const Snapshot& snapshot, const SceneExtent& extent, const LookDefinition& look) {
  find_edges(snapshot);
  upload_tissue(snapshot, look);
  upload_tools(snapshot, extent);
}

void SceneMeshes::upload_tissue(const Snapshot& snapshot, const LookDefinition& look) {
  std::vector<SurfaceVertex> vertices;
  std::vector<std::uint32_t> indices;
  parts_.clear();
  inner_borders_.clear();
  const auto append = [&](const SnapshotSurface& surface, TissueSide side, const std::vector<SurfaceVertex>& added,
                          auto&& add_indices) {
    const auto found = look.bodies.find(surface.body);
    const TissueLook body_look = found == look.bodies.end() ? TissueLook{} : found->second;
    const std::size_t first = indices.size();
    add_indices(static_cast<std::uint32_t>(vertices.size()));
    vertices.insert(vertices.end(), added.begin(), added.end());
    if (indices.size() > first)
      parts_.push_back({surface.body, side, look_uniforms(body_look, side), first, indices.size() - first});
  };
  for (std::size_t k = 0; k < snapshot.surfaces.size(); ++k) {
    const SnapshotSurface& surface = snapshot.surfaces[k];
    std::vector<SurfaceVertex> wall = wall_vertices(surface);
    for (std::size_t v = 0; v < wall.size(); ++v) wall[v].wound = nearness_[k][v];
    const WallDepth depth = wall_depth(surface, wall, borders_[k]);
    for (const BorderEdge& edge : depth.lining.empty() ? std::vector<BorderEdge>{} : borders_[k]) {
      inner_borders_.push_back({depth.lining[edge.start].position, depth.lining[edge.end].position});
    }
    append(surface, TissueSide::kOutside, wall, [&](std::uint32_t offset) {
      for (const Triangle& triangle : surface.topology->triangles) {
        for (const std::uint32_t vertex : triangle) indices.push_back(offset + vertex);
      }
    });
    append(surface, TissueSide::kCap, cap_vertices(surface), [&](std::uint32_t offset) {
      const std::size_t corners = 3 * surface.topology->cap_triangles.size();
      for (std::size_t i = 0; i < corners; ++i) indices.push_back(offset + static_cast<std::uint32_t>(i));
    });
    append(surface, TissueSide::kRim, depth.rim, [&](std::uint32_t offset) {
      for (const std::uint32_t corner : depth.rim_corners) indices.push_back(offset + corner);
    });
    append(surface, TissueSide::kLining, depth.lining, [&](std::uint32_t offset) {
      if (depth.lining.empty()) return;
      for (const Triangle& triangle : surface.topology->triangles) {
        for (const std::size_t corner : {0U, 2U, 1U}) indices.push_back(offset + triangle[corner]);
      }
    });
  }
  tissue_.upload(std::span<const SurfaceVertex>(vertices), indices);
}

/// Edges change with the topology alone, and finding them takes longer than drawing.
void SceneMeshes::find_edges(const Snapshot& snapshot) {
  std::vector<std::shared_ptr<const SnapshotTopology>> topologies;
  for (const SnapshotSurface& surface : snapshot.surfaces) topologies.push_back(surface.topology);
  if (topologies == topologies_) return;
  std::vector<std::uint32_t> corners;
  borders_.clear();
  nearness_.clear();
  std::uint32_t offset = 0;
  for (const SnapshotSurface& surface : snapshot.surfaces) {
    // Wall and caps together: where they meet is no border.
    for (const auto* triangles : {&surface.topology->triangles, &surface.topology->cap_triangles}) {
      for (const Triangle& triangle : *triangles) {
        for (const std::uint32_t vertex : triangle) corners.push_back(offset + vertex);
      }
    }
    offset += static_cast<std::uint32_t>(surface.positions.size());
    borders_.push_back(border_edges(*surface.topology));
    nearness_.push_back(nearness_to_cuts(*surface.topology, borders_.back()));
  }
  tissue_edges_ = mesh_edges(corners);
  topologies_ = std::move(topologies);
}

void SceneMeshes::upload_tools(const Snapshot& snapshot, const SceneExtent& extent) {
  std::vector<ToolVertex>& vertices = tool_vertices_;
  std::vector<std::uint32_t> indices;
  vertices.clear();
  rods_.clear();
  for (const SnapshotTool& tool : snapshot.tools) {
    const ToolShape shape = tool_shape(tool, extent.size);
    const auto offset = static_cast<std::uint32_t>(vertices.size());
    vertices.insert(vertices.end(), shape.vertices.begin(), shape.vertices.end());
    for (const std::uint32_t index : shape.indices) indices.push_back(offset + index);
    rods_.insert(rods_.end(), shape.rods.begin(), shape.rods.end());
  }
  tools_.upload(std::span<const ToolVertex>(vertices), indices);
  std::vector<Float3> positions;
  for (const ToolVertex& vertex : vertices) positions.push_back(vertex.position);
  tool_edges_ = creased_edges(positions, indices);
}

std::vector<OutlineSegment> SceneMeshes::outline(const Snapshot& snapshot, Vector3 eye) const {
  std::vector<Vector3> points;
  for (const SnapshotSurface& surface : snapshot.surfaces) {
    for (const Float3& position : surface.positions) points.push_back(vector3(position));
  }
  std::vector<OutlineSegment> segments = inner_borders_;
  append_outline(
      tissue_edges_, [&](std::uint32_t i) { return points[i]; }, eye, segments);
  append_outline(
      tool_edges_, [&](std::uint32_t i) { return vector3(tool_vertices_[i].position); }, eye, segments);
  return segments;
}

}  // namespace thinwall
