// A cut that runs ahead of its blade: where the wall releases more than new cut area costs.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/simulation/Body.hpp"

namespace thinwall {
namespace {

/// Part of the cost that lips must have released on the blade's way before a trial is worth its two solutions.
constexpr double kLikely = 0.35;

/// Residual force over the largest force at which a trial is at rest: its energy is then right to the square of that.
constexpr double kTrialTolerance = 1e-5;

/// Edge lengths of a piece: the shortest of these that can be cut.
constexpr double kPieces[] = {1, 1.5, 2};

/// Edge lengths that a cut may run in a step at any rate.
constexpr double kLeastBound = 2;

/// Metres along the blade's way from the blade to a place, less than zero behind it.
double lead_of(const Eigen::Vector3d& place, const ToolPose& blade, const ToolPose& next) {
  const Eigen::Vector3d motion = next.tip - blade.tip;
  const Eigen::Vector3d way = motion - motion.dot(blade.direction) * blade.direction;
  return way.stableNormalized().dot(place - blade.tip);
}

/// Edge of the equilateral triangle that has the mean rest area of those around a vertex, metres.
double edge_at(const BodyModel& model, int vertex) {
  double area = 0, count = 0;
  for (int t = 0; t < model.triangles(); ++t) {
    if ((model.surface[t].array() != vertex).all()) continue;
    area += model.rest[t].area;
    count += 1;
  }
  return std::sqrt(4 / std::numbers::sqrt3 * area / count);
}

}  // namespace

std::optional<Rupture> Body::try_cut(const CutPath& path, std::span<const ToolPose> poses) {
  const BodyState as_it_is = state_;
  const double residual = report_.residual;
  std::optional<Rupture> tried;
  state_.cut.held.clear();
  trial_tolerance_ = std::max(options_.tolerance, kTrialTolerance);
  if (snap(poses)) {
    const double imbalance = state_.books.imbalance(),
                 cost = cost_at(point_at(model_->definition.mesh.triangles, *path.from));
    Uncut before;
    tried = Rupture{.cut = change_mesh(path, options_of_blade(poses), &before)};
    if (before.model) {
      tried->cost = cost * tried->cut.length;
      const bool is_at_rest = snap(poses);
      tried->released = imbalance - state_.books.imbalance();
      put_back(std::move(before));
      if (!is_at_rest) tried.reset();
    }
  }
  trial_tolerance_.reset();
  state_ = as_it_is;
  // The iterations of a trial are the step's, its residual is not.
  report_.residual = residual;
  return tried;
}

std::optional<Cut> Body::run_ahead(std::span<const ToolPose> poses, const std::function<ToolPose(double)>& ahead,
                                   double straight_on) {
  CutProgress& progress = state_.cut;
  if (!progress.tool || !progress.tip || progress.awaited > 0) return std::nullopt;
  if (progress.given < kLikely * progress.cost) return std::nullopt;
  const int tool = *progress.tool;
  const double edge = edge_at(*model_, *progress.tip), most = std::max(tools_[tool].width, kLeastBound * edge);
  const Eigen::Vector3d tip = state_.equilibrium.position.segment<3>(3 * *progress.tip);
  const double lead = progress.ahead > 0 ? progress.ahead : lead_of(tip, poses[tool], ahead(edge));
  for (const double piece : kPieces) {
    if (progress.run + piece * edge > most) return std::nullopt;
    const double farther = std::max(0.0, lead + piece * edge);
    const ToolPose pose = ahead(farther);
    std::optional<WayOn> way = way_of_blade(tool).on(pose, std::max(0.0, farther - straight_on));
    if (!way) continue;
    way->path.goes_on = !way->border;
    const std::optional<Rupture> tried = try_cut(way->path, poses);
    if (tried && tried->cut.triangles.empty()) continue;
    if (tried && tried->released >= tried->cost) return run(*way, pose, lead, poses);
    progress.awaited = edge;
    // What the blade will feel when it has come to where the cut has run to.
    if (tried && progress.ahead > 0) progress.given = progress.cost * tried->released / tried->cost;
    return std::nullopt;
  }
  progress.awaited = edge;
  return std::nullopt;
}

std::optional<Cut> Body::run(const WayOn& way, const ToolPose& pose, double lead, std::span<const ToolPose> poses) {
  std::optional<Cut> cut = go_on(way, pose, poses);
  if (!cut) return std::nullopt;
  CutProgress& progress = state_.cut;
  progress.held.back().runs = true;
  const double length = length_of(cut->lips, state_.equilibrium.position);
  // Up to there the wall pays; what it does not pay the blade does beyond.
  progress.ahead = std::max(0.0, lead + length);
  progress.run += length;
  progress.run_length += cut->length;
  if (progress.ahead > 0) progress.resistance = progress.push = 0;
  return cut;
}

}  // namespace thinwall
