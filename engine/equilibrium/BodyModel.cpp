#include "engine/equilibrium/BodyModel.hpp"

#include <tbb/parallel_invoke.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include "engine/equilibrium/CapFans.hpp"
#include "engine/equilibrium/HeldAxes.hpp"
#include "engine/equilibrium/RigidMotions.hpp"
#include "engine/mesh/MeshTopology.hpp"
#include "engine/shell/BendingPatches.hpp"

namespace thinwall {
namespace {

/// The value of a triangle in a field that is absent, even, or given for each triangle.
template <typename Value>
Value of_triangle(const std::vector<Value>& field, int triangle) {
  if (field.empty()) {
    if constexpr (std::is_same_v<Value, Eigen::Vector3d>) {
      return Eigen::Vector3d::Zero();
    } else {
      return {};
    }
  }
  return field[field.size() == 1 ? 0 : static_cast<std::size_t>(triangle)];
}

void add_wall(BodyModel& model) {
  const BodyDefinition& definition = model.definition;
  const int triangles = static_cast<int>(definition.mesh.triangles.size());
  assert(static_cast<int>(definition.thickness.size()) == triangles);
  model.mass.setZero(model.rest_position.size());
  model.rest.reserve(triangles);
  double stiffness = 0, edges = 0;
  for (int t = 0; t < triangles; ++t) {
    const auto corners = corners_of(definition.mesh.triangles[t], model.rest_position);
    model.rest.push_back(make_membrane_rest(corners, definition.thickness[t], of_triangle(definition.prestretch, t),
                                            of_triangle(definition.fibres, t)));
    const double third = definition.density * model.rest[t].area * model.rest[t].thickness / 3;
    for (const int vertex : definition.mesh.triangles[t]) model.mass.segment<3>(3 * vertex).array() += third;
    model.rest_area += model.rest[t].area;
    const Material& material = model.material(t);
    stiffness += material.law->initial_modulus(material.parameters) * definition.thickness[t];
    for (int k = 0; k < 3; ++k) edges += (corners[k] - corners[(k + 1) % 3]).norm();
  }
  model.wall_stiffness = stiffness / triangles;
  model.edge_length = edges / (3 * triangles);
}

/// Bending couples each triangle with the far corners of its neighbours and with the turns of its sides.
void add_bending(BodyModel& model) {
  const SurfaceMesh& mesh = model.definition.mesh;
  std::vector<char> clamped(mesh.vertices.size(), 0);
  for (const FixedRegion& region : model.definition.fixed) {
    if (!region.clamped) continue;
    for (const int vertex : vertices_in(region.region, mesh)) clamped[vertex] = 1;
  }
  const int vertices = model.vertices();
  const MeshEdges edges = edges_of(vertices, mesh.triangles);
  model.bending = make_bending_rests(mesh, edges, model.rest, model.definition.materials, clamped, model.edge_length);
  std::vector<std::array<int, 2>> couplings;
  for (const BendingRest& patch : model.bending) {
    std::array<int, 9> nodes;
    std::copy(patch.vertices.begin(), patch.vertices.end(), nodes.begin());
    for (int side = 0; side < 3; ++side) nodes[6 + side] = vertices + patch.edges[side];
    for (int i = 0; i < 9; ++i) {
      for (int j = i + 1; j < 9; ++j) couplings.push_back({nodes[i], nodes[j]});
    }
  }
  const int turns = static_cast<int>(edges.edges.size());
  model.pattern = extend_block_pattern(model.pattern, couplings, turns).pattern;
  model.rest_position.conservativeResizeLike(Eigen::VectorXd::Zero(model.unknowns()));
  model.mass.conservativeResizeLike(Eigen::VectorXd::Zero(model.unknowns()));
  for (const BendingRest& patch : model.bending) {
    model.bending_addresses.push_back(dense_addresses<21>(model.pattern, unknowns_of(patch, vertices)));
  }
}

void add_addresses(BodyModel& model) {
  model.addresses.reserve(model.surface.size());
  for (const Eigen::Vector3i& triangle : model.surface) {
    model.addresses.push_back(triangle_addresses(model.pattern, triangle));
  }
}

void add_sites(BodyModel& model) {
  std::vector<double> areas;
  for (const MembraneRest& rest : model.rest) areas.push_back(rest.area);
  model.sites = contact_sites(model.vertices(), model.definition.mesh.triangles, areas);
}

void add_held_sites(BodyModel& model) {
  for (int s = 0; s < static_cast<int>(model.sites.size()); ++s) {
    const ContactSite& site = model.sites[s];
    const int count = vertex_count_of(site.part);
    bool is_held = true;
    for (int k = 0; k < count; ++k) {
      const int vertex = model.surface[site.triangle][(site.corner + k) % 3];
      is_held = is_held && (model.fixed[3 * vertex] || model.fixed[3 * vertex + 1] || model.fixed[3 * vertex + 2]);
    }
    if (is_held) model.held_sites.push_back(s);
  }
}

void add_openings(BodyModel& model) {
  for (const Opening& opening : model.definition.openings) {
    assert(opening.lips.size() >= 3);
    model.openings.push_back({.lips = opening.lips});
  }
}

void add_surface(BodyModel& model, const CapSurface& caps) {
  model.surface = model.definition.mesh.triangles;
  model.share.assign(model.surface.size(), 1);
  model.surface.insert(model.surface.end(), caps.triangles.begin(), caps.triangles.end());
  model.share.insert(model.share.end(), caps.share.begin(), caps.share.end());
}

void add_fluid(BodyModel& model, const CapSurface& caps) {
  // With a fan over each opening the surface is closed.
  std::vector<Eigen::Vector3d> vertices = model.definition.mesh.vertices;
  std::vector<Eigen::Vector3i> surface = closed_surface(model.definition.mesh);
  std::size_t fan = surface.size();
  for (const OpeningModel& opening : model.openings) {
    const int middle = static_cast<int>(vertices.size()), count = static_cast<int>(opening.lips.size());
    vertices.emplace_back(opening.at(model.rest_position).rowwise().mean());
    for (int k = 0; k < count; ++k) surface.emplace_back(middle, opening.lips[(k + 1) % count], opening.lips[k]);
  }
  Chambers chambers = find_chambers(vertices, surface, model.definition.fluid);
  model.chambers = std::move(chambers.chambers);
  model.open.assign(model.chambers.size(), 0);
  for (OpeningModel& opening : model.openings) {
    opening.chamber = chambers.of_triangle[fan];
    model.open[opening.chamber] = 1;
    fan += opening.lips.size();
  }
  const std::size_t triangles = model.definition.mesh.triangles.size();
  const auto wall_end = chambers.of_triangle.begin() + static_cast<std::ptrdiff_t>(triangles);
  model.chamber.assign(chambers.of_triangle.begin(), wall_end);
  for (const int cap : caps.cap) model.chamber.push_back(chambers.of_triangle[triangles + cap]);
  for (const ChamberModel& chamber : model.chambers) model.rest_volume += chamber.rest_volume;
}

void add_loads(BodyModel& model) {
  std::vector<double> area;
  for (const MembraneRest& rest : model.rest) area.push_back(rest.area);
  for (const LoadDefinition& load : model.definition.loads) {
    model.loads.push_back(make_load_model(load, model.definition.mesh, area, model.definition.thickness));
    add_turns(model.definition.mesh, model.bending, model.loads.back());
  }
}

/// Turns that no triangle's bending depends on: of clamped sides.
void fix_idle_turns(BodyModel& model) {
  std::fill(model.fixed.begin() + 3 * model.vertices(), model.fixed.end(), 1);
  for (const BendingRest& patch : model.bending) {
    for (int side = 0; side < 3; ++side) {
      if (patch.sides[side].turn_share != 0) model.fixed[3 * model.vertices() + patch.edges[side]] = 0;
    }
  }
}

void fix(BodyModel& model) {
  const int unknowns = model.unknowns();
  model.fixed.assign(unknowns, 0);
  fix_idle_turns(model);
  const std::vector<std::array<bool, 3>> held = held_axes(model.definition.mesh, model.definition.fixed);
  for (int vertex = 0; vertex < model.vertices(); ++vertex) {
    for (int axis = 0; axis < 3; ++axis) model.fixed[3 * vertex + axis] = held[vertex][axis] ? 1 : 0;
  }
  model.diagonal_entries.reserve(unknowns);
  for (int column = 0; column < unknowns; ++column) {
    const int begin = model.pattern.column_begin[column];
    model.diagonal_entries.push_back(begin);
    for (int k = begin + 1; k < model.pattern.column_begin[column + 1]; ++k) {
      if (model.fixed[column] || model.fixed[model.pattern.row[k]]) model.fixed_entries.push_back(k);
    }
  }
}

}  // namespace

Eigen::Matrix3Xd OpeningModel::at(const Eigen::VectorXd& position) const {
  Eigen::Matrix3Xd points(3, lips.size());
  for (std::size_t k = 0; k < lips.size(); ++k)
    points.col(static_cast<Eigen::Index>(k)) = position.segment<3>(3 * lips[k]);
  return points;
}

BodyModel make_body_model(BodyDefinition definition, double slack_stiffness) {
  BodyModel model;
  model.slack_stiffness = slack_stiffness;
  model.definition = std::move(definition);
  const SurfaceMesh& mesh = model.definition.mesh;
  const int vertices = static_cast<int>(mesh.vertices.size());
  model.rest_position.resize(3 * vertices);
  for (int v = 0; v < vertices; ++v) model.rest_position.segment<3>(3 * v) = mesh.vertices[v];
  const CapSurface caps = spread_caps(mesh, model.definition.fixed);
  add_surface(model, caps);
  // Each of two writes what the other does not read.
  tbb::parallel_invoke([&] { add_wall(model); },
                       [&] {
                         model.pattern = make_block_pattern(vertices, model.surface);
                         add_openings(model);
                         if (model.has_fluid()) add_fluid(model, caps);
                       });
  if (model.definition.model == WallModel::kShell) add_bending(model);
  tbb::parallel_invoke([&] { add_addresses(model); },
                       [&] {
                         add_sites(model);
                         add_loads(model);
                         fix(model);
                         add_held_sites(model);
                         hold_rigid_motions(model, model.rest_position);
                       });
  return model;
}

}  // namespace thinwall
