#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// A piece of a triangle.
struct SplitTriangle {
  Triangle vertices{};
  std::array<std::array<double, 3>, 3> weights{};  // of the triangle's corners, at each corner of the piece
};

/// Cuts a triangle into pieces, all turning as it does, whose corners are its own and the points along its edges: those
/// of edge k, from corner k on, are even and 0, 1 or 3 in number. What neighbours have on a common edge fits together.
void split_triangle(const Triangle& triangle, const std::array<std::vector<std::uint32_t>, 3>& points,
                    std::vector<SplitTriangle>& pieces);

}  // namespace thinwall
