#pragma once

#include "engine/cutting/SurfaceTrace.hpp"
#include "engine/mesh/Shapes.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {

/// The way on a body's surface below two points.
inline CutPath path_between(const Body& body, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const SurfaceView surface = body.surface();
  const auto below = [&](const Eigen::Vector3d& point) -> SurfacePoint {
    return *first_entry(surface, point, -Eigen::Vector3d::UnitZ());
  };
  return {.from = {}, .points = trace(surface, below(from), below(to)).pieces.front().points};
}

/// A square of 40 mm, held at its border, that may be cut.
inline BodyDefinition stretched_sheet(int triangles, double stretch) {
  BodyDefinition definition = make_body(make_sheet(40e-3, 40e-3, triangles), 1e-3, neo_hookean(20e3));
  definition.fluid.kind = FluidKind::kNone;
  definition.toughness = {20};
  definition.fixed.push_back({.region = BoundaryRegion{}});
  definition.prestretch = {{.first = stretch, .second = stretch}};
  return definition;
}

}  // namespace thinwall
