#include <optional>

#include "engine/equilibrium/Newton.hpp"
#include "engine/equilibrium/OpenChambers.hpp"
#include "engine/solver/BorderedPart.hpp"
#include "engine/solver/MinimalResidual.hpp"

namespace thinwall {
namespace {

/// Of the forces on the rims of openings that the symmetric matrix leaves out, the part that may be missed: the step's
/// own error is of the order of its square. What slack lips do to them outgrows what the wall does, so they are not
/// found by repeating; so many products with them are the most that is worth its time.
constexpr double kRimAccuracy = 1e-3;
constexpr int kRimProducts = 30;

}  // namespace

Eigen::VectorXd Newton::left_out_at_rims(const EquilibriumProblem& problem, const EquilibriumState& state,
                                         const Step& first) {
  Eigen::VectorXd motion = Eigen::VectorXd::Zero(state.position.size());
  const auto at_rims = [&]() -> Eigen::VectorXd {
    Eigen::VectorXd forces = rim_forces(model_, problem, terms_, state.position, state.pressure, motion);
    clear_fixed(forces);
    return forces(rims_);
  };
  motion(rims_) = first.position(rims_);
  const Eigen::VectorXd pull = at_rims();
  LinearMap answer;
  Step part;
  std::optional<BorderedPart> system;
  if (problem.attachments.empty()) {
    system.emplace(used_factor(), bordered_, rims_);
    answer = [&](const Eigen::VectorXd& forces) {
      motion(rims_) = system->solve(forces);
      return at_rims();
    };
  } else {
    // Points that are held to tools are found by repeating, which asks for the whole.
    answer = [&](const Eigen::VectorXd& forces) {
      Eigen::VectorXd whole = Eigen::VectorXd::Zero(motion.size());
      whole(rims_) = forces;
      solve_linear(problem, whole, nullptr, part);
      motion(rims_) = part.position(rims_);
      return at_rims();
    };
  }
  Eigen::VectorXd left_out = Eigen::VectorXd::Zero(motion.size());
  left_out(rims_) = solve_by_minimal_residual(pull, answer, kRimAccuracy, kRimProducts).solution;
  return left_out;
}

}  // namespace thinwall
