#pragma once

#include <Eigen/Core>
#include <random>
#include <vector>

#include "engine/mesh/Shapes.hpp"
#include "engine/solver/BlockPattern.hpp"

namespace thinwall {

/// A matrix assembled twice from the same random symmetric contributions of triangles: sparse and dense.
struct BlockMatrix {
  BlockPattern pattern;
  std::vector<double> values;
  Eigen::MatrixXd dense;
};

/// Positive semidefinite contributions B B^T plus `shift` on the diagonal, over the triangles of a sphere; its vertices
/// are numbered without regard to neighbourhood.
inline BlockMatrix random_matrix(int triangles, double shift, unsigned seed) {
  const SurfaceMesh mesh = make_sphere(1, triangles);
  const int vertices = static_cast<int>(mesh.vertices.size());
  BlockMatrix matrix{.pattern = make_block_pattern(vertices, mesh.triangles), .values = {}, .dense = {}};
  matrix.values.assign(matrix.pattern.nonzeros(), 0);
  matrix.dense.setZero(3 * vertices, 3 * vertices);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    Eigen::Matrix<double, 9, 3> factor;
    for (double& entry : factor.reshaped()) entry = number(random);
    const Eigen::Matrix<double, 9, 9> part = factor * factor.transpose();
    add_triangle(triangle_addresses(matrix.pattern, triangle), part, matrix.values);
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) {
        matrix.dense.block<3, 3>(3 * triangle[a], 3 * triangle[b]) += part.block<3, 3>(3 * a, 3 * b);
      }
    }
  }
  for (int column = 0; column < 3 * vertices; ++column) {
    matrix.values[matrix.pattern.column_begin[column]] += shift;
    matrix.dense(column, column) += shift;
  }
  return matrix;
}

inline Eigen::MatrixXd random_columns(Eigen::Index rows, Eigen::Index columns, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  Eigen::MatrixXd result(rows, columns);
  for (double& entry : result.reshaped()) entry = number(random);
  return result;
}

}  // namespace thinwall
