#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "engine/equilibrium/BodyModel.hpp"
#include "engine/mesh/MeshTopology.hpp"

namespace thinwall {
namespace {

/// Distances from a plane below this part of the mean edge length count as none.
constexpr double kFlat = 1e-6;

/// Components of a unit normal below this do not ask for a fixed axis.
constexpr double kAlongAxis = 1e-6;

/// The plane of some caps as a floor, if they are one.
std::optional<FloorPlane> floor_of(const BodyModel& model, const std::vector<Eigen::Vector3i>& caps) {
  Eigen::Vector3d area = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3i& cap : caps) {
    const auto corners = corners_of(cap, model.rest_position);
    area += (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  }
  const double flat = kFlat * model.edge_length;
  if (!(area.norm() > flat * flat)) return std::nullopt;
  const Eigen::Vector3d normal = -area.normalized();
  const double height = normal.dot(model.rest_position.segment<3>(3 * caps.front()[0]));
  for (const Eigen::Vector3i& cap : caps) {
    for (const int vertex : cap) {
      if (std::abs(normal.dot(model.rest_position.segment<3>(3 * vertex)) - height) > flat) return std::nullopt;
      for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(normal[axis]) > kAlongAxis && !model.fixed[3 * vertex + axis]) return std::nullopt;
      }
    }
  }
  for (int vertex = 0; vertex < model.vertices(); ++vertex) {
    if (normal.dot(model.rest_position.segment<3>(3 * vertex)) < height - flat) return std::nullopt;
  }
  return FloorPlane{.normal = normal, .height = height};
}

}  // namespace

SelfContactDefinition self_contact_of(const BodyModel& model, const Eigen::VectorXd& placement, double edge_length) {
  // A wall that bears a strain of 1 over the whole body: the pressure of a balloon of that wall, but for a factor.
  const double radius = std::sqrt(model.rest_area / (4 * std::numbers::pi));
  SelfContactDefinition definition{.triangles = model.definition.mesh.triangles,
                                   .position = model.rest_position.head(3 * model.vertices()),
                                   .thickness = model.definition.thickness,
                                   .fixed = {model.fixed.begin(), model.fixed.begin() + 3 * model.vertices()},
                                   .floors = {},
                                   .pressure = model.wall_stiffness / radius,
                                   .edge_length = edge_length};
  if (placement.size() > 0) definition.placement = placement.head(3 * model.vertices());
  const std::vector<Prestretch>& stretch = model.definition.prestretch;
  for (int t = 0; !stretch.empty() && t < model.triangles(); ++t) {
    const Prestretch& there = stretch[stretch.size() == 1 ? 0 : static_cast<std::size_t>(t)];
    definition.stretch.push_back(std::max(there.first, there.second));
  }
  const std::vector<Eigen::Vector3i>& caps = model.definition.mesh.cap_triangles;
  const MeshTopology topology = topology_of(model.vertices(), caps);
  for (int component = 0; component < topology.component_count; ++component) {
    std::vector<Eigen::Vector3i> part;
    for (std::size_t k = 0; k < caps.size(); ++k) {
      if (topology.triangle_component[k] == component) part.push_back(caps[k]);
    }
    if (const auto floor = floor_of(model, part)) definition.floors.push_back(*floor);
  }
  return definition;
}

}  // namespace thinwall
