#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/contact/FrictionPotential.hpp"
#include "engine/equilibrium/BodyModel.hpp"

namespace thinwall {

struct EquilibriumTerms;

/// A place of the wall that a solid presses on and rubs against, during one solution. Normal force, normal and place
/// are those found last, so that the energy has a symmetric Hessian; who solves finds them again until they agree.
struct FrictionContact {
  int solid = 0;                                      // index into the problem's solids
  int site = 0;                                       // index into the model's sites
  int triangle = 0;                                   // index, of the site
  Eigen::Vector3d weights = Eigen::Vector3d::Zero();  // barycentric, of the place in the triangle
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  // unit, out of the solid
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();   // metres, where the place would be if it did not slip
  FrictionPotential potential = {};
  Eigen::Vector3d estimate = Eigen::Vector3d::Zero();  // newton, of the force on the solid: Newton's second unknown

  /// Metres, in the tangent plane.
  Eigen::Vector3d slip(const BodyModel& model, const Eigen::VectorXd& position) const;
  /// What the wall does to the solid, newton.
  Eigen::Vector3d force(const BodyModel& model, const Eigen::VectorXd& position) const;
};

/// What a place of the wall remembers of its friction from one step to the next.
struct FrictionMemory {
  int site = 0;                                            // index into the model's sites
  int triangle = 0;                                        // index, of the site
  Eigen::Vector3d weights = Eigen::Vector3d::Zero();       // barycentric
  Eigen::Vector3d elastic_slip = Eigen::Vector3d::Zero();  // metres, in the frame of the solid
  Eigen::Vector3d force = Eigen::Vector3d::Zero();         // newton, on the solid, in its frame
};

/// Place in a triangle, metres. `position`: (3 vertices), metres.
Eigen::Vector3d place_on(const BodyModel& model, int triangle, const Eigen::Vector3d& weights,
                         const Eigen::VectorXd& position);

/// Carries the estimates of all contacts along with a motion (3 vertices, metres) from `position`.
void advance_estimates(const BodyModel& model, const Eigen::VectorXd& position, const Eigen::VectorXd& motion,
                       double fraction, std::vector<FrictionContact>& contacts);

/// Adds energy, gradient and Hessian of all contacts.
void add_friction(const BodyModel& model, const std::vector<FrictionContact>& contacts, const Eigen::VectorXd& position,
                  EquilibriumTerms& terms);

}  // namespace thinwall
