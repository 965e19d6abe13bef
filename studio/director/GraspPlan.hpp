#pragma once

#include <optional>
#include <span>

#include "studio/director/ClipPlan.hpp"

namespace thinwall {

/// What jaws feel.
struct JawSqueeze {
  double opening = 0;  // metres
  double force = 0;    // newton
};

/// Forceps that reach over a wall with open jaws, then close them.
struct GraspPlan {
  GraspClip clip;
  ToolPose begin;                         // at the stand-off, open
  std::optional<double> stopped;          // metres, opening of the jaws since they held firmly enough, once they do
  std::optional<JawSqueeze> looser = {};  // the last one below the grip of the clip
  std::optional<JawSqueeze> firmer = {};  // the last one above it
  bool has_settled = false;               // whether the jaws keep their opening from now on
  double largest_squeeze = 0;             // newton, that the jaws have felt
  std::optional<double> lost;             // seconds, time of the run since which they have held nothing any more
  double jaw_width = 0;                   // metres
  double edge_length = 0;                 // metres, mean, of the body's triangles

  double duration() const;           // seconds
  ToolMoment at(double time) const;  // `time`: seconds since the clip began, limited to its duration
  /// Stops the jaws once they squeeze with at least the grip of the clip, newton, at `opening` or, over the next calls,
  /// where they squeeze with just that, and notes since when they have squeezed nothing any more. `time`: of the run,
  /// seconds.
  void feel(double squeeze, double opening, double time);

 private:
  void settle(const JawSqueeze& now);
};

/// Finds where the line of approach meets the wall, or the rim of one, as thick as it is: jaws reach over the edge of a
/// sheet or a flap from ahead. `thickness`: (triangles), metres. Throws InputErrors at `location` when it misses the
/// body, or the jaws would touch it already at their stand-off.
GraspPlan plan_grasp(const GraspClip& clip, const ToolDefinition& tool, const SurfaceView& surface,
                     std::span<const double> thickness, const SourceLocation& location);

/// Forceps that open where they are.
struct ReleasePlan {
  ReleaseClip clip;
  ToolPose begin;
  double opening = 0;  // metres, at the end

  double duration() const { return clip.duration; }  // seconds
  ToolMoment at(double time) const;
};

ReleasePlan plan_release(const ReleaseClip& clip, const ToolDefinition& tool, const ToolPose& now);

}  // namespace thinwall
