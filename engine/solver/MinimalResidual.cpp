#include "engine/solver/MinimalResidual.hpp"

#include <Eigen/QR>

namespace thinwall {
namespace {

/// Part of a product that is new below which it is round-off.
constexpr double kNothingNew = 1e-14;

}  // namespace

MinimalResidual solve_by_minimal_residual(const Eigen::VectorXd& b, const LinearMap& map, double accuracy,
                                          int most_products) {
  MinimalResidual result{.solution = Eigen::VectorXd::Zero(b.size())};
  const double size = b.norm();
  if (size == 0) return result;
  Eigen::MatrixXd basis(b.size(), most_products + 1);
  Eigen::MatrixXd hessenberg = Eigen::MatrixXd::Zero(most_products + 1, most_products);
  basis.col(0) = b / size;
  Eigen::VectorXd shares;
  for (int k = 0; k < most_products; ++k) {
    Eigen::VectorXd next = basis.col(k) - map(basis.col(k));
    const double whole = next.norm();
    for (int j = 0; j <= k; ++j) {
      hessenberg(j, k) = basis.col(j).dot(next);
      next -= hessenberg(j, k) * basis.col(j);
    }
    hessenberg(k + 1, k) = next.norm();
    result.products = k + 1;
    const Eigen::MatrixXd left = hessenberg.topLeftCorner(k + 2, k + 1);
    const Eigen::VectorXd right = size * Eigen::VectorXd::Unit(k + 2, 0);
    shares = left.colPivHouseholderQr().solve(right);
    result.residual = (right - left * shares).norm() / size;
    if (result.residual <= accuracy || hessenberg(k + 1, k) <= kNothingNew * whole) break;
    basis.col(k + 1) = next / hessenberg(k + 1, k);
  }
  result.solution = basis.leftCols(result.products) * shares;
  return result;
}

}  // namespace thinwall
