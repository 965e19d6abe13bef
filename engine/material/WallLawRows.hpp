#pragma once

#include "engine/material/WallLaw.hpp"

namespace thinwall {

// One row per law, each defined in the law's own file.
extern const WallLaw kStVenantKirchhoff;
extern const WallLaw kNeoHookean;
extern const WallLaw kMooneyRivlin;
extern const WallLaw kGent;
extern const WallLaw kOgden;
extern const WallLaw kFung;
extern const WallLaw kHolzapfel;

}  // namespace thinwall
