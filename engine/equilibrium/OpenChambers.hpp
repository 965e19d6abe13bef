#pragma once

#include <Eigen/Core>

#include "engine/equilibrium/Equilibrium.hpp"
#include "engine/fluid/PressureLoad.hpp"

namespace thinwall {

// Chambers whose wall has openings. A cap over the lips closes the volume.
//
// What cannot leave, a gel, holds together and to the lips: they bear what the pressure does to the cap, so that the
// load is the gradient of the volume as in a closed chamber, the wall pushes itself nowhere, and no energy is lost at
// the lips. The cap's derivative, which couples all lips of an opening, is brought in like the skew-symmetric part
// below.
//
// Of a fluid that leaves the pressure bears on the wall alone: the load is not pressure times the gradient of the
// volume, and no gradient of anything. With the load g of a unit of pressure, the constraint V(x) + outflow = fluid
// volume and the stiffness K, Newton's step is
//
//     | K - p dg/dx     -g            | | dx |   | -forces                  |
//     | dV/dx + ...     compliance    | | dp | = | fluid volume - V - ...   |
//
// and unsymmetric twice over: the border's column and row differ, which the Schur complement takes as it is; and dg/dx
// has a skew-symmetric part, which lives on the edges of the rim alone: small beside the stiffness of a stretched wall
// (pressure times edge over Young's modulus times thickness), not beside that of slack lips. The sparse matrix keeps
// the symmetric part, and the other is brought in by minimal residuals within the step (see Newton::find_step), so that
// steps are Newton's. Whether a step is convex is asked of the symmetric matrix that has the gradient of the volume as
// column and row. The merit function of the line search takes what the cap does not bear as dead loads, frozen where
// the search starts; and the outflow as more compliance of the fluid and, pressure times its growth as the lips move,
// as further dead loads: without them steps would seem to lead up.

/// Adds the caps over the lips to the volumes and moments in `terms`, and what the weight and the inertia of the
/// contents do to open walls to the gradient and, with the given pressure, (chambers), to the Hessian.
void add_open_chambers(const BodyModel& model, const EquilibriumProblem& problem, const Eigen::VectorXd& position,
                       const Eigen::VectorXd& pressure, EquilibriumTerms& terms);

/// The unknowns of the vertices at the lips of chambers' openings, ascending, each once.
std::vector<int> rim_unknowns(const BodyModel& model);

/// What the load's derivative gives for a motion but for the part that the sparse matrix keeps, both (unknowns): newton
/// and metres.
Eigen::VectorXd rim_forces(const BodyModel& model, const EquilibriumProblem& problem, const EquilibriumTerms& terms,
                           const Eigen::VectorXd& position, const Eigen::VectorXd& pressure,
                           const Eigen::VectorXd& motion);

/// Pressure at the middle of an opening under the weight of the contents, pascal. `pressure`: (chambers).
double lip_pressure(const BodyModel& model, const EquilibriumProblem& problem, const EquilibriumTerms& terms,
                    int opening, const Eigen::VectorXd& pressure);

/// Flow out through an opening of that area, metres^2, under a pressure there, pascal; backwards where that is
/// negative, which no solution is. Below a free surface lips are dry then, and the higher it stands above them the more
/// does the speed count at which the fluid comes to them.
Flow outflow(const BodyModel& model, const EquilibriumProblem& problem, int opening, double area, double lip_pressure);

/// The equation of an open chamber beside that of a closed one: the flow out, or the condition of a chamber with air in
/// it. Volume in metres^3, and its derivatives by the chamber's pressure and the position.
struct OpeningEquation {
  double value = 0;             // metres^3
  double by_pressure = 0;       // metres^3 / pascal
  Eigen::VectorXd by_position;  // (unknowns), metres^2; none where only the value is asked for
};
OpeningEquation opening_equation(const BodyModel& model, const EquilibriumProblem& problem,
                                 const EquilibriumTerms& terms, int chamber, const Eigen::VectorXd& position,
                                 const Eigen::VectorXd& pressure, bool with_derivatives);

}  // namespace thinwall
