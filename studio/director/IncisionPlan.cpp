#include "studio/director/IncisionPlan.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "studio/director/BodyExtent.hpp"
#include "studio/organs/SpanWords.hpp"
#include "studio/scenario/InputError.hpp"

namespace thinwall {
namespace {

/// Samples of the blade's heading for each of its widths, and at most in all: a path of a metre at 0.1 mm.
constexpr double kSamplesPerWidth = 32;
constexpr int kMostSamples = 10000;

/// Points before the tip, and behind it, that tell the heading.
constexpr int kHeadingPoints = 16;

/// Where the path scatters less than this along one direction more than across it, as at a corner of 127 degrees, it
/// tells no heading: the blade goes on as it was.
constexpr double kNoHeading = 0.1;

/// A blade turns by at most this while it goes on by its width, radians.
constexpr double kTurnPerWidth = 4;

std::string to_words(const Eigen::Vector3d& point) {
  return fmt::format("[{:.4g}, {:.4g}, {:.4g}] mm", 1e3 * point.x(), 1e3 * point.y(), 1e3 * point.z());
}

/// Throws what is wrong with a path.
[[noreturn]] void refuse_path(const InciseClip& clip, const PathProblem& problem, const SurfaceView& surface,
                              const SourceLocation& location) {
  const auto index = static_cast<std::size_t>(problem.point);
  const std::string name = fmt::format("path[{}]", index + 1);
  std::string why;
  switch (problem.kind) {
    case PathProblem::Kind::kOffSurface:
      why = fmt::format("{} = {} ", name, to_words(clip.path[index]));
      why += std::isinf(problem.distance)
                 ? fmt::format("does not meet body `{}` along `direction`; move the point or leave `direction` out",
                               clip.body)
                 : fmt::format(
                       "lies {:.4g} mm from body `{}`, which spans {} then, farther than `reach` = {:.4g} mm; move "
                       "the point to the wall or give a larger `reach`",
                       1e3 * problem.distance, clip.body, span_words(box_of(surface)), 1e3 * clip.reach);
      break;
    case PathProblem::Kind::kAlongNormal:
      why = fmt::format(
          "path[{}] and {} lie behind each other as seen along the wall's normal, so that no way from "
          "one to the other stands out; put a point between them",
          index, name);
      break;
    case PathProblem::Kind::kNotJoined:
      why = fmt::format(
          "the wall of body `{}` does not lead from path[{}] to {} straight ahead; put points between "
          "them, or make two clips",
          clip.body, index, name);
      break;
  }
  throw InputErrors({{index < clip.path_locations.size() ? clip.path_locations[index] : location, "incise: " + why}});
}

/// A point of the path, which goes on straight beyond its ends.
Eigen::Vector3d point_at(const SurfacePath& path, double along, double reach) {
  Eigen::Vector3d point = path.at(along).position;
  const double beyond = along < 0 ? along : std::max(0.0, along - path.length());
  if (beyond == 0) return point;
  const double step = std::min(reach, path.length());
  const Eigen::Vector3d chord =
      along < 0 ? path.at(step).position - point : point - path.at(path.length() - step).position;
  return point + beyond * chord.stableNormalized();
}

/// Angle about `inward` from `axis` to the line along which the path scatters most within half a width before and
/// behind a place, from -90 to 90 degrees, radians. The first principal axis: that of the moments in the plane.
double turn_to_path(const SurfacePath& path, double along, double width, const ToolPose& frame) {
  const Eigen::Vector3d middle = path.at(along).position, across = frame.direction.cross(frame.axis);
  std::vector<Eigen::Vector2d> points;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (int k = -kHeadingPoints; k <= kHeadingPoints; ++k) {
    const Eigen::Vector3d offset = point_at(path, along + 0.5 * width * k / kHeadingPoints, 0.5 * width) - middle;
    points.emplace_back(offset.dot(frame.axis), offset.dot(across));
    mean += points.back() / (2 * kHeadingPoints + 1);
  }
  double along_axis = 0, across_axis = 0, mixed = 0;
  for (const Eigen::Vector2d& point : points) {
    const Eigen::Vector2d offset = point - mean;
    along_axis += offset.x() * offset.x();
    across_axis += offset.y() * offset.y();
    mixed += offset.x() * offset.y();
  }
  const double difference = std::hypot(along_axis - across_axis, 2 * mixed);
  if (difference <= kNoHeading * (along_axis + across_axis)) return 0;
  return 0.5 * std::atan2(2 * mixed, along_axis - across_axis);
}

std::vector<Eigen::Vector3d> blade_axes(const SurfacePath& path, double width) {
  const double wanted = std::ceil(kSamplesPerWidth * path.length() / width);
  const int count = static_cast<int>(std::clamp(wanted, 1.0, 1.0 * kMostSamples)) + 1;
  const double step = path.length() / (count - 1);
  // At first the edge leads forwards.
  Eigen::Vector3d axis = point_at(path, 0.5 * width, 0.5 * width) - path.stations.front().position;
  std::vector<Eigen::Vector3d> axes;
  for (int k = 0; k < count; ++k) {
    const ToolPose frame = make_pose(Eigen::Vector3d::Zero(), path.at(k * step).inward, axis);
    const double most = k == 0 ? std::numbers::pi : kTurnPerWidth * step / width;
    const double turn = std::clamp(turn_to_path(path, k * step, width, frame), -most, most);
    axis = std::cos(turn) * frame.axis + std::sin(turn) * frame.direction.cross(frame.axis);
    axes.push_back(axis);
  }
  return axes;
}

void refuse_depth(const InciseClip& clip, const ToolDefinition& tool, const SurfaceView& surface,
                  const Eigen::Vector3d& inward, const SourceLocation& location) {
  const auto refuse = [&](const std::string& why) {
    throw InputErrors({{location, fmt::format("incise: `depth` = {:.4g} mm {}", 1e3 * clip.depth, why)}});
  };
  if (clip.depth > tool.length) {
    refuse(fmt::format("is more than blade `{}` is high ({:.4g} mm); cut less deep or give it a larger `length`",
                       clip.tool, 1e3 * tool.length));
  }
  const double extent = extent_along(surface, inward);
  if (!surface.open && clip.depth >= extent) {
    refuse(fmt::format("is more than body `{}` measures there ({:.4g} mm); cut less deep", clip.body, 1e3 * extent));
  }
}

}  // namespace

void PassedOver::note_cut(double now) {
  if (now == cut) return;
  uncut += std::max(0.0, length - (now - cut));
  length = 0;
  cut = now;
}

double IncisionPlan::duration() const {
  const double in = clip.standoff + clip.depth;
  return ((clip.withdraw ? 2 : 1) * in + path.length()) / clip.speed + clip.hold;
}

double IncisionPlan::progress(double time) const {
  return std::clamp(time * clip.speed - clip.standoff - clip.depth, 0.0, path.length());
}

bool IncisionPlan::goes_out(double time) const {
  return clip.withdraw && time > (clip.standoff + clip.depth + path.length()) / clip.speed + clip.hold;
}

ToolPose IncisionPlan::pose_below(double along) const {
  const PathStation station = path.at(along);
  const double place = std::clamp(along / path.length(), 0.0, 1.0) * static_cast<double>(axes.size() - 1);
  const auto sample = std::min(static_cast<std::size_t>(place), axes.size() - 2);
  const double part = place - static_cast<double>(sample);
  Eigen::Vector3d axis = (1 - part) * axes[sample] + part * axes[sample + 1];
  if (mark) axis = turn_at(path, *mark, along) * axis;
  return make_pose(station.position + clip.depth * station.inward, station.inward, axis);
}

ToolPose IncisionPlan::pose_ahead(double along) const {
  ToolPose pose = pose_below(along);
  const double beyond = along - path.length();
  // As much deeper, so that the edge meets a wall that falls away.
  if (beyond > 0) {
    pose.tip += point_at(path, along, clip.depth) - path.stations.back().position + beyond * pose.direction;
  }
  return pose;
}

ToolMoment IncisionPlan::at(double time) const {
  const double in = clip.standoff + clip.depth;               // metres
  const double arrival = (in + path.length()) / clip.speed;   // seconds
  const double travelled = std::max(0.0, time) * clip.speed;  // metres
  ToolMoment moment{.pose = pose_below(progress(time)), .phase = "cutting"};
  double travel = std::min(in, travelled);
  if (travelled < in) moment.phase = travel < to_contact ? "approach" : "contact";
  if (moment.phase == "contact" && entered && time > *entered) moment.phase = "cutting";
  if (time >= arrival) moment.phase = "hold";
  if (goes_out(time)) {
    travel = std::max(0.0, in - (time - arrival - clip.hold) * clip.speed);
    moment.phase = "withdrawal";
  }
  moment.pose.tip -= (in - travel) * moment.pose.direction;
  moment.depth = std::max(0.0, travel - to_contact);
  return moment;
}

IncisionPlan plan_incision(const InciseClip& clip, const ToolDefinition& tool, const SurfaceView& surface,
                           const SourceLocation& location) {
  const std::optional<Eigen::Vector3d> direction =
      clip.direction ? std::optional<Eigen::Vector3d>(clip.direction->normalized()) : std::nullopt;
  PathResult found = surface_path(surface, clip.path, direction, clip.reach);
  if (found.problem) refuse_path(clip, *found.problem, surface, location);
  if (found.path.length() == 0) {
    throw InputErrors({{location, fmt::format("incise: all points of `path` come to lie in one place of body `{}`; a "
                                              "cut needs a length",
                                              clip.body)}});
  }
  refuse_depth(clip, tool, surface, found.path.stations.front().inward, location);
  IncisionPlan plan{.clip = clip, .path = std::move(found.path), .axes = {}, .begin = {}};
  plan.axes = blade_axes(plan.path, tool.width);
  plan.begin = plan.pose_below(0);
  plan.begin.tip -= (clip.standoff + clip.depth) * plan.begin.direction;
  plan.begin.opening = tool.opening;
  if (is_inside(surface, plan.begin.tip)) {
    throw InputErrors(
        {{location, fmt::format("incise: {:.3g} mm above path[1] blade `{}` would start inside body `{}`; a smaller "
                                "`standoff` or another first point lets it start outside",
                                1e3 * clip.standoff, clip.tool, clip.body)}});
  }
  const double travel =
      free_travel(plan.begin, tool, surface, clip.standoff, {"incise", clip.tool, clip.body}, location);
  // The tip meets the wall at the path's first point; round-off must not let it do so later.
  plan.to_contact = std::min(travel, clip.standoff);
  return plan;
}

}  // namespace thinwall
