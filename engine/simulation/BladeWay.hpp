#pragma once

#include <Eigen/Core>
#include <optional>

#include "engine/cutting/SurfacePath.hpp"
#include "engine/equilibrium/BodyModel.hpp"
#include "engine/simulation/BodyState.hpp"
#include "engine/tool/Tool.hpp"

namespace thinwall {

/// Where a cut goes on.
struct WayOn {
  CutPath path;
  std::optional<Eigen::Vector3d> border = {};        // metres, of the wall, where the path ends there
  Eigen::Vector3d sense = Eigen::Vector3d::UnitX();  // unit, in which the blade goes over that border
};

/// Where a blade is in the wall of a body, and along which way over the wall it has come there. Looks at the body as it
/// is now, and must not outlive it.
class BladeWay {
 public:
  BladeWay(const BodyModel& model, const BodyState& state, const ToolDefinition& blade)
      : model_(model), state_(state), blade_(blade) {}

  /// Where the blade's edge enters the wall: nearest to where it cuts, or to its tip where it does not yet. `higher`:
  /// metres by which it is taken for higher than it is.
  std::optional<SurfacePoint> place_below(const ToolPose& pose, double higher = 0) const;
  /// From the tip of the cut, or where the blade met the wall first, to where it meets the wall or has left it.
  std::optional<WayOn> on(const ToolPose& pose, double higher = 0) const;
  /// A way at whose end the cut ends; where that is next to an open border, or in the other end of a cut, there.
  WayOn brought_to_border(WayOn way) const;
  /// A way that a cut begins with; where an open border is close behind its beginning, from there.
  WayOn brought_from_border(WayOn way) const;
  /// Whether the blade goes back in its own wound: behind the tip, and over no wall but its lips.
  bool is_in_wound(const ToolPose& pose) const;
  /// From the lip over which the blade has come out of its own wound to where it meets the wall.
  std::optional<WayOn> out_of_wound(const ToolPose& pose) const;
  /// Whether a way is too long for a blade that was off the wall to have gone it.
  bool is_far(const WayOn& way) const;
  /// The same of a place, from the tip of the cut or its beginning.
  bool is_far(const SurfacePoint& place) const;

 private:
  /// From the tip to the open border that the blade has left the wall over; nothing where it has not.
  std::optional<WayOn> to_border(const ToolPose& pose) const;
  /// Metres of wall between the end of a cut and a border that are cut along with it.
  double bridged() const;
  SurfaceView surface() const { return surface_of(model_, state_); }

  const BodyModel& model_;
  const BodyState& state_;
  const ToolDefinition& blade_;
};

}  // namespace thinwall
