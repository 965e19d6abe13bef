#pragma once

#include <map>
#include <memory>
#include <span>
#include <string>

#include "studio/director/DirectedTool.hpp"
#include "studio/director/Schedule.hpp"

namespace thinwall {

/// Lets jaws that have grasped and not let go feel what lies between them at the end of a step. `clips`: (timeline);
/// `tools`: by name; `time`: seconds.
void feel_grasps(std::span<ScheduledClip> clips, const std::map<std::string, DirectedTool>& tools,
                 std::span<const std::unique_ptr<Body>> bodies, double time);

}  // namespace thinwall
