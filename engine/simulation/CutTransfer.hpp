#pragma once

#include "engine/cutting/Cut.hpp"
#include "engine/cutting/CutSurface.hpp"
#include "engine/simulation/Body.hpp"

namespace thinwall {

/// The definition of a body after a cut: the mesh as cut, and what is given for each triangle carried over to the
/// triangles that lie in its place: thickness as the mean by rest area, the rest from the triangle with the largest
/// share. A membrane bears no compression from then on (tension field): its lips are free to go slack, and would buckle
/// as finely as the mesh allows. Parts of the wall hold contents as PartedContents says; the openings of a wall without
/// contents are its gapes, see gapes_of. Asserts that `surface` is the one after `cut`.
BodyDefinition cut_definition(const BodyModel& before, const CutSurface& surface, const Cut& cut);

/// The state of a body after a cut that nothing has moved in yet. Vertices take position, velocity and acceleration of
/// the place on the surface before where they lie; both nodes of a lip those of the one node that they come from. What
/// a viscous wall remembers goes over by rest area, turned into the triangles' own axes. Contact forces stay with the
/// vertices that bore them; those of edges and faces are found again. Contents go over as PartedContents says, under
/// `gravity`, metres / second^2. Strains and forces are not carried over.
BodyState carried_over(const BodyModel& before, const BodyState& state, const BodyModel& after, const Cut& cut,
                       const Eigen::Vector3d& gravity);

/// The triangle before a cut that covers most of a triangle.
int main_source(const TriangleSource& source);

}  // namespace thinwall
