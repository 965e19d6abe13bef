#include "engine/contact/SphereContact.hpp"

#include <algorithm>
#include <cmath>

namespace thinwall {

double ContactPotential::energy(double gap) const {
  const double s = gap / range;
  if (s >= 1) return 0;
  if (s >= 0) return stiffness * range * (1 - s) * (1 - s) * (1 - s) / 3;
  return stiffness * range * (1.0 / 3 - s + s * s);
}

double ContactPotential::pressure(double gap) const {
  const double s = gap / range;
  if (s >= 1) return 0;
  return s >= 0 ? stiffness * (1 - s) * (1 - s) : stiffness * (1 - 2 * s);
}

double ContactPotential::pressure_slope(double gap) const {
  const double s = gap / range;
  if (s >= 1) return 0;
  return s >= 0 ? -2 * stiffness * (1 - s) / range : -2 * stiffness / range;
}

namespace {

bool out_of_reach(const SphereTool& sphere, double reach, const std::array<Eigen::Vector3d, 3>& corners) {
  const Eigen::Vector3d centroid = (corners[0] + corners[1] + corners[2]) / 3;
  double extent = 0;
  for (const Eigen::Vector3d& corner : corners) extent = std::max(extent, (corner - centroid).squaredNorm());
  const double distance = sphere.radius + reach + std::sqrt(extent);
  return (centroid - sphere.center).squaredNorm() > distance * distance;
}

void add_sample(const SphereTool& sphere, const ContactPotential& potential, const Eigen::Vector3d& weights,
                double area, const std::array<Eigen::Vector3d, 3>& corners, SphereContactTerms& terms) {
  const Eigen::Vector3d offset =
      weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2] - sphere.center;
  const double distance = offset.norm();
  const double gap = distance - sphere.radius;
  if (gap >= potential.range) return;
  if (!terms.touched) {
    terms.touched = true;
    terms.gradient.setZero();
    terms.hessian.setZero();
    terms.tool_force.setZero();
  }
  const Eigen::Vector3d normal = offset / distance;
  const double pressure = potential.pressure(gap);
  const Eigen::Matrix3d outer = normal * normal.transpose();
  const Eigen::Matrix3d block =
      area * (-potential.pressure_slope(gap) * outer - pressure / distance * (Eigen::Matrix3d::Identity() - outer));
  terms.energy += area * potential.energy(gap);
  terms.tool_force -= area * pressure * normal;
  terms.pressed += area * pressure;
  terms.pressed_squared += area * pressure * pressure;
  for (int a = 0; a < 3; ++a) {
    terms.gradient.segment<3>(3 * a) -= area * pressure * weights[a] * normal;
    for (int b = 0; b < 3; ++b) terms.hessian.block<3, 3>(3 * a, 3 * b) += weights[a] * weights[b] * block;
  }
}

}  // namespace

SphereContactTerms sphere_contact_terms(const SphereTool& sphere, const ContactPotential& potential, double rest_area,
                                        int divisions, const std::array<Eigen::Vector3d, 3>& corners) {
  SphereContactTerms terms;
  if (out_of_reach(sphere, potential.range, corners)) return terms;
  const double area = rest_area / (static_cast<double>(divisions) * divisions);
  const double part = 1.0 / (3 * divisions);
  for (int i = 0; i < divisions; ++i) {
    for (int j = 0; i + j < divisions; ++j) {
      const Eigen::Vector3d upright((3 * i + 1) * part, (3 * j + 1) * part, 1 - (3 * i + 3 * j + 2) * part);
      add_sample(sphere, potential, upright, area, corners, terms);
      if (i + j + 1 < divisions) {
        const Eigen::Vector3d inverted((3 * i + 2) * part, (3 * j + 2) * part, 1 - (3 * i + 3 * j + 4) * part);
        add_sample(sphere, potential, inverted, area, corners, terms);
      }
    }
  }
  return terms;
}

}  // namespace thinwall
