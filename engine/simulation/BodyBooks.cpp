#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/simulation/Body.hpp"
#include "engine/simulation/Leakage.hpp"
#include "engine/simulation/ToolFriction.hpp"

namespace thinwall {
namespace {

const FluidInput& input_of(const BodyInput& input, Eigen::Index chamber) {
  static const FluidInput nothing;
  return chamber < static_cast<Eigen::Index>(input.fluids.size()) ? input.fluids[chamber] : nothing;
}

/// Volume of fluid that a chamber holds at a pressure within a wall of given volume.
double fluid_volume_at(const BodyModel& model, double volume, double pressure, double reference) {
  const FluidDefinition& fluid = model.definition.fluid;
  return fluid.kind == FluidKind::kCompressible ? volume / (1 - (pressure - reference) / fluid.bulk_modulus) : volume;
}

}  // namespace

double EnergyBooks::largest() const {
  double most = 0;
  for (const double term : {elastic, bending, kinetic, fluid, gravity, contact, viscous, friction, leak, fracture, jump,
                            tool_work, script_work}) {
    most = std::max(most, std::abs(term));
  }
  return most;
}

double fluid_energy(const BodyModel& model, const BodyState& state) {
  if (model.definition.fluid.kind != FluidKind::kCompressible) return 0;
  double energy = 0;
  for (Eigen::Index c = 0; c < state.volume.size(); ++c) {
    if (state.fluid_volume[c] == 0) continue;  // all has run out
    // Beside air the fluid does not fill the chamber.
    const double beyond_reference = bulk_pressure_of(state, static_cast<int>(c)) - state.reference_pressure[c];
    const double excess = state.air[c] > 0
                              ? -beyond_reference * state.fluid_volume[c] / model.definition.fluid.bulk_modulus
                              : state.volume[c] - state.fluid_volume[c];
    energy += -state.reference_pressure[c] * excess +
              0.5 * model.definition.fluid.bulk_modulus * excess * excess / state.fluid_volume[c];
  }
  return energy;
}

double Body::rate(const OrificeDefinition& orifice, const BodyState& state) const {
  return flow_between(*model_, orifice, options_.gravity, state.equilibrium.pressure).rate;
}

double Body::gravity_energy() const {
  double energy = newton_->terms().gravity + state_.leaked_gravity;
  // At the level where the pressure is told the whole fluid counts by its weight, whatever space it is compressed to.
  for (Eigen::Index c = 0; c < state_.volume.size(); ++c) {
    energy -=
        model_->definition.fluid.density * options_.gravity.dot(model_->chambers[c].level) * state_.fluid_volume[c];
  }
  return energy;
}

void Body::add_fluids(double duration, const BodyInput& input, EquilibriumProblem& problem) const {
  for (Eigen::Index c = 0; c < state_.fluid_volume.size(); ++c) {
    const FluidInput& given = input_of(input, c);
    FluidProblem fluid{.mode = fluid_mode(),
                       .pressure = state_.reference_pressure[c],
                       .fluid_volume = state_.fluid_volume[c] + given.added,
                       .bulk_modulus = model_->definition.fluid.bulk_modulus};
    if (given.pressure) {
      fluid.mode = FluidMode::kGivenPressure;
      fluid.pressure = *given.pressure;
    }
    problem.fluids.push_back(fluid);
  }
  const std::vector<OrificeDefinition>& orifices = model_->definition.fluid.orifices;
  if (orifices.empty()) return;
  problem.orifice_time = state_.exchange.time(duration);
  for (std::size_t k = 0; k < orifices.size(); ++k) {
    const double share = state_.exchange.share(k, duration);
    problem.fluids[orifices[k].from].fluid_volume -= share;
    problem.fluids[orifices[k].to].fluid_volume += share;
  }
}

void Body::update_fluids(double duration, const BodyInput& input, const EquilibriumProblem& problem) {
  for (Eigen::Index c = 0; c < state_.fluid_volume.size(); ++c) state_.fluid_volume[c] += input_of(input, c).added;
  const std::vector<OrificeDefinition>& orifices = model_->definition.fluid.orifices;
  FlowMemory exchange{.step = duration};
  for (std::size_t k = 0; k < orifices.size(); ++k) {
    const double flown =
        state_.exchange.share(k, duration) + state_.exchange.time(duration) * rate(orifices[k], state_);
    state_.fluid_volume[orifices[k].from] -= flown;
    state_.fluid_volume[orifices[k].to] += flown;
    exchange.volumes.push_back(flown);
  }
  state_.exchange = exchange;
  leak(*model_, options_.gravity, duration, problem, newton_->terms(), state_);
  for (Eigen::Index c = 0; c < state_.fluid_volume.size(); ++c) {
    if (!input_of(input, c).pressure) continue;
    state_.fluid_volume[c] =
        fluid_volume_at(*model_, state_.volume[c], state_.equilibrium.pressure[c], state_.reference_pressure[c]);
  }
}

double Body::book_fluids(const BodyState& before) {
  if (state_.volume.size() == 0) return 0;
  // All at one level, because fluid that moves from one level to another changes its energy in gravity.
  const Eigen::VectorXd mean =
      pressures_at_origin(*model_, options_.gravity, 0.5 * (before.equilibrium.pressure + state_.equilibrium.pressure));
  double lost = 0;
  const std::vector<OrificeDefinition>& orifices = model_->definition.fluid.orifices;
  for (std::size_t k = 0; k < orifices.size(); ++k) {
    lost += state_.exchange.volumes[k] * (mean[orifices[k].from] - mean[orifices[k].to]);
  }
  const double reached = mean.dot(state_.fluid_volume - before.fluid_volume + state_.leaked - before.leaked);
  state_.books.viscous += lost;
  state_.books.script_work += reached + lost;
  return reached;
}

double Body::work_of_solids(const BodyState& before, std::span<const ToolPose> begin,
                            const EquilibriumProblem& problem) const {
  double work = 0;
  std::size_t k = 0;
  for (std::size_t tool = 0; tool < tools_.size(); ++tool) {
    for (const ToolSolid& solid : contact_solids(tools_[tool], begin[tool])) {
      const ToolSolid& after = problem.solids[k].solid;
      const ToolContact &first = before.solid_contacts[k], &last = state_.solid_contacts[k];
      const Eigen::AngleAxisd turn(Eigen::Matrix3d(after.frame * solid.frame.transpose()));
      work -= 0.5 * (first.force + last.force).dot(after.center - solid.center);
      work -= 0.5 * turn.angle() * (first.moment + last.moment).dot(turn.axis());
      ++k;
    }
  }
  return work;
}

void Body::book_stored(double on_shafts) {
  EnergyBooks& books = state_.books;
  const EquilibriumTerms& terms = newton_->terms();
  books.elastic = lasting_part(model_->definition) * terms.strain_energy;
  books.bending = lasting_part(model_->definition) * terms.bending_energy;
  books.kinetic = 0.5 * model_->mass.dot(state_.velocity.cwiseAbs2()) + fluid_kinetic_energy(*model_, state_);
  books.gravity = gravity_energy();
  books.contact = contact_energy(terms) + terms.folds.energy + state_.friction_energy + on_shafts;
  books.fluid = fluid_energy(*model_, state_);
}

void Body::update_books(const BodyState& before, std::span<const ToolPose> begin, double duration,
                        const EquilibriumProblem& problem, const BodyInput& input) {
  EnergyBooks& books = state_.books;
  const double wall_loss = remember(*model_, state_.equilibrium.position, duration, problem.memory, state_.wall);
  const double leak_loss = book_leaks(*model_, options_.gravity, before, state_);
  const ShaftBooks shafts = book_shafts(problem, begin);
  const double friction_loss =
      remember_friction(*model_, before, contact_solids(tools_, begin), problem, state_) + shafts.friction;
  book_stored(shafts.stored);

  // Work by the trapezoidal rule; what it differs from the change of the energies is what the integrator spends.
  const Eigen::VectorXd motion = state_.equilibrium.position - before.equilibrium.position;
  double attached_work = 0;
  for (const std::vector<Attachment>* attachments : {&before.attachments, &std::as_const(state_).attachments}) {
    for (const Attachment& attachment : *attachments) {
      attached_work -= 0.5 * attachment.force.dot(material_point(attachment, motion));
    }
  }
  const double solid_work = work_of_solids(before, begin, problem) + shafts.tool_work;
  track_pressing(before, begin, problem);
  const double fluid_work = book_fluids(before);
  const double load_work = 0.5 * (before.load_force + state_.load_force).dot(motion);
  const double kinetic_work = 0.5 * model_->mass.cwiseProduct(before.acceleration + state_.acceleration).dot(motion);
  const double static_work =
      0.5 * (before.static_force + state_.static_force).dot(motion) + solid_work + load_work + fluid_work;
  const double mass_rate = snaps_ ? 0 : model_->definition.damping.mass_rate;
  const double damping_loss =
      0.5 * mass_rate * model_->mass.cwiseProduct(before.velocity + state_.velocity).dot(motion);
  books.numerical +=
      kinetic_work + static_work - wall_loss - friction_loss - leak_loss - (books.stored() - before.books.stored());
  for (const Eigen::VectorXd* drag : {&before.drag_force, &std::as_const(state_).drag_force}) {
    if (drag->size() > 0) books.numerical -= 0.5 * drag->dot(motion);
  }
  books.viscous += wall_loss + damping_loss;
  books.friction += friction_loss;
  books.leak += leak_loss;
  books.tool_work += attached_work + solid_work;
  books.script_work += load_work - book_cut(before.cut, motion, input.blade);
}

}  // namespace thinwall
