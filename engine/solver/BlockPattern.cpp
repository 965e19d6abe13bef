#include "engine/solver/BlockPattern.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

namespace thinwall {
namespace {

/// Couplings of each node with larger ones, in any order and as often as they come.
struct Couplings {
  std::vector<int> begin;   // (nodes + 1), into `larger`
  std::vector<int> larger;  // nodes

  /// `for_each`: calls what it is given with each coupling, the lower node first; it is called twice.
  template <typename ForEach>
  Couplings(int nodes, const ForEach& for_each) : begin(static_cast<std::size_t>(nodes) + 1, 0) {
    for_each([&](int low, int) { ++begin[low + 1]; });
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    larger.resize(begin.back());
    std::vector<int> next(begin.begin(), begin.end() - 1);
    for_each([&](int low, int high) { larger[next[low]++] = high; });
  }
};

BlockPattern pattern_of(Couplings couplings, int singles) {
  const int nodes = static_cast<int>(couplings.begin.size()) - 1;
  BlockPattern pattern{.vertices = nodes - singles,
                       .singles = singles,
                       .neighbour_begin = {0},
                       .neighbours = {},
                       .column_begin = {0},
                       .row = {}};
  pattern.neighbour_begin.reserve(couplings.begin.size());
  for (int node = 0; node < nodes; ++node) {
    const auto begin = couplings.larger.begin() + couplings.begin[node];
    const auto end = couplings.larger.begin() + couplings.begin[node + 1];
    std::sort(begin, end);
    pattern.neighbours.insert(pattern.neighbours.end(), begin, std::unique(begin, end));
    pattern.neighbour_begin.push_back(static_cast<int>(pattern.neighbours.size()));
  }
  pattern.column_begin.reserve(static_cast<std::size_t>(pattern.unknowns()) + 1);
  // Nine for each pair of vertices, and the triangle of each with itself.
  pattern.row.reserve(9 * pattern.neighbours.size() + 6 * static_cast<std::size_t>(nodes));
  for (int node = 0; node < nodes; ++node) {
    for (int column = 0; column < pattern.unknowns_of(node); ++column) {
      for (int k = column; k < pattern.unknowns_of(node); ++k) pattern.row.push_back(pattern.first_unknown(node) + k);
      for (int at = pattern.neighbour_begin[node]; at < pattern.neighbour_begin[node + 1]; ++at) {
        const int first = pattern.first_unknown(pattern.neighbours[at]);
        for (int k = 0; k < pattern.unknowns_of(pattern.neighbours[at]); ++k) pattern.row.push_back(first + k);
      }
      pattern.column_begin.push_back(static_cast<int>(pattern.row.size()));
    }
  }
  return pattern;
}

std::span<const int> larger_neighbours(const BlockPattern& pattern, int vertex) {
  const int begin = pattern.neighbour_begin[vertex], end = pattern.neighbour_begin[vertex + 1];
  return std::span<const int>(pattern.neighbours).subspan(begin, end - begin);
}

}  // namespace

BlockPattern make_block_pattern(int vertices, std::span<const Eigen::Vector3i> triangles) {
  const auto for_each = [&](const auto& visit) {
    for (const Eigen::Vector3i& triangle : triangles) {
      for (int k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax({triangle[k], triangle[(k + 1) % 3]});
        visit(low, high);
      }
    }
  };
  return pattern_of(Couplings(vertices, for_each), 0);
}

ExtendedPattern extend_block_pattern(const BlockPattern& pattern, std::span<const std::array<int, 2>> couplings,
                                     int further_singles) {
  const auto for_each = [&](const auto& visit) {
    for (int node = 0; node < pattern.nodes(); ++node) {
      for (const int other : larger_neighbours(pattern, node)) visit(node, other);
    }
    for (const auto& [one, other] : couplings) {
      if (one != other) visit(std::min(one, other), std::max(one, other));
    }
  };
  ExtendedPattern extended{
      .pattern = pattern_of(Couplings(pattern.nodes() + further_singles, for_each), pattern.singles + further_singles),
      .entries = {}};
  extended.entries.reserve(pattern.nonzeros());
  for (int column = 0; column < pattern.unknowns(); ++column) {
    int at = extended.pattern.column_begin[column];
    for (int k = pattern.column_begin[column]; k < pattern.column_begin[column + 1]; ++k, ++at) {
      while (extended.pattern.row[at] != pattern.row[k]) ++at;
      extended.entries.push_back(at);
    }
  }
  return extended;
}

bool is_coupled(const BlockPattern& pattern, int vertex, int other) {
  const auto [low, high] = std::minmax(vertex, other);
  const std::span<const int> list = larger_neighbours(pattern, low);
  return low == high || std::binary_search(list.begin(), list.end(), high);
}

BlockAddress block_address(const BlockPattern& pattern, int vertex, int other) {
  assert(vertex < pattern.vertices && other < pattern.vertices);
  const auto [low, high] = std::minmax(vertex, other);
  BlockAddress address{.first = {}, .diagonal = low == high};
  int offset = 0;
  if (!address.diagonal) {
    const auto begin = pattern.neighbours.begin() + pattern.neighbour_begin[low];
    const auto end = pattern.neighbours.begin() + pattern.neighbour_begin[low + 1];
    const auto found = std::lower_bound(begin, end, high);
    assert(found != end && *found == high);
    offset = 3 * static_cast<int>(found - begin);
  }
  for (int column = 0; column < 3; ++column) {
    const int own = address.diagonal ? 0 : 3 - column;
    address.first[column] = pattern.column_begin[3 * low + column] + own + offset;
  }
  return address;
}

int entry_address(const BlockPattern& pattern, int unknown, int other) {
  const auto [column, row] = std::minmax(unknown, other);
  const auto begin = pattern.row.begin() + pattern.column_begin[column];
  const auto end = pattern.row.begin() + pattern.column_begin[column + 1];
  const auto found = std::lower_bound(begin, end, row);
  assert(found != end && *found == row);
  return static_cast<int>(found - pattern.row.begin());
}

TriangleAddresses triangle_addresses(const BlockPattern& pattern, const Eigen::Vector3i& triangle) {
  TriangleAddresses addresses{};
  for (int k = 0; k < 6; ++k) {
    const int vertex = triangle[kBlockCorners[k][0]], other = triangle[kBlockCorners[k][1]];
    addresses.block[k] = block_address(pattern, vertex, other);
    addresses.transposed[k] = vertex < other;
  }
  return addresses;
}

void add_triangle(const TriangleAddresses& addresses, const Eigen::Matrix<double, 9, 9>& matrix,
                  std::span<double> values) {
  for (int k = 0; k < 6; ++k) {
    const int i = 3 * kBlockCorners[k][0], j = 3 * kBlockCorners[k][1];
    const std::array<int, 3>& first = addresses.block[k].first;
    if (addresses.block[k].diagonal) {
      for (int column = 0; column < 3; ++column) {
        for (int row = column; row < 3; ++row) values[first[column] + row - column] += matrix(i + row, i + column);
      }
    } else {
      for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
          values[first[column] + row] +=
              addresses.transposed[k] ? matrix(i + column, j + row) : matrix(i + row, j + column);
        }
      }
    }
  }
}

void add_triangle(const TriangleAddresses& addresses, const double* blocks, int stride, std::span<double> values) {
  for (int k = 0; k < 6; ++k, blocks += 9 * stride) {
    const bool diagonal = addresses.block[k].diagonal;
    const int along = addresses.transposed[k] ? 3 * stride : stride,
              across = addresses.transposed[k] ? stride : 3 * stride;
    for (int column = 0; column < 3; ++column) {
      const double* from = blocks + column * across;
      double* to = values.data() + addresses.block[k].first[column] - (diagonal ? column : 0);
      for (int row = diagonal ? column : 0; row < 3; ++row) to[row] += from[row * along];
    }
  }
}

void add_cross_products(const TriangleAddresses& addresses, const std::array<Eigen::Vector3d, 3>& vectors,
                        std::span<double> values) {
  for (int k = 0; k < 3; ++k) {
    const std::array<int, 3>& first = addresses.block[3 + k].first;
    // Transposed, the matrix of a cross product changes its sign.
    const Eigen::Vector3d v = addresses.transposed[3 + k] ? Eigen::Vector3d(-vectors[k]) : vectors[k];
    values[first[0] + 1] += v.z();
    values[first[0] + 2] -= v.y();
    values[first[1]] -= v.z();
    values[first[1] + 2] += v.x();
    values[first[2]] += v.y();
    values[first[2] + 1] -= v.x();
  }
}

void add_block(const BlockPattern& pattern, int vertex, int other, const Eigen::Matrix3d& block,
               std::span<double> values) {
  const BlockAddress address = block_address(pattern, vertex, other);
  for (int column = 0; column < 3; ++column) {
    for (int row = address.diagonal ? column : 0; row < 3; ++row) {
      values[address.first[column] + row - (address.diagonal ? column : 0)] +=
          vertex < other ? block(column, row) : block(row, column);
    }
  }
}

void multiply(const BlockPattern& pattern, std::span<const double> values, const Eigen::VectorXd& x,
              Eigen::VectorXd& y) {
  y.setZero(x.size());
  for (int column = 0; column < pattern.unknowns(); ++column) {
    int k = pattern.column_begin[column];
    double sum = values[k] * x[column];
    for (++k; k < pattern.column_begin[column + 1]; ++k) {
      const int row = pattern.row[k];
      sum += values[k] * x[row];
      y[row] += values[k] * x[column];
    }
    y[column] += sum;
  }
}

}  // namespace thinwall
