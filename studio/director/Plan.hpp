#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "studio/director/ClipPlan.hpp"
#include "studio/director/FillPlan.hpp"
#include "studio/director/GraspPlan.hpp"
#include "studio/director/IncisionPlan.hpp"
#include "studio/director/PiercingPlan.hpp"

namespace thinwall {

/// What a clip has come to, held against the bodies.
using Plan =
    std::variant<PalpationPlan, PiercingPlan, IncisionPlan, MovePlan, GraspPlan, ReleasePlan, FillPlan, WaitClip>;

/// The tool of a clip when its plan is made.
struct PlannedTool {
  ToolDefinition definition;
  ToolPose pose;
  bool is_first = true;  // whether no clip has driven it yet
};

/// Holds a clip against the bodies as they are. `tool`: the clip's, anything where it drives none; `body_of`: by name.
/// Throws InputErrors as the plans do, with the path of the clip.
Plan plan_clip(const Clip& clip, const PlannedTool& tool,
               const std::function<const Body&(const std::string&)>& body_of);

/// The plans of all clips. `plan_one`: gives that of one. Throws InputErrors with the mistakes of all.
std::vector<Plan> plan_all(std::span<const Clip> timeline, const std::function<Plan(const Clip&)>& plan_one);

/// Of a palpation or piercing; nullptr of others.
PalpationPlan* pressing_of(Plan& plan);

double duration_of(const Plan& plan);  // seconds

/// Where the plan's tool begins; nullptr when it drives none.
const ToolPose* beginning_of(const Plan& plan);

/// Where the plan's tool is `time` seconds after the beginning; nothing when it drives none.
std::optional<ToolMoment> moment_of(const Plan& plan, double time);

/// Whether the plan itself knows how deep its tool is: it was held against the surface that the tool meets.
bool knows_depth(const Plan& plan);

/// The tool that a clip drives; empty when it drives none.
std::string tool_of(const Clip& clip);

/// The body whose wall a clip's tool is brought to; empty where there is none.
std::string body_of(const Clip& clip);

/// What is shown while a clip lasts that has no caption of its own; empty for most.
std::string standard_caption(const Clip& clip);

}  // namespace thinwall
