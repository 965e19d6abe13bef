#include "studio/director/DirectedTool.hpp"

#include <algorithm>

#include "studio/director/ClipPlan.hpp"

namespace thinwall {

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

void DirectedTool::find_first_contact(const ToolDefinition& definition, std::span<const std::unique_ptr<Body>> bodies,
                                      const ToolPose& next) {
  if (first_contact) return;
  const Eigen::Vector3d way = next.tip - pose.tip;
  if (way.norm() == 0) return;
  const Eigen::Vector3d motion = way.normalized();
  for (const auto& body : bodies) {
    const auto travel = travel_to_contact(body->surface(), definition, pose, motion);
    if (travel && *travel >= 0 && *travel <= way.norm()) first_contact = pose.tip + *travel * motion;
  }
}

}  // namespace thinwall
