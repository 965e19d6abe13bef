#pragma once

#include <Eigen/Core>

namespace thinwall {

/// Each column of one times each of the other, one after the other: Eigen's blocked product sums long columns in parts
/// that the processor's caches decide on, and so unlike on unlike processors.
inline Eigen::MatrixXd inner_products(const Eigen::MatrixXd& one, const Eigen::MatrixXd& other) {
  return one.transpose().lazyProduct(other);
}

}  // namespace thinwall
