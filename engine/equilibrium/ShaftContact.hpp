#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "engine/equilibrium/BodyModel.hpp"

namespace thinwall {

struct EquilibriumTerms;

/// A vertex of a puncture's lips, which lies on the needle that is in it.
struct ShaftPoint {
  int vertex = 0;
  double angle = 0;      // radians about the needle's z', from its x'
  bool touches = true;   // until it has come off the tip
  bool is_held = false;  // cannot move: it has made way for the needle, and does nothing to it
  double anchor = 0;     // metres along the needle, from its tip backwards: where the place would be without slip
  double limit = 0;  // newton, of friction: coefficient times the force with which the wall squeezed in the last step
  double friction = 0;  // newton, on the wall, forwards along the needle, at the end of the last step
};

/// What a vertex of the lips and a needle do to each other.
struct ShaftTerms {
  double energy = 0;                                   // joule: potential of the squeeze and of friction
  double stored = 0;                                   // joule: what of that comes back
  double squeeze = 0;                                  // newton, of the wall on the needle, inwards
  double friction = 0;                                 // newton, on the wall, forwards along the needle
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();  // newton, by the vertex's position
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();   // newton / metre
};

/// Which of its laws a vertex of the lips follows: each is linear where the other two of its kind are not.
struct ShaftBranch {
  bool presses = false;  // whether the wall there squeezes the needle
  int slides = 0;        // 1 backwards along the needle, -1 forwards, 0 where friction holds it

  bool operator==(const ShaftBranch&) const = default;
};

/// A needle in the wall during a solution. A slit of twice its radius that is spread on a round shaft: its vertices,
/// evenly spread in angle as they were along the slit, are each kept out of the needle's tangent plane there by a stiff
/// spring, kept from running together around it by a soft one, and slide along the needle under Coulomb's law. With z
/// the distance of a vertex behind the tip, e(angle) the direction of its plane from the axis, t across e and the
/// needle, and r(z) the radius of the needle there, which grows evenly over the cone,
///
///     energy = stiffness / 2 (max(0, r(z) - e . (x - tip))^2 + 0.01 (t . (x - tip))^2) + friction(z - anchor).
struct ShaftContact {
  int tool = 0;                                         // index
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();        // metres
  Eigen::Matrix3d frame = Eigen::Matrix3d::Identity();  // columns x', y', z', a rotation
  double radius = 0;                                    // metres, of the shaft
  double cone = 0;                                      // metres, length of the needle's point
  double spread = 1;                                    // part of the radius by which the slit is spread
  double stiffness = 0;                                 // newton / metre
  double give = 0;                                      // metres of slip before friction is overcome
  std::vector<ShaftPoint> points = {};                  // of the lips

  /// Metres behind the tip, less than zero in front of it.
  double behind_tip(const Eigen::Vector3d& place) const { return -frame.col(2).dot(place - tip); }
  ShaftTerms at(const ShaftPoint& point, const Eigen::Vector3d& place) const;
  ShaftBranch branch_at(const ShaftPoint& point, const Eigen::Vector3d& place) const;
  /// As if the vertex followed one branch everywhere: what a step to where it does may be taken from. Without energies.
  ShaftTerms along(const ShaftBranch& branch, const ShaftPoint& point, const Eigen::Vector3d& place) const;
  /// What the wall does to the needle, newton. `position`: (unknowns), metres.
  Eigen::Vector3d force(const Eigen::VectorXd& position) const;
  /// Energy that comes back, joule.
  double stored(const Eigen::VectorXd& position) const;

 private:
  struct View;
  View view(const ShaftPoint& point, const Eigen::Vector3d& place) const;
};

/// Adds the second derivatives by one vertex. `values`: (non-zeros), newton / metre.
void add_vertex(const BodyModel& model, int vertex, const Eigen::Matrix3d& hessian, std::span<double> values);

/// Adds energy, gradient and Hessian of all of them.
void add_shafts(const BodyModel& model, const std::vector<ShaftContact>& shafts, const Eigen::VectorXd& position,
                EquilibriumTerms& terms);

}  // namespace thinwall
