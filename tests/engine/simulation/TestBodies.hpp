#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "engine/simulation/Body.hpp"

namespace thinwall {

Material neo_hookean(double shear_modulus);
Material mooney_rivlin(double c1, double c2);
Material st_venant_kirchhoff(double youngs_modulus, double poisson_ratio);

/// A body of even thickness, with an incompressible fluid at the volume of the mesh, free.
BodyDefinition make_body(SurfaceMesh mesh, double thickness, Material material);

/// Hemisphere of radius 20 mm on its fixed base, neo-Hookean of 20 kPa, 1 mm thick, under `pressure` pascal.
BodyDefinition pressurised_hemisphere(int triangles, double pressure);

/// Semicylinder about the y axis in plane strain: base fixed, ends guided along y. Radius 10 mm, neo-Hookean of 20 kPa,
/// 1 mm thick.
BodyDefinition fingerpad(double length, int triangles);

/// Metres, from the middle of the small one to that of the large one.
inline constexpr double kBallsApart = 60e-3;

/// Two balls of one wall, of 25 mm (chamber 0, `large`, 600 Pa) and 20 mm (chamber 1, `small`, 200 Pa).
BodyDefinition two_balls();

FixedRegion fixed_group(const char* group, std::array<bool, 3> axes = {true, true, true});

ToolDefinition point_tool();
ToolDefinition line_tool(double length);
ToolDefinition sphere_tool(double radius);

SimulationOptions quasi_static();
SimulationOptions dynamic();

/// A tool whose tip is at `tip` and points along `direction`.
ToolPose pose_at(const Eigen::Vector3d& tip, const Eigen::Vector3d& direction = -Eigen::Vector3d::UnitZ());

/// Moves the only tool of a body in a straight line to `end` in equal steps that take `duration` seconds each, and
/// calls `after` after each of them. Gives the pose at the end.
ToolPose move(Body& body, const ToolPose& begin, const Eigen::Vector3d& end, int steps, double duration,
              const std::function<void(const ToolPose&)>& after = {});

/// What a script puts in to bring the fluid of a body of one chamber to a volume, metres^3.
BodyInput filling(const Body& body, double volume);

/// What the wall, the fluid and the tools do to each vertex, recomputed from the positions alone: gradient of the
/// wall's energy less pressure times that of the volume, caps and fixed vertices included. (3 vertices), newton.
Eigen::VectorXd internal_forces(const Body& body);

/// Force of the supports on the body: what must hold the fixed unknowns in place. Newton.
Eigen::Vector3d support_force(const Body& body);

/// Largest force at which two triangles or fluid and wall pull at one unknown: the scale of round-off. Newton.
double largest_single_force(const Body& body);

/// Of wall and fluid, newton second, and what its rate takes, newton.
Eigen::Vector3d momentum(const Body& body);
Eigen::Vector3d momentum_rate(const Body& body);

/// Sum of mass times `vectors` (3 vertices).
Eigen::Vector3d mass_sum(const BodyModel& model, const Eigen::VectorXd& vectors);

}  // namespace thinwall
