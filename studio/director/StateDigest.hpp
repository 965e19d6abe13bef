#pragma once

#include <memory>
#include <span>
#include <string>

#include "engine/simulation/Body.hpp"

namespace thinwall {

/// Hash of positions, velocities, pressures and tool forces to the last bit: 32 hexadecimal digits.
std::string state_digest(std::span<const std::unique_ptr<Body>> bodies);

}  // namespace thinwall
