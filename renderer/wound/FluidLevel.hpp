#pragma once

#include <limits>
#include <span>
#include <vector>

#include "renderer/snapshot/Snapshot.hpp"
#include "renderer/snapshot/Vector.hpp"

namespace thinwall {

/// Level of a cavity that is full.
inline constexpr double kBrimful = std::numeric_limits<double>::infinity();

/// The sense in which fluids run, of length one: that of gravity, downwards on the picture where there is none.
Vector3 downward(const Snapshot& snapshot);

/// Volume (metres^3) of a closed surface below the height `level` along `up` (of length one), metres from the origin:
/// the integral of (height - level) times the upward part of the normal over what lies below (Gauss's theorem).
double volume_below(std::span<const Float3> positions, std::span<const Triangle> closed, Vector3 up, double level);

/// Height along `up` at which fluid stands that leaves `air` (metres^3) of a closed surface empty, to 1e-10 of its
/// volume; kBrimful when there is no air. With more air than the surface holds, its lowest height.
double fluid_level(std::span<const Float3> positions, std::span<const Triangle> closed, Vector3 up, double air);

/// Where a surface passes through `level`: pairs of points, each with the inside on its left, seen from above.
std::vector<Vector3> level_contour(std::span<const Float3> positions, std::span<const Triangle> closed, Vector3 up,
                                   double level);

}  // namespace thinwall
