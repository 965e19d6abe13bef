#include "engine/simulation/ShaftContact.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "engine/mesh/SurfacePoint.hpp"
#include "engine/simulation/Equilibrium.hpp"

namespace thinwall {
namespace {

/// Stiffness of the springs that keep lips evenly around the needle, over that of those that keep them out of it.
constexpr double kGuide = 0.01;

}  // namespace

ShaftTerms ShaftContact::at(const ShaftPoint& point, const Eigen::Vector3d& place) const {
  if (!point.touches) return {};
  const Eigen::Vector3d along = frame.col(2);
  const Eigen::Vector3d outwards = std::cos(point.angle) * frame.col(0) + std::sin(point.angle) * frame.col(1);
  const double behind = behind_tip(place), whole = spread * radius;
  const bool on_cone = behind > 0 && behind < cone;
  const double wanted = whole * std::clamp(behind / cone, 0.0, 1.0);
  const double slope = on_cone ? whole / cone : 0;  // of the radius, by the distance behind the tip
  const Eigen::Vector3d around = along.cross(outwards);
  const double overlap = std::max(0.0, wanted - outwards.dot(place - tip)), astray = around.dot(place - tip);
  const Eigen::Vector3d by_place = -(outwards + slope * along);
  ShaftTerms terms;
  terms.squeeze = stiffness * overlap;
  const double guide = kGuide * stiffness;
  terms.energy = terms.stored = 0.5 * (terms.squeeze * overlap + guide * astray * astray);
  terms.gradient = terms.squeeze * by_place + guide * astray * around;
  terms.hessian = guide * around * around.transpose();
  if (overlap > 0) terms.hessian += stiffness * by_place * by_place.transpose();
  if (point.limit == 0) return terms;
  const double slip = behind - point.anchor;
  const double elastic = std::clamp(slip, -give, give), spring = point.limit / give;
  terms.stored += 0.5 * spring * elastic * elastic;
  terms.energy += 0.5 * spring * elastic * elastic + point.limit * (std::abs(slip) - std::abs(elastic));
  terms.friction = spring * elastic;
  terms.gradient -= terms.friction * along;
  if (std::abs(slip) <= give) terms.hessian += spring * along * along.transpose();
  return terms;
}

Eigen::Vector3d ShaftContact::force(const Eigen::VectorXd& position) const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const ShaftPoint& point : points) sum += at(point, position.segment<3>(3 * point.vertex)).gradient;
  return sum;
}

double ShaftContact::stored(const Eigen::VectorXd& position) const {
  double sum = 0;
  for (const ShaftPoint& point : points) sum += at(point, position.segment<3>(3 * point.vertex)).stored;
  return sum;
}

void add_shafts(const BodyModel& model, const std::vector<ShaftContact>& shafts, const Eigen::VectorXd& position,
                EquilibriumTerms& terms) {
  for (const ShaftContact& shaft : shafts) {
    for (const ShaftPoint& point : shaft.points) {
      const ShaftTerms own = shaft.at(point, position.segment<3>(3 * point.vertex));
      const SurfacePoint place = point_at(model.definition.mesh.triangles, point.vertex);
      Eigen::Index corner = 0;
      place.weights.maxCoeff(&corner);
      Eigen::Matrix<double, 9, 9> hessian = Eigen::Matrix<double, 9, 9>::Zero();
      hessian.block<3, 3>(3 * corner, 3 * corner) = own.hessian;
      terms.gradient.segment<3>(3 * point.vertex) += own.gradient;
      terms.friction += own.energy;
      add_triangle(model.addresses[place.triangle], hessian, terms.values);
      terms.largest_force = std::max(terms.largest_force, own.gradient.lpNorm<Eigen::Infinity>());
    }
  }
}

}  // namespace thinwall
