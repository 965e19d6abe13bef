#include "renderer/picture/SceneMeshes.hpp"

#include <cstddef>

#include "renderer/picture/SurfaceVertices.hpp"

namespace thinwall {
namespace {

/// Caps close the fluid where no wall is: they look like a smooth, pale cut.
TissueLook cap_look(TissueLook look) {
  for (double& channel : look.color) channel = 0.55 * channel + 0.45 * 0.80;
  look.mottling *= 0.25;
  return look;
}

}  // namespace

SceneMeshes::SceneMeshes()
    : tissue_(sizeof(SurfaceVertex), {{0, 3, offsetof(SurfaceVertex, position)},
                                      {1, 3, offsetof(SurfaceVertex, normal)},
                                      {2, 3, offsetof(SurfaceVertex, rest)},
                                      {3, 2, offsetof(SurfaceVertex, blanch)}}),
      tools_(sizeof(ToolVertex), {{0, 3, offsetof(ToolVertex, position)},
                                  {1, 3, offsetof(ToolVertex, normal)},
                                  {2, 3, offsetof(ToolVertex, roughness)}}) {}

void SceneMeshes::upload(const Snapshot& snapshot, const SceneExtent& extent, const LookDefinition& look) {
  upload_tissue(snapshot, look);
  upload_tools(snapshot, extent);
}

void SceneMeshes::upload_tissue(const Snapshot& snapshot, const LookDefinition& look) {
  std::vector<SurfaceVertex> vertices;
  std::vector<std::uint32_t> indices;
  parts_.clear();
  const auto append = [&](const std::vector<SurfaceVertex>& added, const TissueLook& part_look, auto&& add_indices) {
    const std::size_t first = indices.size();
    add_indices(static_cast<std::uint32_t>(vertices.size()));
    vertices.insert(vertices.end(), added.begin(), added.end());
    parts_.push_back({part_look, first, indices.size() - first});
  };
  for (const SnapshotSurface& surface : snapshot.surfaces) {
    const auto found = look.bodies.find(surface.body);
    const TissueLook body_look = found == look.bodies.end() ? TissueLook{} : found->second;
    append(wall_vertices(surface), body_look, [&](std::uint32_t offset) {
      for (const Triangle& triangle : surface.topology->triangles) {
        for (const std::uint32_t vertex : triangle) indices.push_back(offset + vertex);
      }
    });
    append(cap_vertices(surface), cap_look(body_look), [&](std::uint32_t offset) {
      const std::size_t corners = 3 * surface.topology->cap_triangles.size();
      for (std::size_t i = 0; i < corners; ++i) indices.push_back(offset + static_cast<std::uint32_t>(i));
    });
  }
  tissue_.upload(std::span<const SurfaceVertex>(vertices), indices);
}

void SceneMeshes::upload_tools(const Snapshot& snapshot, const SceneExtent& extent) {
  std::vector<ToolVertex> vertices;
  std::vector<std::uint32_t> indices;
  rods_.clear();
  for (const SnapshotTool& tool : snapshot.tools) {
    const ToolShape shape = tool_shape(tool, extent.size);
    const auto offset = static_cast<std::uint32_t>(vertices.size());
    vertices.insert(vertices.end(), shape.vertices.begin(), shape.vertices.end());
    for (const std::uint32_t index : shape.indices) indices.push_back(offset + index);
    rods_.insert(rods_.end(), shape.rods.begin(), shape.rods.end());
  }
  tools_.upload(std::span<const ToolVertex>(vertices), indices);
}

}  // namespace thinwall
