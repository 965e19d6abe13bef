#include "engine/equilibrium/Newton.hpp"

namespace thinwall {

void Newton::begin_shafts(const EquilibriumProblem& problem, const EquilibriumState& state) {
  branches_.clear();
  for (const ShaftContact& shaft : problem.shafts) {
    for (const ShaftPoint& point : shaft.points) {
      branches_.push_back(shaft.branch_at(point, state.position.segment<3>(3 * point.vertex)));
    }
  }
}

template <typename Visit>
void Newton::visit_changed_shafts(const EquilibriumProblem& problem, const EquilibriumState& state,
                                  const Visit& visit) const {
  std::size_t k = 0;
  for (const ShaftContact& shaft : problem.shafts) {
    for (const ShaftPoint& point : shaft.points) {
      const Eigen::Vector3d place = state.position.segment<3>(3 * point.vertex);
      const ShaftBranch &assumed = branches_[k++], own = shaft.branch_at(point, place);
      if (point.touches && assumed != own)
        visit(point, shaft.along(assumed, point, place), shaft.along(own, point, place));
    }
  }
}

void Newton::add_changed_shafts(const EquilibriumProblem& problem, const EquilibriumState& state) {
  visit_changed_shafts(problem, state, [&](const ShaftPoint& point, const ShaftTerms& assumed, const ShaftTerms& own) {
    add_vertex(model_, point.vertex, assumed.hessian - own.hessian, matrix_);
  });
}

Eigen::VectorXd Newton::changed_shaft_force(const EquilibriumProblem& problem, const EquilibriumState& state) const {
  Eigen::VectorXd force = Eigen::VectorXd::Zero(state.position.size());
  visit_changed_shafts(problem, state, [&](const ShaftPoint& point, const ShaftTerms& assumed, const ShaftTerms& own) {
    force.segment<3>(3 * point.vertex) += own.gradient - assumed.gradient;
  });
  clear_fixed(force);
  return force;
}

bool Newton::revise_shafts(const EquilibriumProblem& problem, const EquilibriumState& state, const Step& step) {
  bool is_revised = false;
  std::size_t k = 0;
  for (const ShaftContact& shaft : problem.shafts) {
    for (const ShaftPoint& point : shaft.points) {
      const auto at = 3 * static_cast<Eigen::Index>(point.vertex);
      const ShaftBranch reached = shaft.branch_at(point, state.position.segment<3>(at) + step.position.segment<3>(at));
      ShaftBranch& assumed = branches_[k++];
      if (!point.touches || reached == assumed) continue;
      // From sliding one way to sliding the other a vertex comes through where friction holds it.
      const bool turns = reached.slides * assumed.slides < 0;
      assumed = {.presses = reached.presses, .slides = turns ? 0 : reached.slides};
      is_revised = true;
    }
  }
  return is_revised;
}

}  // namespace thinwall
