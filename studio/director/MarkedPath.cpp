#include "studio/director/MarkedPath.hpp"

#include <algorithm>

#include "engine/cutting/CarriedPoints.hpp"
#include "studio/director/Schedule.hpp"

namespace thinwall {
namespace {

IncisionPlan* marked_plan(ScheduledClip& clip) {
  auto* plan = std::get_if<IncisionPlan>(&clip.plan);
  return plan != nullptr && clip.begun && plan->mark ? plan : nullptr;
}

/// `passed`: metres of the path; `share`: of the way from where the line was drawn to where it is now.
void follow(SurfacePath& path, const MarkedPath& mark, const SurfaceView& wall, double passed, double share) {
  const auto first = std::ranges::upper_bound(path.lengths, passed) - path.lengths.begin();
  for (auto k = static_cast<std::size_t>(first); k < path.stations.size(); ++k) {
    path.stations[k].position = mark.drawn[k] + share * (position_of(wall, mark.places[k]) - mark.drawn[k]);
  }
}

}  // namespace

MarkedPath drawn_on_wall(const SurfacePath& path) {
  MarkedPath mark;
  for (const SurfaceCurve& piece : path.pieces) {
    mark.places.insert(mark.places.end(), piece.points.begin(), piece.points.end());
  }
  for (const PathStation& station : path.stations) mark.drawn.push_back(station.position);
  return mark;
}

void follow_marks(std::span<ScheduledClip> clips, std::span<const std::unique_ptr<Body>> bodies,
                  std::span<const ToolDefinition> tools, double time) {
  for (ScheduledClip& clip : clips) {
    IncisionPlan* plan = marked_plan(clip);
    if (plan == nullptr || !plan->entered || clip.end <= time + kTimeTolerance) continue;
    const auto body =
        std::ranges::find(bodies, plan->clip.body, [](const auto& each) { return each->model().definition.name; });
    const auto blade = std::ranges::find(tools, plan->clip.tool, &ToolDefinition::name);
    const double passed = plan->progress(time - clip.begin);
    const Eigen::Vector3d before = plan->path.at(passed).position;
    follow(plan->path, *plan->mark, (*body)->surface(), passed, std::min(1.0, passed / blade->width));
    plan->mark->drift = plan->path.at(passed).position - before;
  }
}

void carry_over(std::span<ScheduledClip> clips, const Body& body, const SurfaceMesh& before, const Cut& cut) {
  const BodyDefinition& definition = body.model().definition;
  for (ScheduledClip& clip : clips) {
    IncisionPlan* plan = marked_plan(clip);
    if (plan == nullptr || plan->clip.body != definition.name) continue;
    plan->mark->places = carried_over(plan->mark->places, before, definition.mesh, cut);
  }
}

}  // namespace thinwall
