#include "studio/director/DirectedTool.hpp"

#include <algorithm>

#include "studio/director/ClipPlan.hpp"

namespace thinwall {
namespace {

/// Turned by less than this, or moved by less than the gap that walls keep from tools, a needle stays in its puncture.
constexpr double kSameAttitude = 1e-3;  // radians
constexpr double kSameGap = 1e-5;       // metres

}  // namespace

double DirectedTool::depth_beyond_contact() const {
  return first_contact ? std::max(0.0, (pose.tip - *first_contact).dot(pose.direction)) : 0;
}

void DirectedTool::begin_clip(const ToolPose& beginning) {
  const bool goes_on = depth > 0 && (beginning.tip - pose.tip).norm() < kSamePlace;
  first_contact.reset();
  if (goes_on) first_contact = pose.tip - depth * pose.direction;
  pose = beginning;
  has_begun = true;
}

bool DirectedTool::is_set_elsewhere(const ToolPose& beginning) const {
  return (beginning.tip - pose.tip).norm() > kSameGap || (beginning.direction - pose.direction).norm() > kSameAttitude;
}

void DirectedTool::leave_walls(std::span<const std::unique_ptr<Body>> bodies, std::span<const ToolPose> poses,
                               bool set_elsewhere) const {
  for (const auto& body : bodies) {
    if (body->state().cut.tool == index) body->leave_cut();
    if (set_elsewhere) body->take_needle_out(index, poses);
  }
}

void DirectedTool::find_first_contact(const ToolDefinition& definition, std::span<const std::unique_ptr<Body>> bodies,
                                      const ToolPose& next) {
  if (first_contact) return;
  const Eigen::Vector3d way = next.tip - pose.tip;
  if (way.norm() == 0) return;
  const Eigen::Vector3d motion = way.normalized();
  double least = way.norm();  // metres, to the wall that it meets before all others
  for (const auto& body : bodies) {
    const auto travel = travel_to_contact(body->surface(), definition, pose, motion);
    if (!travel || *travel < 0 || *travel > least) continue;
    least = *travel;
    first_contact = pose.tip + least * motion;
  }
}

}  // namespace thinwall
