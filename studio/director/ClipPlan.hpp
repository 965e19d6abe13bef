#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>

#include "engine/tool/FirstContact.hpp"
#include "engine/tool/Tool.hpp"
#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// Where a tool is at a moment of a clip.
struct ToolMoment {
  ToolPose pose;
  std::string phase;
  double depth = 0;  // metres along the direction since first contact, 0 before; of a palpation
};

/// A palpation whose line of approach has been held against a surface.
struct PalpationPlan {
  PalpateClip clip;
  ToolPose begin;         // at the stand-off
  double to_contact = 0;  // metres from the stand-off to first contact
  double rest = 0;        // seconds at full depth at least

  double arrival() const;            // seconds until full depth
  double stay() const;               // seconds there
  double duration() const;           // seconds
  ToolMoment at(double time) const;  // `time`: seconds since the clip began, limited to its duration
};

/// How messages name a clip and what it is about.
struct ClipWords {
  std::string verb, tool, body;
};

/// A line along which a clip approaches a body.
struct LineOfApproach {
  std::string verb;
  Eigen::Vector3d at;         // metres
  Eigen::Vector3d direction;  // unit
  std::string body;
};

/// Where the line meets the body's wall from outside. Throws InputErrors at `location` when it misses it.
SurfaceEntry meet_on_approach(const LineOfApproach& line, const SurfaceView& surface, const SourceLocation& location);

/// Finds stand-off and first contact. Throws InputErrors at `location` when the line misses the body, or the tool
/// would touch already at its stand-off; `verb` is the clip's word.
PalpationPlan plan_palpation(const PalpateClip& clip, const ToolDefinition& tool, const SurfaceView& surface,
                             const SourceLocation& location, const std::string& verb = "palpate");

/// Throws InputErrors at `location` when a tool touches a body already at its stand-off, metres: where it can go ahead
/// by `travel`, metres, which is not positive.
void refuse_touching(double travel, double standoff, const ClipWords& words, const SourceLocation& location);

/// How far a tool can go ahead from a pose until it touches the body, metres. Throws InputErrors at `location` when it
/// never does or touches already at this stand-off, metres.
double free_travel(const ToolPose& pose, const ToolDefinition& tool, const SurfaceView& surface, double standoff,
                   const ClipWords& words, const SourceLocation& location);

/// A straight motion, in which the tool turns evenly from its attitude at the beginning to that at the end.
struct MovePlan {
  MoveClip clip;
  ToolPose begin, end;

  double duration() const { return clip.duration; }  // seconds
  ToolMoment at(double time) const;                  // the phase is left to who knows whether the tool touches
};

/// `now`: the tool as an earlier clip has left it, whose attitude is kept where the clip gives none, and turned where
/// it does. A tool's first clip has its attitude throughout, with the direction of the motion where it gives none; so
/// has one that is set elsewhere (`from`). Throws InputErrors at `location` when the given axis lies along the
/// direction that is kept.
MovePlan plan_move(const MoveClip& clip, const ToolPose& now, bool is_first, const SourceLocation& location = {});

/// Two places of a tool that are the same but for rounding.
constexpr double kSamePlace = 1e-9;  // metres

/// The frame of a tool that moves along `direction`: y' is `axis` made perpendicular to it, by default world y, or
/// world x where the direction is parallel to y.
ToolPose make_pose(const Eigen::Vector3d& tip, const Eigen::Vector3d& direction,
                   const std::optional<Eigen::Vector3d>& axis);

}  // namespace thinwall
