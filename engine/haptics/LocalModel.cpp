#include "engine/haptics/LocalModel.hpp"

#include <algorithm>
#include <cmath>

namespace thinwall {
namespace {

/// Multiple of the way between two equilibria beyond the later one for which what lies between them is thought to go
/// on.
constexpr double kFarthestShare = 6;

/// Part of the reach beyond which a model gives no more for ways along the wall: other places bear the tool there.
constexpr double kSidewaysReach = 0.25;

/// By which a force may differ from what the stiffness in the direction of the force alone would make of it.
constexpr double kSlack = 2;

/// Part of the force at the equilibrium below which a tool that holds the wall lets go of it sideways too.
constexpr double kLettingGo = 0.05;

/// Of the sum of all forces by the way of the tool in the direction of the sum, newton / metre.
double stiffness_of(const ToolResponse& response, double reach) {
  const double size = response.force.norm();
  if (size == 0) return 0;
  const Eigen::Vector3d out = response.force / size;
  Eigen::Vector3d change = response.held_by_motion.leftCols<3>() * out;
  for (const SiteResponse& site : response.sites) {
    change -= site.force_by_motion.head<3>().dot(out) * site.normal +
              site.force * (site.normal_by_motion.leftCols<3>() * out);
  }
  const double stiffness = -change.dot(out);
  return stiffness > 0 ? stiffness : size / reach;
}

}  // namespace

Eigen::Vector3d LocalModel::force_of_sites(const ToolMotion& motion) const {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  double pressed = 0;
  for (const SiteResponse& site : response.sites) {
    const double push = site.force + site.force_by_motion.dot(motion);
    if (push <= 0) continue;
    force -= push * (site.normal + site.normal_by_motion * motion).normalized();
    pressed += push;
  }
  // Friction goes with what presses.
  return site_force > 0 ? force + std::min(1.0, pressed / site_force) * rest : force;
}

Eigen::Vector3d LocalModel::force_of_hold(const ToolMotion& motion) const {
  const Eigen::Vector3d force = response.held_force + response.held_by_motion * motion;
  const Eigen::Vector3d& direction = response.pose.direction;
  const double push = -force.dot(direction), at_rest = std::abs(response.held_force.dot(direction));
  if (push <= 0) return Eigen::Vector3d::Zero();
  const Eigen::Vector3d sideways = force + push * direction;
  return -push * direction + std::min(1.0, push / std::max(kLettingGo * at_rest, 1e-12)) * sideways;
}

Eigen::Vector3d LocalModel::limited(const Eigen::Vector3d& tip) const {
  const double size = response.force.norm();
  const Eigen::Vector3d out =
      size > 0 ? Eigen::Vector3d(response.force / size) : Eigen::Vector3d(-response.pose.direction);
  const double back = tip.dot(out);
  const Eigen::Vector3d sideways = tip - back * out;
  const double part = sideways.norm() / (kSidewaysReach * reach);
  return std::max(back, -reach) * out + sideways / std::sqrt(1 + part * part);
}

double LocalModel::share_of_way(const Eigen::Vector3d& tip) const {
  const double length = way.norm();
  if (length == 0) return 0;
  return std::clamp(tip.dot(way) / (length * length), -1.0, std::min(kFarthestShare, reach / length));
}

double LocalModel::most_force(const ToolMotion& motion) const {
  const double size = response.force.norm(), back = size > 0 ? motion.head<3>().dot(response.force) / size : 0;
  const double sideways = std::sqrt(std::max(0.0, motion.head<3>().squaredNorm() - back * back));
  if (back <= 0) return size + stiffness * (sideways - kSlack * back);
  return std::max(0.0, size - stiffness * back / kSlack) + stiffness * sideways * std::max(0.0, 1 - back / reach);
}

Eigen::Vector3d LocalModel::force_at(const ToolPose& pose) const {
  ToolMotion motion = motion_between(response.pose, pose);
  if (!response.is_touching()) {
    const double gap = response.ahead.gap - response.ahead.normal.dot(motion.head<3>());
    return rest + (gap < 0 ? response.ahead.stiffness * std::max(gap, -reach) : 0.0) * response.ahead.normal;
  }
  const Eigen::Vector3d whole = motion.head<3>();
  const double share = share_of_way(whole);
  motion.head<3>() = limited(whole - share * way);
  const Eigen::Vector3d aside = response.holds ? force_of_hold(motion) : force_of_sites(motion);
  const Eigen::Vector3d force = aside + share * change;
  motion.head<3>() = limited(whole);
  const double most = most_force(motion), size = force.norm();
  return size > most ? Eigen::Vector3d(most / size * force) : force;
}

void LocalModelMaker::make(const ToolResponse& response, double time, bool event, LocalModel& model) {
  model.response = response;
  model.time = time;
  model.reach = reach_;
  model.way.setZero();
  model.change.setZero();
  model.site_force = 0;
  model.stiffness = stiffness_of(response, reach_);
  Eigen::Vector3d explained = response.held_force;
  for (const SiteResponse& site : response.sites) {
    explained -= site.force * site.normal;
    model.site_force += site.force;
  }
  model.rest = response.force - explained;
  // What a hold does is all that it does.
  if (response.holds) model.rest.setZero();
  if (event) anchors_.clear();
  // Of the equilibria before the nearest that is far enough; what lies between tells too little.
  if (anchors_.size() == 2 && (response.pose.tip - anchors_[1].tip).norm() >= shortest_way_)
    anchors_.erase(anchors_.begin());
  if (!anchors_.empty()) {
    const Eigen::Vector3d way = response.pose.tip - anchors_[0].tip;
    // A way on which the tool came to touch the wall tells nothing of how the force goes on.
    const bool touched = !anchors_[0].force.isZero() && response.is_touching();
    if (touched && way.norm() >= shortest_way_ && way.norm() <= reach_) {
      model.way = way;
      model.change = response.force - anchors_[0].force;
    }
  }
  const bool is_far = anchors_.empty() || (response.pose.tip - anchors_.back().tip).norm() >= shortest_way_;
  if (is_far) anchors_.push_back({.tip = response.pose.tip, .force = response.force});
}

}  // namespace thinwall
