#include "engine/equilibrium/PatchRelaxation.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

#include "engine/contact/ContinuousCollision.hpp"

namespace thinwall {
namespace {

constexpr int kMostIterations = 30;
constexpr int kMostHalvings = 8;

/// What is first added to the diagonal of a matrix that is not convex, as a part of the wall's stiffness, and how often
/// that is multiplied by ten.
constexpr double kFirstShift = 1e-6;
constexpr int kMostShifts = 12;

/// Part of the energy that a step foretells which it must bring (Armijo), and the same of the gradient.
constexpr double kEnoughEnergy = 1e-4;
constexpr double kEnoughGradient = 0.1;

/// A step, (unknowns of the patch), metres, that leads downhill; none where no shift makes the matrix convex.
Eigen::VectorXd step_of(const PatchEnergy& energy, double& shift) {
  Eigen::MatrixXd matrix;
  for (int attempt = 0; attempt <= kMostShifts; ++attempt) {
    matrix = energy.hessian();
    matrix.diagonal().array() += shift * energy.stiffness();
    const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factor(matrix);
    if (factor.info() == Eigen::Success) return -factor.solve(energy.gradient());
    shift = shift == 0 ? kFirstShift : 10 * shift;
  }
  return {};
}

double safe_fraction_of(const PatchEnergy& energy, const Eigen::VectorXd& position, const Eigen::VectorXd& motion) {
  double fraction = 1;
  for (const NearPair& pair : energy.folds()) {
    fraction = std::min(
        fraction, safe_fraction(pair.kind, corners_at(pair.vertices, position), corners_at(pair.vertices, motion)));
  }
  return fraction;
}

/// Takes as much of a step as makes things better; false where none does.
bool search(PatchEnergy& energy, Eigen::VectorXd& position, const Eigen::VectorXd& step) {
  const Eigen::VectorXd from = position;
  Eigen::VectorXd motion = Eigen::VectorXd::Zero(from.size());
  motion(energy.patch().unknowns) = step;
  const double before = energy.value(), slope = energy.gradient().dot(step), norm = energy.gradient().norm();
  double fraction = safe_fraction_of(energy, from, motion);
  for (int halving = 0; halving < kMostHalvings; ++halving, fraction *= 0.5) {
    position = from + fraction * motion;
    energy.evaluate(position, false);
    const bool gradient_fell = energy.gradient().norm() <= (1 - kEnoughGradient * fraction) * norm;
    if (gradient_fell || energy.value() <= before + kEnoughEnergy * fraction * slope) return true;
  }
  position = from;
  return false;
}

}  // namespace

Eigen::VectorXd relaxed(PatchEnergy& energy, const Eigen::VectorXd& position, double goal) {
  Eigen::VectorXd reached = position;
  double shift = 0;
  for (int iteration = 0; iteration < kMostIterations && energy.gradient().norm() > goal; ++iteration) {
    const Eigen::VectorXd step = step_of(energy, shift);
    shift = shift > kFirstShift ? 0.1 * shift : 0;
    if (step.size() == 0 || !search(energy, reached, step)) break;
    energy.evaluate(reached, true);
  }
  return reached;
}

}  // namespace thinwall
