#include "engine/equilibrium/ShaftContact.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "engine/equilibrium/Equilibrium.hpp"
#include "engine/mesh/SurfacePoint.hpp"

namespace thinwall {
namespace {

/// Stiffness of the springs that keep lips evenly around the needle, over that of those that keep them out of it.
constexpr double kGuide = 0.01;

}  // namespace

/// Where a vertex is seen from the needle.
struct ShaftContact::View {
  Eigen::Vector3d along, around, by_place;   // the last: of the overlap
  double overlap = 0, astray = 0, slip = 0;  // metres, the first less than zero beside the needle
};

ShaftContact::View ShaftContact::view(const ShaftPoint& point, const Eigen::Vector3d& place) const {
  const Eigen::Vector3d along = frame.col(2);
  const Eigen::Vector3d outwards = std::cos(point.angle) * frame.col(0) + std::sin(point.angle) * frame.col(1);
  const double behind = behind_tip(place), whole = spread * radius;
  // The cone goes on beyond the tip: a lip that is drawn over it would find no rest where its end began.
  const double wanted = whole * std::min(behind / cone, 1.0);
  const double slope = behind < cone ? whole / cone : 0;  // of the radius, by the distance behind the tip
  const Eigen::Vector3d around = along.cross(outwards);
  return {.along = along,
          .around = around,
          .by_place = -(outwards + slope * along),
          .overlap = wanted - outwards.dot(place - tip),
          .astray = around.dot(place - tip),
          .slip = behind - point.anchor};
}

ShaftBranch ShaftContact::branch_at(const ShaftPoint& point, const Eigen::Vector3d& place) const {
  const View seen = view(point, place);
  return {.presses = seen.overlap > 0, .slides = std::abs(seen.slip) <= give ? 0 : seen.slip > 0 ? 1 : -1};
}

ShaftTerms ShaftContact::along(const ShaftBranch& branch, const ShaftPoint& point, const Eigen::Vector3d& place) const {
  if (!point.touches || point.is_held) return {};
  const View seen = view(point, place);
  const double guide = kGuide * stiffness, spring = point.limit / give;
  ShaftTerms terms;
  terms.squeeze = branch.presses ? stiffness * seen.overlap : 0;
  terms.friction = branch.slides == 0 ? spring * seen.slip : branch.slides * point.limit;
  terms.gradient = terms.squeeze * seen.by_place + guide * seen.astray * seen.around - terms.friction * seen.along;
  terms.hessian = guide * seen.around * seen.around.transpose();
  if (branch.presses) terms.hessian += stiffness * seen.by_place * seen.by_place.transpose();
  if (branch.slides == 0) terms.hessian += spring * seen.along * seen.along.transpose();
  return terms;
}

ShaftTerms ShaftContact::at(const ShaftPoint& point, const Eigen::Vector3d& place) const {
  if (!point.touches || point.is_held) return {};
  const View seen = view(point, place);
  ShaftTerms terms = along(branch_at(point, place), point, place);
  const double overlap = std::max(0.0, seen.overlap), elastic = std::clamp(seen.slip, -give, give);
  const double spring = point.limit / give;
  terms.stored = 0.5 * stiffness * (overlap * overlap + kGuide * seen.astray * seen.astray);
  terms.stored += 0.5 * spring * elastic * elastic;
  terms.energy = terms.stored + point.limit * (std::abs(seen.slip) - std::abs(elastic));
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

void add_vertex(const BodyModel& model, int vertex, const Eigen::Matrix3d& hessian, std::span<double> values) {
  const SurfacePoint place = point_at(model.definition.mesh.triangles, vertex);
  Eigen::Index corner = 0;
  place.weights.maxCoeff(&corner);
  Eigen::Matrix<double, 9, 9> whole = Eigen::Matrix<double, 9, 9>::Zero();
  whole.block<3, 3>(3 * corner, 3 * corner) = hessian;
  add_triangle(model.addresses[place.triangle], whole, values);
}

void add_shafts(const BodyModel& model, const std::vector<ShaftContact>& shafts, const Eigen::VectorXd& position,
                EquilibriumTerms& terms) {
  for (const ShaftContact& shaft : shafts) {
    for (const ShaftPoint& point : shaft.points) {
      const ShaftTerms own = shaft.at(point, position.segment<3>(3 * point.vertex));
      terms.gradient.segment<3>(3 * point.vertex) += own.gradient;
      terms.friction += own.energy;
      if (terms.has_hessian()) add_vertex(model, point.vertex, own.hessian, terms.values);
      terms.largest_force = std::max(terms.largest_force, own.gradient.lpNorm<Eigen::Infinity>());
    }
  }
}

}  // namespace thinwall
