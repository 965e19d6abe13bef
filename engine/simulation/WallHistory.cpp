#include "engine/simulation/WallHistory.hpp"

#include <cmath>

#include "engine/shell/BendingPatches.hpp"
#include "engine/simulation/BackwardDifference.hpp"
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
  return wall_response(material, c, model.definition.tension_field, model.slack_stiffness).second_piola_kirchhoff;
}

Eigen::Matrix3d unstrained_tangent(const BodyModel& model, int triangle) {
  const Material& material = model.material(triangle);
  return material.law->respond(material.parameters, Eigen::Vector3d(1, 1, 0)).tangent;
}

void find_bending_strains(const BodyModel& model, const Eigen::VectorXd& position, WallHistory& history) {
  history.bending_strain.clear();
  history.law_moment.clear();
  for (const BendingRest& rest : model.bending) {
    history.bending_strain.push_back(bending_strain(rest, patch_of(rest, position, model.vertices())));
    history.law_moment.push_back(rest.stiffness * history.bending_strain.back());
  }
}

Eigen::Vector3d strain_of(const BodyModel& model, int triangle, const Eigen::VectorXd& position) {
  return green_lagrange_strain(model.rest[triangle], corners_of(model.surface[triangle], position));
}

/// The same of bending.
double remember_bending(const BodyModel& model, const Eigen::VectorXd& position, double duration,
                        const WallMemory& whole, WallHistory& history) {
  const double lasting = lasting_part(model.definition);
  double loss = 0;
  for (int t = 0; t < static_cast<int>(model.bending.size()); ++t) {
    const BendingRest& rest = model.bending[t];
    const Eigen::Vector3d strain = bending_strain(rest, patch_of(rest, position, model.vertices()));
    const Eigen::Vector3d moment = rest.stiffness * strain;
    const BendingMemory memory = whole.of_bending(t);
    const Eigen::Vector3d overmoment = (memory.scale - lasting) * moment + memory.overmoment;
    for (std::size_t k = 0; k < model.definition.viscosity.size(); ++k) {
      const PronyStep step = prony_step(model.definition.viscosity[k], duration);
      Eigen::Vector3d& branch = history.branch_moment[k][t];
      branch = step.fade * branch + step.share * (moment - history.law_moment[t]);
    }
    loss += 0.5 * rest.area * (history.overmoment[t] + overmoment).dot(strain - history.bending_strain[t]);
    history.previous_bending_strain[t] = history.bending_strain[t];
    history.bending_strain[t] = strain;
    history.law_moment[t] = moment;
    history.overmoment[t] = overmoment;
  }
  return loss;
}

}  // namespace

double lasting_part(const BodyDefinition& definition) {
  double part = 1;
  for (const PronyTerm& term : definition.viscosity) part -= term.fraction;
  return part;
}

void find_strains(const BodyModel& model, const Eigen::VectorXd& position, WallHistory& history) {
  if (!is_viscous(model.definition)) return;
  history.strain.clear();
  history.law_stress.clear();
  for (int t = 0; t < model.triangles(); ++t) {
    history.strain.push_back(strain_of(model, t, position));
    history.law_stress.push_back(law_stress(model, t, history.strain[t]));
  }
  find_bending_strains(model, position, history);
}

WallHistory rested_history(const BodyModel& model, const Eigen::VectorXd& position) {
  WallHistory history;
  if (!is_viscous(model.definition)) return history;
  find_strains(model, position, history);
  history.previous_strain = history.strain;
  const std::vector<Eigen::Vector3d> none(model.triangles(), Eigen::Vector3d::Zero());
  history.branch_stress.assign(model.definition.viscosity.size(), none);
  history.overstress = none;
  const std::vector<Eigen::Vector3d> unbent(model.bending.size(), Eigen::Vector3d::Zero());
  history.previous_bending_strain = history.bending_strain;
  history.branch_moment.assign(model.definition.viscosity.size(), unbent);
  history.overmoment = unbent;
  return history;
}

void stop_damping(const BodyModel& model, WallHistory& history) {
  if (model.definition.damping.stiffness_time == 0) return;
  for (int t = 0; t < model.triangles(); ++t) {
    history.overstress[t].setZero();
    for (const std::vector<Eigen::Vector3d>& branch : history.branch_stress) history.overstress[t] += branch[t];
  }
  for (std::size_t t = 0; t < model.bending.size(); ++t) {
    history.overmoment[t].setZero();
    for (const std::vector<Eigen::Vector3d>& branch : history.branch_moment) history.overmoment[t] += branch[t];
  }
}

WallMemory memory_after(const BodyModel& model, const WallHistory& history, const HistoryStep& step) {
  const BodyDefinition& definition = model.definition;
  WallMemory memory;
  if (!is_viscous(definition)) return memory;
  memory.scale = lasting_part(definition);
  memory.overstress.assign(model.triangles(), Eigen::Vector3d::Zero());
  memory.overmoment.assign(model.bending.size(), Eigen::Vector3d::Zero());
  for (std::size_t k = 0; k < definition.viscosity.size(); ++k) {
    const PronyStep prony = prony_step(definition.viscosity[k], step.duration);
    memory.scale += prony.share;
    for (int t = 0; t < model.triangles(); ++t) {
      memory.overstress[t] += prony.fade * history.branch_stress[k][t] - prony.share * history.law_stress[t];
    }
    for (std::size_t t = 0; t < model.bending.size(); ++t) {
      memory.overmoment[t] += prony.fade * history.branch_moment[k][t] - prony.share * history.law_moment[t];
    }
  }
  if (definition.damping.stiffness_time == 0 || !step.is_damped) return memory;
  const BackwardDifference difference = backward_difference(step.duration, step.previous);
  const double factor = definition.damping.stiffness_time / step.duration;
  memory.damping = factor * difference.now;
  for (int t = 0; t < model.triangles(); ++t) {
    memory.overstress[t] += factor * unstrained_tangent(model, t) *
                            (difference.before * history.strain[t] + difference.earlier * history.previous_strain[t]);
  }
  for (std::size_t t = 0; t < model.bending.size(); ++t) {
    memory.overmoment[t] +=
        factor * (difference.before * history.law_moment[t] +
                  difference.earlier * model.bending[t].stiffness * history.previous_bending_strain[t]);
  }
  return memory;
}

double remember(const BodyModel& model, const Eigen::VectorXd& position, double duration, const WallMemory& memory,
                WallHistory& history) {
  const BodyDefinition& definition = model.definition;
  if (!is_viscous(definition)) return 0;
  const double lasting = lasting_part(definition);
  double loss = remember_bending(model, position, duration, memory, history);
  for (int t = 0; t < model.triangles(); ++t) {
    const Eigen::Vector3d strain = strain_of(model, t, position);
    const Eigen::Vector3d stress = law_stress(model, t, strain);
    Eigen::Vector3d overstress = (memory.scale - lasting) * stress + memory.overstress[t];
    if (memory.damping > 0) overstress += memory.damping * unstrained_tangent(model, t) * strain;
    for (std::size_t k = 0; k < definition.viscosity.size(); ++k) {
      const PronyStep step = prony_step(definition.viscosity[k], duration);
      Eigen::Vector3d& branch = history.branch_stress[k][t];
      branch = step.fade * branch + step.share * (stress - history.law_stress[t]);
    }
    const double volume = model.rest[t].area * model.rest[t].thickness;
    loss += 0.5 * volume * (history.overstress[t] + overstress).dot(strain - history.strain[t]);
    history.previous_strain[t] = history.strain[t];
    history.strain[t] = strain;
    history.law_stress[t] = stress;
    history.overstress[t] = overstress;
  }
  return loss;
}

Eigen::Matrix2Xd principal_stress(const BodyModel& model, const Eigen::VectorXd& position, const WallHistory& history) {
  Eigen::Matrix2Xd stress(2, model.triangles());
  const bool viscous = is_viscous(model.definition);
  const double lasting = lasting_part(model.definition);
  for (int t = 0; t < model.triangles(); ++t) {
    const Eigen::Vector3d strain = strain_of(model, t, position);
    Eigen::Vector3d total = law_stress(model, t, strain);
    if (viscous) total = lasting * total + history.overstress[t];
    stress.col(t) = principal_cauchy_stress(total, {1 + 2 * strain[0], 1 + 2 * strain[1], strain[2]});
  }
  return stress;
}

}  // namespace thinwall
