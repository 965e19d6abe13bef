#include "studio/director/FirstPoses.hpp"

#include <optional>

namespace thinwall {
namespace {

/// Where tools wait that no clip drives: they must touch nothing.
const Eigen::Vector3d kOutOfTheWay(0, 0, 100);  // metres

}  // namespace

void set_first_poses(std::span<const Clip> timeline, std::span<const ScheduledClip> clips,
                     std::map<std::string, DirectedTool>& tools) {
  for (auto& [name, tool] : tools) {
    std::optional<std::size_t> first;
    for (std::size_t k = 0; k < clips.size(); ++k) {
      if (tool_of(timeline[k]) == name && (!first || clips[k].begin < clips[*first].begin)) first = k;
    }
    if (!first) {
      tool.pose.tip = kOutOfTheWay;
      continue;
    }
    tool.pose = *beginning_of(clips[*first].plan);
    if (clips[*first].begin <= 0) tool.phase = moment_of(clips[*first].plan, 0)->phase;
  }
}

}  // namespace thinwall
