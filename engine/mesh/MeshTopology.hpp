#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "engine/mesh/SurfaceMesh.hpp"

namespace thinwall {

/// The edges of a triangle list, manifold or not.
struct MeshEdges {
  std::vector<std::array<int, 2>> edges;           // (edges x 2), vertices, the lower first; ascending
  std::vector<std::array<int, 3>> triangle_edges;  // (triangles x 3), edge k joins corners k and k + 1
  std::vector<int> edge_triangle_begin;            // (edges + 1), into edge_triangles
  std::vector<int> edge_triangles;                 // (3 triangles), the triangles at each edge, ascending

  std::vector<int> open_edges;      // edges of one triangle only, ascending
  std::vector<int> crowded_edges;   // edges of more than two triangles, ascending
  std::vector<int> contrary_edges;  // edges whose two triangles run along them in the same sense, ascending
};

/// The pieces that a triangle list consists of, joined across edges, and their borders.
struct MeshPieces : MeshEdges {
  std::vector<std::vector<int>> boundary_loops;  // vertices along the open edges, in the sense of their triangles
  std::vector<int> triangle_component;           // (triangles), numbered from 0 by first triangle
  int component_count = 0;
};

/// How the triangles of a surface hang together. Plain data; any triangle list is allowed, manifold or not.
struct MeshTopology : MeshPieces {
  std::vector<int> non_manifold_vertices;  // used vertices whose triangles do not form one fan, ascending
  int euler_characteristic = 0;            // used vertices - edges + triangles
};

/// Of a triangle list over vertices 0 ... vertex_count - 1. Corners must be in that range and differ. What knows less
/// takes less time.
MeshEdges edges_of(int vertex_count, std::span<const Eigen::Vector3i> triangles);
MeshPieces pieces_of(int vertex_count, std::span<const Eigen::Vector3i> triangles);
MeshTopology topology_of(int vertex_count, std::span<const Eigen::Vector3i> triangles);

/// Wall and caps together, the wall's triangles first: the surface that encloses the fluid.
std::vector<Eigen::Vector3i> closed_surface(const SurfaceMesh& mesh);

/// The triangles at an edge, ascending.
inline std::span<const int> triangles_at(const MeshEdges& mesh, int edge) {
  const int begin = mesh.edge_triangle_begin[edge], end = mesh.edge_triangle_begin[edge + 1];
  return std::span<const int>(mesh.edge_triangles).subspan(begin, end - begin);
}

/// Every edge has at most two triangles, of contrary sense, and the triangles of every vertex form one fan.
inline bool is_oriented_manifold(const MeshTopology& topology) {
  return topology.crowded_edges.empty() && topology.contrary_edges.empty() && topology.non_manifold_vertices.empty();
}

/// An oriented manifold without open edges.
inline bool is_closed(const MeshTopology& topology) {
  return is_oriented_manifold(topology) && topology.open_edges.empty();
}

}  // namespace thinwall
