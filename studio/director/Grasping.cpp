#include "studio/director/Grasping.hpp"

namespace thinwall {
namespace {

/// The grasp of a tool that began last; null where none has.
ScheduledClip* last_grasp_of(const std::string& tool, std::span<ScheduledClip> clips) {
  ScheduledClip* last = nullptr;
  for (ScheduledClip& clip : clips) {
    const auto* grasp = std::get_if<GraspPlan>(&clip.plan);
    if (grasp == nullptr || !clip.begun || grasp->clip.tool != tool) continue;
    if (last == nullptr || clip.begin > last->begin) last = &clip;
  }
  return last;
}

}  // namespace

void feel_grasps(std::span<ScheduledClip> clips, const std::map<std::string, DirectedTool>& tools,
                 std::span<const std::unique_ptr<Body>> bodies, double time) {
  for (const auto& [name, tool] : tools) {
    if (!tool.holds) continue;
    ScheduledClip* clip = last_grasp_of(name, clips);
    if (clip == nullptr) continue;
    double squeeze = 0;
    for (const auto& body : bodies) squeeze += body->squeeze(tool.index, tool.pose);
    std::get<GraspPlan>(clip->plan).feel(squeeze, tool.pose.opening, time);
  }
}

}  // namespace thinwall
