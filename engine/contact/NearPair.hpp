#pragma once

#include "engine/contact/PairDistance.hpp"

namespace thinwall {

/// Two parts of a wall that may come to push each other, and what the stress-free shape says of them.
struct NearPair {
  PairKind kind = PairKind::kPointTriangle;
  Eigen::Vector4i vertices = Eigen::Vector4i::Zero();
  double range = 0;     // metres, below which they push
  double area = 0;      // metres^2, that the pair stands for
  double parallel = 0;  // metres^4, see FoldPair
};

/// The parts at a position, or their motions. `vectors`: (3 vertices).
inline PairCorners corners_at(const Eigen::Vector4i& vertices, const Eigen::VectorXd& vectors) {
  return {vectors.segment<3>(3 * vertices[0]), vectors.segment<3>(3 * vertices[1]), vectors.segment<3>(3 * vertices[2]),
          vectors.segment<3>(3 * vertices[3])};
}

}  // namespace thinwall
