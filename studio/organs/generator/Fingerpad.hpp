#pragma once

#include "studio/organs/generator/OrganPlan.hpp"

namespace thinwall {

/// The pulp of an index finger's tip on its bone: a flat base on z = 0 where the phalanx carries it, the pad bulging
/// towards +z, the tip of the finger at +y, cut flat behind at the crease of the last joint. The origin lies in the
/// base under the pad's highest part. About 16 mm wide, 27 mm long, 9 mm deep. Groups: base (the bone), proximal_end
/// (the cut), pad (what touches), tip, sides.
OrganPlan plan_fingerpad();

}  // namespace thinwall
