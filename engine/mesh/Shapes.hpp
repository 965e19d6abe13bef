#pragma once

#include "engine/mesh/SurfaceMesh.hpp"

namespace thinwall {

// Meshes of the elementary shapes, centred on the origin. `triangles` is the wanted number of wall triangles; each
// shape comes as near to it as its pattern allows, and the mesh tells what it got. Lengths are positive and in metres.
// All vertices are in the group `wall`. Wall and caps together are closed where a shape has caps.

/// Icosahedron with n segments on each edge, 20 n^2 triangles; two vertices on the z axis.
SurfaceMesh make_sphere(double radius, int triangles);

/// Upper half of a sphere from an octahedron, 4 n^2 triangles: a pole and rings of 4, 8, ... 4 n vertices at equal
/// steps of latitude. Crown at +z, base on z = 0, closed by a cap; the vertices of the rim are the group `base`.
SurfaceMesh make_hemisphere(double radius, int triangles);

/// Half a cylinder about the y axis, crown at +z, base on z = 0; mirror-symmetric about x = 0 and y = 0. Vertices stand
/// in straight rows along y, evenly spaced along the arc, one row on the crown; every second row is shifted by half a
/// spacing, so triangles are nearly equilateral. Groups: `base`, the two straight edges; `ends`, the arcs at
/// y = +-length / 2. Caps close the base and the ends.
SurfaceMesh make_semicylinder(double radius, double length, int triangles);

/// Cylinder about the y axis, rows of vertices as in the semicylinder, one of them at +z. The circles at
/// y = +-length / 2 are the group `ends` and closed by caps.
SurfaceMesh make_cylinder(double radius, double length, int triangles);

/// Flat rectangle in z = 0, normal +z, width along x, length along y; rows of vertices as in the semicylinder. Open.
SurfaceMesh make_sheet(double width, double length, int triangles);

/// Flat disc in z = 0, normal +z, 6 n^2 triangles: a centre and rings of 6, 12, ... 6 n vertices. Open.
SurfaceMesh make_disc(double radius, int triangles);

/// Flat ring in z = 0, normal +z, inner_radius < radius. Circles of equally many vertices, each turned by half a
/// spacing, their radii in geometric progression, so all triangles have nearly the same shape. Open at both circles,
/// which are the groups `inner` and `outer`.
SurfaceMesh make_annulus(double inner_radius, double radius, int triangles);

/// The same ring slit along +x. The lips lie on each other and have vertices of their own, from the hole outwards: the
/// groups `slit_start`, from which the ring goes counter-clockwise, and `slit_end`, where it comes back; their ends are
/// in `inner` and `outer` too.
SurfaceMesh make_slit_annulus(double inner_radius, double radius, int triangles);

}  // namespace thinwall
