#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/simulation/Body.hpp"
#include "studio/record/StepRecord.hpp"
#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// A recorded point with the vertex that stands for it.
struct FollowedPoint {
  std::string name;
  const Body* body = nullptr;
  int vertex = 0;

  PointRecord record() const;
};

/// The vertex whose stress-free position is nearest; of several as near the first. The point's body must be among the
/// bodies, which must live as long as the result.
FollowedPoint follow(const RecordedPoint& point, const std::vector<std::unique_ptr<Body>>& bodies);

}  // namespace thinwall
