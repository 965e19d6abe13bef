#pragma once

#include <Eigen/Core>

#include "engine/simulation/ToolResponse.hpp"

namespace thinwall {

/// What a hand feels around one equilibrium, cheap enough for every tick: each place that presses answers by its own
/// force and direction, first order in the motion of the tool, and lets go when its force is used up; the wall ahead of
/// a free tool is a spring. To this comes a correction of second order, along the way from the equilibrium before, that
/// brings the model of today to the force that was found there (a secant).
struct LocalModel {
  ToolResponse response;
  double time = 0;        // seconds, of the hand, for which it was found
  double reach = 0;       // metres, of the tool's way beyond which it gives no more than at its end
  double stiffness = 0;   // newton / metre, of the whole force by the way in its own direction
  double site_force = 0;  // newton, sum of the sites' forces
  Eigen::Vector3d rest = Eigen::Vector3d::Zero();    // newton, what the sites do not explain: friction, blades, shafts
  Eigen::Vector3d way = Eigen::Vector3d::Zero();     // metres, to the tip from where the correction was found, or zero
  Eigen::Vector3d missed = Eigen::Vector3d::Zero();  // newton, by which the first order misses the force there

  /// Newton, what the tissue does to a tool at a pose.
  Eigen::Vector3d force_at(const ToolPose& pose) const;

 private:
  /// A way of the tip, metres, as far as the model is good for it: back out of the wall always, into it up to the
  /// reach, along it up to a part of that.
  Eigen::Vector3d limited(const Eigen::Vector3d& tip) const;
  /// Newton, that no motion may exceed: a model far from where it was found must neither push a tool that has left nor
  /// grow without end.
  double most_force(const ToolMotion& motion) const;
  Eigen::Vector3d force_of_sites(const ToolMotion& motion) const;
  Eigen::Vector3d force_of_hold(const ToolMotion& motion) const;
};

/// Makes models of equilibria that follow one another.
class LocalModelMaker {
 public:
  /// `reach`: metres; `shortest_way`: metres between two equilibria from which a correction is found.
  LocalModelMaker(double reach, double shortest_way) : reach_(reach), shortest_way_(shortest_way) {}

  /// `event`: whether the wall has been cut or pierced since the last one, which then tells nothing.
  void make(const ToolResponse& response, double time, bool event, LocalModel& model);

 private:
  double reach_, shortest_way_;
  bool has_anchor_ = false;
  ToolPose anchor_;
  Eigen::Vector3d anchor_force_ = Eigen::Vector3d::Zero();
};

}  // namespace thinwall
