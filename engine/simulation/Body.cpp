#include "engine/simulation/Body.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <utility>

#include "engine/simulation/SimulationFailure.hpp"

namespace thinwall {
namespace {

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
  assert(model_->has_fluid());
  state_.fluid_volume = volume;
  // A compressible fluid takes the filling up at once, at the volume that the body has; an incompressible one moves the
  // wall in the next step, which books the work.
  const double energy = fluid_energy(*model_, state_);
  state_.books.script_work += energy - state_.books.fluid;
  state_.books.fluid = energy;
}

bool Body::try_step(std::span<const ToolPose> begin, std::span<const ToolPose> end, double duration) {
  EquilibriumProblem problem;
  problem.fluid = fluid_mode();
  problem.pressure = state_.reference_pressure;
  problem.fluid_volume = state_.fluid_volume;
  problem.bulk_modulus = model_->definition.fluid.bulk_modulus;
  add_spheres(end, problem);
  problem.hold_rigid_motions = options_.analysis == Analysis::kQuasiStatic && model_->rigid_motions.cols() > 0;
  attach(begin, end, problem);
  for (;;) {
    // What a tool takes hold of or lets go of changes its velocity at once; a difference that reaches back across that
    // would see the jump as a motion.
    if (problem.attachments.size() != state_.attachments.size()) state_.previous_step = 0;
    if (options_.analysis == Analysis::kDynamic) add_inertia(duration, problem);
    EquilibriumState trial = state_.equilibrium;
    if (options_.analysis == Analysis::kDynamic) trial.position += duration * state_.velocity;
    if (!solve(problem, trial).converged) return false;
    if (release(end, problem)) continue;
    accept(begin, duration, problem, trial);
    return true;
  }
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

}  // namespace thinwall
