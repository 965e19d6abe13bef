#include "studio/director/Plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <type_traits>
#include <utility>

#include "studio/scenario/InputError.hpp"

namespace thinwall {
namespace {

template <typename Kind>
constexpr bool kDrivesTool = !std::is_same_v<Kind, FillPlan> && !std::is_same_v<Kind, WaitClip>;

template <typename Kind>
constexpr bool kHasTool = !std::is_same_v<Kind, FillClip> && !std::is_same_v<Kind, WaitClip>;

/// Three digits, and all of a larger number before its point: "0.25", "1650".
std::string told(double value) {
  return value < 999.5 ? fmt::format("{:.3g}", value) : fmt::format("{:.0f}", value);
}

/// "Filling: 5 ml in 2 s", "Pressure to 2 kPa in 2 s"
std::string fill_caption(const FillClip& fill) {
  if (fill.pressure) return fmt::format("Pressure to {:.3g} kPa in {} s", 1e-3 * *fill.pressure, told(fill.duration));
  return fmt::format("{}: {} ml in {} s", fill.added < 0 ? "Draining" : "Filling", told(1e6 * std::abs(fill.added)),
                     told(fill.duration));
}

/// "Palpation: 4 mm deep at 10 mm/s"
template <typename Action>
std::string depth_caption(const std::string& what, const Action& action) {
  return fmt::format("{}: {} mm deep at {} mm/s", what, told(1e3 * action.depth), told(1e3 * action.speed));
}

Plan plan_action(const Clip& clip, const PlannedTool& tool,
                 const std::function<const Body&(const std::string&)>& body_of) {
  if (const auto* palpate = std::get_if<PalpateClip>(&clip.action)) {
    return plan_palpation(*palpate, tool.definition, body_of(palpate->body).surface(), clip.location);
  }
  if (const auto* pierce = std::get_if<PierceClip>(&clip.action)) {
    return plan_piercing(*pierce, tool.definition, body_of(pierce->body).surface(), clip.location);
  }
  if (const auto* incise = std::get_if<InciseClip>(&clip.action)) {
    return plan_incision(*incise, tool.definition, body_of(incise->body).surface(), clip.location);
  }
  if (const auto* grasp = std::get_if<GraspClip>(&clip.action)) {
    const Body& body = body_of(grasp->body);
    GraspPlan plan =
        plan_grasp(*grasp, tool.definition, body.surface(), body.model().definition.thickness, clip.location);
    plan.edge_length = body.model().edge_length;
    return plan;
  }
  if (const auto* fill = std::get_if<FillClip>(&clip.action)) {
    return plan_fill(*fill, body_of(fill->body), clip.location);
  }
  if (const auto* move = std::get_if<MoveClip>(&clip.action)) {
    return plan_move(*move, tool.pose, tool.is_first, clip.location);
  }
  if (const auto* release = std::get_if<ReleaseClip>(&clip.action)) {
    return plan_release(*release, tool.definition, tool.pose);
  }
  return std::get<WaitClip>(clip.action);
}

}  // namespace

Plan plan_clip(const Clip& clip, const PlannedTool& tool,
               const std::function<const Body&(const std::string&)>& body_of) {
  try {
    return plan_action(clip, tool, body_of);
  } catch (const InputErrors& refusal) {
    // A plan knows what it does, not where in the timeline it stands.
    std::vector<Diagnostic> named = refusal.diagnostics();
    for (Diagnostic& mistake : named) mistake.message = fmt::format("timeline[{}].{}", clip.number, mistake.message);
    throw InputErrors(std::move(named));
  }
}

std::vector<Plan> plan_all(std::span<const Clip> timeline, const std::function<Plan(const Clip&)>& plan_one) {
  std::vector<Plan> plans;
  std::vector<Diagnostic> mistakes;
  for (const Clip& clip : timeline) {
    try {
      plans.push_back(plan_one(clip));
    } catch (const InputErrors& of_clip) {
      std::ranges::copy(of_clip.diagnostics(), std::back_inserter(mistakes));
    }
  }
  if (!mistakes.empty()) throw InputErrors(std::move(mistakes));
  return plans;
}

PalpationPlan* pressing_of(Plan& plan) {
  if (auto* piercing = std::get_if<PiercingPlan>(&plan)) return piercing;
  return std::get_if<PalpationPlan>(&plan);
}

double duration_of(const Plan& plan) {
  return std::visit(
      [](const auto& own) -> double {
        if constexpr (std::is_same_v<std::decay_t<decltype(own)>, WaitClip>) {
          return own.duration;
        } else {
          return own.duration();
        }
      },
      plan);
}

const ToolPose* beginning_of(const Plan& plan) {
  return std::visit(
      [](const auto& own) -> const ToolPose* {
        if constexpr (kDrivesTool<std::decay_t<decltype(own)>>) {
          return &own.begin;
        } else {
          return nullptr;
        }
      },
      plan);
}

std::optional<ToolMoment> moment_of(const Plan& plan, double time) {
  return std::visit(
      [time](const auto& own) -> std::optional<ToolMoment> {
        if constexpr (kDrivesTool<std::decay_t<decltype(own)>>) {
          return own.at(time);
        } else {
          return std::nullopt;
        }
      },
      plan);
}

bool knows_depth(const Plan& plan) {
  return std::holds_alternative<PalpationPlan>(plan) || std::holds_alternative<PiercingPlan>(plan) ||
         std::holds_alternative<IncisionPlan>(plan);
}

std::string tool_of(const Clip& clip) {
  return std::visit(
      [](const auto& action) -> std::string {
        if constexpr (kHasTool<std::decay_t<decltype(action)>>) {
          return action.tool;
        } else {
          return "";
        }
      },
      clip.action);
}

std::string body_of(const Clip& clip) {
  return std::visit(
      [](const auto& action) -> std::string {
        if constexpr (requires { action.standoff; }) {
          return action.body;
        } else {
          return "";
        }
      },
      clip.action);
}

std::string standard_caption(const Clip& clip) {
  if (const auto* fill = std::get_if<FillClip>(&clip.action)) return fill_caption(*fill);
  if (std::holds_alternative<GraspClip>(clip.action)) return "Grasping";
  if (std::holds_alternative<ReleaseClip>(clip.action)) return "Release";
  return std::visit(
      [](const auto& action) -> std::string {
        using Kind = std::decay_t<decltype(action)>;
        if constexpr (std::is_same_v<Kind, PalpateClip>) return depth_caption("Palpation", action);
        if constexpr (std::is_same_v<Kind, PierceClip>) return depth_caption("Piercing", action);
        if constexpr (std::is_same_v<Kind, InciseClip>) return depth_caption("Incision", action);
        return "";
      },
      clip.action);
}

}  // namespace thinwall
