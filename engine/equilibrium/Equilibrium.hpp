#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "engine/contact/ContactPotential.hpp"
#include "engine/contact/SelfContact.hpp"
#include "engine/contact/SolidGap.hpp"
#include "engine/equilibrium/BodyModel.hpp"
#include "engine/equilibrium/FrictionContact.hpp"
#include "engine/equilibrium/PinchedWall.hpp"
#include "engine/equilibrium/ShaftContact.hpp"
#include "engine/fluid/LipCap.hpp"
#include "engine/fluid/OrificeFlow.hpp"

namespace thinwall {

/// A material point whose three displacement components a tool prescribes, as far as the body does not hold them fixed.
struct Attachment {
  int tool = 0;  // index
  Eigen::Vector3i vertices = Eigen::Vector3i::Zero();
  Eigen::Vector3d weights = Eigen::Vector3d::Zero();     // barycentric, of the vertices
  Eigen::Vector2d offset = Eigen::Vector2d::Zero();      // metres from the tip, across (x') and along (y') the tool
  Eigen::Vector3d target = Eigen::Vector3d::Zero();      // metres
  Eigen::Vector3d prescribed = Eigen::Vector3d::Ones();  // 1 or 0 for each axis: 0 where all the vertices are fixed
  Eigen::Vector3d touched = Eigen::Vector3d::Zero();     // metres, where the point was as the tool took hold of it
  Eigen::Vector3d followed = Eigen::Vector3d::Ones();    // for each axis, part of the tool's motion since then
  Eigen::Vector3d force = Eigen::Vector3d::Zero();       // newton, multiplier: what the tissue does to the tool
};

Eigen::Vector3d material_point(const Attachment& attachment, const Eigen::VectorXd& position);

/// A solid of a tool and what it presses on.
struct SolidContact {
  /// Pressure under which the gap closes, over the hugging pressure: the wall then rests near the range.
  static constexpr double kStiffness = 50;
  /// Of an edge that dips into a solid as far as the face beside it may, the part that it may itself: what the chord
  /// and the plane through points of a ball have.
  static constexpr double kEdgeDip = 0.75;
  /// The same of an edge that dips into a hull, past the rims that ought to have held it back.
  static constexpr double kPassedEdgeDip = 2;

  int tool = 0;  // index
  ToolSolid solid;
  double range = 0;                       // metres, gap at which vertices begin to be pushed
  double dip = 0;                         // metres inside the solid at which faces begin to be pushed
  double hugging_pressure = 0;            // pascal, under which a wall of unit strain lies on the solid
  bool in_wall = false;                   // a blade that cuts: keeps nothing out
  bool catches_edges = false;             // a hull: keeps out edges too, since one came past its rims
  std::vector<PinchedSite> pinched = {};  // between a jaw and the other, in the order of the sites
  double inner_side = 0;                  // of a jaw, see inner_side()
  std::vector<double> forces;             // (sites), newton, between the solid and each site: multipliers

  /// Where the wall lies on a solid that is flatter than its triangles, the vertices bear the load and stand for a wall
  /// that is curved between them; edges are held back where an edge of the tool crosses them, faces where a tip or a
  /// ball smaller than the triangles would pass through. So no site has to choose between equally deep points.
  ContactPotential potential(const ContactSite& site) const {
    const double stiffness = kStiffness * hugging_pressure * site.area / range;
    if (site.part == SitePart::kCorner) return {.onset = range, .stiffness = stiffness};
    const bool passed = site.part == SitePart::kEdge && solid.role == ToolSolid::Role::kHull;
    const double part = site.part == SitePart::kFace ? 1 : passed ? kPassedEdgeDip : kEdgeDip;
    return {.onset = -part * dip, .stiffness = stiffness};
  }

  const PinchedSite* find_pinched(int site) const {
    const auto found = std::ranges::lower_bound(pinched, site, {}, &PinchedSite::site);
    return found == pinched.end() || found->site != site ? nullptr : &*found;
  }

  /// That of site `index`, of a pinched one the wall's own.
  ContactPotential potential(int index, const ContactSite& site) const {
    ContactPotential own = potential(site);
    if (const PinchedSite* found = find_pinched(index)) {
      own.onset = std::max(own.onset, found->potential.onset);
      own.stiffness = std::min(own.stiffness, found->potential.stiffness);
    }
    return own;
  }

  /// As `solid_gap`, of site `index`, from where the solid is now or was before: `at`.
  std::optional<SolidGap> gap(int index, const ContactSite& site, const ToolSolid& at, double reach,
                              const std::array<Eigen::Vector3d, 3>& corners, GapTerms wanted) const {
    if (find_pinched(index)) return gap_from_inner_side(at, inner_side, corners, site.corner);
    return solid_gap(at, reach, corners, site.part, site.corner, wanted);
  }

  /// Gap from which on nothing is pushed, metres.
  double reach() const {
    double reach = range;
    for (const PinchedSite& site : pinched) reach = std::max(reach, site.potential.onset);
    return reach;
  }

  bool meets(SitePart part) const {
    if (in_wall) return false;
    return part == SitePart::kCorner ? solid.meets_vertices()
           : part == SitePart::kEdge ? solid.meets_edges() || catches_edges
                                     : solid.meets_faces();
  }
};

enum class FluidMode {
  kGivenPressure,   // the pressure is a load
  kIncompressible,  // the pressure is the multiplier of volume = fluid volume
  kCompressible     // pressure = reference + bulk modulus (fluid volume - volume) / fluid volume
};

/// What a compressible fluid is under that has air above it, pascal, where the pressure at its chamber's level is
/// `at_level`: that, or nothing where the surface lies below. So it fills as much when air has just come in as just
/// before, and never more than without pressure.
inline double bulk_pressure_beside_air(double at_level) {
  return std::max(0.0, at_level);
}

/// The fluid of a chamber.
struct FluidProblem {
  FluidMode mode = FluidMode::kIncompressible;
  double pressure = 0;         // pascal: the given one, or the reference one of a compressible fluid
  double fluid_volume = 0;     // metres^3
  double bulk_modulus = 0;     // pascal
  double outflow_time = 0;     // seconds for which fluid leaves through openings under the pressure that is sought
  int vent = -1;               // opening at which there may be air, so that the pressure there is zero; or -1
  bool presses_out = false;    // what the wall has no room for leaves at the vent at once, as where it snaps
  bool is_empty = false;       // all of it leaves: there is none, and no pressure, whatever wall and caps enclose
  bool has_surface = false;    // under gravity: there is air above the fluid, which pulls at nothing
  double vent_compliance = 0;  // metres^3 / pascal, gives that condition the unit of a volume

  /// Whether the pressure is an unknown.
  bool is_multiplier() const { return mode != FluidMode::kGivenPressure; }
  /// Whether it is found from the volume.
  bool seeks_volume() const { return is_multiplier() && vent < 0; }
  /// What a compressible fluid is under, pascal, where the chamber's pressure is `at`.
  double bulk_pressure(double at) const { return has_surface ? bulk_pressure_beside_air(at) : at; }
  /// Space that a volume of fluid fills at a pressure, pascal, over that at its reference pressure.
  double held(double at) const { return 1 - (bulk_pressure(at) - pressure) * yielding(); }
  /// Space that it fills at a pressure, pascal, metres^3.
  double space(double at) const { return fluid_volume * held(at); }
  /// Volume by which a compressible fluid gives way to a pascal more, metres^3; zero for others.
  double compliance(double at) const { return bulk_pressure(at) == at ? fluid_volume * yielding() : 0; }
  /// 1 / pascal: part of its volume by which a compressible fluid gives way to a pascal.
  double yielding() const { return mode == FluidMode::kCompressible ? 1 / bulk_modulus : 0; }
};

/// Inertia of the fluid in a chamber, which moves as a whole: its momentum is density times the rate of its first
/// moment M = integral of x over the volume, whatever its flow, and its kinetic energy at least density / (2 volume)
/// times the square of that rate (Kelvin: the even flow has the least). Enters as a spring from M to where it would go
/// freely.
struct FluidInertia {
  double factor = 0;                                 // kg / metre^6 / second^2: density / volume times a rate squared
  Eigen::Vector3d target = Eigen::Vector3d::Zero();  // metres^4
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  // metres, of the moment: the level, or the lips of an open chamber
};

/// What a viscous wall remembers, see MembraneMemory.
struct WallMemory {
  double scale = 1;
  double damping = 0;
  std::vector<Eigen::Vector3d> overstress;  // (triangles), pascal, or none
  std::vector<Eigen::Vector3d> overmoment;  // (triangles) of a shell, newton, or none

  MembraneMemory of(int triangle) const {
    return {.scale = scale,
            .overstress = overstress.empty() ? Eigen::Vector3d::Zero().eval() : overstress[triangle],
            .damping = damping};
  }
  BendingMemory of_bending(int triangle) const {
    // The law of bending is linear: damping by the stiffness of the unstrained wall is more of it.
    return {.scale = scale + damping,
            .overmoment = overmoment.empty() ? Eigen::Vector3d::Zero().eval() : overmoment[triangle]};
  }
};

/// What a slack wall is held by in statics, see LeastMotion.hpp.
struct LeastMotion {
  double part = 0;       // of the wall's stiffness; none: 0
  Eigen::VectorXd from;  // (unknowns), metres
};

/// What a body must be in equilibrium with. Inertia enters as springs from each vertex to where it would go freely.
struct EquilibriumProblem {
  std::vector<FluidProblem> fluids;         // (chambers)
  std::vector<FluidInertia> fluid_inertia;  // (chambers), or none
  double orifice_time = 0;                  // seconds for which fluid flows under the pressures that are sought
  WallMemory memory;
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();  // metres / second^2
  std::vector<double> load_factors;                   // (loads); 1 where it is shorter
  Eigen::VectorXd cut_force;                          // (unknowns) or none, newton, dead, at the lips of a cut
  Eigen::VectorXd start;                              // (unknowns), metres: from where rotations under moments count
  double inertia = 0;               // 1 / second^2, factor of mass (position - inertia_target); zero for statics
  Eigen::VectorXd inertia_target;   // (unknowns), metres
  LeastMotion least_motion;         // without inertia only, which holds a slack wall as well
  bool hold_rigid_motions = false;  // keep the mass-weighted mean position and rotation of a free body
  std::vector<Attachment> attachments;
  std::vector<SolidContact> solids;
  std::vector<FrictionContact> friction;  // where tools with friction press; fixed during a solution
  std::vector<ShaftContact> shafts;       // needles that are in the wall
  std::vector<std::vector<char>> free;    // (tools x triangles) or none: whether a needle's shaft lets the wall be
  std::vector<std::vector<char>> passed;  // (tools x sites) or none: whether a needle goes through it unfelt
  std::vector<double> approach;           // (openings) or none, metres / second, at which fluid comes to the lips
  std::vector<char> sealed;               // (openings) or none: whether a needle keeps it shut

  bool seeks_least_motion() const { return least_motion.part > 0 && inertia == 0; }
  bool is_free(int tool, int triangle) const { return !free.empty() && !free[tool].empty() && free[tool][triangle]; }
  bool passes(int tool, int site) const { return !passed.empty() && !passed[tool].empty() && passed[tool][site]; }
  double approach_to(int opening) const { return approach.empty() ? 0 : approach[opening]; }
  bool is_sealed(int opening) const { return !sealed.empty() && sealed[opening]; }
};

/// What the tissue does to a tool, or to one of its solids.
struct ToolContact {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   // newton
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  // newton metre, about the centre of the solid; of solids only
  double area = 0;                                   // metres^2
  bool touching = false;
};

/// A site of the wall in contact with a solid, or near it.
struct ContactPoint {
  int solid = 0;     // index into the problem's solids
  int site = 0;      // index into the model's sites
  int triangle = 0;  // index, of the site
  ContactPotential potential;
  SolidGap gap;
};

/// Energies and derivatives at a position.
struct EquilibriumTerms {
  double elastic = 0;          // joule, potential of the wall, memory included
  double strain_energy = 0;    // joule, of the wall's law alone
  double bending = 0;          // joule, potential of a shell's bending, memory included
  double bending_energy = 0;   // joule, of its stiffness alone
  double gravity = 0;          // joule, of the wall from the origin's level, of the fluid from the chambers'
  double load_work = 0;        // joule, that the loads give up from position zero
  double contact = 0;          // joule
  double friction = 0;         // joule, potential of the friction of tools, and of walls on the shafts of needles
  double inertial = 0;         // joule, of the inertia springs
  Eigen::VectorXd volume;      // (chambers), metres^3
  Eigen::VectorXd gradient;    // (unknowns), newton: of wall, folds, gravity and inertia of the fluid, less the loads
  Eigen::VectorXd load_force;  // (unknowns), newton
  Eigen::Matrix3Xd moment;     // (3 x chambers), metres^4, integral of x, where the fluid has inertia
  Eigen::MatrixXd moment_gradient;     // (unknowns x 3 chambers), metres^3
  Eigen::VectorXd filled;              // (chambers), metres^3, below the free surface; else the volume
  Eigen::VectorXd filled_by_pressure;  // (chambers), metres^3 / pascal
  Eigen::MatrixXd volume_gradient;     // (unknowns x chambers), metres^2, of what is filled
  std::vector<LipCap> lips;            // (openings), of chambers
  Eigen::MatrixXd pressure_load;       // (unknowns x chambers), metres^2, of bodies with open chambers
  Eigen::MatrixXd moment_load;         // (unknowns x 3 chambers), metres^3, likewise
  Eigen::VectorXd lip_force;           // (unknowns), newton, what the pressure would do to the caps over openings
  std::vector<double> values;  // (non-zeros) or none, newton / metre: Hessian of all that less pressure times volume
  double largest_force = 0;    // newton, of a single term: the scale of the residual
  std::vector<ContactPoint> contacts;  // sites near a solid, or with a force on them
  SelfContactTerms folds;              // the wall against itself and its floors: Newton adds them to the gradient

  bool has_hessian() const { return !values.empty(); }

  /// Load of a pascal in each chamber: the gradient of the volume where the chamber is closed.
  const Eigen::MatrixXd& load_of_pressure() const { return lips.empty() ? volume_gradient : pressure_load; }
};

/// Fills `terms`, reusing its memory; where the wall has collapsed its energy is not finite. `position`: (3 vertices),
/// metres. `pressure`: (chambers), of the Hessian, pascal. Without `with_hessian` that is left out; all else is equal
/// to the bit. `meanwhile`: something else to be done, by another thread where there are many triangles.
void evaluate(const BodyModel& model, const EquilibriumProblem& problem, const Eigen::VectorXd& position,
              const Eigen::VectorXd& pressure, bool with_hessian, EquilibriumTerms& terms,
              const std::function<void()>& meanwhile = {});

/// What the forces of the problem add up to on one of its solids, at contacts found by `evaluate`. The area of a whole
/// body counts what its rims and corners touch; these have none of their own. It grows smoothly while site after site
/// comes to lie on the solid: on a ball it is that of the cap over which an even pressure would spread the directions
/// of the forces as they are; on other solids that of the ellipse, across the mean normal, over which an even pressure
/// would have the forces' second moments, at most the solid's shadow; at least the force over the hugging pressure.
/// `position`: (unknowns), metres.
ToolContact contact_on(const BodyModel& model, const EquilibriumProblem& problem, const EquilibriumTerms& terms,
                       const Eigen::VectorXd& position, int solid);

/// Energy of the contact potentials at contacts found by `evaluate`, joule.
double contact_energy(const EquilibriumTerms& terms);

/// Pressure of each chamber brought to the level of the origin, (chambers), pascal.
Eigen::VectorXd pressures_at_origin(const BodyModel& model, const Eigen::Vector3d& gravity,
                                    const Eigen::VectorXd& pressure);

/// Flow through an orifice under these pressures of the chambers, (chambers), pascal.
Flow flow_between(const BodyModel& model, const OrificeDefinition& orifice, const Eigen::Vector3d& gravity,
                  const Eigen::VectorXd& pressure);

/// Enclosed volume of each chamber, (chambers), metres^3.
Eigen::VectorXd enclosed_volumes(const BodyModel& model, const Eigen::VectorXd& position);

}  // namespace thinwall
