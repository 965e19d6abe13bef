// A blade in a gap of the wall: between the lips of an opening that it crosses.

#include <algorithm>
#include <vector>

#include "engine/cutting/BorderCrossing.hpp"
#include "engine/cutting/SurfaceTrace.hpp"
#include "engine/simulation/Body.hpp"
#include "engine/tool/FirstContact.hpp"

namespace thinwall {

void Body::find_gap(const Cut& cut, const Eigen::Vector3d& left, const Eigen::Vector3d& way, const ToolPose& pose) {
  std::vector<int> own;
  for (const Lips& lips : cut.lips) {
    own.insert(own.end(), lips.left.begin(), lips.left.end());
    own.insert(own.end(), lips.right.begin(), lips.right.end());
  }
  const double below = (pose.tip - left).dot(pose.direction);
  const auto lip = border_beyond(surface(), {.left = left,
                                             .way = way,
                                             .line = pose.direction,
                                             .above = below - tools_[*state_.cut.tool].length,
                                             .below = below,
                                             .lips = std::move(own),
                                             .overlap = model_->edge_length});
  if (lip) state_.cut.gap = GapBeyond{.lip = snapped_to_edges(surface(), *lip), .way = way};
}

void Body::enter_gap(int tool, const ToolPose& pose, const Eigen::Vector3d& way) {
  const double length = tools_[tool].length;
  const SurfaceView wall = surface();
  const Eigen::Vector3d top = pose.tip - length * pose.direction;
  if (first_entry_on_segment(wall, top, pose.tip + model_->edge_length * pose.direction)) return;
  const Eigen::Vector3d across = (way - way.dot(pose.direction) * pose.direction).normalized();
  const auto lip = border_beyond(
      wall,
      {.left = pose.tip, .way = across, .line = pose.direction, .above = -length, .overlap = model_->edge_length});
  if (!lip) return;
  state_.cut.tool = tool;
  state_.cut.gap = GapBeyond{.lip = snapped_to_edges(wall, *lip), .way = across};
}

bool Body::come_out_of_gap(const ToolPose& pose) {
  if (!state_.cut.gap) return false;
  const GapBeyond& gap = *state_.cut.gap;
  const Eigen::Vector3d lip = place_on(*model_, gap.lip.triangle, gap.lip.weights, state_.equilibrium.position);
  if ((pose.tip - lip).dot(gap.way) < 0) return false;
  begin_cut(gap.lip);
  state_.cut.gap.reset();
  return true;
}

}  // namespace thinwall
