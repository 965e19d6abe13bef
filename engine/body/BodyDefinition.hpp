#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/material/WallLaw.hpp"
#include "engine/mesh/Region.hpp"
#include "engine/mesh/SurfaceMesh.hpp"
#include "engine/wall/Prestretch.hpp"

namespace thinwall {

enum class FluidKind { kNone, kIncompressible, kCompressible };

/// A volume of fluid of its own: one closed part of the surface.
struct ChamberDefinition {
  std::string name = {};
  Eigen::Vector3d inside = Eigen::Vector3d::Zero();  // metres, a point in it, of the stress-free shape
  // Pascal above the surroundings, at time zero: the volume follows. Absent: the volume is the mesh's and the pressure
  // follows.
  std::optional<double> initial_pressure = {};
  std::optional<int> wall = {};  // a triangle of its wall, which tells it instead of the point inside
};

/// A hole through which two chambers exchange fluid: flow = discharge area sqrt(2 (p1 - p2) / density).
struct OrificeDefinition {
  int from = 0, to = 0;  // chambers, indices
  double area = 0;       // metres^2
  double discharge = 0.61;
};

/// The fluid that the wall and the caps enclose.
struct FluidDefinition {
  FluidKind kind = FluidKind::kIncompressible;
  std::optional<double> initial_pressure = {};   // pascal, of every chamber that is not named; as in ChamberDefinition
  double density = 1010;                         // kg / metre^3
  double bulk_modulus = 2e6;                     // pascal, compressible only
  std::vector<ChamberDefinition> chambers = {};  // named ones; every other closed part of the surface is one of its own
  bool other_chambers = true;                    // otherwise other parts hold nothing: pieces cut out of the wall
  std::vector<OrificeDefinition> orifices = {};
  bool leaks = true;        // through openings of the wall; otherwise the contents hold together, as a gel does
  double discharge = 0.61;  // of openings of the wall
};

/// An opening of the wall: the lips in the sense of the wall's triangles there. A slit has them in pairs that may lie
/// on each other. What the wall and its caps leave open beside it makes no chamber. Without contents: what cuts left.
struct Opening {
  std::vector<int> lips = {};  // vertices, each once, at least three
};

/// Vertices that keep their stress-free positions along some axes.
struct FixedRegion {
  Region region = {};
  std::array<bool, 3> axes = {true, true, true};  // x, y, z
  bool clamped = false;  // shell: the wall's tangent plane is held as well at open edges within the region
};

/// Whether the whole wall is held, which makes a body scenery: it is only seen and met.
inline bool is_scenery(const std::vector<FixedRegion>& fixed) {
  return std::ranges::any_of(fixed, [](const FixedRegion& part) {
    return std::holds_alternative<WholeRegion>(part.region) && part.axes == std::array{true, true, true};
  });
}

enum class WallModel { kMembrane, kShell };

/// A term of the Prony series of quasi-linear viscoelasticity: the reduced relaxation function is
/// 1 - sum of fraction (1 - exp(-t / time)).
struct PronyTerm {
  double fraction = 0;  // of the stress at once
  double time = 1;      // seconds
};

/// Rayleigh damping: mass times `mass_rate` plus the stiffness of the unstrained wall times `stiffness_time`.
struct RayleighDamping {
  double mass_rate = 0;       // 1 / second
  double stiffness_time = 0;  // seconds
};

enum class LoadKind {
  kFollowerPressure,  // pascal, follows the wall, along its outer normal (a positive one inflates)
  kDeadTraction,      // pascal, dead, per rest area
  kDeadForce,         // newton, dead, in all, spread evenly over the region
  kDeadLineForce,     // newton / metre, dead, along the edges in the region (open edges only where it has any)
  kDeadMoment,        // newton metre, in all, on the edges in the region; turns the wall beside them about a fixed axis
  kDeadBodyForce      // newton / metre^3 of rest volume of the wall, dead
};

struct LoadDefinition {
  LoadKind kind = LoadKind::kDeadForce;
  Region region = {};
  double pressure = 0;                               // pascal, kFollowerPressure only
  Eigen::Vector3d vector = Eigen::Vector3d::Zero();  // all others
};

/// Everything about a body that does not change while it is simulated.
struct BodyDefinition {
  std::string name = {};
  SurfaceMesh mesh = {};
  WallModel model = WallModel::kMembrane;
  std::vector<double> thickness = {};        // (triangles), metres, of the stress-free wall
  double density = 1060;                     // kg / metre^3, of the wall
  std::vector<Material> materials = {};      // (1) of the whole wall, or (triangles)
  std::vector<Eigen::Vector3d> fibres = {};  // (none), (1) or (triangles): direction of E11, brought into each triangle
  bool tension_field = false;                // membrane: the wall wrinkles instead of taking compression
  std::vector<Prestretch> prestretch = {};   // (none), (1) or (triangles)
  // (none), (1) of the whole wall, or (triangles), joule per metre^2 of new cut area, one of thickness times length:
  // what cutting and piercing cost. A wall without cannot be cut.
  std::vector<double> toughness = {};
  std::vector<PronyTerm> viscosity = {};
  RayleighDamping damping = {};
  FluidDefinition fluid = {};
  std::vector<Opening> openings = {};
  std::vector<FixedRegion> fixed = {};
  std::vector<LoadDefinition> loads = {};
};

}  // namespace thinwall
