#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/mesh/SurfaceMesh.hpp"
#include "studio/organs/PlyFile.hpp"
#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// How the triangles of a wall come from the vertices and faces of its file, as the file counts them: what the rows of
/// a table belong to. Rows count from 0.
struct TableOrder {
  std::size_t vertices = 0, faces = 0;          // rows of a table per vertex or per face
  std::vector<std::array<int, 3>> corner_rows;  // (triangles of the wall), vertices of the triangle's own face
  std::vector<int> face_rows;                   // (triangles of the wall)
  // Rows of which one counts, because faces lie on each other: their values must agree.
  std::vector<std::array<int, 2>> doubled_vertices, doubled_faces;
  std::optional<PlyFile> ply;  // of a PLY file
};

/// The order of a PLY or OBJ file, or of a shape, whose vertices and faces are those of `wall`. A triangle of the wall
/// is found among the faces by the places of its corners, to 2e-6 of the extent, so that vertices which the import
/// welds may have values that differ from face to face. Throws InputErrors at `location`, beginning with `path`: a file
/// of another kind, a remeshed surface, a triangle that is none of the file's faces (repaired); at the place in the
/// mesh file: what cannot be read of it.
TableOrder table_order(const std::variant<MeshFileSource, ShapeSource>& source, const SurfaceMesh& wall,
                       const std::string& path, const SourceLocation& location);

}  // namespace thinwall
