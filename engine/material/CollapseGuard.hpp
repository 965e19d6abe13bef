#pragma once

#include "engine/material/WallLaw.hpp"

namespace thinwall {

/// Area of a wall over its area at rest, squared, below which a law that would let it vanish is guarded. A linear law
/// loses its stability near there: pressed along one direction at a stretch of 0.58, pulled at one of 1.8.
inline constexpr double kGuardedDeterminant = 0.5;

/// Adds to the answer of a law whose energy stays finite where the wall shrinks to nothing what keeps it from doing so,
///
///     modulus / 10 ln(d0 / det C)^3   where det C < d0 = kGuardedDeterminant, nothing elsewhere.
///
/// Such a law softens when it is pressed, and its triangles collapse into lines one after the other; the guarded
/// one hardens before they do. Twice differentiable. `modulus`: pascal, of the law at zero strain;
/// `right_cauchy_green` = (C11, C22, C12) with det C > 0.
void guard_against_collapse(double modulus, const Eigen::Vector3d& right_cauchy_green, WallLawResponse& response);

}  // namespace thinwall
