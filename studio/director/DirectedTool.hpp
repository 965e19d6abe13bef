#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "engine/simulation/Body.hpp"

namespace thinwall {

/// What the director knows of a tool.
struct DirectedTool {
  int index = 0;
  ToolPose pose;
  std::string phase = "idle";
  bool has_begun = false;                        // whether a clip has driven it: it has an attitude to keep
  bool holds = false;                            // whether its jaws have grasped
  bool noted = false;                            // whether it has been told what tip a bare point acts like
  double depth = 0;                              // metres
  std::optional<Eigen::Vector3d> first_contact;  // metres, of the tip, that a move counts its depth from

  double depth_beyond_contact() const;  // metres

  /// Sets the tool where a clip begins. Where it already is, pressing a wall, it goes on from the contact that it has.
  void begin_clip(const ToolPose& beginning);

  /// Whether it is set where another clip begins rather than goes on from where it is.
  bool is_set_elsewhere(const ToolPose& beginning) const;

  /// A blade that an earlier clip has left in a wall is not there any more, nor is a needle that is `set_elsewhere`.
  /// `poses`: (tools), as they are then.
  void leave_walls(std::span<const std::unique_ptr<Body>> bodies, std::span<const ToolPose> poses,
                   bool set_elsewhere) const;

  /// Notes where the tip is when the moving tool first meets a surface on its way to the next pose.
  void find_first_contact(const ToolDefinition& definition, std::span<const std::unique_ptr<Body>> bodies,
                          const ToolPose& next);
};

}  // namespace thinwall
