#include "engine/solver/PatchAddresses.hpp"

namespace thinwall {

PatchAddresses patch_addresses(const BlockPattern& pattern, const std::array<int, 6>& vertices) {
  PatchAddresses addresses{};
  int k = 0;
  for (int i = 0; i < 6; ++i) {
    for (int j = i; j < 6; ++j, ++k) {
      addresses.block[k] = block_address(pattern, vertices[i], vertices[j]);
      addresses.transposed[k] = vertices[i] < vertices[j];
    }
  }
  return addresses;
}

void add_patch(const PatchAddresses& addresses, const Eigen::Matrix<double, 18, 18>& matrix, std::span<double> values) {
  int k = 0;
  for (int i = 0; i < 6; ++i) {
    for (int j = i; j < 6; ++j, ++k) {
      const BlockAddress& address = addresses.block[k];
      Eigen::Matrix3d block = matrix.block<3, 3>(3 * i, 3 * j);
      if (addresses.transposed[k]) block.transposeInPlace();
      if (address.diagonal && i != j) block += block.transpose().eval();
      for (int column = 0; column < 3; ++column) {
        const int first_row = address.diagonal ? column : 0;
        for (int row = first_row; row < 3; ++row) values[address.first[column] + row - first_row] += block(row, column);
      }
    }
  }
}

}  // namespace thinwall
