#pragma once

#include <array>

#include "renderer/snapshot/Vector.hpp"

namespace thinwall {

/// A pinhole at the origin that looks along -z, with a right angle of view.
inline std::array<float, 16> right_angle() {
  const Matrix4 matrix = perspective_matrix(1, 1, 0.01, 10);
  std::array<float, 16> result;
  for (std::size_t i = 0; i < 16; ++i) result[i] = static_cast<float>(matrix.values[i]);
  return result;
}

}  // namespace thinwall
