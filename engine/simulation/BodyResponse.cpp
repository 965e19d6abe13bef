#include <Eigen/Geometry>
#include <cassert>
#include <limits>

#include "engine/simulation/Body.hpp"
#include "engine/simulation/PrescribedPoint.hpp"
#include "engine/simulation/SimulationFailure.hpp"
#include "engine/tool/PoseBetween.hpp"

namespace thinwall {
namespace {

/// Seconds within which a body in motion answers a hand: so long that the wall follows, and its inertia counts only
/// where nothing else holds the body. A tool that goes on as it did takes the wall along, which asks for no force; as
/// an answer within a step of the solver it would be the inertia of a wall that is thrown.
constexpr double kAnswerTime = 0.1;

using Vector9 = Eigen::Matrix<double, 9, 1>;

/// Velocity of a point that goes with a tool.
Eigen::Vector3d velocity_at(const ToolMotion& motion, const ToolPose& pose, const Eigen::Vector3d& point) {
  return motion.head<3>() + motion.tail<3>().cross(point - pose.tip);
}

/// What a motion of the tool does to a contact while the wall stays: rates of the gap and of its gradient. A gap
/// depends on where wall and tool are to each other only, so the wall may be moved back instead and the gradient
/// turned.
struct GapRate {
  double gap = 0;
  Vector9 gradient;
};

GapRate rate_of(const ContactPoint& contact, const std::array<Eigen::Vector3d, 3>& corners, const ToolPose& pose,
                const ToolMotion& motion) {
  Vector9 back;
  for (int k = 0; k < 3; ++k) back.segment<3>(3 * k) = -velocity_at(motion, pose, corners[k]);
  GapRate rate{.gap = contact.gap.gradient.dot(back), .gradient = contact.gap.hessian * back};
  for (int k = 0; k < 3; ++k) {
    rate.gradient.segment<3>(3 * k) += motion.tail<3>().cross(Eigen::Vector3d(contact.gap.gradient.segment<3>(3 * k)));
  }
  return rate;
}

Vector9 at_corners(const Eigen::Vector3i& triangle, const Eigen::VectorXd& motion) {
  Vector9 corners;
  for (int k = 0; k < 3; ++k) corners.segment<3>(3 * k) = motion.segment<3>(3 * triangle[k]);
  return corners;
}

Eigen::Vector3d sum_of(const Vector9& corners) {
  return corners.head<3>() + corners.segment<3>(3) + corners.tail<3>();
}

}  // namespace

ToolMotion motion_between(const ToolPose& from, const ToolPose& to) {
  ToolMotion motion = ToolMotion::Zero();
  motion.head<3>() = to.tip - from.tip;
  if (from.direction == to.direction && from.axis == to.axis) return motion;
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(frame_of(to) * frame_of(from).transpose()));
  motion.tail<3>() = turn.angle() * turn.axis();
  return motion;
}

EquilibriumProblem Body::response_problem(std::span<const ToolPose> poses, double duration) const {
  EquilibriumProblem problem = make_problem(poses, duration, {.load_factors = state_.load_factors, .fluids = {}});
  problem.attachments = state_.attachments;
  if (has_inertia()) add_inertia(kAnswerTime, problem);
  return problem;
}

ToolResponse Body::respond(int tool, std::span<const ToolPose> poses, double duration, double reach) {
  ToolResponse response;
  response.pose = poses[tool];
  response.force = state_.contacts[tool].force;
  const bool touches = state_.contacts[tool].touching;
  const WallAhead ahead = touches ? WallAhead{} : wall_ahead(tool, poses[tool]);
  if (!touches && ahead.gap > reach) return response;
  foresight_.reset();
  const EquilibriumProblem problem = response_problem(poses, duration);
  // With inertia the factor is that of a part of the step.
  const bool reuses_factor = touches && options_.extrapolates && !has_inertia();
  if (!newton_->linearize(problem, state_.equilibrium, reuses_factor)) {
    throw SimulationFailure("body `" + model_->definition.name + "`: its answer to a tool cannot be found");
  }
  if (touches) {
    add_contacts_to(response, problem, tool);
  } else {
    response.ahead = stiffness_ahead(ahead, problem, tool, poses[tool]);
  }
  return response;
}

Eigen::VectorXd Body::add_motion_to(ToolResponse& response, const EquilibriumProblem& problem, int tool,
                                    std::span<const ContactPoint* const> pressing, int axis) {
  const Eigen::VectorXd& position = state_.equilibrium.position;
  const ToolMotion motion = ToolMotion::Unit(axis);
  Eigen::VectorXd force = Eigen::VectorXd::Zero(position.size());
  std::vector<GapRate> rates;
  for (std::size_t k = 0; k < pressing.size(); ++k) {
    const ContactPoint& contact = *pressing[k];
    const Eigen::Vector3i& triangle = model_->surface[contact.triangle];
    rates.push_back(rate_of(contact, corners_of(triangle, position), response.pose, motion));
    const Vector9 push =
        response.sites[k].force * rates[k].gradient - contact.potential.stiffness * rates[k].gap * contact.gap.gradient;
    for (int c = 0; c < 3; ++c) force.segment<3>(3 * triangle[c]) += push.segment<3>(3 * c);
  }
  std::vector<Eigen::Vector3d> held;
  for (const Attachment& attachment : problem.attachments) {
    const Eigen::Vector3d velocity = velocity_at(motion, response.pose, holding_point(attachment, response.pose));
    held.emplace_back(Eigen::Vector3d::Zero());
    if (attachment.tool == tool) held.back() = velocity.cwiseProduct(attachment.followed);
  }
  const LinearAnswer answer = newton_->answer(problem, force, held);
  for (std::size_t k = 0; k < pressing.size(); ++k) {
    const ContactPoint& contact = *pressing[k];
    const Vector9 moved = at_corners(model_->surface[contact.triangle], answer.motion);
    response.sites[k].force_by_motion[axis] =
        -contact.potential.stiffness * (contact.gap.gradient.dot(moved) + rates[k].gap);
    response.sites[k].normal_by_motion.col(axis) = sum_of(contact.gap.hessian * moved + rates[k].gradient);
  }
  for (std::size_t k = 0; k < problem.attachments.size(); ++k) {
    if (problem.attachments[k].tool == tool) response.held_by_motion.col(axis) += answer.forces[k];
  }
  return answer.motion;
}

void Body::add_contacts_to(ToolResponse& response, const EquilibriumProblem& problem, int tool) {
  std::vector<const ContactPoint*> pressing;
  const std::vector<ContactPoint>& contacts = newton_->factorised_contacts();
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const SolidContact& solid = problem.solids[contacts[k].solid];
    // What the last step let go, but for a part of its force, answers no motion.
    const bool presses = solid.forces[contacts[k].site] > 0 && !newton_->is_factorised_open(k);
    if (solid.tool == tool && presses) pressing.push_back(&contacts[k]);
  }
  for (const ContactPoint* contact : pressing) {
    SiteResponse& site = response.sites.emplace_back();
    site.force = problem.solids[contact->solid].forces[contact->site];
    site.normal = sum_of(contact->gap.gradient);
  }
  for (const Attachment& attachment : problem.attachments) {
    if (attachment.tool != tool) continue;
    response.holds = true;
    response.held_force += attachment.force;
  }
  foresight_ = Foresight{.tool = tool, .motion = {}, .sites = {}};
  foresight_->motion.resize(model_->unknowns(), 6);
  for (int axis = 0; axis < 6; ++axis)
    foresight_->motion.col(axis) = add_motion_to(response, problem, tool, pressing, axis);
  for (std::size_t k = 0; k < pressing.size(); ++k) {
    foresight_->sites.push_back(
        {.solid = pressing[k]->solid, .site = pressing[k]->site, .force_by_motion = response.sites[k].force_by_motion});
  }
}

void Body::begin_as_foreseen(std::span<const ToolPose> begin, std::span<const ToolPose> end,
                             EquilibriumProblem& problem, EquilibriumState& trial) const {
  const ToolMotion motion = motion_between(begin[foresight_->tool], end[foresight_->tool]);
  if (motion.isZero()) return;
  // Where the body moves anyway the foreseen motion is part of that.
  const Eigen::VectorXd foreseen = state_.equilibrium.position + foresight_->motion * motion;
  if (!has_inertia()) trial.position = foreseen;
  for (const Foresight::Site& one : foresight_->sites) {
    double& force = problem.solids[one.solid].forces[one.site];
    force = std::max(0.0, force + one.force_by_motion.dot(motion));
  }
}

WallAhead Body::wall_ahead(int tool, const ToolPose& pose) const {
  WallAhead ahead;
  if (tools_[tool].kind == ToolKind::kLine) return ahead;
  if (tools_[tool].kind == ToolKind::kPoint) {
    const auto entry = first_entry(surface(), pose.tip, pose.direction);
    if (entry && entry->travel >= 0) ahead = {.gap = entry->travel, .normal = pose.direction};
    return ahead;
  }
  for (const ToolSolid& solid : tool_solids(tools_[tool], pose)) {
    for (int v = 0; v < model_->vertices(); ++v) {
      const SignedDistance distance = signed_distance(solid, state_.equilibrium.position.segment<3>(3 * v));
      if (distance.value < ahead.gap) ahead = {.gap = distance.value, .normal = distance.normal};
    }
  }
  return ahead;
}

WallAhead Body::stiffness_ahead(WallAhead ahead, const EquilibriumProblem& problem, int tool, const ToolPose& pose) {
  Eigen::VectorXd force = Eigen::VectorXd::Zero(model_->unknowns());
  if (tools_[tool].kind == ToolKind::kPoint) {
    const auto entry = first_entry(surface(), pose.tip, pose.direction);
    assert(entry && "a wall is ahead where the point's line meets it");
    for (int k = 0; k < 3; ++k) {
      force.segment<3>(3 * model_->surface[entry->triangle][k]) += entry->weights[k] * ahead.normal;
    }
  } else {
    int nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (const ToolSolid& solid : tool_solids(tools_[tool], pose)) {
      for (int v = 0; v < model_->vertices(); ++v) {
        const double value = distance_from(solid, state_.equilibrium.position.segment<3>(3 * v));
        if (value < least) least = value, nearest = v;
      }
    }
    force.segment<3>(3 * nearest) = ahead.normal;
  }
  const std::vector<Eigen::Vector3d> still(problem.attachments.size(), Eigen::Vector3d::Zero());
  const double compliance = force.dot(newton_->answer(problem, force, still).motion);
  ahead.stiffness = compliance > 0 ? 1 / compliance : 0;
  return ahead;
}

}  // namespace thinwall
