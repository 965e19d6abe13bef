#include "tests/engine/simulation/OpenBodies.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "engine/mesh/MeshTopology.hpp"
#include "engine/mesh/Shapes.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

bool touches(const Eigen::Vector3i& triangle, const std::vector<char>& chosen) {
  return chosen[triangle[0]] || chosen[triangle[1]] || chosen[triangle[2]];
}

std::vector<char> chosen_vertices(const SurfaceMesh& mesh, const Eigen::Vector3d& point, int rings) {
  std::vector<char> chosen(mesh.vertices.size(), 0);
  const auto farther = [&](const Eigen::Vector3d& one, const Eigen::Vector3d& other) {
    return (one - point).norm() < (other - point).norm();
  };
  chosen[std::min_element(mesh.vertices.begin(), mesh.vertices.end(), farther) - mesh.vertices.begin()] = 1;
  for (int ring = 1; ring < rings; ++ring) {
    const std::vector<char> inner = chosen;
    for (const Eigen::Vector3i& triangle : mesh.triangles) {
      if (!touches(triangle, inner)) continue;
      for (const int vertex : triangle) chosen[vertex] = 1;
    }
  }
  return chosen;
}

}  // namespace

void open_at(const Eigen::Vector3d& point, int rings, BodyDefinition& body) {
  const std::vector<char> chosen = chosen_vertices(body.mesh, point, rings);
  std::vector<int> number(chosen.size(), -1);
  SurfaceMesh mesh;
  for (std::size_t v = 0; v < chosen.size(); ++v) {
    if (chosen[v]) continue;
    number[v] = static_cast<int>(mesh.vertices.size());
    mesh.vertices.push_back(body.mesh.vertices[v]);
  }
  const auto renumber = [&](const Eigen::Vector3i& triangle) {
    return Eigen::Vector3i(number[triangle[0]], number[triangle[1]], number[triangle[2]]);
  };
  std::vector<double> thickness;
  for (std::size_t t = 0; t < body.mesh.triangles.size(); ++t) {
    if (touches(body.mesh.triangles[t], chosen)) continue;
    mesh.triangles.push_back(renumber(body.mesh.triangles[t]));
    thickness.push_back(body.thickness[t]);
  }
  for (const Eigen::Vector3i& cap : body.mesh.cap_triangles) mesh.cap_triangles.push_back(renumber(cap));
  for (const auto& [name, vertices] : body.mesh.groups) {
    for (const int v : vertices) {
      if (number[v] >= 0) mesh.groups[name].push_back(number[v]);
    }
  }
  const MeshTopology topology = topology_of(static_cast<int>(mesh.vertices.size()), closed_surface(mesh));
  double nearest = std::numeric_limits<double>::infinity();
  Opening opening;
  for (const std::vector<int>& loop : topology.boundary_loops) {
    const double distance = (mesh.vertices[loop[0]] - point).norm();
    if (distance < nearest) opening.lips = loop, nearest = distance;
  }
  body.openings.push_back(opening);
  body.mesh = std::move(mesh);
  body.thickness = std::move(thickness);
}

void fix_lips(BodyDefinition& body) {
  body.mesh.groups["lips"] = body.openings.back().lips;
  std::ranges::sort(body.mesh.groups["lips"]);
  body.fixed.push_back(fixed_group("lips"));
}

BodyDefinition open_ball(int triangles, double pressure, int rings) {
  BodyDefinition body = make_body(make_sphere(20e-3, triangles), 1e-3, neo_hookean(20e3));
  body.fluid.initial_pressure = pressure;
  open_at({0, 0, 20e-3}, rings, body);
  fix_lips(body);
  return body;
}

Eigen::Vector3d force_of_supports(const Body& body, const Eigen::Vector3d& gravity) {
  const BodyModel& model = body.model();
  const BodyState& state = body.state();
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(3 * model.vertices());
  for (std::size_t t = 0; t < model.surface.size(); ++t) {
    const auto corners = corners_of(model.surface[t], state.equilibrium.position);
    const int chamber = model.chamber[t];
    PressureField field{.at_origin = state.equilibrium.pressure[chamber],
                        .slope = model.definition.fluid.density * gravity};
    field.at_origin -= field.slope.dot(model.chambers[chamber].level);
    Eigen::Matrix<double, 9, 1> part = -model.share[t] * pressure_load_of(corners, field);
    if (t < model.rest.size())
      part += membrane_terms(model.rest[t], model.material(static_cast<int>(t)), corners).gradient;
    for (int k = 0; k < 3; ++k) forces.segment<3>(3 * model.surface[t][k]) += part.segment<3>(3 * k);
  }
  for (int v = 0; v < model.vertices(); ++v) forces.segment<3>(3 * v) -= model.mass[3 * v] * gravity;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (Eigen::Index k = 0; k < forces.size(); ++k) {
    if (model.fixed[k]) sum[k % 3] += forces[k];
  }
  return sum;
}

}  // namespace thinwall
