#include "studio/director/ScenarioRun.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>

#include "engine/simulation/Body.hpp"
#include "engine/simulation/SimulationFailure.hpp"
#include "studio/director/BodyInputs.hpp"
#include "studio/director/CutCheck.hpp"
#include "studio/director/DirectedTool.hpp"
#include "studio/director/DrainCheck.hpp"
#include "studio/director/FirstPoses.hpp"
#include "studio/director/FollowedPoint.hpp"
#include "studio/director/Grasping.hpp"
#include "studio/director/Incising.hpp"
#include "studio/director/IntegratorEnergy.hpp"
#include "studio/director/KeptWay.hpp"
#include "studio/director/MarkedPath.hpp"
#include "studio/director/MeetingBodies.hpp"
#include "studio/director/Plan.hpp"
#include "studio/director/RunNotes.hpp"
#include "studio/director/Schedule.hpp"
#include "studio/director/SnapshotMaker.hpp"
#include "studio/director/StateDigest.hpp"
#include "studio/director/StepTally.hpp"
#include "studio/organs/BodyBuilder.hpp"

namespace thinwall {

struct ScenarioRun::Implementation {
  Scenario scenario;
  std::vector<std::unique_ptr<Body>> bodies;
  std::vector<std::shared_ptr<const SnapshotTopology>> topologies;
  std::map<std::string, DirectedTool> tools;
  std::vector<ScheduledClip> clips;
  std::vector<FollowedPoint> points;
  std::vector<std::string> warnings;
  MeetingBodies meetings;
  Snapshot snapshot;
  StepRecord record;
  std::map<std::size_t, RunningCut> runs;  // by the body's index
  long steps = 0;
  long cuts = 0;
  StepTally tally;
  IntegratorEnergy integrator_energy;

  explicit Implementation(const Scenario& the_scenario) : scenario(the_scenario) {
    for (const BodyScenario& description : scenario.bodies) {
      BodyDefinition definition = build_body(description, warnings);
      refuse_uncuttable(scenario.timeline, definition);
      bodies.push_back(make_body(description, std::move(definition)));
      bodies.back()->settle(load_factors(description, 0));
      topologies.push_back(snapshot_topology(bodies.back()->model()));
      std::ranges::copy(thick_wall_notes(scenario, bodies.back()->model().definition), std::back_inserter(warnings));
      std::ranges::copy(start_notes(*bodies.back(), scenario.simulation), std::back_inserter(warnings));
    }
    for (int k = 0; k < static_cast<int>(scenario.tools.size()); ++k) {
      tools[scenario.tools[k].name].index = k;
      tools[scenario.tools[k].name].pose.opening = scenario.tools[k].opening;
    }
    for (const RecordedPoint& point : scenario.record.points) points.push_back(follow(point, bodies));
    const auto plan_one = [this](const Clip& clip) { return plan(clip); };
    for (Plan& planned : plan_all(scenario.timeline, plan_one)) clips.push_back({.plan = std::move(planned)});
    std::ranges::copy(
        far_side_notes(scenario.timeline, [this](const std::string& body) -> const Body& { return body_named(body); }),
        std::back_inserter(warnings));
    schedule(scenario.timeline, clips);
    refuse_endless(scenario.timeline, clips, step_length());
    refuse_overlaps(scenario.timeline, clips);
    refuse_overdrawn(scenario.timeline, clips,
                     [this](const std::string& body) -> const Body& { return body_named(body); });
    foresee_moves(scenario.timeline, clips);
    set_first_poses(scenario.timeline, clips, tools);
    note_buried_tools();
    write_moment();
  }

  std::unique_ptr<Body> make_body(const BodyScenario& description, BodyDefinition definition) const {
    try {
      return std::make_unique<Body>(std::move(definition), scenario.tools, scenario.simulation);
    } catch (const std::invalid_argument& refusal) {
      throw InputErrors({{description.location, fmt::format("bodies.{}: {}", description.name, refusal.what())}});
    }
  }

  double step_length() const { return scenario.simulation.time_step; }
  double time() const { return static_cast<double>(steps) * step_length(); }

  std::size_t body_index(const std::string& name) const {
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      if (bodies[k]->model().definition.name == name) return k;
    }
    throw InputErrors({{SourceLocation{.file = scenario.file}, "no body is called `" + name + "`"}});
  }

  const Body& body_named(const std::string& name) const { return *bodies[body_index(name)]; }

  Plan plan(const Clip& clip) const {
    const std::string name = tool_of(clip);
    const DirectedTool tool = name.empty() ? DirectedTool{} : tools.at(name);
    const PlannedTool planned{.definition = name.empty() ? ToolDefinition{} : scenario.tools[tool.index],
                              .pose = tool.pose,
                              .is_first = !tool.has_begun};
    return plan_clip(clip, planned, [this](const std::string& body) -> const Body& { return body_named(body); });
  }

  /// The plan of a clip that begins, on the wall as it is now, or as it was where that has none for it any more.
  Plan plan_begun(std::size_t index) {
    const Clip& clip = scenario.timeline[index];
    try {
      return plan(clip);
    } catch (const InputErrors& missed) {
      const std::string tool = tool_of(clip), body = body_of(clip);
      if (tool.empty() || body.empty()) throw;
      auto kept = kept_way(clips[index].plan, scenario.tools[tools.at(tool).index], body_named(body).surface());
      if (!kept) throw;
      warnings.push_back(kept_way_note(index + 1, clips[index].begin, missed));
      return *std::move(kept);
    }
  }

  void begin_clips(double until, const DrivenTool* driven) {
    for (std::size_t k = 0; k < clips.size(); ++k) {
      ScheduledClip& clip = clips[k];
      if (clip.begun || clip.begin >= until - kTimeTolerance) continue;
      clip.begun = true;
      clip.plan = plan_begun(k);
      schedule(scenario.timeline, clips);
      refuse_overlaps(scenario.timeline, clips);
      turn_at_step_end(scenario.timeline, clips, k, step_length());
      if (const auto* fill = std::get_if<FillPlan>(&clip.plan)) {
        if (auto note = fill_note(k + 1, *fill)) warnings.push_back(*std::move(note));
      }
      const std::string name = tool_of(scenario.timeline[k]);
      if (name.empty()) continue;
      DirectedTool& tool = tools.at(name);
      // A clip may begin elsewhere than the last one ended: the tool is set there and touches nothing on the way.
      const bool is_driven = driven != nullptr && driven->index == tool.index;
      const ToolPose beginning = is_driven ? tool.pose : *beginning_of(clip.plan);
      const bool set_elsewhere = tool.is_set_elsewhere(beginning);
      tool.begin_clip(beginning);
      if (std::holds_alternative<GraspPlan>(clip.plan)) tool.holds = true;
      if (std::holds_alternative<ReleasePlan>(clip.plan)) tool.holds = false;
      tool.leave_walls(bodies, poses(), set_elsewhere);
      if (auto* incision = std::get_if<IncisionPlan>(&clip.plan)) {
        begin_incision(*incision, body_named(incision->clip.body), scenario.tools[tool.index]);
      }
    }
  }

  std::vector<ToolPose> poses() const {
    std::vector<ToolPose> now(scenario.tools.size());
    for (const auto& [name, tool] : tools) now[tool.index] = tool.pose;
    return now;
  }

  /// Moves the tools to where they are at a time; returns the poses before and after, in the order of the scenario.
  std::pair<std::vector<ToolPose>, std::vector<ToolPose>> move_tools(double until, const DrivenTool* driven) {
    const std::vector<ToolPose> before = poses();
    for (auto& [name, tool] : tools) tool.phase = "idle";
    for (const auto& [name, k] : driving_clips(scenario.timeline, clips, time(), until)) {
      const ScheduledClip& clip = clips[k];
      const ToolMoment moment = *moment_of(clip.plan, until - clip.begin);
      DirectedTool& tool = tools.at(name);
      const bool is_planned = knows_depth(clip.plan);
      if (!is_planned) tool.find_first_contact(scenario.tools[tool.index], bodies, moment.pose);
      tool.pose = moment.pose;
      tool.phase = moment.phase;
      tool.depth = is_planned ? moment.depth : tool.depth_beyond_contact();
    }
    for (auto& [name, tool] : tools) {
      if (driven != nullptr && driven->index == tool.index) tool.pose = driven->pose;
    }
    return {before, poses()};
  }

  /// Lets the blades of a step cut.
  void follow_blades(std::span<const ToolPose> after, double until) {
    for (ScheduledClip& clip : clips) {
      auto* incision = std::get_if<IncisionPlan>(&clip.plan);
      if (incision == nullptr || !clip.begun || clip.end <= time() + kTimeTolerance) continue;
      const BladeStep step{.tool = tools.at(incision->clip.tool).index,
                           .begin = time() - clip.begin,
                           .end = until - clip.begin,
                           .after = after};
      const std::size_t index = body_index(incision->clip.body);
      Body& body = *bodies[index];
      const auto cut = [&](auto&& how) {
        const SurfaceMesh uncut = body.model().definition.mesh;
        const std::optional<Cut> made = how();
        if (made) {
          take_over(*made, index, uncut, until);
          incision->cut += made->length;
        }
        return made.has_value();
      };
      cut([&] { return incise(*incision, body, step); });
      while (cut([&] { return run_ahead(*incision, body, step); })) {
        runs.try_emplace(index, RunningCut{.blade = incision->clip.tool, .since = until});
      }
      note_wall_below(*incision, body, scenario.tools[step.tool], step);
      note_open_wall(*incision, body, step);
    }
  }

  /// The clip that drives a needle through a wall, if one does.
  ScheduledClip* piercing_by(const std::string& tool) {
    const auto found = std::ranges::find_if(clips, [&](const ScheduledClip& one) {
      const auto* piercing = std::get_if<PiercingPlan>(&one.plan);
      return piercing != nullptr && one.begun && one.end > time() + kTimeTolerance && piercing->clip.tool == tool;
    });
    return found == clips.end() ? nullptr : &*found;
  }

  void feel_rupture(const std::string& tool, double until) {
    ScheduledClip* clip = piercing_by(tool);
    if (clip == nullptr) return;
    std::get<PiercingPlan>(clip->plan).feel_rupture(until - clip->begin);
    tools.at(tool).phase = "rupture";
  }

  /// Takes over where the wall has given way to needles within a step.
  void take_over_ruptures(std::size_t index, double until) {
    for (const StepRupture& one : bodies[index]->report().ruptures) {
      take_over(one.rupture.cut, index, one.uncut, until);
      feel_rupture(scenario.tools[one.tool].name, until);
    }
  }

  /// Lets the needles of a step pierce, and those that an earlier clip has left in a wall come out.
  void let_needles_pierce(std::span<const ToolPose> after, double until) {
    for (auto& [name, tool] : tools) {
      if (scenario.tools[tool.index].kind != ToolKind::kNeedle) continue;
      const ScheduledClip* clip = piercing_by(name);
      for (std::size_t index = 0; index < bodies.size(); ++index) {
        Body& body = *bodies[index];
        const bool is_in_wall = std::ranges::any_of(
            body.state().punctures, [own = tool.index](const Puncture& puncture) { return puncture.tool == own; });
        const bool pierces =
            clip != nullptr && std::get<PiercingPlan>(clip->plan).clip.body == body.model().definition.name;
        if (!is_in_wall && !pierces) continue;
        const SurfaceMesh uncut = body.model().definition.mesh;
        const std::optional<Rupture> rupture = body.pierce(tool.index, after);
        if (!rupture) continue;
        take_over(rupture->cut, index, uncut, until);
        feel_rupture(name, until);
      }
    }
  }

  /// Brings what names places of a body's surface onto the one that a cut has left at the end of a step.
  void take_over(const Cut& cut, std::size_t index, const SurfaceMesh& uncut, double until) {
    carry_over(points, *bodies[index], uncut, cut);
    carry_over(clips, *bodies[index], uncut, cut);
    topologies[index] = snapshot_topology_after_cut(bodies[index]->model(), *topologies[index], until);
    ++cuts;
  }

  void note_buried_tools() {
    for (const auto& [name, tool] : tools) {
      for (const auto& body : bodies) {
        auto note = buried_tool_note(scenario.tools[tool.index], tool.pose, *body);
        if (note) warnings.push_back(*std::move(note));
      }
    }
  }

  /// Tells once for each bare point what tip it acts like on the membrane that it touches.
  void note_bare_points() {
    for (const auto& body : bodies) {
      if (body->model().definition.model != WallModel::kMembrane) continue;
      for (const Attachment& attachment : body->state().attachments) {
        const ToolDefinition& tool = scenario.tools[attachment.tool];
        DirectedTool& directed = tools.at(tool.name);
        if (tool.kind != ToolKind::kPoint || directed.noted) continue;
        directed.noted = true;
        warnings.push_back(bare_point_note(tool, body->surface(), attachment));
      }
    }
  }

  bool has_ended() const { return time() >= end_of(clips) - kTimeTolerance; }

  void step(int count = 1, const DrivenTool* driven = nullptr) {
    const double next = static_cast<double>(steps + count) * step_length();
    begin_clips(next, driven);
    follow_marks(clips, bodies, scenario.tools, time());
    const auto [before, after] = move_tools(next, driven);
    try {
      for (std::size_t index = 0; index < bodies.size(); ++index) {
        const BodyInput input = input_of(scenario.bodies[index], *bodies[index], clips, tools, time(), next);
        bodies[index]->advance(before, after, count * step_length(), input);
        take_over_ruptures(index, next);
        tally.note(bodies[index]->model().definition.name, bodies[index]->report(), next);
      }
      follow_blades(after, next);
      let_needles_pierce(after, next);
    } catch (const SimulationFailure& failure) {
      throw SimulationFailure(fmt::format("at {:.6g} s (step {}): {}", next, steps + count, failure.what()));
    }
    steps += count;
    feel_grasps(clips, tools, bodies, next);
    note_bare_points();
    write_moment();
  }

  ToolResponse respond(int index, double duration, double reach) {
    const std::vector<ToolPose> now = poses();
    ToolResponse all{.pose = now[index], .sites = {}, .ahead = {}};
    for (const auto& body : bodies) {
      const ToolResponse one = body->respond(index, now, duration, reach);
      all.force += one.force;
      std::ranges::copy(one.sites, std::back_inserter(all.sites));
      all.holds = all.holds || one.holds;
      all.held_force += one.held_force;
      all.held_by_motion += one.held_by_motion;
      if (one.ahead.gap < all.ahead.gap) all.ahead = one.ahead;
    }
    return all;
  }

  void write_moment() {
    record = {.time = time(), .tools = {}, .bodies = {}};
    record.tools.resize(scenario.tools.size());
    const Eigen::Vector3d& gravity = scenario.simulation.gravity;
    snapshot = {
        .time = time(), .gravity = {gravity.x(), gravity.y(), gravity.z()}, .surfaces = {}, .tools = {}, .scalars = {}};
    for (const auto& [name, tool] : tools) {
      record.tools[tool.index] = tool_record(name, tool, bodies);
    }
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      record.bodies.push_back(body_record(*bodies[k]));
      std::ranges::copy(chamber_records(*bodies[k]), std::back_inserter(record.chambers));
      integrator_energy.note(*bodies[k], time());
      snapshot.surfaces.push_back(snapshot_surface(*bodies[k], topologies[k]));
      add_scalars(*bodies[k], snapshot.scalars);
    }
    std::ranges::copy(meetings.notes(bodies, time()), std::back_inserter(warnings));
    for (const FollowedPoint& point : points) record.points.push_back(point.record());
    for (std::size_t k = 0; k < scenario.tools.size(); ++k) {
      const DirectedTool& tool = tools.at(scenario.tools[k].name);
      snapshot.tools.push_back(snapshot_tool(scenario.tools[k], tool.pose, record.tools[k]));
    }
  }
};

ScenarioRun::ScenarioRun(const Scenario& scenario) : implementation_(std::make_unique<Implementation>(scenario)) {}
ScenarioRun::~ScenarioRun() = default;
ScenarioRun::ScenarioRun(ScenarioRun&&) noexcept = default;
ScenarioRun& ScenarioRun::operator=(ScenarioRun&&) noexcept = default;

bool ScenarioRun::step() {
  if (implementation_->has_ended()) return false;
  implementation_->step();
  return true;
}

void ScenarioRun::step_driven(int count, const DrivenTool& driven) {
  implementation_->step(count, &driven);
}

ToolResponse ScenarioRun::respond(int tool, double duration, double reach) {
  return implementation_->respond(tool, duration, reach);
}

long ScenarioRun::cuts() const {
  return implementation_->cuts;
}

double ScenarioRun::time() const {
  return implementation_->time();
}

double ScenarioRun::planned_duration() const {
  return end_of(implementation_->clips);
}

const Snapshot& ScenarioRun::snapshot() const {
  return implementation_->snapshot;
}

const StepRecord& ScenarioRun::record() const {
  return implementation_->record;
}

std::vector<TimedText> ScenarioRun::captions() const {
  return texts_of(implementation_->scenario.timeline, implementation_->clips, false);
}

std::vector<TimedText> ScenarioRun::chapters() const {
  return texts_of(implementation_->scenario.timeline, implementation_->clips, true);
}

std::vector<std::string> ScenarioRun::warnings() const {
  std::vector<std::string> all = implementation_->warnings;
  std::ranges::copy(implementation_->tally.warnings(implementation_->steps), std::back_inserter(all));
  const Scenario& scenario = implementation_->scenario;
  std::ranges::copy(implementation_->integrator_energy.warnings(scenario.simulation.analysis, !scenario.tools.empty()),
                    std::back_inserter(all));
  std::ranges::copy(ended_clip_notes(implementation_->clips, time()), std::back_inserter(all));
  for (const auto& [index, run] : implementation_->runs) all.push_back(to_text(run, *implementation_->bodies[index]));
  std::ranges::copy(passed_over_notes(implementation_->clips, implementation_->scenario.tools),
                    std::back_inserter(all));
  return all;
}

std::string ScenarioRun::state_digest() const {
  return thinwall::state_digest(implementation_->bodies);
}

}  // namespace thinwall
