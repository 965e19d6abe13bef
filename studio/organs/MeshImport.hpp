#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/mesh/SurfaceMesh.hpp"
#include "studio/organs/SurfaceOrigin.hpp"

namespace thinwall {

/// How messages speak of a mesh file: with its coordinates as they stand there.
SurfaceOrigin mesh_origin(const std::filesystem::path& file, double metres_per_unit, const std::string& key_path,
                          const SourceLocation& location);

struct ImportOptions {
  bool repair = false;     // mend what is safe to mend
  double edge_length = 0;  // metres; above zero: remesh with edges of about this length
};

struct ImportedMesh {
  SurfaceMesh mesh;                // metres; no caps
  std::vector<std::string> notes;  // a line for each thing that was found or done
};

/// Reads a mesh file and makes a surface of it. In this order: vertices nearer than 1e-6 of the mesh's extent are
/// welded, which a note tells where it joins edges of a file that shares vertices; collapsed and repeated triangles are
/// removed, flat ones turned away or removed; when one component has more than 99 % of the area the others are removed
/// as debris; unused vertices are removed; triangles are made to agree and to face outwards. Each group, object and
/// material that the file names is a group of the mesh, with the vertices of its faces; the group `wall` has all
/// vertices unless the file itself has one of that name. `origin` is what `mesh_origin` gives for the file. With
/// `repair` besides: small flaps are removed (see remove_flaps) and parts that touch split apart (split_apart) before
/// debris is looked for, small holes filled (fill_small_holes) at the end; the result is an oriented manifold. With
/// `edge_length` the surface is remeshed at last (see remesh_to_length); each triangle is of the part of the given one
/// nearest to its middle, so that a group's border moves by less than an edge. Throws InputErrors: unreadable (see
/// read_mesh_file), coordinates that are no finite numbers, no extent, nothing left, no orientation that agrees
/// everywhere; with `repair`: a wall that branches.
ImportedMesh import_mesh(const std::filesystem::path& file, const SurfaceOrigin& origin,
                         const ImportOptions& options = {});

}  // namespace thinwall
