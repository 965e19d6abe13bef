#pragma once

#include <functional>
#include <span>
#include <string>

#include "engine/simulation/Body.hpp"
#include "studio/director/Schedule.hpp"

namespace thinwall {

/// Throws InputErrors with each clip that takes more fluid out of a chamber than there will be: what it holds now, at
/// time zero, with what earlier clips fill in and take out. Chambers that orifices join count as one. What runs out of
/// wounds does not count, and after a clip that reaches a pressure nothing is known. `clips`: (timeline), with their
/// times.
void refuse_overdrawn(std::span<const Clip> timeline, std::span<const ScheduledClip> clips,
                      const std::function<const Body&(const std::string& name)>& body_named);

}  // namespace thinwall
