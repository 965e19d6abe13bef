#pragma once

#include <Eigen/Core>

#include "engine/cutting/Cut.hpp"
#include "engine/cutting/CutPatch.hpp"

namespace thinwall {

/// The smallest angle that a cut may leave where the mesh was good, radians: 20 degrees.
inline constexpr double kGoodAngle = 0.34906585039886592;
/// Lines of cuts that would meet at less are merged, radians: 10 degrees.
inline constexpr double kMergingAngle = 0.17453292519943295;

/// Cosine of the smallest angle of a triangle; 1 for one without area or turned over, seen along `normal`. The smaller
/// the better; angles are compared by it because it needs no inverse function.
double sharpness(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                 const Eigen::Vector3d& normal);
double sharpness(const CutPatch& patch, int triangle);

/// The largest sharpness of the triangles at a vertex.
double sharpness_around(const CutPatch& patch, int vertex);

/// Smallest angle of the triangles that are not frozen, radians.
double least_angle(const CutPatch& patch);

/// Sets what angles a cut may leave: at each vertex the least of kGoodAngle and those of the triangles there now.
void allow_angles_as_now(CutPatch& patch);

/// Allows half of the angle at which lines of the path meet each other or a border, at the vertices where they do.
void allow_wedges(CutPatch& patch);

/// The largest sharpness that a triangle may have by the angles allowed at its vertices.
double allowed_sharpness(const CutPatch& patch, int triangle);

/// The same by the angles allowed where it lies on the patch before the cut, and by the wedges of the path at it.
double allowed_sharpness(const CutPatch& before, const CutPatch& patch, const TriangleSource& source);

/// Whether a triangle is strained, as the wall lies now, far more than any that lay in its place: it spans a fold.
/// False where the patch before the cut does not know its placement.
bool is_strained(const CutPatch& before, const CutPatch& patch, const TriangleSource& source);

/// The smallest angle at which the path meets itself or open borders, radians, measured in the wall; pi if nowhere.
double least_meeting_angle(const CutPatch& patch);

}  // namespace thinwall
