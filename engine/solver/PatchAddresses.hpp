#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

#include "engine/solver/BlockPattern.hpp"

namespace thinwall {

/// The addresses of the 21 blocks on and above the diagonal of a patch of six vertices, row by row. A vertex may stand
/// in two places of a patch: their common block then lies on the diagonal.
struct PatchAddresses {
  std::array<BlockAddress, 21> block;
  std::array<bool, 21> transposed;  // the first vertex is the smaller one
};

/// Asserts that the vertices are coupled in the pattern.
PatchAddresses patch_addresses(const BlockPattern& pattern, const std::array<int, 6>& vertices);

/// Adds a symmetric 18 x 18 matrix of a patch to the values.
void add_patch(const PatchAddresses& addresses, const Eigen::Matrix<double, 18, 18>& matrix, std::span<double> values);

}  // namespace thinwall
