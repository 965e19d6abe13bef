#pragma once

#include <Eigen/Core>
#include <array>
#include <bitset>
#include <span>

#include "engine/solver/BlockPattern.hpp"

namespace thinwall {

/// Where the lower triangle of a dense symmetric matrix of an element goes, row by row. An unknown may stand in two
/// places of an element: their common entry lies on the diagonal and counts twice.
template <int size>
struct DenseAddresses {
  static constexpr int kEntries = size * (size + 1) / 2;
  std::array<int, kEntries> entry;
  std::bitset<kEntries> twice;
};

/// Asserts that the unknowns are coupled in the pattern.
template <int size>
DenseAddresses<size> dense_addresses(const BlockPattern& pattern, const std::array<int, size>& unknowns) {
  DenseAddresses<size> addresses{};
  int k = 0;
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j <= i; ++j, ++k) {
      addresses.entry[k] = entry_address(pattern, unknowns[i], unknowns[j]);
      addresses.twice[k] = i != j && unknowns[i] == unknowns[j];
    }
  }
  return addresses;
}

/// Adds a symmetric matrix to the values.
template <int size>
void add_dense(const DenseAddresses<size>& addresses, const Eigen::Matrix<double, size, size>& matrix,
               std::span<double> values) {
  int k = 0;
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j <= i; ++j, ++k) values[addresses.entry[k]] += (addresses.twice[k] ? 2 : 1) * matrix(i, j);
  }
}

}  // namespace thinwall
