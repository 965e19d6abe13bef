#include "engine/simulation/Body.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "engine/simulation/SimulationFailure.hpp"

namespace thinwall {
namespace {

/// How often `relax` solves with springs before it gives up.
constexpr int kRelaxationTurns = 100;

/// Multiple of the rest volume beyond which a body under a given pressure has burst: past its limit point a wall under
/// constant pressure grows without end.
constexpr double kBurstVolume = 30;

/// Gap at which the wall rests on a tool: small beside any depth that matters, whatever the mesh.
double contact_range(const ToolDefinition& tool) {
  return std::min(10e-6, 1e-4 * tool.radius);  // metres
}

std::vector<ToolPose> interpolate(std::span<const ToolPose> begin, std::span<const ToolPose> end, double fraction) {
  std::vector<ToolPose> poses(begin.begin(), begin.end());
  for (std::size_t k = 0; k < poses.size(); ++k) {
    poses[k].tip += fraction * (end[k].tip - begin[k].tip);
    poses[k].direction += fraction * (end[k].direction - begin[k].direction);
    poses[k].direction.normalize();
    poses[k].axis += fraction * (end[k].axis - begin[k].axis);
    poses[k].axis -= poses[k].direction * poses[k].direction.dot(poses[k].axis);
    poses[k].axis.normalize();
  }
  return poses;
}

Eigen::Vector3d prescribed_point(const Attachment& attachment, const ToolPose& pose) {
  return pose.tip + attachment.offset.x() * pose.axis.cross(pose.direction) + attachment.offset.y() * pose.axis;
}

SphereTool sphere_at(const ToolDefinition& tool, const ToolPose& pose) {
  return {.center = pose.tip - tool.radius * pose.direction, .radius = tool.radius};
}

/// Coefficients of the second-order backward difference of a step h after one of h / ratio:
/// y' = (now y1 + before y0 + earlier y-1) / h; with ratio zero it is the backward Euler difference.
struct BackwardDifference {
  double now, before, earlier;
};
BackwardDifference backward_difference(double ratio) {
  return {.now = (1 + 2 * ratio) / (1 + ratio), .before = -(1 + ratio), .earlier = ratio * ratio / (1 + ratio)};
}

double fluid_energy(const BodyModel& model, const BodyState& state) {
  if (model.definition.fluid.kind != FluidKind::kCompressible) return 0;
  const double excess = state.volume - state.fluid_volume;
  return -state.reference_pressure * excess +
         0.5 * model.definition.fluid.bulk_modulus * excess * excess / state.fluid_volume;
}

}  // namespace

Body::Body(BodyDefinition definition, std::vector<ToolDefinition> tools, SimulationOptions options)
    : model_(std::make_unique<const BodyModel>(make_body_model(std::move(definition)))),
      tools_(std::move(tools)),
      options_(options),
      newton_(*model_) {
  const Eigen::Index unknowns = model_->rest_position.size();
  state_.equilibrium.position = model_->rest_position;
  state_.velocity = state_.acceleration = state_.previous_velocity = state_.static_force =
      Eigen::VectorXd::Zero(unknowns);
  state_.previous_position = model_->rest_position;
  state_.contacts.resize(tools_.size());
  state_.sphere_forces.assign(tools_.size(), std::vector<double>(model_->triangles(), 0));
}

SurfaceView Body::surface() const {
  return {.triangles = model_->definition.mesh.triangles,
          .position = state_.equilibrium.position,
          .open = !model_->has_fluid()};
}

FluidMode Body::fluid_mode() const {
  switch (model_->definition.fluid.kind) {
    case FluidKind::kIncompressible:
      return FluidMode::kIncompressible;
    case FluidKind::kCompressible:
      return FluidMode::kCompressible;
    case FluidKind::kNone:
      break;
  }
  return FluidMode::kNone;
}

void Body::set_fluid_volume(double volume) {
  state_.fluid_volume = volume;
}

NewtonResult Body::solve(EquilibriumProblem& problem, EquilibriumState& state) {
  const NewtonResult result = newton_.solve(
      problem, state, {.tolerance = options_.tolerance, .maximum_iterations = options_.maximum_iterations});
  report_.newton_iterations += result.iterations;
  report_.shifted_iterations += result.shifted_iterations;
  report_.residual = result.residual;
  failure_ = result.reason;
  return result;
}

NewtonResult Body::relax(EquilibriumProblem& problem, EquilibriumState& state) {
  // Pseudo-inertia: springs, in units of the wall's stiffness, tie every vertex to where it is. A slack or a buckling
  // wall has directions without stiffness in which Newton's steps make no sense; the springs give them some, and are
  // weakened as long as the solution follows.
  double springs = 1;
  for (int turn = 0; turn < kRelaxationTurns; ++turn) {
    EquilibriumState trial = state;
    EquilibriumProblem held = problem;
    held.inertia = springs * model_->wall_stiffness / model_->mass.mean();
    held.inertia_target = state.position;
    if (solve(held, trial).converged) {
      state = trial;
      problem.attachments = held.attachments;
      problem.spheres = held.spheres;
      springs *= 0.25;
    } else {
      springs *= 8;
    }
    if (std::abs(enclosed_volume(*model_, state.position)) > kBurstVolume * model_->rest_volume) break;
    if (springs < 1e-3 && turn % 4 == 3) {
      trial = state;
      held = problem;
      const NewtonResult result = solve(held, trial);
      if (!result.converged) continue;
      state = trial;
      problem = held;
      return result;
    }
  }
  NewtonResult failed;
  failed.reason = "no equilibrium was found, also with pseudo-inertia";
  failure_ = failed.reason;
  return failed;
}

void Body::solve_statics(double pressure, FluidMode mode) {
  EquilibriumProblem problem;
  problem.fluid = mode;
  problem.pressure = pressure;
  problem.fluid_volume = model_->rest_volume;
  problem.bulk_modulus = model_->definition.fluid.bulk_modulus;
  problem.hold_rigid_motions = model_->rigid_motions.cols() > 0;
  EquilibriumProblem again = problem;
  EquilibriumState trial = state_.equilibrium;
  if (!solve(problem, trial).converged) {
    trial = state_.equilibrium;
    if (!relax(again, trial).converged) {
      std::ostringstream message;
      message << "body `" << model_->definition.name << "`, equilibrium before time zero";
      if (mode == FluidMode::kGivenPressure) message << " under " << pressure << " Pa";
      message << ": " << failure_
              << "; a wall holds only so much pressure: take a lower one, or a thicker or stiffer wall";
      throw SimulationFailure(message.str());
    }
  }
  state_.equilibrium = trial;
}

void Body::settle() {
  const FluidDefinition& fluid = model_->definition.fluid;
  if (!model_->has_fluid()) {
    solve_statics(0, FluidMode::kNone);
  } else if (fluid.initial_pressure) {
    solve_statics(*fluid.initial_pressure, FluidMode::kGivenPressure);
  } else {
    solve_statics(0, fluid_mode());
  }
  state_.volume = enclosed_volume(*model_, state_.equilibrium.position);
  state_.fluid_volume = fluid.initial_pressure ? state_.volume : model_->rest_volume;
  state_.reference_pressure = fluid.initial_pressure.value_or(0);
  state_.previous_position = state_.equilibrium.position;
  state_.static_force = newton_.terms().gradient - state_.equilibrium.pressure * newton_.terms().volume_gradient;
  state_.books.elastic = newton_.terms().elastic;
  state_.books.fluid = fluid_energy(*model_, state_);
  state_.books.script_work = state_.books.stored();
}

void Body::attach(std::span<const ToolPose> begin, std::span<const ToolPose> end, EquilibriumProblem& problem) const {
  problem.attachments = state_.attachments;
  for (int tool = 0; tool < static_cast<int>(tools_.size()); ++tool) {
    if (tools_[tool].kind == ToolKind::kLine) attach_line(tool, end[tool], problem);
    if (tools_[tool].kind != ToolKind::kPoint) continue;
    const bool attached = std::any_of(problem.attachments.begin(), problem.attachments.end(),
                                      [&](const Attachment& attachment) { return attachment.tool == tool; });
    if (attached) continue;
    if (const auto hit = first_entry_on_segment(surface(), begin[tool].tip, end[tool].tip)) {
      problem.attachments.push_back(
          {.tool = tool, .vertices = model_->surface[hit->triangle], .weights = hit->weights});
    }
  }
  for (Attachment& attachment : problem.attachments)
    attachment.target = prescribed_point(attachment, end[attachment.tool]);
}

void Body::attach_line(int tool, const ToolPose& end, EquilibriumProblem& problem) const {
  // What lies this far behind the line was never in its way.
  const double reach = 2 * model_->edge_length;
  for (const LineCrossing& crossing : line_crossings(surface(), tools_[tool], end)) {
    if (crossing.travel > 0 || crossing.travel < -reach) continue;
    Attachment attachment{.tool = tool, .vertices = model_->surface[crossing.triangle], .weights = crossing.weights};
    const Eigen::Vector3d offset = material_point(attachment, state_.equilibrium.position) - end.tip;
    attachment.offset = {offset.dot(end.axis.cross(end.direction)), crossing.along};
    const bool crowded =
        std::any_of(problem.attachments.begin(), problem.attachments.end(), [&](const Attachment& other) {
          return other.tool == tool && std::abs(other.offset.y() - crossing.along) < 0.25 * model_->edge_length;
        });
    if (!crowded) problem.attachments.push_back(attachment);
  }
}

bool Body::release(std::span<const ToolPose> poses, EquilibriumProblem& problem) const {
  const std::size_t before = problem.attachments.size();
  std::erase_if(problem.attachments, [&](const Attachment& attachment) {
    const Eigen::Vector3d motion = attachment.target - material_point(attachment, state_.equilibrium.position);
    const Eigen::Vector3d& direction = poses[attachment.tool].direction;
    // A tool lifts off when it goes back and would have to pull the tissue after it.
    return motion.dot(direction) < 0 && attachment.force.dot(direction) > 0;
  });
  return problem.attachments.size() != before;
}

void Body::add_spheres(std::span<const ToolPose> poses, EquilibriumProblem& problem) const {
  for (int tool = 0; tool < static_cast<int>(tools_.size()); ++tool) {
    if (tools_[tool].kind != ToolKind::kSphere) continue;
    // Fifty times the pressure under which a wall of unit strain hugs the sphere: the wall then rests near the range.
    const double pressure = std::max(model_->wall_stiffness / tools_[tool].radius, std::abs(state_.reference_pressure));
    problem.spheres.push_back({.tool = tool,
                               .sphere = sphere_at(tools_[tool], poses[tool]),
                               .range = contact_range(tools_[tool]),
                               .largest_pressure = 50 * pressure,
                               .forces = state_.sphere_forces[tool]});
  }
}

void Body::add_inertia(double duration, EquilibriumProblem& problem) const {
  const double ratio = state_.previous_step > 0 ? duration / state_.previous_step : 0;
  const BackwardDifference difference = backward_difference(ratio);
  const double factor = difference.now / duration;
  problem.inertia = factor * factor;
  const Eigen::VectorXd& position = state_.equilibrium.position;
  const Eigen::VectorXd velocity_part =
      (difference.before * position + difference.earlier * state_.previous_position) / duration;
  const Eigen::VectorXd acceleration_part =
      (difference.before * state_.velocity + difference.earlier * state_.previous_velocity) / duration;
  problem.inertia_target = -(factor * velocity_part + acceleration_part) / problem.inertia;
}

bool Body::try_step(std::span<const ToolPose> begin, std::span<const ToolPose> end, double duration) {
  EquilibriumProblem problem;
  problem.fluid = fluid_mode();
  problem.pressure = state_.reference_pressure;
  problem.fluid_volume = state_.fluid_volume;
  problem.bulk_modulus = model_->definition.fluid.bulk_modulus;
  add_spheres(end, problem);
  if (options_.analysis == Analysis::kDynamic) {
    add_inertia(duration, problem);
  } else {
    problem.hold_rigid_motions = model_->rigid_motions.cols() > 0;
  }
  attach(begin, end, problem);
  for (;;) {
    EquilibriumState trial = state_.equilibrium;
    if (options_.analysis == Analysis::kDynamic) trial.position += duration * state_.velocity;
    if (!solve(problem, trial).converged) return false;
    if (release(end, problem)) continue;
    accept(begin, end, duration, problem, trial);
    return true;
  }
}

void Body::accept(std::span<const ToolPose> begin, std::span<const ToolPose> end, double duration,
                  const EquilibriumProblem& problem, const EquilibriumState& reached) {
  const BodyState before = state_;
  const EquilibriumTerms& terms = newton_.terms();
  state_.equilibrium = reached;
  const Eigen::VectorXd motion = reached.position - before.equilibrium.position;
  EnergyBooks& books = state_.books;
  if (problem.inertia != 0) {
    const BackwardDifference difference =
        backward_difference(before.previous_step > 0 ? duration / before.previous_step : 0);
    state_.velocity = (difference.now * reached.position + difference.before * before.equilibrium.position +
                       difference.earlier * before.previous_position) /
                      duration;
    state_.acceleration = problem.inertia * (reached.position - problem.inertia_target);
    books.kinetic = 0.5 * model_->mass.dot(state_.velocity.cwiseAbs2());
  }
  state_.previous_position = before.equilibrium.position;
  state_.previous_velocity = before.velocity;
  state_.previous_step = duration;
  state_.volume = terms.volume;
  state_.static_force = terms.gradient - reached.pressure * terms.volume_gradient;
  for (const ContactPoint& contact : terms.contacts) {
    const double force = problem.spheres[contact.sphere].forces[contact.triangle];
    for (int k = 0; k < 3; ++k) {
      state_.static_force.segment<3>(3 * model_->surface[contact.triangle][k]) -=
          force * contact.gap.gradient.segment<3>(3 * k);
    }
  }
  books.elastic = terms.elastic;
  books.contact = contact_energy(*model_, problem, terms);
  books.fluid = fluid_energy(*model_, state_);

  // Work by the trapezoidal rule; what it differs from the change of the energies is what the integrator spends.
  double tool_work = 0;
  state_.contacts.assign(tools_.size(), ToolContact{});
  for (std::size_t k = 0; k < problem.spheres.size(); ++k) {
    const int tool = problem.spheres[k].tool;
    state_.contacts[tool] = contact_on(*model_, problem, terms, reached.position, static_cast<int>(k));
    state_.sphere_forces[tool] = problem.spheres[k].forces;
    const Eigen::Vector3d path = problem.spheres[k].sphere.center - sphere_at(tools_[tool], begin[tool]).center;
    tool_work -= 0.5 * (before.contacts[tool].force + state_.contacts[tool].force).dot(path);
  }
  const auto attached_work = [&](const std::vector<Attachment>& attachments) {
    for (const Attachment& attachment : attachments) {
      tool_work -= 0.5 * attachment.force.dot(material_point(attachment, motion));
    }
  };
  attached_work(before.attachments);
  attached_work(problem.attachments);
  for (const Attachment& attachment : problem.attachments) {
    state_.contacts[attachment.tool].force += attachment.force;
    state_.contacts[attachment.tool].touching = true;
  }
  state_.attachments = problem.attachments;
  const double script_work =
      problem.fluid == FluidMode::kIncompressible
          ? 0.5 * (before.equilibrium.pressure + reached.pressure) * (state_.volume - before.volume)
          : 0;
  double sphere_work = 0;
  for (const SphereContact& contact : problem.spheres) {
    const Eigen::Vector3d path = contact.sphere.center - sphere_at(tools_[contact.tool], begin[contact.tool]).center;
    sphere_work -= 0.5 * (before.contacts[contact.tool].force + state_.contacts[contact.tool].force).dot(path);
  }
  const double kinetic_work = 0.5 * model_->mass.cwiseProduct(before.acceleration + state_.acceleration).dot(motion);
  const double static_work = 0.5 * (before.static_force + state_.static_force).dot(motion) + sphere_work + script_work;
  books.numerical += kinetic_work + static_work - (books.stored() - before.books.stored());
  books.tool_work += tool_work;
  books.script_work += script_work;
  (void)end;
}

void Body::advance(std::span<const ToolPose> begin, std::span<const ToolPose> end, double duration) {
  report_ = {};
  const BodyState before = state_;
  double done = 0, part = 1;
  std::vector<ToolPose> from(begin.begin(), begin.end());
  while (done < 1) {
    const std::vector<ToolPose> to = interpolate(begin, end, done + part);
    if (try_step(from, to, part * duration)) {
      from = to;
      done += part;
      part = std::min(2 * part, 1 - done);
      continue;
    }
    part *= 0.5;
    if (++report_.halvings > options_.maximum_halvings) {
      state_ = before;
      throw SimulationFailure("body `" + model_->definition.name + "`: " + failure_ + ", also with the step divided " +
                              std::to_string(options_.maximum_halvings) + " times");
    }
  }
}

Eigen::VectorXd Body::contact_pressure() const {
  Eigen::VectorXd pressure = Eigen::VectorXd::Zero(model_->vertices());
  for (const Attachment& attachment : state_.attachments) {
    for (int k = 0; k < 3; ++k) pressure[attachment.vertices[k]] += attachment.weights[k] * attachment.force.norm();
  }
  Eigen::VectorXd area = Eigen::VectorXd::Zero(model_->vertices());
  for (int t = 0; t < model_->triangles(); ++t) {
    for (const int vertex : model_->surface[t]) area[vertex] += model_->rest[t].area / 3;
  }
  return pressure.cwiseQuotient(area.cwiseMax(1e-300));
}

}  // namespace thinwall
