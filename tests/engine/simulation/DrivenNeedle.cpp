#include "tests/engine/simulation/DrivenNeedle.hpp"

#include <cmath>
#include <utility>

#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {

ToolDefinition test_needle(double friction) {
  return {.name = "needle", .kind = ToolKind::kNeedle, .length = 60e-3, .radius = 0.5e-3, .friction = friction};
}

void DrivenNeedle::move(Body& body, double to, const std::function<void()>& after_step) {
  const auto steps = static_cast<int>(std::lround(std::abs(to - depth) / step));
  const double begin = depth;
  for (int k = 1; k <= steps; ++k) {
    const std::vector<ToolPose> from = {pose_at(at + depth * direction, direction)};
    depth = begin + (to - begin) * k / steps;
    const std::vector<ToolPose> next = {pose_at(at + depth * direction, direction)};
    body.advance(from, next, duration);
    forces.push_back(-body.state().contacts[0].force.dot(direction));
    if (pierces) {
      if (auto rupture = body.pierce(0, next)) {
        ruptures.push_back(std::move(*rupture));
        ruptured_at.push_back(depth);
      }
    }
    if (after_step) after_step();
  }
}

bool DrivenNeedle::move_to_rupture(Body& body, std::size_t count, double most,
                                   const std::function<void()>& after_step) {
  while (ruptures.size() < count && depth < most) move(body, depth + step, after_step);
  return ruptures.size() >= count;
}

}  // namespace thinwall
