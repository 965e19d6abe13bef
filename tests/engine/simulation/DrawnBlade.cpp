#include "tests/engine/simulation/DrawnBlade.hpp"

#include <algorithm>
#include <cmath>

#include "engine/contact/SolidGap.hpp"
#include "engine/tool/ToolSolids.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

/// Whether some of the wall lies within the blade, which no blade that comes from outside lets happen.
bool stands_in_wall(const Body& body, const ToolPose& pose) {
  return std::ranges::any_of(contact_solids(test_blade(), pose), [&](const ToolSolid& solid) {
    return std::ranges::any_of(body.model().sites, [&](const ContactSite& site) {
      const auto corners = corners_of(body.model().surface[site.triangle], body.state().equilibrium.position);
      return solid_gap(solid, 0, corners, site.part, site.corner, GapTerms::kGradient).has_value();
    });
  });
}

/// Lowers the blade by its length to where its stroke begins, until it has met the wall.
void come_down(Body& body, const BladeStroke& stroke, const std::function<void()>& after_step) {
  const Eigen::Vector3d way = test_blade().length * stroke.direction;
  const int steps = static_cast<int>(std::ceil(way.norm() / stroke.step));
  std::vector<ToolPose> poses = {pose_at(stroke.points.front() - way, stroke.direction)};
  for (int step = 1; step <= steps && !body.state().cut.tool; ++step) {
    const double left = 1 - static_cast<double>(step) / steps;
    const std::vector<ToolPose> next = {pose_at(stroke.points.front() - left * way, stroke.direction)};
    body.advance(poses, next, stroke.duration);
    poses = next;
    body.follow_blade(0, poses);
    if (after_step) after_step();
  }
}

}  // namespace

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
  if (stroke.comes_down && !body.state().cut.tool && stands_in_wall(body, poses[0]))
    come_down(body, stroke, after_step);
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
      const bool is_last = k + 1 == stroke.points.size() && step == steps;
      note(body.follow_blade(0, poses, !(stroke.ends && is_last)));
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
