#include <cmath>

#include "engine/shell/BendingPatches.hpp"
#include "engine/simulation/BackwardDifference.hpp"
#include "engine/simulation/Body.hpp"
#include "engine/wall/TensionField.hpp"

namespace thinwall {
namespace {

/// Weights of the exact recursion of a Prony term over a step (Taylor, Pister and Goudreau 1970; Simo and Hughes 1998,
/// section 10.3): the stress of the branch fades by `fade`, and takes `share` of what the law's stress has grown by,
/// exactly where that grows evenly.
struct PronyStep {
  double fade, share;
};
PronyStep prony_step(const PronyTerm& term, double duration) {
  const double x = duration / term.time;
  return {.fade = std::exp(-x), .share = term.fraction * (-std::expm1(-x) / x)};
}

bool is_viscous(const BodyDefinition& definition) {
  return !definition.viscosity.empty() || definition.damping.stiffness_time > 0;
}

Eigen::Vector3d law_stress(const BodyModel& model, int triangle, const Eigen::Vector3d& strain) {
  const Material& material = model.material(triangle);
  const Eigen::Vector3d c(1 + 2 * strain[0], 1 + 2 * strain[1], strain[2]);
  return wall_response(material, c, model.definition.tension_field).second_piola_kirchhoff;
}

Eigen::Matrix3d unstrained_tangent(const BodyModel& model, int triangle) {
  const Material& material = model.material(triangle);
  return material.law->respond(material.parameters, Eigen::Vector3d(1, 1, 0)).tangent;
}

void find_bending_strains(const BodyModel& model, const Eigen::VectorXd& position, WallHistory& wall) {
  wall.bending_strain.clear();
  wall.law_moment.clear();
  for (const BendingRest& rest : model.bending) {
    wall.bending_strain.push_back(bending_strain(rest, patch_of(rest, position, model.vertices())));
    wall.law_moment.push_back(rest.stiffness * wall.bending_strain.back());
  }
}

Eigen::Vector3d strain_of(const BodyModel& model, int triangle, const Eigen::VectorXd& position) {
  return green_lagrange_strain(model.rest[triangle], corners_of(model.surface[triangle], position));
}

}  // namespace

double lasting_part(const BodyDefinition& definition) {
  double part = 1;
  for (const PronyTerm& term : definition.viscosity) part -= term.fraction;
  return part;
}

void Body::find_strains() {
  if (!is_viscous(model_->definition)) return;
  WallHistory& wall = state_.wall;
  wall.strain.clear();
  wall.law_stress.clear();
  for (int t = 0; t < model_->triangles(); ++t) {
    wall.strain.push_back(strain_of(*model_, t, state_.equilibrium.position));
    wall.law_stress.push_back(law_stress(*model_, t, wall.strain[t]));
  }
  find_bending_strains(*model_, state_.equilibrium.position, wall);
}

void Body::start_memory() {
  if (!is_viscous(model_->definition)) return;
  find_strains();
  WallHistory& wall = state_.wall;
  wall.previous_strain = wall.strain;
  const std::vector<Eigen::Vector3d> none(model_->triangles(), Eigen::Vector3d::Zero());
  wall.branch_stress.assign(model_->definition.viscosity.size(), none);
  wall.overstress = none;
  const std::vector<Eigen::Vector3d> unbent(model_->bending.size(), Eigen::Vector3d::Zero());
  wall.previous_bending_strain = wall.bending_strain;
  wall.branch_moment.assign(model_->definition.viscosity.size(), unbent);
  wall.overmoment = unbent;
}

void Body::stop_damping() {
  WallHistory& wall = state_.wall;
  if (model_->definition.damping.stiffness_time == 0) return;
  for (int t = 0; t < model_->triangles(); ++t) {
    wall.overstress[t].setZero();
    for (const std::vector<Eigen::Vector3d>& branch : wall.branch_stress) wall.overstress[t] += branch[t];
  }
  for (std::size_t t = 0; t < model_->bending.size(); ++t) {
    wall.overmoment[t].setZero();
    for (const std::vector<Eigen::Vector3d>& branch : wall.branch_moment) wall.overmoment[t] += branch[t];
  }
}

void Body::add_memory(double duration, EquilibriumProblem& problem) const {
  const BodyDefinition& definition = model_->definition;
  if (!is_viscous(definition)) return;
  const WallHistory& wall = state_.wall;
  problem.memory.scale = lasting_part(definition);
  problem.memory.overstress.assign(model_->triangles(), Eigen::Vector3d::Zero());
  problem.memory.overmoment.assign(model_->bending.size(), Eigen::Vector3d::Zero());
  for (std::size_t k = 0; k < definition.viscosity.size(); ++k) {
    const PronyStep step = prony_step(definition.viscosity[k], duration);
    problem.memory.scale += step.share;
    for (int t = 0; t < model_->triangles(); ++t) {
      problem.memory.overstress[t] += step.fade * wall.branch_stress[k][t] - step.share * wall.law_stress[t];
    }
    for (std::size_t t = 0; t < model_->bending.size(); ++t) {
      problem.memory.overmoment[t] += step.fade * wall.branch_moment[k][t] - step.share * wall.law_moment[t];
    }
  }
  if (definition.damping.stiffness_time == 0 || snaps_) return;
  const BackwardDifference difference = backward_difference(duration, state_.previous_step);
  const double factor = definition.damping.stiffness_time / duration;
  problem.memory.damping = factor * difference.now;
  for (int t = 0; t < model_->triangles(); ++t) {
    problem.memory.overstress[t] += factor * unstrained_tangent(*model_, t) *
                                    (difference.before * wall.strain[t] + difference.earlier * wall.previous_strain[t]);
  }
  for (std::size_t t = 0; t < model_->bending.size(); ++t) {
    problem.memory.overmoment[t] +=
        factor * (difference.before * wall.law_moment[t] +
                  difference.earlier * model_->bending[t].stiffness * wall.previous_bending_strain[t]);
  }
}

Eigen::Matrix2Xd Body::principal_stress() const {
  Eigen::Matrix2Xd stress(2, model_->triangles());
  const bool viscous = is_viscous(model_->definition);
  const double lasting = lasting_part(model_->definition);
  for (int t = 0; t < model_->triangles(); ++t) {
    const Eigen::Vector3d strain = strain_of(*model_, t, state_.equilibrium.position);
    Eigen::Vector3d total = law_stress(*model_, t, strain);
    if (viscous) total = lasting * total + state_.wall.overstress[t];
    stress.col(t) = principal_cauchy_stress(total, {1 + 2 * strain[0], 1 + 2 * strain[1], strain[2]});
  }
  return stress;
}

double Body::update_bending_memory(double duration, const EquilibriumProblem& problem) {
  WallHistory& wall = state_.wall;
  const double lasting = lasting_part(model_->definition);
  double loss = 0;
  for (int t = 0; t < static_cast<int>(model_->bending.size()); ++t) {
    const BendingRest& rest = model_->bending[t];
    const Eigen::Vector3d strain =
        bending_strain(rest, patch_of(rest, state_.equilibrium.position, model_->vertices()));
    const Eigen::Vector3d moment = rest.stiffness * strain;
    const BendingMemory memory = problem.memory.of_bending(t);
    const Eigen::Vector3d overmoment = (memory.scale - lasting) * moment + memory.overmoment;
    for (std::size_t k = 0; k < model_->definition.viscosity.size(); ++k) {
      const PronyStep step = prony_step(model_->definition.viscosity[k], duration);
      Eigen::Vector3d& branch = wall.branch_moment[k][t];
      branch = step.fade * branch + step.share * (moment - wall.law_moment[t]);
    }
    loss += 0.5 * rest.area * (wall.overmoment[t] + overmoment).dot(strain - wall.bending_strain[t]);
    wall.previous_bending_strain[t] = wall.bending_strain[t];
    wall.bending_strain[t] = strain;
    wall.law_moment[t] = moment;
    wall.overmoment[t] = overmoment;
  }
  return loss;
}

double Body::update_memory(double duration, const EquilibriumProblem& problem) {
  const BodyDefinition& definition = model_->definition;
  if (!is_viscous(definition)) return 0;
  WallHistory& wall = state_.wall;
  const double lasting = lasting_part(definition);
  double loss = update_bending_memory(duration, problem);
  for (int t = 0; t < model_->triangles(); ++t) {
    const Eigen::Vector3d strain = strain_of(*model_, t, state_.equilibrium.position);
    const Eigen::Vector3d stress = law_stress(*model_, t, strain);
    Eigen::Vector3d overstress = (problem.memory.scale - lasting) * stress + problem.memory.overstress[t];
    if (problem.memory.damping > 0) overstress += problem.memory.damping * unstrained_tangent(*model_, t) * strain;
    for (std::size_t k = 0; k < definition.viscosity.size(); ++k) {
      const PronyStep step = prony_step(definition.viscosity[k], duration);
      Eigen::Vector3d& branch = wall.branch_stress[k][t];
      branch = step.fade * branch + step.share * (stress - wall.law_stress[t]);
    }
    const double volume = model_->rest[t].area * model_->rest[t].thickness;
    loss += 0.5 * volume * (wall.overstress[t] + overstress).dot(strain - wall.strain[t]);
    wall.previous_strain[t] = wall.strain[t];
    wall.strain[t] = strain;
    wall.law_stress[t] = stress;
    wall.overstress[t] = overstress;
  }
  return loss;
}

}  // namespace thinwall
