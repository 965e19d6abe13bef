#pragma once

#include <optional>
#include <vector>

#include "engine/cutting/SurfacePath.hpp"
#include "studio/director/ClipPlan.hpp"
#include "studio/director/MarkedPath.hpp"

namespace thinwall {

/// Where a blade in its depth met no wall, as that had given way from under it. A cut that goes on goes from its tip to
/// the blade, and so makes up for what the blade has passed over since; where it touches the wall but in passing, for a
/// part.
struct PassedOver {
  double since = 0;   // seconds since the clip began
  double length = 0;  // metres of the path, since the last cut
  double cut = 0;     // metres, that the body had been cut then
  double uncut = 0;   // metres of the path before, that no cut made up for

  double whole() const { return uncut + length; }
  /// The body is cut so far, metres.
  void note_cut(double now);
};

/// A blade that comes from the stand-off above the first point of its path, presses in along the inward normal, follows
/// the path at its depth below it, rests, and goes back along the inward normal at the path's end.
struct IncisionPlan {
  InciseClip clip;
  SurfacePath path;                    // on the surface as it was when the clip began, or where its mark has gone
  std::vector<Eigen::Vector3d> axes;   // (samples), unit, y' of the blade, evenly spaced along the path
  ToolPose begin;                      // at the stand-off
  double to_contact = 0;               // metres from the stand-off to first contact
  std::optional<double> entered = {};  // seconds since the clip began, when the blade had gone in, once it has
  double entry_cost = 0;               // joule that the blade has to put into the dent before it goes in
  PassedOver passed_over = {};
  std::optional<MarkedPath> mark = {};  // once the clip has begun, of a path that the blade follows on the wall
  double edge_length = 0;               // metres, mean, of the body's triangles
  double rest_length = 0;               // metres, of the path, rest
  double cut = 0;                       // metres, rest, that the clip has cut so far
  double open = 0;                      // metres of the path so far, along which the wall had been cut before

  double duration() const;                  // seconds
  ToolMoment at(double time) const;         // `time`: seconds since the clip began, limited to its duration
  double progress(double time) const;       // metres of the path that the tip has passed
  bool goes_out(double time) const;         // whether the blade is on its way back
  ToolPose pose_below(double along) const;  // of the blade in its depth, `along` metres from the path's beginning
  ToolPose pose_ahead(double along) const;  // the same; straight on beyond the path's end, and as much deeper there
  void feel_entry(double time) { entered = entered.value_or(time); }
};

/// Brings the path to the surface. Throws InputErrors at the path's point or at `location` when a point is out of reach
/// or cannot be joined with the one before, the path has no length, the blade is shorter than the depth or the body
/// less deep, or the blade would start inside the body or touch it already.
///
/// The blade's width (y') lies along the path: along the line nearest to the path within half a width before and behind
/// the tip, so that it turns over its width at a corner; at first the edge leads forwards. Where the path turns back by
/// more than some 127 degrees the blade goes back without turning. It turns by at most 4 rad over its width.
IncisionPlan plan_incision(const InciseClip& clip, const ToolDefinition& tool, const SurfaceView& surface,
                           const SourceLocation& location);

}  // namespace thinwall
