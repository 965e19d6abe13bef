#include "engine/shell/BendingPatches.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace thinwall {
namespace {

/// Two triangles cannot be folded flat upon each other, because the wall has a thickness: beyond this angle more is
/// counted than there is, without bound towards half a turn. No mesh that resolves the wall bends so sharply.
constexpr double kFold = 2.5;  // radian

/// Fills the weights by which the angles of the sides make the curvature.
void weigh_sides(const MembraneRest& rest, BendingRest& result) {
  const Eigen::Matrix2d edges = rest.inverse_edges.inverse();
  const std::array<Eigen::Vector2d, 3> corners = {Eigen::Vector2d::Zero(), edges.col(0), edges.col(1)};
  for (int side = 0; side < 3; ++side) {
    const Eigen::Vector2d along = corners[(side + 1) % 3] - corners[side];
    const Eigen::Vector2d normal = Eigen::Vector2d(along.y(), -along.x()).normalized();
    result.weights.col(side) =
        along.norm() / rest.area *
        Eigen::Vector3d(normal.x() * normal.x(), normal.y() * normal.y(), 2 * normal.x() * normal.y());
  }
}

/// Outwards from a side in the plane of its triangle, as long as the triangle is high.
Eigen::Vector3d outwards(const SurfaceMesh& mesh, const Eigen::Vector3i& corners, int side) {
  const Eigen::Vector3d &p = mesh.vertices[corners[side]], &q = mesh.vertices[corners[(side + 1) % 3]];
  const Eigen::Vector3d arm = p - mesh.vertices[corners[(side + 2) % 3]], along = (q - p).normalized();
  return arm - along * along.dot(arm);
}

void add_side(const SurfaceMesh& mesh, const MeshEdges& edges, const std::vector<char>& clamped, int triangle, int side,
              double turn_length, BendingRest& result) {
  const Eigen::Vector3i& corners = mesh.triangles[triangle];
  const int a = corners[side], b = corners[(side + 1) % 3];
  result.edges[side] = edges.triangle_edges[triangle][side];
  const auto triangles = triangles_at(edges, result.edges[side]);
  BendingSide& own = result.sides[side];
  if (triangles.size() == 2) {
    const bool first = triangles[0] == triangle;
    const Eigen::Vector3i& other = mesh.triangles[triangles[first ? 1 : 0]];
    int far = 0;
    while (other[far] == a || other[far] == b) ++far;
    result.vertices[3 + side] = other[far];
    own.share = 0.5;
    own.turn_share = (first ? 1 : -1) / turn_length;
  } else if (triangles.size() == 1 && clamped[a] && clamped[b]) {
    own.share = 1;
    own.clamped = true;
    own.held = outwards(mesh, corners, side);
  } else if (triangles.size() == 1) {
    own.turn_share = 1 / turn_length;
  }
}

}  // namespace

BendingPatch patch_of(const BendingRest& rest, const Eigen::VectorXd& unknowns, int vertices) {
  BendingPatch patch;
  for (int k = 0; k < 6; ++k) patch.position[k] = unknowns.segment<3>(3 * rest.vertices[k]);
  for (int side = 0; side < 3; ++side) patch.turns[side] = unknowns[3 * vertices + rest.edges[side]];
  return patch;
}

std::array<int, 21> unknowns_of(const BendingRest& rest, int vertices) {
  std::array<int, 21> unknowns;
  for (int k = 0; k < 18; ++k) unknowns[k] = 3 * rest.vertices[k / 3] + k % 3;
  for (int side = 0; side < 3; ++side) unknowns[18 + side] = 3 * vertices + rest.edges[side];
  return unknowns;
}

std::vector<BendingRest> make_bending_rests(const SurfaceMesh& mesh, const MeshEdges& edges,
                                            std::span<const MembraneRest> rest, std::span<const Material> materials,
                                            const std::vector<char>& clamped, double turn_length) {
  std::vector<BendingRest> triangles;
  for (int t = 0; t < static_cast<int>(rest.size()); ++t) {
    const Eigen::Vector3i& corners = mesh.triangles[t];
    BendingRest triangle{.vertices = {corners[0], corners[1], corners[2], corners[0], corners[0], corners[0]},
                         .edges = {},
                         .sides = {},
                         .area = rest[t].area};
    weigh_sides(rest[t], triangle);
    BendingPatch given;
    for (int side = 0; side < 3; ++side) add_side(mesh, edges, clamped, t, side, turn_length, triangle);
    for (int k = 0; k < 6; ++k) given.position[k] = mesh.vertices[triangle.vertices[k]];
    const Eigen::Vector3d angles = side_angles(triangle, given);
    for (int side = 0; side < 3; ++side) {
      BendingSide& own = triangle.sides[side];
      own.rest_angle = angles[side];
      // What is sharper than that at rest has half of what is left.
      if (own.share > 0) own.fold = std::max(kFold, 0.5 * (std::abs(angles[side]) / own.share + std::numbers::pi));
    }
    const Material& material = materials[materials.size() == 1 ? 0 : t];
    const double cube = rest[t].thickness * rest[t].thickness * rest[t].thickness;
    triangle.stiffness = cube / 12 * material.law->respond(material.parameters, Eigen::Vector3d(1, 1, 0)).tangent;
    triangles.push_back(triangle);
  }
  return triangles;
}

}  // namespace thinwall
