#include "engine/shell/BendingPatches.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "engine/mesh/MeshTopology.hpp"

namespace thinwall {
namespace {

using Flat = Eigen::Vector2d;

/// Builds the patch of one triangle.
class PatchBuilder {
 public:
  PatchBuilder(const SurfaceMesh& mesh, const MeshTopology& topology, const MembraneRest& rest, int triangle)
      : mesh_(mesh), topology_(topology), triangle_(triangle), corners_(mesh.triangles[triangle]) {
    const Eigen::Matrix2d edges = rest.inverse_edges.inverse();
    flat_ = {Flat::Zero(), edges.col(0), edges.col(1)};
    // From the plane of the given triangle, with its first edge along the first axis, to the rest plane.
    const Eigen::Vector3d first = at(1) - at(0), second = at(2) - at(0);
    along_ = first.normalized();
    normal_ = first.cross(second).normalized();
    across_ = normal_.cross(along_);
    Eigen::Matrix2d given;
    given << first.dot(along_), second.dot(along_), 0, second.dot(across_);
    to_rest_ = edges * given.inverse();
    result_.area = rest.area;
    result_.vertices = {corners_[0], corners_[1], corners_[2], corners_[0], corners_[0], corners_[0]};
    result_.shares.setZero();
  }

  BendingRest build(const std::vector<char>& clamped) {
    for (int side = 0; side < 3; ++side) {
      const auto triangles = triangles_at(topology_, topology_.triangle_edges[triangle_][side]);
      if (triangles.size() == 2) {
        add_neighbour(side, triangles[0] == triangle_ ? triangles[1] : triangles[0]);
      } else if (triangles.size() == 1 && clamped[corners_[side]] && clamped[corners_[(side + 1) % 3]]) {
        add_clamped(side);
      }
    }
    return result_;
  }

 private:
  const Eigen::Vector3d& at(int corner) const { return mesh_.vertices[corners_[corner]]; }

  /// Outer normal of a side in the rest plane times its length over the area, 1 / metre.
  Flat outward(int side) const {
    const Flat edge = flat_[(side + 1) % 3] - flat_[side];
    return Flat(edge.y(), -edge.x()) / result_.area;
  }

  /// The derivatives by the two rest coordinates at a side, as weights of six vertices, enter the mean of the second
  /// ones with the outward normal; the mixed one is taken from both sides and doubled.
  void add(int side, const Eigen::Matrix<double, 2, 6>& derivative) {
    const Flat n = outward(side);
    result_.shares.row(0) += n.x() * derivative.row(0);
    result_.shares.row(1) += n.y() * derivative.row(1);
    result_.shares.row(2) += n.x() * derivative.row(1) + n.y() * derivative.row(0);
  }

  /// Gradients of the shape functions of a triangle in the rest plane, a column for each corner.
  static Eigen::Matrix<double, 2, 3> gradients(const std::array<Flat, 3>& corners) {
    Eigen::Matrix2d edges;
    edges << corners[1] - corners[0], corners[2] - corners[0];
    const Eigen::Matrix2d inverse = edges.inverse();
    Eigen::Matrix<double, 2, 3> result;
    result.col(1) = inverse.row(0).transpose();
    result.col(2) = inverse.row(1).transpose();
    result.col(0) = -result.col(1) - result.col(2);
    return result;
  }

  /// Where the far corner of a neighbour lies in the rest plane once it is turned about the common side into it.
  Flat unfolded(int side, const Eigen::Vector3d& far) const {
    const Eigen::Vector3d edge = (at((side + 1) % 3) - at(side)).normalized(), arm = far - at(side);
    const double forward = arm.dot(edge), height = (arm - forward * edge).norm();
    const Eigen::Vector3d outer = edge.cross(normal_);
    const Eigen::Vector3d place = at(side) + forward * edge + height * outer - at(0);
    return to_rest_ * Flat(place.dot(along_), place.dot(across_));
  }

  void add_neighbour(int side, int neighbour) {
    const Eigen::Vector3i& other = mesh_.triangles[neighbour];
    const int a = corners_[side], b = corners_[(side + 1) % 3];
    int far = 0;
    while (other[far] == a || other[far] == b) ++far;
    result_.vertices[3 + side] = other[far];
    const Flat tip = unfolded(side, mesh_.vertices[other[far]]);
    const Eigen::Matrix<double, 2, 3> own = gradients(flat_);
    const Eigen::Matrix<double, 2, 3> next = gradients({flat_[(side + 1) % 3], flat_[side], tip});
    const Flat normal = outward(side).normalized();
    const double own_height = normal.dot(flat_[side] - flat_[(side + 2) % 3]);
    const double next_height = normal.dot(tip - flat_[side]);
    const double weight = own_height / (own_height + next_height);
    Eigen::Matrix<double, 2, 6> derivative = Eigen::Matrix<double, 2, 6>::Zero();
    derivative.leftCols<3>() = (1 - weight) * own;
    derivative.col((side + 1) % 3) += weight * next.col(0);
    derivative.col(side) += weight * next.col(1);
    derivative.col(3 + side) += weight * next.col(2);
    add(side, derivative);
  }

  /// The derivative across a clamped side keeps the direction that it has at rest. The one along it lies in the plane
  /// of the triangle whatever its shape, and adds nothing.
  void add_clamped(int side) {
    const Eigen::Vector3d outer = (at((side + 1) % 3) - at(side)).cross(normal_).normalized();
    const Flat n = outward(side), unit = n.normalized();
    result_.held.col(0) += n.x() * unit.x() * outer;
    result_.held.col(1) += n.y() * unit.y() * outer;
    result_.held.col(2) += (n.x() * unit.y() + n.y() * unit.x()) * outer;
  }

  const SurfaceMesh& mesh_;
  const MeshTopology& topology_;
  int triangle_;
  Eigen::Vector3i corners_;
  std::array<Flat, 3> flat_;  // metres, in the rest plane
  Eigen::Vector3d along_, across_, normal_;
  Eigen::Matrix2d to_rest_;
  BendingRest result_;
};

}  // namespace

BendingPatch patch_of(const BendingRest& rest, const Eigen::VectorXd& position) {
  BendingPatch patch;
  for (int k = 0; k < 6; ++k) patch[k] = position.segment<3>(3 * rest.vertices[k]);
  return patch;
}

std::vector<BendingRest> make_bending_rests(const SurfaceMesh& mesh, std::span<const MembraneRest> rest,
                                            std::span<const Material> materials, const std::vector<char>& clamped) {
  const MeshTopology topology = topology_of(static_cast<int>(mesh.vertices.size()), mesh.triangles);
  std::vector<BendingRest> patches;
  for (int t = 0; t < static_cast<int>(rest.size()); ++t) {
    BendingRest patch = PatchBuilder(mesh, topology, rest[t], t).build(clamped);
    const Material& material = materials[materials.size() == 1 ? 0 : t];
    const double cube = rest[t].thickness * rest[t].thickness * rest[t].thickness;
    patch.stiffness = cube / 12 * material.law->respond(material.parameters, Eigen::Vector3d(1, 1, 0)).tangent;
    BendingPatch given;
    for (int k = 0; k < 6; ++k) given[k] = mesh.vertices[patch.vertices[k]];
    patch.curvature = bending_strain(patch, given);
    patches.push_back(patch);
  }
  return patches;
}

}  // namespace thinwall
