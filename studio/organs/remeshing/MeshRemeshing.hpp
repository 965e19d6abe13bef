#pragma once

#include <vector>

#include "studio/organs/remeshing/TriangleSurface.hpp"

namespace thinwall {

/// Of the wanted edge length: how far the surface may move.
inline constexpr double kMostMoved = 0.5;

struct RemeshedMesh {
  TriangleSurface surface;
  std::vector<int> source;  // (triangles), the triangle of the start mesh nearest to each one's middle
  double largest_distance =
      0;  // metres, between the two surfaces, either way, over corners, edges' and triangles' middles
};

/// Remeshes a mesh with edges of about one length (metres). Borders and creases of more than 50 degrees stay where they
/// are, creases shorter than two wanted lengths aside, and so do vertices and edges, such as peaks, that the surface
/// would leave by more than kMostMoved otherwise. The start must be an oriented manifold.
RemeshedMesh remesh_to_length(const TriangleSurface& start, double edge_length);

}  // namespace thinwall
