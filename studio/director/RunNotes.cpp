#include "studio/director/RunNotes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <variant>

#include "engine/contact/PointRadius.hpp"
#include "engine/contact/SolidGap.hpp"
#include "engine/equilibrium/CapFans.hpp"
#include "engine/mesh/MeshMeasures.hpp"
#include "engine/tool/FirstContact.hpp"
#include "engine/tool/ToolSolids.hpp"

namespace thinwall {
namespace {

/// Metres by which a tool may be in a wall that it lies on.
constexpr double kBuried = 1e-5;

std::optional<std::string> piercing_note(std::size_t number, const PiercingPlan& plan) {
  if (!plan.ruptures.empty()) return std::nullopt;
  return fmt::format(
      "timeline[{}]: needle `{}` has gone its whole depth of {:.4g} mm and no wall has given way to it; body `{}` is "
      "not pierced, unless the needle went in where it was open",
      number, plan.clip.tool, 1e3 * plan.clip.depth, plan.clip.body);
}

/// Of the path of a blade, below which it is told that this is all it has cut.
constexpr double kHardlyCut = 0.5;

/// Beyond a cut there may be one that is shorter than so many edges, which is no matter.
constexpr double kShortRest = 3;

std::optional<std::string> short_cut_note(std::size_t number, const IncisionPlan& plan) {
  const double length = plan.path.length(), rest = plan.rest_length / length;
  const double uncut = plan.rest_length - plan.cut - rest * (plan.open + plan.passed_over.whole());
  if (uncut < (1 - kHardlyCut) * plan.rest_length || uncut < kShortRest * plan.edge_length) return std::nullopt;
  return fmt::format(
      "timeline[{}]: blade `{}` has gone its whole path of {:.4g} mm and cut no more than {:.3g} mm of body `{}`, "
      "which gave way to it or is held along that path; hold the body (`fixed`) beside it but not nearer than an edge "
      "of its triangles ({:.3g} mm), go deeper, or take more steps (`time_step`)",
      number, plan.clip.tool, 1e3 * length, 1e3 * plan.cut, plan.clip.body, 1e3 * plan.edge_length);
}

std::optional<std::string> incision_note(std::size_t number, const IncisionPlan& plan) {
  if (plan.cut > 0) return short_cut_note(number, plan);
  const std::string which = fmt::format("timeline[{}]: blade `{}` has gone its whole path of {:.4g} mm and cut nothing",
                                        number, plan.clip.tool, 1e3 * plan.path.length());
  if (plan.path.length() >= plan.edge_length) {
    return which + fmt::format(
                       " of body `{}`, which gave way to it, was open there or is held along that path; hold the body "
                       "(`fixed`) beside it, go deeper, or take more steps (`time_step`)",
                       plan.clip.body);
  }
  return which + fmt::format(
                     "; body `{}` has triangles with edges of {:.3g} mm: a cut asks for a longer path or more "
                     "triangles",
                     plan.clip.body, 1e3 * plan.edge_length);
}

/// Jaws meet the wall at its vertices: between triangles that are larger than they are there may be none.
std::string coarse_mesh_note(const GraspPlan& plan) {
  if (plan.edge_length <= plan.jaw_width) return "";
  return fmt::format(
      "; edges of the triangles of body `{}`, {:.3g} mm, are longer than the jaws are wide, {:.3g} mm: "
      "they hold more triangles better",
      plan.clip.body, 1e3 * plan.edge_length, 1e3 * plan.jaw_width);
}

std::optional<std::string> grasp_note(std::size_t number, const GraspPlan& plan) {
  const GraspClip& clip = plan.clip;
  const std::string which = fmt::format("timeline[{}]: forceps `{}` have ", number, clip.tool);
  if (plan.largest_squeeze == 0) {
    return which +
           fmt::format(
               "closed to {:.4g} mm and squeezed nothing; for a wall between the jaws go deeper, turn `axis`, "
               "or close further",
               1e3 * clip.to) +
           coarse_mesh_note(plan);
  }
  if (plan.lost) {
    return which +
           fmt::format(
               "held nothing any more since {:.4g} s, after squeezing with {:.3g} N at most; to hold the wall "
               "go deeper, close further, or give the tool more `friction`",
               *plan.lost, plan.largest_squeeze) +
           coarse_mesh_note(plan);
  }
  if (clip.grip > 0 && !plan.stopped) {
    return which +
           fmt::format(
               "closed to {:.4g} mm and squeezed with {:.3g} N at most, less than `grip` = {:.4g} N; go deeper, "
               "close further, or ask for less",
               1e3 * clip.to, plan.largest_squeeze, clip.grip);
  }
  return std::nullopt;
}

double largest_thickness(const BodyDefinition& body) {
  return std::ranges::max(body.thickness);
}

std::optional<std::string> small_tool_note(const ToolDefinition& tool, const BodyDefinition& body) {
  const double thickest = largest_thickness(body);
  const bool is_round = tool.kind == ToolKind::kSphere || tool.kind == ToolKind::kCapsule;
  if (!is_round || tool.radius >= thickest) return std::nullopt;
  return fmt::format(
      "tool `{}` has a radius of {:.3g} mm, less than the wall of body `{}` is thick ({:.3g} mm): a thin wall is not "
      "pressed together across its thickness, so the dent within the wall and its part of the force are missing",
      tool.name, 1e3 * tool.radius, body.name, 1e3 * thickest);
}

std::optional<std::string> thick_wall_note(const BodyDefinition& body) {
  const SurfaceMesh& mesh = body.mesh;
  if (body.fluid.kind == FluidKind::kNone || mesh.vertices.empty()) return std::nullopt;
  const double width = bounding_box(mesh.vertices).sizes().minCoeff();
  const double thickest = largest_thickness(body);
  if (2 * thickest <= width) return std::nullopt;
  return fmt::format(
      "body `{}` is {:.3g} mm wide, less than two walls of {:.3g} mm: the wall is drawn and its volume counted where "
      "no room is for it; see whether `thickness` and the `unit` of the mesh are meant so",
      body.name, 1e3 * width, 1e3 * thickest);
}

/// Whether `fixed` holds something of a body along each axis that gravity, metres / second^2, pulls along.
bool bears_its_weight(const BodyModel& model, const Eigen::Vector3d& gravity) {
  std::array<bool, 3> is_borne = {gravity.x() == 0, gravity.y() == 0, gravity.z() == 0};
  for (int k = 0; k < 3 * model.vertices(); ++k) is_borne[k % 3] = is_borne[k % 3] || model.fixed[k];
  return std::ranges::count(is_borne, true) == 3;
}

/// Whether nothing stretches a wall that has no stiffness across itself but by its tension.
bool is_slack(const BodyScenario& body) {
  if (is_scenery(body.fixed)) return false;
  if (body.model != WallModel::kMembrane || body.fluid.kind == FluidKind::kNone) return false;
  const auto has_pressure = [](const std::optional<double>& pressure) { return pressure.value_or(0) > 0; };
  const bool is_filled = has_pressure(body.fluid.initial_pressure) ||
                         std::ranges::any_of(body.fluid.chambers, [&](const ChamberDefinition& chamber) {
                           return has_pressure(chamber.initial_pressure);
                         });
  const Prestretch& stretch = body.prestretch.standard;
  return !is_filled && is_uniform(body.prestretch) && stretch.first <= 1 && stretch.second <= 1;
}

/// `number`: of the clip, from 1.
std::optional<std::string> far_side_note(std::size_t number, const PalpateClip& clip, const Body& body) {
  constexpr double kNear = 0.1;  // of the way through the body
  // The origin is what stands for a point that nobody has given: no side of a body is meant by it.
  if (clip.at.isZero(0)) return std::nullopt;
  const SurfaceView surface = body.surface();
  const auto near = first_entry(surface, clip.at, clip.direction), far = first_entry(surface, clip.at, -clip.direction);
  if (surface.open || !near || !far) return std::nullopt;
  const double way_through = -far->travel - near->travel;
  if (way_through <= 0 || -far->travel > kNear * way_through) return std::nullopt;
  const Eigen::Vector3d met = 1e3 * (clip.at + near->travel * clip.direction);
  return fmt::format(
      "timeline[{}]: along `direction` tool `{}` comes upon body `{}` at [{:.4g}, {:.4g}, {:.4g}] mm, and `at` is on "
      "its other side, {:.4g} mm on; to press there turn `direction` round",
      number, clip.tool, clip.body, met.x(), met.y(), met.z(), -1e3 * near->travel);
}

}  // namespace

std::vector<std::string> thick_wall_notes(const Scenario& scenario, const BodyDefinition& body) {
  std::vector<std::string> notes;
  const auto add = [&](std::optional<std::string> note) {
    if (note && std::ranges::find(notes, *note) == notes.end()) notes.push_back(*std::move(note));
  };
  add(thick_wall_note(body));
  for (const Clip& clip : scenario.timeline) {
    const auto* palpate = std::get_if<PalpateClip>(&clip.action);
    if (palpate == nullptr || palpate->body != body.name) continue;
    add(small_tool_note(*std::ranges::find(scenario.tools, palpate->tool, &ToolDefinition::name), body));
  }
  return notes;
}

std::string slack_wall_advice(const Scenario& scenario) {
  const auto slack = std::ranges::find_if(scenario.bodies, is_slack);
  if (slack == scenario.bodies.end()) return "";
  return fmt::format(
      "; body `{}` is a membrane that nothing stretches, which crumples as finely as its triangles where it is pressed "
      "or hangs: a `pressure` of its `contents`, a `prestretch` or `model: shell` is sooner computed",
      slack->name);
}

std::vector<std::string> start_notes(const Body& body, const SimulationOptions& options) {
  const std::string& name = body.model().definition.name;
  std::vector<std::string> notes;
  const auto free = body.model().rigid_motions.cols();
  if (free > 0 && options.analysis == Analysis::kQuasiStatic) {
    const char* weight = bears_its_weight(body.model(), options.gravity)
                             ? ""
                             : " and the weight: it does not fall, and lies on no tool; let `fixed` hold it along "
                               "gravity, or take `analysis: dynamic`";
    notes.push_back(fmt::format(
        "body `{}`: `fixed` leaves {} rigid motion{} free, removed by constraints weighted with the mass, which take "
        "up what the tools push{}",
        name, free, free == 1 ? "" : "s", weight));
  }
  const BodyDefinition& definition = body.model().definition;
  if (body.model().has_fluid() && has_free_corner(definition.mesh, definition.fixed)) {
    notes.push_back(fmt::format(
        "body `{}`: two of its caps meet where no wall is, and the ends of that edge are not held along their normals: "
        "these ends bear what presses on the caps there, and are drawn out the farther the finer the triangles are; "
        "let `fixed` hold the caps, as `base` and `ends` of a semicylinder",
        name));
  }
  if (body.report().unstable && options.analysis == Analysis::kDynamic) {
    notes.push_back(fmt::format(
        "body `{}`: its equilibrium before time zero is not stable: the wall would buckle there, and stays until "
        "something moves it; a small load across it shows where to, and a membrane that is pressed along itself "
        "wrinkles with `tension_field: true`",
        name));
  }
  return notes;
}

std::optional<std::string> buried_tool_note(const ToolDefinition& tool, const ToolPose& pose, const Body& body) {
  double deepest = 0;  // metres
  for (const ToolSolid& solid : tool_solids(tool, pose)) {
    for (const Eigen::Vector3i& triangle : body.model().surface) {
      const auto corners = corners_of(triangle, body.state().equilibrium.position);
      const auto gap = solid_gap(solid, -kBuried, corners, SitePart::kFace, 0, GapTerms::kGradient);
      if (gap) deepest = std::max(deepest, -gap->gap);
    }
  }
  if (deepest == 0) return std::nullopt;
  return fmt::format(
      "tool `{}` is {:.3g} mm deep in the wall of body `{}` before the first step: what drives them apart is work that "
      "nobody does, and results are in doubt; let its first clip begin where it touches nothing",
      tool.name, 1e3 * deepest, body.model().definition.name);
}

std::vector<std::string> far_side_notes(std::span<const Clip> timeline,
                                        const std::function<const Body&(const std::string&)>& body_of) {
  std::vector<std::string> notes;
  for (std::size_t k = 0; k < timeline.size(); ++k) {
    const auto* palpate = std::get_if<PalpateClip>(&timeline[k].action);
    if (palpate == nullptr) continue;
    if (auto note = far_side_note(k + 1, *palpate, body_of(palpate->body))) notes.push_back(*std::move(note));
  }
  return notes;
}

std::string bare_point_note(const ToolDefinition& tool, const SurfaceView& surface, const Attachment& attachment) {
  const double radius =
      effective_point_radius(surface.triangles, surface.position, attachment.vertices, attachment.weights);
  return fmt::format(
      "tool `{}`: a bare point on a membrane; on this mesh it acts like a tip of {:.3g} mm radius, and a finer "
      "mesh lowers its force; a `radius` makes the force independent of the mesh",
      tool.name, 1e3 * radius);
}

std::string kept_way_note(std::size_t number, double begin, const InputErrors& missed) {
  return fmt::format(
      "timeline[{}]: from {:.4g} s the tool goes the way that it had when the run began, as the wall is no longer "
      "where it was: {}",
      number, begin, missed.diagnostics().front().message);
}

std::optional<std::string> fill_note(std::size_t number, const FillPlan& plan) {
  const FillClip& clip = plan.clip;
  if (!clip.pressure) return std::nullopt;
  const double rise = *clip.pressure - plan.begin_pressure;
  if (clip.drains ? rise <= 0 : rise >= 0) return std::nullopt;
  return fmt::format("timeline[{}]: {} to {:.4g} Pa {} body `{}`, whose pressure is {:.4g} Pa when the clip begins",
                     number, clip.drains ? "drain" : "inflate", *clip.pressure, clip.drains ? "fills" : "drains",
                     clip.body, plan.begin_pressure);
}

std::vector<std::string> ended_clip_notes(std::span<const ScheduledClip> clips, double time) {
  std::vector<std::string> notes;
  for (std::size_t k = 0; k < clips.size(); ++k) {
    if (!clips[k].begun || clips[k].end > time + kTimeTolerance) continue;
    std::optional<std::string> note;
    if (const auto* piercing = std::get_if<PiercingPlan>(&clips[k].plan)) note = piercing_note(k + 1, *piercing);
    if (const auto* incision = std::get_if<IncisionPlan>(&clips[k].plan)) note = incision_note(k + 1, *incision);
    if (const auto* grasp = std::get_if<GraspPlan>(&clips[k].plan)) note = grasp_note(k + 1, *grasp);
    if (note) notes.push_back(*std::move(note));
  }
  return notes;
}

}  // namespace thinwall
