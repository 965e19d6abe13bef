#include "studio/director/MarkedPath.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "engine/cutting/CarriedPoints.hpp"
#include "engine/cutting/SurfaceNormals.hpp"
#include "studio/director/Schedule.hpp"

namespace thinwall {
namespace {

/// Radians by which a blade turns with its wall at most while it goes on by its width: a last bridge that gives way
/// turns faster than a hand does.
constexpr double kTurnWithWallPerWidth = 0.5;

struct MarkShare {
  double share = 1;  // of the way from where the line was drawn to where it is now
  double reach = 0;  // metres of the line that tell how the wall has turned
  double most = 0;   // radians, of turn in a step
};

IncisionPlan* marked_plan(ScheduledClip& clip) {
  auto* plan = std::get_if<IncisionPlan>(&clip.plan);
  return plan != nullptr && clip.begun && plan->mark ? plan : nullptr;
}

/// The frame of a line from one of its stations to another: straight ahead, across it in the wall, inwards. Nothing
/// where the line turns back between them, to less than half of `reach` metres.
std::optional<Eigen::Matrix3d> frame_between(std::span<const PathStation> stations, std::size_t begin, std::size_t end,
                                             double reach) {
  Eigen::Vector3d inward = Eigen::Vector3d::Zero();
  for (std::size_t k = begin; k <= end; ++k) inward += stations[k].inward;
  inward.normalize();
  const Eigen::Vector3d chord = stations[end].position - stations[begin].position;
  const Eigen::Vector3d ahead = chord - chord.dot(inward) * inward;
  if (ahead.norm() < 0.5 * reach) return std::nullopt;
  Eigen::Matrix3d frame;
  frame << ahead.normalized(), inward.cross(ahead.normalized()), inward;
  return frame;
}

/// The shortest way from one turn to another, at most `most` radians of it.
Eigen::Quaterniond towards(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to, double most) {
  const double way = from.angularDistance(to);
  return way > most ? from.slerp(most / way, to) : to;
}

/// Of the wall ahead of a station, over `reach` metres; as that of the station before where too little is left there.
void turn_with_wall(MarkedPath& mark, std::span<const PathStation> now, std::span<const double> lengths,
                    std::size_t first, const MarkShare& part) {
  for (std::size_t k = first; k < now.size(); ++k) {
    const auto end = std::ranges::lower_bound(lengths, lengths[k] + part.reach) - lengths.begin();
    const std::size_t last = std::min(static_cast<std::size_t>(end), now.size() - 1);
    const auto then = frame_between(mark.drawn, k, last, part.reach), here = frame_between(now, k, last, part.reach);
    if (then && here) {
      const Eigen::Quaterniond turn(Eigen::Matrix3d(*here * then->transpose()));
      mark.turns[k] = towards(mark.turns[k], Eigen::Quaterniond::Identity().slerp(part.share, turn), part.most);
    } else if (k > first) {
      mark.turns[k] = mark.turns[k - 1];
    }
  }
}

/// `passed`: metres of the path.
void follow(SurfacePath& path, MarkedPath& mark, const SurfaceView& wall, double passed, const MarkShare& part) {
  const auto first = static_cast<std::size_t>(std::ranges::upper_bound(path.lengths, passed) - path.lengths.begin());
  const std::vector<Eigen::Vector3d> normals = vertex_normals(wall);
  std::vector<PathStation> now = mark.drawn;
  for (std::size_t k = first; k < now.size(); ++k) {
    now[k] = {.position = position_of(wall, mark.places[k]),
              .inward = -mark.outer * smooth_normal(wall, normals, mark.places[k])};
  }
  turn_with_wall(mark, now, path.lengths, first, part);
  for (std::size_t k = first; k < now.size(); ++k) {
    const PathStation& drawn = mark.drawn[k];
    path.stations[k] = {.position = drawn.position + part.share * (now[k].position - drawn.position),
                        .inward = mark.turns[k] * drawn.inward};
  }
}

}  // namespace

MarkedPath drawn_on_wall(const SurfacePath& path, const SurfaceView& wall) {
  MarkedPath mark;
  for (const SurfaceCurve& piece : path.pieces) {
    mark.places.insert(mark.places.end(), piece.points.begin(), piece.points.end());
  }
  mark.drawn = path.stations;
  mark.turns.assign(path.stations.size(), Eigen::Quaterniond::Identity());
  if (smooth_normal(wall, mark.places.front()).dot(path.stations.front().inward) > 0) mark.outer = -1;
  return mark;
}

Eigen::Quaterniond turn_at(const SurfacePath& path, const MarkedPath& mark, double along) {
  const auto after = std::ranges::upper_bound(path.lengths, along);
  if (after == path.lengths.begin()) return mark.turns.front();
  if (after == path.lengths.end()) return mark.turns.back();
  const auto k = static_cast<std::size_t>(after - path.lengths.begin());
  return mark.turns[k - 1].slerp((along - path.lengths[k - 1]) / (path.lengths[k] - path.lengths[k - 1]),
                                 mark.turns[k]);
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
    const double widths = (passed - std::exchange(plan->mark->passed, passed)) / blade->width;
    const MarkShare part{.share = std::min(1.0, passed / blade->width),
                         .reach = 0.5 * blade->width,
                         .most = kTurnWithWallPerWidth * std::max(0.0, widths)};
    follow(plan->path, *plan->mark, (*body)->surface(), passed, part);
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
