#include "engine/simulation/ToolFriction.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/tool/ToolSolids.hpp"

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

bool has_friction(std::span<const ToolDefinition> tools) {
  return std::ranges::any_of(tools, [](const ToolDefinition& tool) { return tool.friction > 0; });
}

FrictionSearch::FrictionSearch(const BodyModel& model, const BodyState& state, std::span<const ToolDefinition> tools,
                               std::span<const ToolPose> begin)
    : model_(model), state_(state), tools_(tools), begin_(contact_solids(tools, begin)) {}

std::vector<FrictionContact> FrictionSearch::first(const EquilibriumProblem& problem) const {
  return contacts(problem, true, state_.equilibrium.position);
}

bool FrictionSearch::revise(EquilibriumProblem& problem, const Eigen::VectorXd& reached, double motion) {
  if (!has_friction(tools_)) return false;
  const int turn = turns_++;
  const std::vector<FrictionContact> asked = contacts(problem, false, reached);
  mixing_.note(problem.friction, asked);
  const double limits = sum_of_limits(asked);
  if (mixing_.missed() <= (turn < kQuietTurns ? kAgreement : kRestlessAgreement) * limits) return false;
  const bool rests = turn >= kWholeTurns && motion <= kRestlessMotion * model_.edge_length;
  if (rests && std::abs(limits - sum_of_limits(problem.friction)) <= kRestlessAgreement * limits) return false;
  problem.friction = mixing_.next(problem.friction, asked, turn < kWholeTurns ? 1 : kLaterPart);
  for (FrictionContact& contact : problem.friction) contact.estimate = contact.force(model_, reached);
  return true;
}

bool FrictionSearch::is_hopeless() const {
  return turns_ > kMostTurns;
}

std::vector<FrictionContact> FrictionSearch::contacts(const EquilibriumProblem& problem, bool at_begin,
                                                      const Eigen::VectorXd& position) const {
  std::vector<FrictionContact> contacts;
  for (int k = 0; k < static_cast<int>(problem.solids.size()); ++k) {
    const SolidContact& solid = problem.solids[k];
    const double coefficient = tools_[solid.tool].friction;
    if (coefficient == 0) continue;
    const double give = kGive * solid.solid.half_thickness();
    for (int s = 0; s < static_cast<int>(model_.sites.size()); ++s) {
      if (solid.forces[s] <= 0) continue;
      const ContactSite& site = model_.sites[s];
      const auto gap = solid.gap(s, site, at_begin ? begin_[k] : solid.solid, std::numeric_limits<double>::infinity(),
                                 corners_of(model_.surface[site.triangle], position), GapTerms::kHessian);
      FrictionContact contact{.solid = k, .site = s, .triangle = site.triangle, .weights = gap->weights};
      contact.normal = gap->normal;
      contact.potential = {.limit = coefficient * solid.forces[s], .give = give};
      const Eigen::Vector3d start = place_on(model_, contact.triangle, contact.weights, state_.equilibrium.position);
      contact.origin = start + displacement_of(begin_[k], solid.solid, start);
      if (const FrictionMemory* memory = find_memory(state_.friction[k], s)) {
        contact.origin -= solid.solid.frame * memory->elastic_slip;
        contact.estimate = solid.solid.frame * memory->force;
      }
      if (!at_begin) contact.estimate = contact.force(model_, position);
      contacts.push_back(contact);
    }
  }
  return contacts;
}

void add_friction_forces(const BodyModel& model, const EquilibriumProblem& problem, BodyState& state) {
  const Eigen::VectorXd& position = state.equilibrium.position;
  for (const FrictionContact& contact : problem.friction) {
    const ToolSolid& solid = problem.solids[contact.solid].solid;
    const Eigen::Vector3d force = contact.force(model, position);
    const Eigen::Vector3d arm = place_on(model, contact.triangle, contact.weights, position) - solid.center;
    state.solid_contacts[contact.solid].force += force;
    state.solid_contacts[contact.solid].moment += arm.cross(force);
    state.contacts[problem.solids[contact.solid].tool].force += force;
  }
}

double remember_friction(const BodyModel& model, const BodyState& before, std::span<const ToolSolid> begin,
                         const EquilibriumProblem& problem, BodyState& state) {
  // What a place does during the step, seen from the solid that it touched before.
  const auto motion = [&](const FrictionMemory& memory, std::size_t solid) -> Eigen::Vector3d {
    const Eigen::Vector3d from = place_on(model, memory.triangle, memory.weights, before.equilibrium.position);
    return place_on(model, memory.triangle, memory.weights, state.equilibrium.position) - from -
           displacement_of(begin[solid], problem.solids[solid].solid, from);
  };
  for (std::vector<FrictionMemory>& memories : state.friction) memories.clear();
  state.friction_energy = 0;
  double spent = 0;  // joule, by the trapezoidal rule as all work: half under the forces before, half under those now
  for (const FrictionContact& contact : problem.friction) {
    const Eigen::Matrix3d& frame = problem.solids[contact.solid].solid.frame;
    const Eigen::Vector3d slip = contact.slip(model, state.equilibrium.position);
    const Eigen::Vector3d elastic = contact.potential.elastic_part(slip);
    const Eigen::Vector3d force = contact.potential.stiffness() * elastic;
    spent += 0.5 * force.dot(slip - elastic);
    state.friction_energy += 0.5 * force.dot(elastic);
    state.friction[contact.solid].push_back({.site = contact.site,
                                             .triangle = contact.triangle,
                                             .weights = contact.weights,
                                             .elastic_slip = frame.transpose() * elastic,
                                             .force = frame.transpose() * force});
  }
  for (std::size_t k = 0; k < before.friction.size(); ++k) {
    for (const FrictionMemory& earlier : before.friction[k]) {
      const FrictionMemory* now = find_memory(state.friction[k], earlier.site);
      const Eigen::Vector3d given_back = earlier.elastic_slip - (now ? now->elastic_slip : Eigen::Vector3d::Zero());
      spent += 0.5 * (begin[k].frame * earlier.force).dot(motion(earlier, k) + begin[k].frame * given_back);
    }
  }
  // A step in which sliding turns round spends nothing rather than giving back.
  return std::max(0.0, spent);
}

}  // namespace thinwall
