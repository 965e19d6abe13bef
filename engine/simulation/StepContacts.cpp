#include "engine/simulation/StepContacts.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/contact/DeepestPoint.hpp"
#include "engine/contact/SolidGap.hpp"
#include "engine/equilibrium/HeldWall.hpp"
#include "engine/equilibrium/ShaftContact.hpp"
#include "engine/simulation/PrescribedPoint.hpp"
#include "engine/simulation/Puncture.hpp"
#include "engine/simulation/SimulationFailure.hpp"
#include "engine/tool/FirstContact.hpp"
#include "engine/tool/ToolSolids.hpp"

namespace thinwall {
namespace {

/// Springs that keep lips out of a shaft, over the wall's stiffness: they give by a hundredth of what the wall does.
constexpr double kShaftStiffness = 100;

/// Slip before friction is overcome, part of the needle's radius.
constexpr double kShaftGive = 1e-3;

/// Gap at which the wall rests on a tool: small beside the tool and any depth that matters, whatever the mesh.
double contact_range(const ToolSolid& solid) {
  return std::min(1e-5 * solid.extent(), 1e-3 * solid.sharpness());  // metres
}

/// How far faces may dip into a solid. The vertices of a wall that hugs a ball lie on it, and the chords between them
/// dip in by edge^2 / (6 radius): up to triangles of 0.4 radii that is left to them. To keep flat triangles all outside
/// would hold the wall off by as much, with three to four times the error in force.
double contact_dip(const ToolSolid& solid) {
  return 0.03 * solid.sharpness();  // metres
}

/// A solid near a wall moves no farther in one solution than this part of its smallest radius of curvature: what it
/// touched before is then at its rounded edges at most, not inside, where it might leave through the wrong side.
constexpr double kRoundedMotion = 0.9;

/// Part of a unit vector along an axis that is rounding.
constexpr double kNoPart = 1e-9;

/// Two places of a tool that are the same but for rounding.
constexpr double kSamePlace = 1e-9;  // metres

/// The same for unit vectors.
constexpr double kSameDirection = 1e-9;

/// A place farther behind a line than so many times what both have moved was never in its way: to take hold of it would
/// draw it there in one step. More than once, as a line that goes sideways meets what lies on slopes.
constexpr double kPassedWays = 2;

/// Whether a needle moves along itself alone: then it is its point that pushes, and its shaft only slides.
bool slides_along_itself(const ToolDefinition& tool, const ToolPose& begin, const ToolPose& end) {
  const Eigen::Vector3d motion = end.tip - begin.tip;
  return tool.kind == ToolKind::kNeedle && (end.direction - begin.direction).norm() <= kSameDirection &&
         (end.axis - begin.axis).norm() <= kSameDirection &&
         begin.direction.cross(motion).norm() <= kSameDirection * motion.norm();
}

/// 1 for each axis along which something may move, 0 where all is fixed.
Eigen::Vector3d free_axes(const Eigen::Vector3d& free_share) {
  return (free_share.array() > 0).cast<double>();
}

/// Lets the jaws of forceps feel how thick the wall between them is. `position`: (unknowns), metres.
void pinch(const BodyModel& model, const Eigen::VectorXd& position, int tool, EquilibriumProblem& problem) {
  std::vector<SolidContact*> jaws;
  for (SolidContact& contact : problem.solids) {
    if (contact.tool == tool && !contact.solid.is_part()) jaws.push_back(&contact);
  }
  assert(jaws.size() == 2 && "forceps have two jaws");
  const ToolSolid &one = jaws[0]->solid, &other = jaws[1]->solid;
  jaws[0]->inner_side = inner_side(one, other);
  jaws[1]->inner_side = inner_side(other, one);
  PinchedWall pinched = pinched_wall(model, position, one, other);
  jaws[0]->pinched = std::move(pinched.one);
  jaws[1]->pinched = std::move(pinched.other);
}

/// Whether no vertex of a triangle that a gap hangs on may move along its normal.
bool is_rigid(const BodyModel& model, const Eigen::Vector3i& triangle, const SolidGap& gap) {
  for (int k = 0; k < 3; ++k) {
    if (gap.weights[k] == 0) continue;
    for (int axis = 0; axis < 3; ++axis) {
      if (!model.fixed[3 * triangle[k] + axis] && std::abs(gap.normal[axis]) > kNoPart) return false;
    }
  }
  return true;
}

}  // namespace

void StepContacts::attach(std::span<const ToolPose> begin, std::span<const ToolPose> end,
                          EquilibriumProblem& problem) const {
  problem.attachments = state_.attachments;
  // A tool that is set elsewhere between two clips lets go of what it held.
  std::erase_if(problem.attachments, [&](const Attachment& attachment) {
    return (prescribed_point(attachment, begin[attachment.tool]) - attachment.target).norm() > kSamePlace;
  });
  for (int tool = 0; tool < static_cast<int>(tools_.size()); ++tool) {
    if (tools_[tool].kind == ToolKind::kLine) attach_line(tool, begin[tool], end[tool], problem);
    if (tools_[tool].kind != ToolKind::kPoint) continue;
    const bool attached = std::any_of(problem.attachments.begin(), problem.attachments.end(),
                                      [&](const Attachment& attachment) { return attachment.tool == tool; });
    if (attached) continue;
    auto hit = first_entry_on_segment(surface(), begin[tool].tip, end[tool].tip);
    // Let go of, a wall may spring back farther than the tool has gone.
    if (!hit) hit = overrun_by(surface(), state_.previous_position, begin[tool].tip, begin[tool].direction);
    if (hit) {
      Attachment attachment{.tool = tool, .vertices = model_.surface[hit->triangle], .weights = hit->weights};
      attachment.prescribed = free_axes(free_share(model_, attachment));
      if (attachment.prescribed.isZero()) {
        throw SimulationFailure("tool `" + tools_[tool].name + "` presses on a point of body `" +
                                model_.definition.name + "` that `fixed` holds along all axes");
      }
      problem.attachments.push_back(attachment);
    }
  }
  for (Attachment& attachment : problem.attachments) {
    attachment.target = prescribed_point(attachment, end[attachment.tool]);
  }
}

void StepContacts::attach_line(int tool, const ToolPose& begin, const ToolPose& end,
                               EquilibriumProblem& problem) const {
  const double moved = (end.tip - begin.tip).norm();
  for (const LineCrossing& crossing : line_crossings(surface(), tools_[tool], end)) {
    if (crossing.travel > 0) continue;
    Attachment attachment{.tool = tool, .vertices = model_.surface[crossing.triangle], .weights = crossing.weights};
    const Eigen::Vector3d place = material_point(attachment, state_.equilibrium.position);
    const double sprung = (place - material_point(attachment, state_.previous_position)).norm();
    if (crossing.travel < -kPassedWays * (moved + sprung)) continue;
    const Eigen::Vector3d offset = place - end.tip;
    // A line laid across a border that is held bends around it: of a triangle that is held in part the free corners
    // follow the line.
    attachment.followed = free_share(model_, attachment);
    attachment.prescribed = free_axes(attachment.followed);
    attachment.touched = place;
    attachment.offset = {offset.dot(end.axis.cross(end.direction)), crossing.along};
    const bool crowded =
        std::any_of(problem.attachments.begin(), problem.attachments.end(), [&](const Attachment& other) {
          return other.tool == tool && std::abs(other.offset.y() - crossing.along) < 0.25 * model_.edge_length;
        });
    if (!crowded) problem.attachments.push_back(attachment);
  }
}

void StepContacts::refuse_held_places(const EquilibriumProblem& problem) const {
  // Where neither can give way, the force of a contact is as large as its multipliers have had time to grow.
  for (const SolidContact& contact : problem.solids) {
    for (const int s : model_.held_sites) {
      const ContactSite& site = model_.sites[s];
      if (!contact.meets(site.part)) continue;
      if (problem.is_free(contact.tool, site.triangle) || problem.passes(contact.tool, s)) continue;
      const Eigen::Vector3i& triangle = model_.surface[site.triangle];
      const double reach = contact.potential(site).onset - 2 * contact.range;
      const auto gap = solid_gap(contact.solid, reach, corners_of(triangle, state_.equilibrium.position), site.part,
                                 site.corner, GapTerms::kGradient);
      if (!gap || !is_rigid(model_, triangle, *gap)) continue;
      throw SimulationFailure("tool `" + tools_[contact.tool].name + "` presses on a part of body `" +
                              model_.definition.name +
                              "` that `fixed` holds and that cannot give way; press it less deep or beside that part");
    }
  }
}

bool StepContacts::release(std::span<const ToolPose> poses, EquilibriumProblem& problem) const {
  const std::size_t before = problem.attachments.size();
  std::erase_if(problem.attachments, [&](const Attachment& attachment) {
    const Eigen::Vector3d motion = attachment.target - material_point(attachment, state_.equilibrium.position);
    const Eigen::Vector3d& direction = poses[attachment.tool].direction;
    // A tool lifts off when it goes back and would have to pull the tissue after it. One that draws a flat wall along
    // its plane does neither but for round-off.
    return motion.dot(direction) < -kNoPart * motion.norm() &&
           attachment.force.dot(direction) > kNoPart * attachment.force.norm();
  });
  return problem.attachments.size() != before;
}

double StepContacts::largest_part(std::span<const ToolPose> begin, std::span<const ToolPose> end) const {
  double part = 1;
  for (std::size_t tool = 0; tool < tools_.size(); ++tool) {
    if (state_.cut.tool == static_cast<int>(tool)) continue;
    const std::vector<ToolSolid> before = tool_solids(tools_[tool], begin[tool]);
    const std::vector<ToolSolid> after = tool_solids(tools_[tool], end[tool]);
    for (std::size_t k = 0; k < before.size(); ++k) {
      const Eigen::AngleAxisd turn(Eigen::Matrix3d(after[k].frame * before[k].frame.transpose()));
      const double motion = (after[k].center - before[k].center).norm() + turn.angle() * before[k].extent();
      if (motion <= kRoundedMotion * before[k].sharpness()) continue;
      const double reach = motion + model_.edge_length;
      const double pushing = slides_along_itself(tools_[tool], begin[tool], end[tool])
                                 ? needle_cone(tools_[tool]) + reach
                                 : std::numeric_limits<double>::infinity();  // metres behind the tip
      double nearest = std::numeric_limits<double>::infinity();
      for (int v = 0; v < model_.vertices(); ++v) {
        const Eigen::Vector3d place = state_.equilibrium.position.segment<3>(3 * v);
        if (begin[tool].direction.dot(begin[tool].tip - place) > pushing) continue;
        nearest = std::min(nearest, distance_from(before[k], place));
      }
      if (nearest > reach) continue;
      part = std::min(part, kRoundedMotion * before[k].sharpness() / motion);
    }
  }
  return part;
}

void StepContacts::add_solids(std::span<const ToolPose> poses, EquilibriumProblem& problem) const {
  add_passed(poses, problem);
  for (int tool = 0; tool < static_cast<int>(tools_.size()); ++tool) {
    const double largest_pressure =
        state_.reference_pressure.size() > 0 ? state_.reference_pressure.lpNorm<Eigen::Infinity>() : 0;
    double range = 0;
    for (const ToolSolid& solid : contact_solids(tools_[tool], poses[tool])) {
      // Rims and corners come after their body and are as stiff as it is.
      if (!solid.is_part()) range = contact_range(solid);
      problem.solids.push_back(
          {.tool = tool,
           .solid = solid,
           .range = range,
           .dip = contact_dip(solid),
           .hugging_pressure = std::max(model_.wall_stiffness / solid.sharpness(), largest_pressure),
           .in_wall = state_.cut.tool == tool,
           .forces = state_.solid_forces[problem.solids.size()]});
    }
    if (tools_[tool].kind == ToolKind::kForceps) pinch(model_, state_.equilibrium.position, tool, problem);
  }
}

WayStart StepContacts::way(std::span<const ToolPose> begin, const EquilibriumProblem& problem) const {
  WayStart start{.solids = contact_solids(tools_, begin), .position = state_.equilibrium.position};
  for (std::size_t k = 0; k < start.solids.size(); ++k) {
    const SolidContact& after = problem.solids[k];
    const bool is_in_wall = !problem.free.empty() && !problem.free[after.tool].empty();
    start.guarded.push_back(is_guarded(tools_[after.tool].kind, start.solids, k, after.solid, is_in_wall));
    start.forces.emplace_back(state_.solid_forces[k]);
  }
  return start;
}

bool StepContacts::catch_passed_edges(EquilibriumProblem& problem, const Eigen::VectorXd& position) const {
  bool caught = false;
  for (SolidContact& contact : problem.solids) {
    if (contact.solid.role != ToolSolid::Role::kHull || contact.catches_edges || contact.in_wall) continue;
    contact.catches_edges = std::ranges::any_of(model_.sites, [&](const ContactSite& site) {
      if (site.part != SitePart::kEdge) return false;
      return solid_gap(contact.solid, -SolidContact::kPassedEdgeDip * contact.dip,
                       corners_of(model_.surface[site.triangle], position), site.part, site.corner, GapTerms::kGradient)
          .has_value();
    });
    caught = caught || contact.catches_edges;
  }
  return caught;
}

void StepContacts::add_shafts(std::span<const ToolPose> poses, EquilibriumProblem& problem) const {
  problem.free.resize(tools_.size());
  for (const Puncture& puncture : state_.punctures) {
    if (!puncture.tool) continue;
    problem.free[*puncture.tool] = free_triangles(model_, state_.punctures, *puncture.tool);
    if (!puncture.is_sealed()) continue;
    const ToolPose& pose = poses[*puncture.tool];
    const ToolDefinition& tool = tools_[*puncture.tool];
    ShaftContact shaft{.tool = *puncture.tool,
                       .tip = pose.tip,
                       .radius = tool.radius,
                       .cone = needle_cone(tool),
                       .spread = puncture.spread,
                       .stiffness = kShaftStiffness * model_.wall_stiffness,
                       .give = kShaftGive * tool.radius,
                       .points = puncture.points};
    shaft.frame << pose.axis.cross(pose.direction), pose.axis, pose.direction;
    problem.shafts.push_back(std::move(shaft));
  }
  problem.sealed.resize(model_.openings.size(), 0);
  for (std::size_t k = 0; k < problem.sealed.size(); ++k)
    problem.sealed[k] = is_shut(model_, state_.punctures, static_cast<int>(k));
}

void StepContacts::add_passed(std::span<const ToolPose> poses, EquilibriumProblem& problem) const {
  if (state_.piercing.empty() && state_.incising.empty()) return;
  problem.passed.resize(tools_.size());
  for (const std::vector<int>* passing : {&state_.piercing, &state_.incising}) {
    for (const int tool : *passing) {
      const ToolSolid solid = tool_solids(tools_[tool], poses[tool]).front();
      problem.passed[tool] =
          sites_in_the_way(model_, state_.equilibrium.position, solid, held_against(model_, poses[tool].direction));
    }
  }
}

bool StepContacts::is_out_of_wall(int tool, const ToolPose& pose) const {
  if (std::ranges::any_of(state_.punctures, [&](const Puncture& one) { return one.tool == tool; })) return false;
  const ToolSolid needle = tool_solids(tools_[tool], pose).front();
  const Eigen::VectorXd& position = state_.equilibrium.position;
  const std::vector<char> passed = sites_in_the_way(model_, position, needle, held_against(model_, pose.direction));
  for (std::size_t s = 0; s < passed.size(); ++s) {
    const ContactSite& site = model_.sites[s];
    if (!passed[s]) continue;
    const auto corners = corners_of(model_.surface[site.triangle], position);
    if (solid_gap(needle, 0, corners, site.part, site.corner, GapTerms::kGradient)) return false;
  }
  return true;
}

}  // namespace thinwall
