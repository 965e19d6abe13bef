#pragma once

#include <array>
#include <cstdint>

namespace thinwall {

/// A place on a triangle of a surface.
struct SurfacePlace {
  std::uint32_t triangle = 0;
  std::array<double, 3> weights{};  // of its corners, sum 1
};

/// A place on a border of a surface.
struct BorderPlace {
  std::uint32_t border = 0;
  double along = 0;  // part of its length from its start, 0 to 1
};

}  // namespace thinwall
