#pragma once

#include "engine/mesh/Shapes.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {

/// A ball under 300 Pa whose lower third is held.
inline BodyDefinition filled_ball(int triangles, WallModel model = WallModel::kMembrane) {
  BodyDefinition body = make_body(make_sphere(20e-3, triangles), 1e-3, neo_hookean(20e3));
  body.fluid.initial_pressure = 300;
  body.fixed = {{.region = BelowRegion{.axis = 2, .at = -10e-3}}};
  body.toughness = {100};
  body.model = model;
  return body;
}

}  // namespace thinwall
