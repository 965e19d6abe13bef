#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

namespace thinwall {

/// The sparsity of a symmetric matrix made of 3 x 3 blocks, one row of blocks per vertex, and of single unknowns behind
/// them: its lower triangle by columns, rows ascending, as the factorisation wants it. Nodes are the vertices and then
/// the single unknowns.
struct BlockPattern {
  int vertices = 0;
  int singles = 0;
  std::vector<int> neighbour_begin;  // (nodes + 1), into `neighbours`
  std::vector<int> neighbours;       // larger neighbours of each node, ascending
  std::vector<int> column_begin;     // (unknowns + 1), into `row` and the values
  std::vector<int> row;              // (non-zeros)

  int nonzeros() const { return column_begin.back(); }
  int nodes() const { return vertices + singles; }
  int unknowns() const { return 3 * vertices + singles; }
  int first_unknown(int node) const { return node < vertices ? 3 * node : 2 * vertices + node; }
  int unknowns_of(int node) const { return node < vertices ? 3 : 1; }
};

/// Where a block lies in the value array: position of its first entry in each of its three columns. The block of a
/// vertex with itself keeps its lower triangle only; an off-diagonal block stands in the column of the smaller vertex.
struct BlockAddress {
  std::array<int, 3> first;
  bool diagonal;
};

/// Pattern in which the vertices of each triangle are coupled with each other.
BlockPattern make_block_pattern(int vertices, std::span<const Eigen::Vector3i> triangles);

/// The pattern with further single unknowns and further pairs of nodes coupled, and where each value of the old pattern
/// lies in it.
struct ExtendedPattern {
  BlockPattern pattern;
  std::vector<int> entries;  // (non-zeros of the old pattern), index of the value in the new one
};
ExtendedPattern extend_block_pattern(const BlockPattern& pattern, std::span<const std::array<int, 2>> couplings,
                                     int further_singles = 0);

/// Whether the pattern has a block for the two vertices, in either order.
bool is_coupled(const BlockPattern& pattern, int vertex, int other);

/// Address of the block of two coupled vertices, in either order. Asserts that they are coupled.
BlockAddress block_address(const BlockPattern& pattern, int vertex, int other);

/// Where the entry of two coupled unknowns lies in the value array. Asserts that they are coupled.
int entry_address(const BlockPattern& pattern, int unknown, int other);

/// The corners that the six blocks of a triangle couple, in their order.
constexpr std::array<std::array<int, 2>, 6> kBlockCorners = {{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}}};

/// The addresses of a triangle's blocks, and whether an off-diagonal block must be transposed because its first vertex
/// is the smaller one.
struct TriangleAddresses {
  std::array<BlockAddress, 6> block;
  std::array<bool, 6> transposed;
};
TriangleAddresses triangle_addresses(const BlockPattern& pattern, const Eigen::Vector3i& triangle);

/// Adds a symmetric 9 x 9 matrix of a triangle to the values.
void add_triangle(const TriangleAddresses& addresses, const Eigen::Matrix<double, 9, 9>& matrix,
                  std::span<double> values);

/// The same of a matrix by its blocks: (6 x 9 numbers, `stride` apart), each block by columns, of those on the diagonal
/// the lower triangle.
void add_triangle(const TriangleAddresses& addresses, const double* blocks, int stride, std::span<double> values);

/// Adds a symmetric 9 x 9 matrix of a triangle whose blocks beside the diagonal are those of cross products and whose
/// others are zero: block (0, 1) is that of vectors[0] x, (1, 2) of vectors[1] x, (0, 2) of vectors[2] x.
void add_cross_products(const TriangleAddresses& addresses, const std::array<Eigen::Vector3d, 3>& vectors,
                        std::span<double> values);

/// Adds a 3 x 3 block: rows belong to `vertex`, columns to `other`; of two equal vertices, the lower triangle is kept.
void add_block(const BlockPattern& pattern, int vertex, int other, const Eigen::Matrix3d& block,
               std::span<double> values);

/// y = A x with the symmetric matrix of the pattern. (unknowns) each.
void multiply(const BlockPattern& pattern, std::span<const double> values, const Eigen::VectorXd& x,
              Eigen::VectorXd& y);

}  // namespace thinwall
