#include "studio/director/Incising.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <variant>
#include <vector>

#include "engine/cutting/SurfaceCurve.hpp"
#include "engine/tool/FirstContact.hpp"

namespace thinwall {
namespace {

bool is_in_wall(const Body& body, int tool) {
  return body.state().cut.tool == tool;
}

int first_triangle(const IncisionPlan& plan) {
  return plan.path.pieces.front().points.front().triangle;
}

/// The edge has gone through where it stands, or where it would stand the wall's thickness deeper: the dented wall lies
/// just before it. Where it has come to the path within the step, that is at the path's beginning.
void enter(const IncisionPlan& plan, Body& body, const BladeStep& step, double thickness) {
  std::vector<ToolPose> through(step.after.begin(), step.after.end());
  ToolPose& blade = through[static_cast<std::size_t>(step.tool)];
  if (plan.progress(step.end) > 0) blade = plan.pose_below(0);
  blade.tip += thickness * blade.direction;
  body.follow_blade(step.tool, through);
}

/// The path begins where an earlier cut gapes.
void enter_gap(const IncisionPlan& plan, Body& body, const BladeStep& step, double thickness) {
  const double next = plan.progress(2 * step.end - step.begin);
  const Eigen::Vector3d way = plan.path.at(next).position - plan.path.at(plan.progress(step.begin)).position;
  if (next <= 0 || way.norm() == 0) return;
  ToolPose blade = step.after[static_cast<std::size_t>(step.tool)];
  blade.tip += thickness * blade.direction;
  body.enter_gap(step.tool, blade, way.normalized());
}

}  // namespace

double cost_of_entry(const Body& body, const IncisionPlan& plan, const ToolDefinition& blade) {
  return body.model().cut_cost(first_triangle(plan)) * blade.width;
}

void begin_incision(IncisionPlan& plan, const Body& body, const ToolDefinition& blade) {
  plan.entry_cost = cost_of_entry(body, plan, blade);
  plan.edge_length = body.model().edge_length;
  if (plan.clip.marked) plan.mark = drawn_on_wall(plan.path, body.surface());
  const BodyModel& model = body.model();
  const SurfaceView rest{.triangles = model.definition.mesh.triangles, .position = model.rest_position};
  plan.rest_length = 0;
  for (const auto& piece : plan.path.pieces) plan.rest_length += length_of(rest, piece.points);
}

std::optional<BladeInput> blade_input(const IncisionPlan& plan, const Body& body, const BladeStep& step) {
  const double from = plan.progress(step.begin), to = plan.progress(step.end);
  // In the step in which it turns back it still comes to the path's end.
  if (!is_in_wall(body, step.tool) || (plan.goes_out(step.end) && to <= from)) return std::nullopt;
  // A line that moves takes the blade along.
  const Eigen::Vector3d drift = plan.mark ? plan.mark->drift : Eigen::Vector3d::Zero();
  const Eigen::Vector3d way = plan.path.at(to).position - plan.path.at(from).position + drift;
  BladeInput input{.tool = step.tool, .travel = to - from};
  if (way.norm() > 0) input.direction = way.normalized();
  input.travel = std::max(0.0, input.travel + drift.dot(input.direction));
  return input;
}

std::optional<Cut> incise(IncisionPlan& plan, Body& body, const BladeStep& step) {
  const auto tool = static_cast<std::size_t>(step.tool);
  if (!is_in_wall(body, step.tool)) {
    if (plan.entered || plan.goes_out(step.end)) return std::nullopt;
    const bool must_go_on = plan.progress(2 * step.end - step.begin) > 0;
    if (body.state().pressing[tool].work < plan.entry_cost && !must_go_on) return std::nullopt;
    const double thickness = body.model().rest[static_cast<std::size_t>(first_triangle(plan))].thickness;
    enter(plan, body, step, thickness);
    if (!is_in_wall(body, step.tool)) enter_gap(plan, body, step, thickness);
    if (is_in_wall(body, step.tool)) plan.feel_entry(step.end);
    return std::nullopt;
  }
  if (step.end >= plan.duration() - kTimeTolerance && plan.clip.withdraw) {
    body.leave_cut();
    return std::nullopt;
  }
  // The last bit of the path is cut once, as well as the triangles allow; what is left then would only turn back.
  const double length = plan.path.length();
  if (plan.progress(step.begin) >= length) return std::nullopt;
  std::vector<ToolPose> in_wall(step.after.begin(), step.after.end());
  // It has been at the path's end before it has gone out in this step.
  if (plan.goes_out(step.end)) in_wall[tool] = plan.pose_below(length);
  return body.follow_blade(step.tool, in_wall, plan.progress(step.end) < length);
}

std::optional<Cut> run_ahead(const IncisionPlan& plan, Body& body, const BladeStep& step) {
  if (!is_in_wall(body, step.tool) || plan.goes_out(step.end)) return std::nullopt;
  const double passed = plan.progress(step.end);
  return body.run_ahead(
      step.after, [&](double way) { return plan.pose_ahead(passed + way); }, plan.path.length() - passed);
}

void note_wall_below(IncisionPlan& plan, const Body& body, const ToolDefinition& blade, const BladeStep& step) {
  // Before its first cut the wall may be dented.
  if (!is_in_wall(body, step.tool) || !body.state().cut.tip || plan.goes_out(step.end)) return;
  const double travel = plan.progress(step.end) - plan.progress(step.begin);
  if (travel <= 0) return;
  PassedOver& passed = plan.passed_over;
  passed.note_cut(body.state().cut.length);
  const ToolPose& pose = step.after[static_cast<std::size_t>(step.tool)];
  const Eigen::Vector3d reach = blade.length * pose.direction;
  const SurfaceView wall = body.surface();
  if (first_entry_on_segment(wall, pose.tip - reach, pose.tip)) return;
  if (!first_entry_on_segment(wall, pose.tip, pose.tip + reach)) return;
  if (passed.whole() == 0) passed.since = step.begin;
  passed.length += travel;
}

void note_open_wall(IncisionPlan& plan, const Body& body, const BladeStep& step) {
  const CutProgress& cut = body.state().cut;
  const bool is_open = cut.is_in_wound || cut.gap || cut.ahead > 0;
  if (is_in_wall(body, step.tool) && is_open) plan.open += plan.progress(step.end) - plan.progress(step.begin);
}

std::vector<std::string> passed_over_notes(std::span<const ScheduledClip> clips,
                                           std::span<const ToolDefinition> tools) {
  std::vector<std::string> notes;
  for (const ScheduledClip& clip : clips) {
    const auto* plan = std::get_if<IncisionPlan>(&clip.plan);
    if (plan == nullptr) continue;
    const auto blade = std::ranges::find(tools, plan->clip.tool, &ToolDefinition::name);
    const PassedOver& passed = plan->passed_over;
    if (passed.whole() <= blade->width) continue;
    notes.push_back(fmt::format(
        "body `{}`: from {:.4g} s on blade `{}` passed above the wall over {:.3g} of the {:.3g} mm of its path, and "
        "cut nothing there: the wall had given way from under it; more `depth` reaches it{}",
        plan->clip.body, clip.begin + passed.since, plan->clip.tool, 1e3 * passed.whole(), 1e3 * plan->path.length(),
        plan->mark ? "" : ", or `marked: true` lets the blade follow the wall"));
  }
  return notes;
}

std::string to_text(const RunningCut& run, const Body& body) {
  return fmt::format(
      "body `{}`: from {:.4g} s on the cut of blade `{}` ran ahead, by {:.3g} mm in all: the tense wall released more "
      "there than its `toughness` asks",
      body.model().definition.name, run.since, run.blade, 1e3 * body.state().cut.run_length);
}

}  // namespace thinwall
