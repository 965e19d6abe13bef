#pragma once

#include <Eigen/Core>

#include "engine/body/BodyDefinition.hpp"
#include "engine/simulation/Body.hpp"

namespace thinwall {

/// Leaves out the triangles of the wall around the vertex nearest to a point, and around those next to it `rings` - 1
/// times, with the vertices that no triangle is left of, and declares the hole an opening. Thickness and groups follow;
/// no other field may be given by triangle yet.
void open_at(const Eigen::Vector3d& point, int rings, BodyDefinition& body);

/// Ball of radius 20 mm, neo-Hookean of 20 kPa, 1 mm thick, under `pressure` pascal, with an opening at the top whose
/// lips are fixed.
BodyDefinition open_ball(int triangles, double pressure, int rings = 1);

/// Holds the lips of the last opening.
void fix_lips(BodyDefinition& body);

/// Force of the supports on a body at rest, recomputed from positions and pressure alone: what holds the fixed unknowns
/// against a membrane's wall, full contents that bear on wall and caps alone, and weight. Newton.
Eigen::Vector3d force_of_supports(const Body& body, const Eigen::Vector3d& gravity = Eigen::Vector3d::Zero());

}  // namespace thinwall
