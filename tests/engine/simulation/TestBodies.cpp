#include "tests/engine/simulation/TestBodies.hpp"

#include <cmath>
#include <utility>

#include "engine/fluid/EnclosedVolume.hpp"
#include "engine/fluid/FluidWeight.hpp"
#include "engine/mesh/Shapes.hpp"

namespace thinwall {

Material neo_hookean(double shear_modulus) {
  return {find_wall_law("neo_hookean"), {shear_modulus}};
}

Material mooney_rivlin(double c1, double c2) {
  return {find_wall_law("mooney_rivlin"), {c1, c2}};
}

Material st_venant_kirchhoff(double youngs_modulus, double poisson_ratio) {
  return {find_wall_law("st_venant_kirchhoff"), {youngs_modulus, poisson_ratio}};
}

BodyDefinition make_body(SurfaceMesh mesh, double thickness, Material material) {
  BodyDefinition body;
  body.name = "body";
  body.thickness.assign(mesh.triangles.size(), thickness);
  body.mesh = std::move(mesh);
  body.materials = {std::move(material)};
  return body;
}

FixedRegion fixed_group(const char* group, std::array<bool, 3> axes) {
  return {.region = GroupRegion{group}, .axes = axes};
}

BodyDefinition pressurised_hemisphere(int triangles, double pressure) {
  BodyDefinition body = make_body(make_hemisphere(20e-3, triangles), 1e-3, neo_hookean(20e3));
  body.fluid.initial_pressure = pressure;
  body.fixed = {fixed_group("base")};
  return body;
}

BodyDefinition fingerpad(double length, int triangles) {
  BodyDefinition body = make_body(make_semicylinder(10e-3, length, triangles), 1e-3, neo_hookean(20e3));
  body.fixed = {fixed_group("base"), fixed_group("ends", {false, true, false})};
  return body;
}

BodyDefinition two_balls() {
  SurfaceMesh mesh = make_sphere(20e-3, 320);
  const SurfaceMesh other = make_sphere(25e-3, 320);
  const int count = static_cast<int>(mesh.vertices.size());
  for (const Eigen::Vector3d& vertex : other.vertices) {
    mesh.vertices.push_back(vertex + Eigen::Vector3d(kBallsApart, 0, 0));
  }
  for (const Eigen::Vector3i& triangle : other.triangles) mesh.triangles.push_back(triangle.array() + count);
  BodyDefinition definition = make_body(mesh, 1e-3, mooney_rivlin(8e3, 2e3));
  definition.fixed = {{.region = BelowRegion{.axis = 2, .at = -18e-3}}};
  definition.fluid.chambers = {
      {.name = "large", .inside = {kBallsApart, 0, 0}, .initial_pressure = 600},
      {.name = "small", .inside = {0, 0, 0}, .initial_pressure = 200},
  };
  return definition;
}

ToolDefinition point_tool() {
  return {.name = "tip", .kind = ToolKind::kPoint, .length = 0, .radius = 0};
}
ToolDefinition line_tool(double length) {
  return {.name = "edge", .kind = ToolKind::kLine, .length = length, .radius = 0};
}
ToolDefinition sphere_tool(double radius) {
  return {.name = "ball", .kind = ToolKind::kSphere, .length = 0, .radius = radius};
}

SimulationOptions quasi_static() {
  SimulationOptions options;
  options.analysis = Analysis::kQuasiStatic;
  return options;
}

SimulationOptions dynamic() {
  SimulationOptions options;
  options.analysis = Analysis::kDynamic;
  return options;
}

ToolPose pose_at(const Eigen::Vector3d& tip, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d side = std::abs(direction.y()) < 0.9 ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitX();
  return {.tip = tip, .direction = direction, .axis = (side - direction * direction.dot(side)).normalized()};
}

ToolPose move(Body& body, const ToolPose& begin, const Eigen::Vector3d& end, int steps, double duration,
              const std::function<void(const ToolPose&)>& after) {
  std::array<ToolPose, 1> from = {begin}, to = {begin};
  for (int step = 1; step <= steps; ++step) {
    to[0].tip = begin.tip + (end - begin.tip) * (static_cast<double>(step) / steps);
    body.advance(from, to, duration);
    from = to;
    if (after) after(to[0]);
  }
  return to[0];
}

BodyInput filling(const Body& body, double volume) {
  return {.load_factors = {}, .fluids = {{.added = volume - body.state().fluid_volume[0], .pressure = {}}}};
}

Eigen::VectorXd internal_forces(const Body& body) {
  const BodyModel& model = body.model();
  const Eigen::VectorXd& position = body.state().equilibrium.position;
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(position.size());
  for (std::size_t t = 0; t < model.surface.size(); ++t) {
    const auto corners = corners_of(model.surface[t], position);
    Eigen::Matrix<double, 9, 1> part = Eigen::Matrix<double, 9, 1>::Zero();
    if (model.has_fluid()) {
      const int chamber = model.chamber[t];
      part -= body.state().equilibrium.pressure[chamber] * volume_gradient_of(corners);
      const double density = model.definition.fluid.density / body.state().fluid_volume[chamber];
      part += fluid_moment_of(relative_to(model.chambers[chamber].level, corners),
                              density * body.state().fluid_motion[chamber].acceleration)
                  .gradient;
      part *= model.share[t];
    }
    if (t < model.rest.size())
      part += membrane_terms(model.rest[t], model.material(static_cast<int>(t)), corners).gradient;
    for (int k = 0; k < 3; ++k) forces.segment<3>(3 * model.surface[t][k]) += part.segment<3>(3 * k);
  }
  return forces;
}

Eigen::Vector3d support_force(const Body& body) {
  const BodyModel& model = body.model();
  Eigen::VectorXd forces = internal_forces(body);
  for (const Attachment& attachment : body.state().attachments) {
    for (int k = 0; k < 3; ++k)
      forces.segment<3>(3 * attachment.vertices[k]) += attachment.weights[k] * attachment.force;
  }
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (Eigen::Index k = 0; k < forces.size(); ++k) {
    if (model.fixed[k]) sum[k % 3] += forces[k];
  }
  return sum;
}

double largest_single_force(const Body& body) {
  const BodyModel& model = body.model();
  double largest = 0;
  for (std::size_t t = 0; t < model.rest.size(); ++t) {
    const auto corners = corners_of(model.surface[t], body.state().equilibrium.position);
    const auto terms = membrane_terms(model.rest[t], model.material(static_cast<int>(t)), corners);
    largest = std::max(largest, terms.gradient.cwiseAbs().maxCoeff());
  }
  return largest;
}

Eigen::Vector3d momentum(const Body& body) {
  Eigen::Vector3d sum = mass_sum(body.model(), body.state().velocity);
  for (const FluidMotion& fluid : body.state().fluid_motion)
    sum += body.model().definition.fluid.density * fluid.velocity;
  return sum;
}

Eigen::Vector3d momentum_rate(const Body& body) {
  Eigen::Vector3d sum = mass_sum(body.model(), body.state().acceleration);
  for (std::size_t c = 0; c < body.state().fluid_motion.size(); ++c) {
    const double density =
        body.model().definition.fluid.density * body.state().volume[c] / body.state().fluid_volume[c];
    sum += density * body.state().fluid_motion[c].acceleration;
  }
  return sum;
}

Eigen::Vector3d mass_sum(const BodyModel& model, const Eigen::VectorXd& vectors) {
  const Eigen::VectorXd weighted = model.mass.cwiseProduct(vectors);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int v = 0; v < model.vertices(); ++v) sum += weighted.segment<3>(3 * v);
  return sum;
}

}  // namespace thinwall
