#pragma once

#include <Eigen/Core>
#include <functional>

namespace thinwall {

/// A y for a linear map A of vectors of one size.
using LinearMap = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

struct MinimalResidual {
  Eigen::VectorXd solution;
  double residual = 0;  // |b - y + A y| / |b|
  int products = 0;     // with A
};

/// Solves y = b + A y for a map that is known by its products only, whether or not its powers die away: among the
/// combinations of b, A b, A^2 b, ... the one that leaves the least (GMRES; Saad and Schultz 1986, algorithm 3). Ends
/// below `accuracy`, after `most_products`, or where another product would add nothing.
MinimalResidual solve_by_minimal_residual(const Eigen::VectorXd& b, const LinearMap& map, double accuracy,
                                          int most_products);

}  // namespace thinwall
