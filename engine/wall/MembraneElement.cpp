#include "engine/wall/MembraneElement.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "engine/solver/BlockPattern.hpp"
#include "engine/wall/MembraneLanes.hpp"
#include "engine/wall/TensionField.hpp"

namespace thinwall {
namespace {

using ShapeGradients = Eigen::Matrix<double, 2, 3>;  // gradient of the shape functions N0, N1, N2 in the rest plane

ShapeGradients shape_gradients(const MembraneRest& rest) {
  ShapeGradients gradients;
  gradients.col(1) = rest.inverse_edges.row(0).transpose();
  gradients.col(2) = rest.inverse_edges.row(1).transpose();
  gradients.col(0) = -gradients.col(1) - gradients.col(2);
  return gradients;
}

Eigen::Vector3d right_cauchy_green(const Eigen::Matrix<double, 3, 2>& f) {
  return {f.col(0).squaredNorm(), f.col(1).squaredNorm(), f.col(0).dot(f.col(1))};
}

Eigen::Vector3d green_lagrange(const Eigen::Vector3d& c) {
  return {0.5 * (c[0] - 1), 0.5 * (c[1] - 1), c[2]};
}

void remember(const MembraneMemory& memory, const Material& material, const Eigen::Vector3d& strain,
              WallLawResponse& response) {
  if (memory.scale == 1 && memory.damping == 0 && memory.overstress.isZero()) return;
  response.energy = memory.scale * response.energy + memory.overstress.dot(strain);
  response.second_piola_kirchhoff = memory.scale * response.second_piola_kirchhoff + memory.overstress;
  response.tangent *= memory.scale;
  if (memory.damping == 0) return;
  const Eigen::Matrix3d damping =
      memory.damping * material.law->respond(material.parameters, Eigen::Vector3d(1, 1, 0)).tangent;
  response.energy += 0.5 * strain.dot(damping * strain);
  response.second_piola_kirchhoff += damping * strain;
  response.tangent += damping;
}

/// `tension`: (S11, S22, S12) times the rest volume, joule.
void add_geometric_stiffness(const ShapeGradients& gradients, const Eigen::Vector3d& tension,
                             Eigen::Matrix<double, 9, 9>& hessian) {
  Eigen::Matrix2d stress;
  stress << tension[0], tension[2], tension[2], tension[1];
  const Eigen::Matrix3d geometric = gradients.transpose() * stress * gradients;
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      for (int k = 0; k < 3; ++k) hessian(3 * a + k, 3 * b + k) += geometric(a, b);
    }
  }
}

/// The unit vector in the plane with this normal that is nearest to a direction.
Eigen::Vector3d in_plane(const Eigen::Vector3d& direction, const Eigen::Vector3d& normal) {
  const Eigen::Vector3d flat = direction - normal * normal.dot(direction);
  assert(flat.norm() > 1e-9 * direction.norm());
  return flat.normalized();
}

}  // namespace

MembraneRest make_membrane_rest(const std::array<Eigen::Vector3d, 3>& corners, double thickness,
                                const Prestretch& prestretch, const Eigen::Vector3d& fibre) {
  Eigen::Matrix<double, 3, 2> edges;
  edges << corners[1] - corners[0], corners[2] - corners[0];
  const Eigen::Vector3d normal = edges.col(0).cross(edges.col(1)).normalized();
  if (prestretch.first != 1 || prestretch.second != 1) {
    const bool even = prestretch.first == prestretch.second;
    const Eigen::Vector3d along = in_plane(even ? edges.col(0).eval() : prestretch.along, normal);
    const Eigen::Vector3d across = normal.cross(along);
    edges = along * (along.transpose() * edges) / prestretch.first +
            across * (across.transpose() * edges) / prestretch.second;
  }
  const Eigen::Vector3d first = in_plane(fibre.isZero() ? edges.col(0).eval() : fibre, normal);
  Eigen::Matrix<double, 2, 3> axes;
  axes << first.transpose(), normal.cross(first).transpose();
  const Eigen::Matrix2d flat = axes * edges;
  const double area = 0.5 * flat.determinant();
  assert(area > 0 && thickness > 0);
  return {.inverse_edges = flat.inverse(), .area = area, .thickness = thickness};
}

Eigen::Matrix<double, 3, 2> deformation_gradient(const MembraneRest& rest,
                                                 const std::array<Eigen::Vector3d, 3>& corners) {
  Eigen::Matrix<double, 3, 2> edges;
  edges.col(0) = corners[1] - corners[0];
  edges.col(1) = corners[2] - corners[0];
  return edges * rest.inverse_edges;
}

MembraneResponse membrane_response(const Material& material, const Eigen::Vector3d& right_cauchy_green,
                                   const MembraneMemory& memory) {
  MembraneResponse response{
      .whole = wall_response(material, right_cauchy_green, memory.tension_field, memory.slack_stiffness),
      .strain_energy = 0};
  response.strain_energy = response.whole.energy;
  remember(memory, material, green_lagrange(right_cauchy_green), response.whole);
  return response;
}

MembraneTerms membrane_terms(const MembraneRest& rest, const Material& material,
                             const std::array<Eigen::Vector3d, 3>& corners, const MembraneMemory& memory) {
  MembraneLanes lanes;
  const MembraneTriangle triangle{.rest = &rest, .material = &material, .corners = corners, .memory = memory};
  membrane_lanes({&triangle, 1}, true, lanes);
  MembraneTerms terms{
      .energy = lanes.energy[0], .strain_energy = lanes.strain_energy[0], .gradient = {}, .hessian = {}};
  for (int k = 0; k < 9; ++k) terms.gradient[k] = lanes.gradient[k][0];
  for (int block = 0; block < 6; ++block) {
    const auto [i, j] = kBlockCorners[block];
    for (int column = 0; column < 3; ++column) {
      for (int row = i == j ? column : 0; row < 3; ++row) {
        const double value = lanes.hessian[block][3 * column + row][0];
        terms.hessian(3 * i + row, 3 * j + column) = terms.hessian(3 * j + column, 3 * i + row) = value;
      }
    }
  }
  return terms;
}

MembraneStress membrane_stress(const MembraneRest& rest, const Material& material,
                               const std::array<Eigen::Vector3d, 3>& corners,
                               const std::array<Eigen::Vector3d, 3>& motion, const MembraneMemory& memory) {
  const Eigen::Matrix<double, 3, 2> f = deformation_gradient(rest, corners);
  const Eigen::Matrix2d product = f.transpose() * deformation_gradient(rest, motion);
  const WallLawResponse response = membrane_response(material, right_cauchy_green(f), memory).whole;
  const Eigen::Vector3d strain(product(0, 0), product(1, 1), product(0, 1) + product(1, 0));
  return {.now = response.second_piola_kirchhoff,
          .foreseen = response.second_piola_kirchhoff + response.tangent * strain};
}

Eigen::Matrix<double, 9, 9> geometric_stiffness(const MembraneRest& rest, const Eigen::Vector3d& stress) {
  Eigen::Matrix<double, 9, 9> stiffness = Eigen::Matrix<double, 9, 9>::Zero();
  add_geometric_stiffness(shape_gradients(rest), rest.area * rest.thickness * stress, stiffness);
  return stiffness;
}

Eigen::Vector3d green_lagrange_strain(const MembraneRest& rest, const std::array<Eigen::Vector3d, 3>& corners) {
  return green_lagrange(right_cauchy_green(deformation_gradient(rest, corners)));
}

Eigen::Vector2d principal_cauchy_stress(const Eigen::Vector3d& s, const Eigen::Vector3d& c) {
  // Half the difference is taken from entries that vanish where the two are equal; trace and determinant would lose
  // half the digits there.
  const double first = s[0] * c[0] + s[2] * c[2], second = s[2] * c[2] + s[1] * c[1];
  const double across = (s[0] * c[2] + s[2] * c[1]) * (s[2] * c[0] + s[1] * c[2]);
  const double half_difference = std::sqrt(std::max(0.0, 0.25 * (first - second) * (first - second) + across));
  return {0.5 * (first + second) + half_difference, 0.5 * (first + second) - half_difference};
}

double largest_tension(const MembraneRest& rest, const Material& material,
                       const std::array<Eigen::Vector3d, 3>& corners) {
  const Eigen::Vector3d c = right_cauchy_green(deformation_gradient(rest, corners));
  const Eigen::Vector3d s = material.law->respond(material.parameters, c).second_piola_kirchhoff;
  const double det_c = c[0] * c[1] - c[2] * c[2];
  return rest.thickness * principal_cauchy_stress(s, c)[0] / std::sqrt(det_c);
}

}  // namespace thinwall
