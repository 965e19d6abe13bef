#pragma once

#include "engine/material/WallLaw.hpp"

namespace thinwall {

// One row per law, each defined in the law's own file.
extern const WallLaw kStVenantKirchhoff;
extern const WallLaw kNeoHookean;
extern const WallLaw kMooneyRivlin;

}  // namespace thinwall
