#include "tests/engine/simulation/DrawnBlade.hpp"

#include <cmath>

#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {

ToolDefinition test_blade() {
  return {.name = "blade", .kind = ToolKind::kScalpel, .length = 20e-3, .width = 4e-3, .thickness = 0.3e-3};
}

std::vector<Cut> draw_blade(Body& body, const BladeStroke& stroke, const std::function<void()>& after_step,
                            const std::function<void(const Cut&)>& after_cut) {
  std::vector<ToolPose> poses = {pose_at(stroke.points.front(), stroke.direction)};
  std::vector<Cut> cuts;
  const auto note = [&](const std::optional<Cut>& cut) {
    if (!cut) return false;
    cuts.push_back(*cut);
    if (after_cut) after_cut(*cut);
    return true;
  };
  note(body.follow_blade(0, poses));
  for (std::size_t k = 1; k < stroke.points.size(); ++k) {
    const Eigen::Vector3d begin = stroke.points[k - 1], way = stroke.points[k] - begin;
    const int steps = static_cast<int>(std::ceil(way.norm() / stroke.step - 1e-9));
    for (int step = 1; step <= steps; ++step) {
      const std::vector<ToolPose> next = {pose_at(begin + way * step / steps, stroke.direction)};
      BodyInput input;
      if (body.state().cut.tool) {
        input.blade = BladeInput{.tool = 0, .travel = way.norm() / steps, .direction = way.normalized()};
      }
      body.advance(poses, next, stroke.duration, input);
      poses = next;
      note(body.follow_blade(0, poses));
      while (note(body.run_ahead(
          poses, [&](double ahead) { return pose_at(poses[0].tip + ahead * way.normalized(), stroke.direction); }))) {
      }
      if (after_step) after_step();
    }
  }
  body.leave_cut();
  return cuts;
}

}  // namespace thinwall
