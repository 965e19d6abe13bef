#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/mesh/SurfacePoint.hpp"
#include "engine/simulation/Body.hpp"
#include "studio/record/StepRecord.hpp"
#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// A recorded point with the place of the wall that stands for it.
struct FollowedPoint {
  std::string name;
  const Body* body = nullptr;
  SurfacePoint place;

  PointRecord record() const;
};

/// The vertex of the wall whose stress-free position is nearest; of several as near the first. The point's body must be
/// among the bodies, which must live as long as the result.
FollowedPoint follow(const RecordedPoint& point, const std::vector<std::unique_ptr<Body>>& bodies);

/// Keeps the points of a body that has been cut at their places of the stress-free wall. `before`: its mesh before.
void carry_over(std::vector<FollowedPoint>& points, const Body& body, const SurfaceMesh& before, const Cut& cut);

}  // namespace thinwall
