#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/contact/NearPair.hpp"
#include "engine/equilibrium/Equilibrium.hpp"
#include "engine/equilibrium/WallPatch.hpp"

namespace thinwall {

/// The energy of a membrane by the unknowns of a patch, all others held: that of the wall, of its contacts with itself,
/// of inertia and of the least motion of a slack wall, and the work of all other forces, which stay as they are at the
/// position where it begins.
class PatchEnergy {
 public:
  /// `folds`: pairs with a vertex in the patch, `fold_pressure`: of their potentials, pascal. `position`: (unknowns of
  /// the body), metres; `force`: (unknowns of the body), newton, gradient of all there. What is given outlives it.
  PatchEnergy(const BodyModel& model, const EquilibriumProblem& problem, const WallPatch& patch,
              std::vector<NearPair> folds, double fold_pressure, const Eigen::VectorXd& position,
              const Eigen::VectorXd& force);

  /// At a position of the body, (unknowns), metres. Without `with_hessian` the Hessian stays as it was.
  void evaluate(const Eigen::VectorXd& position, bool with_hessian);

  const WallPatch& patch() const { return patch_; }
  const std::vector<NearPair>& folds() const { return folds_; }
  double value() const { return value_; }                        // joule, not finite where the wall has collapsed
  const Eigen::VectorXd& gradient() const { return gradient_; }  // (unknowns of the patch), newton
  const Eigen::MatrixXd& hessian() const { return hessian_; }    // the lower triangle, newton / metre
  double stiffness() const { return model_.wall_stiffness; }     // newton / metre, of which it has some

 private:
  void add_wall(const Eigen::VectorXd& position, bool with_hessian);
  void add_slack(const Eigen::VectorXd& position, bool with_hessian);
  void add_folds(const Eigen::VectorXd& position, bool with_hessian);
  void add_inertia(const Eigen::VectorXd& position, bool with_hessian);
  void add_to_hessian(int row, int column, double value);

  const BodyModel& model_;
  const EquilibriumProblem& problem_;
  const WallPatch& patch_;
  std::vector<NearPair> folds_;
  double fold_pressure_;   // pascal
  Eigen::VectorXd start_;  // (unknowns of the patch), metres
  Eigen::VectorXd dead_;   // (unknowns of the patch), newton, less all other forces
  double value_ = 0;
  Eigen::VectorXd gradient_;
  Eigen::MatrixXd hessian_;
};

}  // namespace thinwall
