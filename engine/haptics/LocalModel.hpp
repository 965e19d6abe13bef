#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/simulation/ToolResponse.hpp"

namespace thinwall {

/// What a hand feels around one equilibrium, cheap enough for every tick: each place that presses answers by its own
/// force and direction, first order in the motion of the tool, and lets go when its force is used up; the wall ahead of
/// a free tool is a spring. That holds while the same places bear the tool. Where it slides others come to bear it, and
/// the force goes on far more evenly than that of any of them: so along the way from the equilibrium before it changes
/// as it did on that way (a secant), and the places answer what goes aside from it.
struct LocalModel {
  ToolResponse response;
  double time = 0;        // seconds, of the hand, for which it was found
  double reach = 0;       // metres, of the tool's way beyond which it gives no more than at its end
  double stiffness = 0;   // newton / metre, of the whole force by the way in its own direction
  double site_force = 0;  // newton, sum of the sites' forces
  Eigen::Vector3d rest = Eigen::Vector3d::Zero();    // newton, what the sites do not explain: friction, blades, shafts
  Eigen::Vector3d way = Eigen::Vector3d::Zero();     // metres, to the tip from the equilibrium before, or zero
  Eigen::Vector3d change = Eigen::Vector3d::Zero();  // newton, of the force on that way

  /// Newton, what the tissue does to a tool at a pose.
  Eigen::Vector3d force_at(const ToolPose& pose) const;

 private:
  /// By how many of `way` the tip has gone on along it: back to the equilibrium before at most, and ahead within reach.
  double share_of_way(const Eigen::Vector3d& tip) const;
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
  /// `reach`: metres; `shortest_way`: metres between two equilibria from which a secant is found.
  LocalModelMaker(double reach, double shortest_way) : reach_(reach), shortest_way_(shortest_way) {}

  /// `event`: whether the wall has been cut or pierced since the last one, which then tells nothing.
  void make(const ToolResponse& response, double time, bool event, LocalModel& model);

 private:
  /// An equilibrium before.
  struct Anchor {
    Eigen::Vector3d tip;    // metres
    Eigen::Vector3d force;  // newton
  };

  double reach_, shortest_way_;
  std::vector<Anchor> anchors_;  // two at most, the older one first
};

}  // namespace thinwall
