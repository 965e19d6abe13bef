#include "studio/director/SnapshotMaker.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "renderer/snapshot/CutTimes.hpp"
#include "renderer/snapshot/SurfaceFields.hpp"

namespace thinwall {
namespace {

Float3 to_float3(const Eigen::Vector3d& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

Double3 to_double3(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

std::vector<Triangle> to_triangles(const std::vector<Eigen::Vector3i>& triangles) {
  std::vector<Triangle> result;
  for (const Eigen::Vector3i& t : triangles) {
    result.push_back(
        {static_cast<std::uint32_t>(t[0]), static_cast<std::uint32_t>(t[1]), static_cast<std::uint32_t>(t[2])});
  }
  return result;
}

// The engine's kinds of tools are those of pictures, in the same order.
static_assert(std::ranges::equal(kToolKindNames, kSnapshotToolKindNames));

/// Digits of stresses that are kept: 13 bits, one part in 16 384, so that takes stay small.
constexpr int kStressBits = 13;

float shortened(double value) {
  int exponent = 0;
  const double mantissa = std::frexp(value, &exponent);
  return static_cast<float>(std::ldexp(std::round(std::ldexp(mantissa, kStressBits)), exponent - kStressBits));
}

SnapshotField stress_field(std::string_view name, const Eigen::RowVectorXd& stress) {
  SnapshotField field{.name = std::string(name), .unit = "Pa", .location = FieldLocation::kTriangle, .values = {}};
  for (const double value : stress) field.values.push_back(shortened(value));
  return field;
}

/// Products of the edges of the shape without stress.
Float3 rest_metric(const MembraneRest& rest) {
  const Eigen::Matrix2d edges = rest.inverse_edges.inverse();
  const Eigen::Matrix2d products = edges.transpose() * edges;
  return to_float3({products(0, 0), products(1, 1), products(0, 1)});
}

/// Pascal, at the chamber's level; below zero only where fluid is under suction, not where air has taken its place.
double pressure_of(const BodyState& state, Eigen::Index chamber) {
  const double pressure = state.equilibrium.pressure[chamber];
  return state.air[chamber] > 0 ? std::max(0.0, pressure) : pressure;
}

/// Of the first chamber; zero without fluid.
double first_pressure(const BodyState& state) {
  return state.equilibrium.pressure.size() == 0 ? 0 : pressure_of(state, 0);
}

std::shared_ptr<SnapshotTopology> topology_of(const BodyModel& model) {
  auto topology = std::make_shared<SnapshotTopology>();
  const BodyDefinition& definition = model.definition;
  for (const Eigen::Vector3d& vertex : definition.mesh.vertices) topology->rest_positions.push_back(to_float3(vertex));
  topology->triangles = to_triangles(definition.mesh.triangles);
  topology->cap_triangles = to_triangles(definition.mesh.cap_triangles);
  for (const double thickness : definition.thickness) topology->thickness.push_back(static_cast<float>(thickness));
  for (const MembraneRest& rest : model.rest) topology->rest_metric.push_back(rest_metric(rest));
  topology->is_scenery = is_scenery(definition.fixed);
  return topology;
}

}  // namespace

std::shared_ptr<const SnapshotTopology> snapshot_topology(const BodyModel& model) {
  return topology_of(model);
}

std::shared_ptr<const SnapshotTopology> snapshot_topology_after_cut(const BodyModel& model,
                                                                    const SnapshotTopology& before, double time) {
  std::shared_ptr<SnapshotTopology> topology = topology_of(model);
  topology->cut_times = cut_times(*topology, before, time);
  return topology;
}

SnapshotSurface snapshot_surface(const Body& body, std::shared_ptr<const SnapshotTopology> topology) {
  const Eigen::VectorXd& position = body.state().equilibrium.position;
  SnapshotSurface surface{
      .body = body.model().definition.name, .topology = std::move(topology), .positions = {}, .fields = {}};
  for (int v = 0; v < body.model().vertices(); ++v) {
    surface.positions.push_back(to_float3(position.segment<3>(3 * v)));
  }
  SnapshotField field{
      .name = std::string(kContactPressureField), .unit = "Pa", .location = FieldLocation::kVertex, .values = {}};
  for (const double pressure : body.contact_pressure()) field.values.push_back(static_cast<float>(pressure));
  surface.fields.push_back(std::move(field));
  const Eigen::Matrix2Xd stress = body.principal_stress();
  surface.fields.push_back(stress_field(kLargestStressField, stress.row(0)));
  surface.fields.push_back(stress_field(kSmallestStressField, stress.row(1)));
  return surface;
}

SnapshotTool snapshot_tool(const ToolDefinition& tool, const ToolPose& pose, const ToolRecord& record) {
  return {.name = tool.name,
          .kind = static_cast<SnapshotToolKind>(tool.kind),
          .radius = tool.radius,
          .length = tool.length,
          .width = tool.width,
          .thickness = tool.thickness,
          .opening = pose.opening,
          .tip = to_double3(pose.tip),
          .direction = to_double3(pose.direction),
          .axis = to_double3(pose.axis),
          .phase = record.phase,
          .depth = record.depth,
          .force = to_double3(record.force)};
}

void add_scalars(const Body& body, std::vector<SnapshotScalar>& scalars) {
  const std::string& name = body.model().definition.name;
  scalars.push_back({.name = name + std::string(kPressureScalar), .unit = "Pa", .value = first_pressure(body.state())});
  for (std::size_t c = 0; c < body.model().chambers.size(); ++c) {
    const std::string& chamber = body.model().chambers[c].name;
    if (chamber.empty()) continue;
    scalars.push_back({.name = name + "." + chamber + ".pressure",
                       .unit = "Pa",
                       .value = pressure_of(body.state(), static_cast<Eigen::Index>(c))});
  }
  const auto add_volume = [&](std::string_view kind, double volume) {
    scalars.push_back({.name = name + std::string(kind), .unit = "m^3", .value = volume});
  };
  add_volume(kVolumeScalar, body.state().volume.sum());
  add_volume(kFluidVolumeScalar, body.state().fluid_volume.sum());
  add_volume(kLeakedScalar, body.state().leaked.sum());
}

ToolRecord tool_record(const std::string& name, const DirectedTool& tool,
                       std::span<const std::unique_ptr<Body>> bodies) {
  ToolRecord record{.tool = name, .phase = tool.phase, .position = tool.pose.tip, .depth = tool.depth};
  bool touching = false;
  for (const auto& body : bodies) {
    const ToolContact& contact = body->state().contacts[tool.index];
    record.force += contact.force;
    record.contact_area += contact.area;
    touching = touching || contact.touching;
  }
  if (touching && record.phase == "idle") record.phase = "hold";
  if (touching && record.phase == "approach") record.phase = "contact";
  return record;
}

BodyRecord body_record(const Body& body) {
  const BodyState& state = body.state();
  BodyRecord record;
  record.body = body.model().definition.name;
  record.volume = state.volume.sum();
  record.fluid_volume = state.fluid_volume.sum();
  record.leaked = state.leaked.sum();
  record.cut_length = state.cut.length;
  record.open_area = state.open_area.sum();
  record.pressure = first_pressure(state);
  record.elastic = state.books.elastic;
  record.bending = state.books.bending;
  record.kinetic = state.books.kinetic;
  record.fluid = state.books.fluid;
  record.gravity = state.books.gravity;
  record.contact = state.books.contact;
  record.viscous = state.books.viscous;
  record.friction = state.books.friction;
  record.leak = state.books.leak;
  record.fracture = state.books.fracture;
  record.jump = state.books.jump;
  record.numerical = state.books.numerical;
  record.tool_work = state.books.tool_work;
  record.script_work = state.books.script_work;
  record.newton_iterations = body.report().newton_iterations;
  record.residual = body.report().residual;
  return record;
}

std::vector<ChamberRecord> chamber_records(const Body& body) {
  const BodyState& state = body.state();
  std::vector<ChamberRecord> records;
  for (std::size_t k = 0; k < body.model().chambers.size(); ++k) {
    const std::string& name = body.model().chambers[k].name;
    if (name.empty()) continue;
    const auto c = static_cast<Eigen::Index>(k);
    records.push_back({.body = body.model().definition.name,
                       .chamber = name,
                       .volume = state.volume[c],
                       .fluid_volume = state.fluid_volume[c],
                       .leaked = state.leaked[c],
                       .pressure = pressure_of(state, c)});
  }
  return records;
}

}  // namespace thinwall
