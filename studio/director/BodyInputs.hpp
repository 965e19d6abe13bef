#pragma once

#include <map>
#include <span>
#include <string>

#include "engine/simulation/Body.hpp"
#include "studio/director/DirectedTool.hpp"
#include "studio/director/Schedule.hpp"
#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// What a script puts into a body in a step from `begin` to `end` (seconds): the loads' factors at its end, the fluid
/// of the clips that play, the needles that pierce it and the blade that cuts it. `clips`: (timeline); `tools`: by
/// name.
BodyInput input_of(const BodyScenario& scenario, const Body& body, std::span<const ScheduledClip> clips,
                   const std::map<std::string, DirectedTool>& tools, double begin, double end);

}  // namespace thinwall
