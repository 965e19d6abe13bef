#include "engine/solver/BlockPattern.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/solver/DenseAddresses.hpp"
#include "engine/solver/SparseFactor.hpp"
#include "tests/engine/solver/BlockMatrix.hpp"

namespace thinwall {
namespace {

/// The lower triangle as a dense matrix, read from columns and rows as a sparse library would.
Eigen::MatrixXd expanded(const BlockPattern& pattern, const std::vector<double>& values) {
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(pattern.unknowns(), pattern.unknowns());
  for (int column = 0; column < pattern.unknowns(); ++column) {
    for (int k = pattern.column_begin[column]; k < pattern.column_begin[column + 1]; ++k) {
      dense(pattern.row[k], column) = values[k];
      dense(column, pattern.row[k]) = values[k];
    }
  }
  return dense;
}

TEST(BlockPattern, AssembledMatrixIsTheDenseOne) {
  const BlockMatrix matrix = random_matrix(80, 0.5, 3);
  EXPECT_LT((expanded(matrix.pattern, matrix.values) - matrix.dense).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(BlockPattern, CornersInAnyOrderGoToTheSamePlaces) {
  // Each of the six orders of the corners must place a triangle's blocks where the dense assembly does.
  const std::vector<Eigen::Vector3i> orders = {{0, 2, 3}, {0, 3, 2}, {2, 0, 3}, {2, 3, 0}, {3, 0, 2}, {3, 2, 0}};
  Eigen::Matrix<double, 9, 9> part = random_columns(9, 9, 5);
  part = (part + part.transpose()).eval();
  for (const Eigen::Vector3i& triangle : orders) {
    const BlockPattern pattern = make_block_pattern(4, std::vector<Eigen::Vector3i>{triangle});
    std::vector<double> values(pattern.nonzeros(), 0);
    add_triangle(triangle_addresses(pattern, triangle), part, values);
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(12, 12);
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) dense.block<3, 3>(3 * triangle[a], 3 * triangle[b]) = part.block<3, 3>(3 * a, 3 * b);
    }
    EXPECT_EQ((expanded(pattern, values) - dense).cwiseAbs().maxCoeff(), 0) << triangle.transpose();
  }
}

TEST(BlockPattern, BlocksAreAddedAsTheirDenseMatrixIs) {
  const std::vector<Eigen::Vector3i> orders = {{0, 2, 3}, {0, 3, 2}, {2, 0, 3}, {2, 3, 0}, {3, 0, 2}, {3, 2, 0}};
  Eigen::Matrix<double, 9, 9> whole = random_columns(9, 9, 6);
  whole = (whole + whole.transpose()).eval();
  constexpr int kStride = 3;
  std::vector<double> blocks;
  for (const auto& [i, j] : kBlockCorners) {
    for (int k = 0; k < 9; ++k) {
      // Between them stands what belongs to others, and above the diagonal what nobody asks for.
      const bool wanted = i != j || k % 3 >= k / 3;
      blocks.insert(blocks.end(), {wanted ? whole(3 * i + k % 3, 3 * j + k / 3) : 1e9, 1e9, 1e9});
    }
  }
  for (const Eigen::Vector3i& triangle : orders) {
    const BlockPattern pattern = make_block_pattern(4, std::vector<Eigen::Vector3i>{triangle});
    std::vector<double> dense(pattern.nonzeros(), 0), by_blocks(dense);
    add_triangle(triangle_addresses(pattern, triangle), whole, dense);
    add_triangle(triangle_addresses(pattern, triangle), blocks.data(), kStride, by_blocks);
    EXPECT_EQ(by_blocks, dense) << triangle.transpose();
  }
}

TEST(BlockPattern, CrossProductsAreAddedAsTheirDenseMatrixIs) {
  const std::vector<Eigen::Vector3i> orders = {{0, 2, 3}, {0, 3, 2}, {2, 0, 3}, {2, 3, 0}, {3, 0, 2}, {3, 2, 0}};
  const Eigen::MatrixXd drawn = random_columns(3, 3, 7);
  const std::array<Eigen::Vector3d, 3> vectors = {drawn.col(0), drawn.col(1), drawn.col(2)};
  Eigen::Matrix<double, 9, 9> whole = Eigen::Matrix<double, 9, 9>::Zero();
  const int places[3][2] = {{0, 1}, {1, 2}, {0, 2}};
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d& v = vectors[k];
    Eigen::Matrix3d block;
    block << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    whole.block<3, 3>(3 * places[k][0], 3 * places[k][1]) = block;
    whole.block<3, 3>(3 * places[k][1], 3 * places[k][0]) = block.transpose();
  }
  for (const Eigen::Vector3i& triangle : orders) {
    const BlockPattern pattern = make_block_pattern(4, std::vector<Eigen::Vector3i>{triangle});
    std::vector<double> dense(pattern.nonzeros(), 0), quick(dense);
    add_triangle(triangle_addresses(pattern, triangle), whole, dense);
    add_cross_products(triangle_addresses(pattern, triangle), vectors, quick);
    EXPECT_EQ(quick, dense) << triangle.transpose();
  }
}

TEST(BlockPattern, KeepsTheLowerTriangleInAscendingRowsWithTheDiagonalFirst) {
  const BlockPattern pattern = random_matrix(80, 0, 1).pattern;
  for (int column = 0; column < 3 * pattern.vertices; ++column) {
    const auto begin = pattern.row.begin() + pattern.column_begin[column];
    const auto end = pattern.row.begin() + pattern.column_begin[column + 1];
    ASSERT_NE(begin, end);
    EXPECT_EQ(*begin, column);
    EXPECT_TRUE(std::is_sorted(begin, end));
    EXPECT_EQ(std::adjacent_find(begin, end), end);
  }
}

TEST(BlockPattern, HasNineEntriesPerEdgeAndSixPerVertex) {
  // A closed triangulated sphere: E = 3 F / 2, V = F / 2 + 2.
  const BlockPattern pattern = random_matrix(80, 0, 1).pattern;
  EXPECT_EQ(pattern.vertices, 42);
  EXPECT_EQ(pattern.nonzeros(), 9 * 120 + 6 * 42);
}

TEST(BlockPattern, VertexWithoutTrianglesKeepsItsDiagonal) {
  const BlockPattern pattern = make_block_pattern(5, std::vector<Eigen::Vector3i>{{0, 2, 3}});
  EXPECT_EQ(pattern.column_begin[3 * 1 + 1] - pattern.column_begin[3 * 1], 3);
  EXPECT_EQ(pattern.row[pattern.column_begin[3 * 4]], 12);
}

TEST(BlockPattern, ExtendedKeepsItsValuesAndHasRoomForFurtherCouplings) {
  const BlockMatrix matrix = random_matrix(80, 0.5, 3);
  ASSERT_FALSE(is_coupled(matrix.pattern, 2, 40));
  const std::vector<std::array<int, 2>> couplings = {{40, 2}, {5, 30}, {2, 40}, {7, 7}};
  const ExtendedPattern extended = extend_block_pattern(matrix.pattern, couplings);
  EXPECT_EQ(extended.pattern.nonzeros(), matrix.pattern.nonzeros() + 2 * 9);
  EXPECT_TRUE(is_coupled(extended.pattern, 2, 40));
  EXPECT_TRUE(is_coupled(extended.pattern, 40, 2));
  EXPECT_FALSE(is_coupled(extended.pattern, 2, 30));
  std::vector<double> values(extended.pattern.nonzeros(), 0);
  for (int k = 0; k < matrix.pattern.nonzeros(); ++k) values[extended.entries[k]] = matrix.values[k];
  const Eigen::Matrix3d block = random_columns(3, 3, 9);
  add_block(extended.pattern, 40, 2, block, values);
  add_block(extended.pattern, 5, 30, block, values);
  add_block(extended.pattern, 3, 3, block + block.transpose(), values);
  Eigen::MatrixXd dense = matrix.dense;
  dense.block<3, 3>(120, 6) += block;
  dense.block<3, 3>(6, 120) += block.transpose();
  dense.block<3, 3>(15, 90) += block;
  dense.block<3, 3>(90, 15) += block.transpose();
  dense.block<3, 3>(9, 9) += block + block.transpose();
  EXPECT_LT((expanded(extended.pattern, values) - dense).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(BlockPattern, ProductWithAVectorIsTheDenseOne) {
  const BlockMatrix matrix = random_matrix(80, 0.5, 3);
  const Eigen::VectorXd x = random_columns(matrix.dense.rows(), 1, 8);
  Eigen::VectorXd y;
  multiply(matrix.pattern, matrix.values, x, y);
  EXPECT_LT((y - matrix.dense * x).cwiseAbs().maxCoeff(), 1e-13);
}

/// Elements of two vertices and two single unknowns each; the second names one vertex in both places.
TEST(BlockPattern, DenseElementsOfVerticesAndSingleUnknownsGoWhereTheDenseAssemblyPutsThem) {
  const int vertices = 4;
  const std::vector<std::array<int, 4>> elements = {{2, 0, 5, 4}, {3, 3, 4, 6}, {1, 2, 6, 5}};
  std::vector<std::array<int, 2>> couplings;
  for (const std::array<int, 4>& nodes : elements) {
    for (const int one : nodes) {
      for (const int other : nodes) couplings.push_back({one, other});
    }
  }
  const BlockPattern pattern =
      extend_block_pattern(make_block_pattern(vertices, std::vector<Eigen::Vector3i>{{0, 1, 3}}), couplings, 3).pattern;
  ASSERT_EQ(pattern.unknowns(), 15);
  std::vector<double> values(pattern.nonzeros(), 0);
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(15, 15);
  for (const std::array<int, 4>& nodes : elements) {
    std::array<int, 8> unknowns;
    for (int k = 0; k < 6; ++k) unknowns[k] = 3 * nodes[k / 3] + k % 3;
    for (int k = 0; k < 2; ++k) unknowns[6 + k] = pattern.first_unknown(nodes[2 + k]);
    const Eigen::MatrixXd root = random_columns(8, 8, 7);
    const Eigen::Matrix<double, 8, 8> part = root * root.transpose();
    add_dense(dense_addresses<8>(pattern, unknowns), part, values);
    for (int i = 0; i < 8; ++i) {
      for (int j = 0; j < 8; ++j) dense(unknowns[i], unknowns[j]) += part(i, j);
    }
  }
  EXPECT_LT((expanded(pattern, values) - dense).cwiseAbs().maxCoeff(), 1e-14);

  for (int k = 0; k < 15; ++k) values[entry_address(pattern, k, k)] += 1;
  const Eigen::VectorXd exact = Eigen::VectorXd::LinSpaced(15, -1, 2);
  Eigen::MatrixXd solution = dense * exact + exact;
  SparseFactor factor(pattern);
  ASSERT_TRUE(factor.factorize(values));
  factor.solve(solution);
  EXPECT_LT((solution - exact).cwiseAbs().maxCoeff(), 1e-12);
}

}  // namespace
}  // namespace thinwall
