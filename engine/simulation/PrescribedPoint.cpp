#include "engine/simulation/PrescribedPoint.hpp"

#include <Eigen/Geometry>

namespace thinwall {

Eigen::Vector3d holding_point(const Attachment& attachment, const ToolPose& pose) {
  return pose.tip + attachment.offset.x() * pose.axis.cross(pose.direction) + attachment.offset.y() * pose.axis;
}

Eigen::Vector3d prescribed_point(const Attachment& attachment, const ToolPose& pose) {
  const Eigen::Vector3d way = holding_point(attachment, pose) - attachment.touched;
  return attachment.touched + attachment.followed.cwiseProduct(way);
}

Eigen::Vector3d free_share(const BodyModel& model, const Attachment& attachment) {
  Eigen::Vector3d share = Eigen::Vector3d::Zero();
  for (int corner = 0; corner < 3; ++corner) {
    for (int axis = 0; axis < 3; ++axis) {
      if (!model.fixed[3 * attachment.vertices[corner] + axis]) share[axis] += attachment.weights[corner];
    }
  }
  return share;
}

}  // namespace thinwall
