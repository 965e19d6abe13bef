#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "engine/body/BodyDefinition.hpp"
#include "engine/contact/ContactSites.hpp"
#include "engine/contact/SelfContact.hpp"
#include "engine/equilibrium/Chambers.hpp"
#include "engine/equilibrium/LoadModel.hpp"
#include "engine/shell/BendingElement.hpp"
#include "engine/solver/BlockPattern.hpp"
#include "engine/solver/DenseAddresses.hpp"
#include "engine/solver/Lanes.hpp"
#include "engine/wall/MembraneElement.hpp"
#include "engine/wall/TensionField.hpp"

namespace thinwall {

/// An opening of the wall, see Opening.
struct OpeningModel {
  std::vector<int> lips;  // vertices
  int chamber = -1;       // index; -1 without fluid

  /// (3 x lips), metres. `position`: (unknowns), metres.
  Eigen::Matrix3Xd at(const Eigen::VectorXd& position) const;
};

/// Everything about a body that its definition determines: computed once, never changed. The unknowns are the positions
/// of the vertices and, of a shell, the turn of each edge of the wall: an angle times the mean edge length, in metres.
struct BodyModel {
  BodyDefinition definition;
  Eigen::VectorXd rest_position;                      // (unknowns), metres
  std::vector<MembraneRest> rest;                     // (triangles)
  std::vector<Eigen::Vector3i> surface;               // (triangles + caps): the wall, then the caps, see spread_caps
  std::vector<double> share;                          // (triangles + caps), how much of each encloses the fluid
  BlockPattern pattern;                               // unknowns coupled by the wall and by the fluid on the caps
  std::vector<TriangleAddresses> addresses;           // (triangles + caps)
  std::vector<BendingRest> bending;                   // (triangles) of a shell; none for a membrane
  std::vector<DenseAddresses<21>> bending_addresses;  // (triangles) of a shell
  std::vector<ContactSite> sites;                     // what keeps out of tools: vertices, edges, triangles of the wall
  std::vector<int> held_sites;                        // sites each vertex of which is fixed along some axis
  Eigen::VectorXd mass;                               // (unknowns), kg, lumped, of the wall; none of turns
  std::vector<ChamberModel> chambers;                 // named ones first; none without fluid
  std::vector<int> chamber;                           // (triangles + caps), index; -1: in none; empty without fluid
  std::vector<OpeningModel> openings;
  std::vector<char> open;  // (chambers), whether the chamber has an opening
  std::vector<LoadModel> loads;
  std::vector<char> fixed;            // (unknowns), whether the unknown keeps its rest value
  std::vector<int> fixed_entries;     // off-diagonal values in rows and columns of fixed unknowns
  std::vector<int> diagonal_entries;  // (unknowns), values on the diagonal
  Eigen::MatrixXd rigid_motions;      // (unknowns x free rigid motions) of the parts, that `fixed` does not prevent
  Eigen::VectorXd held_position;      // (unknowns), metres, where rigid motions are held: at rest, or where it was cut
  std::vector<int> anchors;           // (9 or none of each part), unknowns of three vertices far from each other
  double wall_stiffness = 0;          // newton / metre, mean of Young's modulus times thickness
  double slack_stiffness = 0;         // of a tension field, see TensionField.hpp
  double edge_length = 0;             // metres, mean
  double rest_area = 0;               // metres^2, of the wall
  double rest_volume = 0;             // metres^3, enclosed by the mesh; zero without fluid

  const Material& material(int triangle) const {
    return definition.materials[definition.materials.size() == 1 ? 0 : static_cast<std::size_t>(triangle)];
  }
  /// What a new cut costs per length, newton: toughness times rest thickness.
  double cut_cost(int triangle) const {
    const std::vector<double>& field = definition.toughness;
    return field[field.size() == 1 ? 0 : static_cast<std::size_t>(triangle)] * rest[triangle].thickness;
  }
  /// Joule, of the whole wall at a strain of 1e-6; less is as good as none.
  double least_energy() const noexcept { return 1e-12 * wall_stiffness * rest_area; }
  int vertices() const { return pattern.vertices; }
  int unknowns() const { return pattern.unknowns(); }
  int triangles() const { return static_cast<int>(rest.size()); }
  bool is_open(int chamber_index) const { return open[chamber_index]; }
  /// Whether fluid bears on a wall that is open: pressure and volume are then no conjugates.
  bool has_open_chambers() const { return has_fluid() && !openings.empty(); }
  bool has_fluid() const { return definition.fluid.kind != FluidKind::kNone; }
};

/// `slack_stiffness`: of the wall where it is a tension field. Throws std::out_of_range when a fixed region names a
/// group that the mesh lacks. Asserts one thickness per triangle.
BodyModel make_body_model(BodyDefinition definition, double slack_stiffness = kSlackStiffness);

/// Corners seen from a point.
inline std::array<Eigen::Vector3d, 3> relative_to(const Eigen::Vector3d& origin,
                                                  const std::array<Eigen::Vector3d, 3>& corners) {
  return {corners[0] - origin, corners[1] - origin, corners[2] - origin};
}

/// What the body's wall must know of itself to keep out of its own way. Floors are the planes of flat caps whose
/// vertices are fixed along the normal, where the whole stress-free wall lies on one side: what the body stands on.
/// After a cut: `placement`, (unknowns), metres, where the wall is, and the edge length that the ranges of the whole
/// wall were measured by, metres.
SelfContactDefinition self_contact_of(const BodyModel& model, const Eigen::VectorXd& placement = {},
                                      double edge_length = 0);

/// The three corners of a triangle. `position`: (3 vertices), metres.
inline std::array<Eigen::Vector3d, 3> corners_of(const Eigen::Vector3i& triangle, const Eigen::VectorXd& position) {
  return {position.segment<3>(3 * triangle[0]), position.segment<3>(3 * triangle[1]),
          position.segment<3>(3 * triangle[2])};
}

/// Those of as many triangles from `first` on as there are lanes and triangles, and how many these are. `corners`:
/// (9 x lanes), metres, x0, y0, z0, x1, ..., z2; lanes beyond them are left as they are.
inline int gather_corners(std::span<const Eigen::Vector3i> triangles, const Eigen::VectorXd& position, int first,
                          double (&corners)[9][kLanes]) {
  const int count = std::min(kLanes, static_cast<int>(triangles.size()) - first);
  for (int lane = 0; lane < count; ++lane) {
    for (int k = 0; k < 9; ++k) corners[k][lane] = position[3 * triangles[first + lane][k / 3] + k % 3];
  }
  return count;
}

/// Adds as much as `share` of what one triangle, in a lane, has of (9 x lanes) to `whole`, (unknowns).
inline void scatter_lane(const Eigen::Vector3i& triangle, const double (&part)[9][kLanes], int lane, double share,
                         double* whole) {
  for (int k = 0; k < 9; ++k) whole[3 * triangle[k / 3] + k % 3] += share * part[k][lane];
}

}  // namespace thinwall
