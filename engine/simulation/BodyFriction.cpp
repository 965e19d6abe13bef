#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/equilibrium/FrictionMixing.hpp"
#include "engine/simulation/Body.hpp"

namespace thinwall {
namespace {

/// Slip that a place that sticks gives before it slides, as a part of half the smallest thickness of the tool (the
/// radius of a ball): far below what is seen or felt, whatever the mesh, the tool's edges and the force.
constexpr double kGive = 1e-4;

/// Friction is found when the limits and normals that the solution asks for differ from those it was found with by no
/// more than this part of the sum of all limits. Where a tool rests on more places than its balance determines, the
/// shares of the places may go to and fro without end while their sum stands: then the other part is good enough, and
/// where the wall moves by no more than that part of an edge the sum alone counts.
constexpr double kAgreement = 2e-4;
constexpr double kRestlessAgreement = 1e-2;
constexpr double kRestlessMotion = 1e-3;

/// Solutions after which each one goes only a part of the way to what the last asked for, after which the looser
/// agreement counts, and after which to give up.
constexpr int kWholeTurns = 8;
constexpr int kQuietTurns = 14;
constexpr int kMostTurns = 40;
constexpr double kLaterPart = 0.5;

const FrictionMemory* find_memory(const std::vector<FrictionMemory>& memories, int site) {
  const auto found = std::ranges::lower_bound(memories, site, {}, &FrictionMemory::site);
  return found == memories.end() || found->site != site ? nullptr : &*found;
}

/// Newton.
double sum_of_limits(std::span<const FrictionContact> contacts) {
  double sum = 0;
  for (const FrictionContact& contact : contacts) sum += contact.potential.limit;
  return sum;
}

}  // namespace

std::vector<FrictionContact> Body::friction_contacts(const std::vector<ToolSolid>& before,
                                                     const EquilibriumProblem& problem, bool at_begin,
                                                     const Eigen::VectorXd& position) const {
  std::vector<FrictionContact> contacts;
  for (int k = 0; k < static_cast<int>(problem.solids.size()); ++k) {
    const SolidContact& solid = problem.solids[k];
    const double coefficient = tools_[solid.tool].friction;
    if (coefficient == 0) continue;
    const double give = kGive * solid.solid.half_thickness();
    for (int s = 0; s < static_cast<int>(model_->sites.size()); ++s) {
      if (solid.forces[s] <= 0) continue;
      const ContactSite& site = model_->sites[s];
      const auto gap = solid.gap(s, site, at_begin ? before[k] : solid.solid, std::numeric_limits<double>::infinity(),
                                 corners_of(model_->surface[site.triangle], position), GapTerms::kHessian);
      FrictionContact contact{.solid = k, .site = s, .triangle = site.triangle, .weights = gap->weights};
      contact.normal = gap->normal;
      contact.potential = {.limit = coefficient * solid.forces[s], .give = give};
      const Eigen::Vector3d start = place_on(*model_, contact.triangle, contact.weights, state_.equilibrium.position);
      contact.origin = start + displacement_of(before[k], solid.solid, start);
      if (const FrictionMemory* memory = find_memory(state_.friction[k], s)) {
        contact.origin -= solid.solid.frame * memory->elastic_slip;
        contact.estimate = solid.solid.frame * memory->force;
      }
      if (!at_begin) contact.estimate = contact.force(*model_, position);
      contacts.push_back(contact);
    }
  }
  return contacts;
}

void Body::add_friction_to(EquilibriumProblem& problem, std::span<const ToolPose> begin) const {
  problem.friction = friction_contacts(contact_solids(tools_, begin), problem, true, state_.equilibrium.position);
}

bool Body::revise_friction(EquilibriumProblem& problem, std::span<const ToolPose> begin,
                           const EquilibriumState& reached, double motion, int turn, FrictionMixing& mixing) const {
  const std::vector<FrictionContact> asked =
      friction_contacts(contact_solids(tools_, begin), problem, false, reached.position);
  mixing.note(problem.friction, asked);
  const double limits = sum_of_limits(asked);
  if (mixing.missed() <= (turn < kQuietTurns ? kAgreement : kRestlessAgreement) * limits) return false;
  const bool rests = turn >= kWholeTurns && motion <= kRestlessMotion * model_->edge_length;
  if (rests && std::abs(limits - sum_of_limits(problem.friction)) <= kRestlessAgreement * limits) return false;
  problem.friction = mixing.next(problem.friction, asked, turn < kWholeTurns ? 1 : kLaterPart);
  for (FrictionContact& contact : problem.friction) contact.estimate = contact.force(*model_, reached.position);
  return true;
}

bool Body::solve_with_friction(EquilibriumProblem& problem, EquilibriumState& trial, std::span<const ToolPose> begin,
                               bool goes_on) {
  FrictionMixing mixing;
  for (int turn = 0;; ++turn) {
    const Eigen::VectorXd before = trial.position;
    if (!solve_step(problem, trial, begin, goes_on || turn > 0)) return false;
    const double motion = (trial.position - before).head(3 * model_->vertices()).lpNorm<Eigen::Infinity>();
    if (!has_friction() || !revise_friction(problem, begin, trial, motion, turn, mixing)) return true;
    if (turn == kMostTurns) {
      failure_ = "friction and pressure of a tool do not come to agree";
      return false;
    }
  }
}

double Body::squeeze(int tool, const ToolPose& pose) const {
  std::size_t k = 0;
  for (int before = 0; before < tool; ++before) k += contact_solids(tools_[before], {}).size();
  const Eigen::Vector3d across = pose.axis.cross(pose.direction);
  // The wall between the jaws pushes each outwards.
  double right = 0, left = 0;
  for (const ToolSolid& solid : contact_solids(tools_[tool], pose)) {
    const double outwards = state_.solid_contacts[k++].force.dot(across);
    (across.dot(solid.center - pose.tip) > 0 ? right : left) += outwards;
  }
  return std::max(0.0, std::min(right, -left));
}

bool Body::has_friction() const {
  return std::ranges::any_of(tools_, [](const ToolDefinition& tool) { return tool.friction > 0; });
}

void Body::add_friction_to_contacts(const EquilibriumProblem& problem) {
  const Eigen::VectorXd& position = state_.equilibrium.position;
  for (const FrictionContact& contact : problem.friction) {
    const ToolSolid& solid = problem.solids[contact.solid].solid;
    const Eigen::Vector3d force = contact.force(*model_, position);
    const Eigen::Vector3d arm = place_on(*model_, contact.triangle, contact.weights, position) - solid.center;
    state_.solid_contacts[contact.solid].force += force;
    state_.solid_contacts[contact.solid].moment += arm.cross(force);
    state_.contacts[problem.solids[contact.solid].tool].force += force;
  }
}

double Body::update_friction(const BodyState& before, std::span<const ToolPose> begin,
                             const EquilibriumProblem& problem) {
  const std::vector<ToolSolid> solids = contact_solids(tools_, begin);
  // What a place does during the step, seen from the solid that it touched before.
  const auto motion = [&](const FrictionMemory& memory, std::size_t solid) -> Eigen::Vector3d {
    const Eigen::Vector3d from = place_on(*model_, memory.triangle, memory.weights, before.equilibrium.position);
    return place_on(*model_, memory.triangle, memory.weights, state_.equilibrium.position) - from -
           displacement_of(solids[solid], problem.solids[solid].solid, from);
  };
  for (std::vector<FrictionMemory>& memories : state_.friction) memories.clear();
  state_.friction_energy = 0;
  double spent = 0;  // joule, by the trapezoidal rule as all work: half under the forces before, half under those now
  for (const FrictionContact& contact : problem.friction) {
    const Eigen::Matrix3d& frame = problem.solids[contact.solid].solid.frame;
    const Eigen::Vector3d slip = contact.slip(*model_, state_.equilibrium.position);
    const Eigen::Vector3d elastic = contact.potential.elastic_part(slip);
    const Eigen::Vector3d force = contact.potential.stiffness() * elastic;
    spent += 0.5 * force.dot(slip - elastic);
    state_.friction_energy += 0.5 * force.dot(elastic);
    state_.friction[contact.solid].push_back({.site = contact.site,
                                              .triangle = contact.triangle,
                                              .weights = contact.weights,
                                              .elastic_slip = frame.transpose() * elastic,
                                              .force = frame.transpose() * force});
  }
  for (std::size_t k = 0; k < before.friction.size(); ++k) {
    for (const FrictionMemory& earlier : before.friction[k]) {
      const FrictionMemory* now = find_memory(state_.friction[k], earlier.site);
      const Eigen::Vector3d given_back = earlier.elastic_slip - (now ? now->elastic_slip : Eigen::Vector3d::Zero());
      spent += 0.5 * (solids[k].frame * earlier.force).dot(motion(earlier, k) + solids[k].frame * given_back);
    }
  }
  // A step in which sliding turns round spends nothing rather than giving back.
  return std::max(0.0, spent);
}

}  // namespace thinwall
