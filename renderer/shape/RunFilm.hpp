#pragma once

#include <span>

#include "renderer/shape/Film.hpp"
#include "renderer/wound/RunPath.hpp"

namespace thinwall {

/// Metres beyond the edge of a narrow film that are drawn at least, for its edge is uneven.
inline constexpr double kFilmMargin = 0.0003;

struct RunShape {
  double half_width = 0;  // metres, of the trail
  double length = 0;      // metres
  double height = 0;      // metres, of the trail
  double dry = 0;         // 0 to 1
  double swell = 0;       // metres by which the swellings of the trail have come down
  double drop = 1.7;      // half the width of the drop at its end, over that of the trail
};

/// Adds what has run along a path, on the wall as it is now. `normals`: (vertices), of length one, outward.
void append_run(const SnapshotSurface& surface, std::span<const Float3> normals, const FluidRun& run,
                const RunShape& shape, Film& film);

}  // namespace thinwall
