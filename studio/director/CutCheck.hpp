#pragma once

#include <span>

#include "engine/body/BodyDefinition.hpp"
#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// Throws InputErrors with each clip that cuts or pierces the body, where its wall is no oriented manifold: says where
/// more than two triangles share an edge, two face opposite ways, or parts of the wall touch in a vertex.
void refuse_uncuttable(std::span<const Clip> timeline, const BodyDefinition& body);

}  // namespace thinwall
