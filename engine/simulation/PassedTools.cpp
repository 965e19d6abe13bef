#include "engine/simulation/PassedTools.hpp"

#include <algorithm>
#include <cmath>

#include "engine/contact/DeepestPoint.hpp"
#include "engine/contact/SolidGap.hpp"
#include "engine/contact/TriangleCrossing.hpp"

namespace thinwall {
namespace {

/// A place of the wall whose straight way in one solution leads deeper into a tool than this part of half its thickness
/// did not slide around it but went through.
constexpr double kDeepestWay = 0.5;

/// Longest way of a vertex from one position to another, as a solid sees it that moves meanwhile, metres: no place
/// between vertices goes farther. Positions: (unknowns), metres.
double farthest_way(const BodyModel& model, const ToolSolid& before, const ToolSolid& after,
                    const Eigen::VectorXd& from, const Eigen::VectorXd& to) {
  double farthest = 0;
  for (int v = 0; v < model.vertices(); ++v) {
    const Eigen::Index at = 3 * static_cast<Eigen::Index>(v);
    const Eigen::Vector3d start = from.segment<3>(at);
    const Eigen::Vector3d way = to.segment<3>(at) - start - displacement_of(before, after, start);
    farthest = std::max(farthest, way.squaredNorm());
  }
  return std::sqrt(farthest);
}

/// Whether the middle of a ball went through a triangle. The point of a needle is so small that a wall which slides off
/// it closes over it again beside the place that it touched. `is_near`: (triangles), of those in question.
bool has_gone_through_middle(const BodyModel& model, const WayStart& start, std::size_t k,
                             const EquilibriumProblem& problem, const Eigen::VectorXd& position,
                             const std::vector<char>& is_near) {
  const SolidContact& after = problem.solids[k];
  for (int s = 0; s < static_cast<int>(model.sites.size()); ++s) {
    const ContactSite& site = model.sites[s];
    if (site.part != SitePart::kFace || !is_near[site.triangle]) continue;
    if (problem.is_free(after.tool, site.triangle) || problem.passes(after.tool, s)) continue;
    const Eigen::Vector3i& triangle = model.surface[site.triangle];
    const MovingTriangle way{.from = corners_of(triangle, start.position), .to = corners_of(triangle, position)};
    if (goes_through(start.solids[k].center, after.solid.center, way)) return true;
  }
  return false;
}

/// The same of one of the solids.
bool jumped_over(const BodyModel& model, const WayStart& start, std::size_t k, const EquilibriumProblem& problem,
                 const Eigen::VectorXd& position) {
  const ToolSolid& before = start.solids[k];
  const SolidContact& after = problem.solids[k];
  const double deepest_way = kDeepestWay * after.solid.half_thickness();
  // Places farther away cannot have come so deep.
  const double reach = farthest_way(model, before, after.solid, start.position, position) - deepest_way;
  // Below zero only what was pressed can be as deep already.
  const bool only_pressed = reach < 0;
  thread_local std::vector<char> is_near;  // (triangles), asked of each once: it has several sites
  is_near.assign(model.surface.size(), 1);
  if (!only_pressed) {
    std::ranges::transform(model.surface, is_near.begin(), [&](const Eigen::Vector3i& triangle) {
      return !is_out_of_reach(before, reach, corners_of(triangle, start.position));
    });
    if (before.is_ball() && has_gone_through_middle(model, start, k, problem, position, is_near)) return true;
  }
  return std::ranges::any_of(model.sites, [&, s = 0](const ContactSite& site) mutable {
    const int number = s++;
    if (!is_near[site.triangle] || (only_pressed && start.forces[k][number] <= 0)) return false;
    if (problem.is_free(after.tool, site.triangle) || problem.passes(after.tool, number)) return false;
    const Eigen::Vector3i& triangle = model.surface[site.triangle];
    const auto near =
        solid_gap(before, reach, corners_of(triangle, start.position), site.part, site.corner, GapTerms::kGradient);
    if (!near || near->gap >= reach) return false;
    // The way of the place that was nearest, as the tool sees it.
    const Eigen::Vector3d place = place_on(model, site.triangle, near->weights, start.position);
    const Eigen::Vector3d from = place + displacement_of(before, after.solid, place);
    const Eigen::Vector3d to = place_on(model, site.triangle, near->weights, position);
    const DeepestPoint deepest = deepest_on_edge(after.solid, {from, to, to}, 0, 1);
    const Eigen::Vector3d point = deepest.weights[0] * from + deepest.weights[1] * to;
    return distance_from(after.solid, point) < -deepest_way;
  });
}

}  // namespace

bool is_guarded(ToolKind kind, std::span<const ToolSolid> solids, std::size_t solid, const ToolSolid& after,
                bool is_in_wall) {
  if (kind == ToolKind::kSphere || kind == ToolKind::kCapsule || kind == ToolKind::kPlate) {
    return !solids[solid].is_part();
  }
  const bool is_point = solid > 0 && solids[solid - 1].form == ToolSolid::Form::kNeedle && solids[solid].is_part();
  return is_point && (!is_in_wall || (after.center - solids[solid].center).dot(after.frame.col(2)) > 0);
}

bool jumped_over_tools(const BodyModel& model, const WayStart& start, const EquilibriumProblem& problem,
                       const Eigen::VectorXd& position) {
  for (std::size_t k = 0; k < start.solids.size(); ++k) {
    if (start.guarded[k] && jumped_over(model, start, k, problem, position)) return true;
  }
  return false;
}

WayStart going_on(const WayStart& way, const EquilibriumProblem& problem, const Eigen::VectorXd& position) {
  WayStart start{.guarded = way.guarded, .position = position};
  for (const SolidContact& contact : problem.solids) {
    start.solids.push_back(contact.solid);
    start.forces.emplace_back(contact.forces);
  }
  return start;
}

}  // namespace thinwall
