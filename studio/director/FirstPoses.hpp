#pragma once

#include <map>
#include <span>
#include <string>

#include "studio/director/DirectedTool.hpp"
#include "studio/director/Schedule.hpp"

namespace thinwall {

/// Sets each tool where its first clip begins, as it waits there before; tools that no clip drives out of the way.
/// `clips`: (timeline), scheduled; `tools`: by name.
void set_first_poses(std::span<const Clip> timeline, std::span<const ScheduledClip> clips,
                     std::map<std::string, DirectedTool>& tools);

}  // namespace thinwall
