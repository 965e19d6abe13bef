#include "engine/mesh/Region.hpp"

#include <cmath>
#include <stdexcept>

#include "engine/mesh/MeshTopology.hpp"

namespace thinwall {
namespace {

/// Metres past a limit that still count: what places of organs lose where meshes are read in single precision, turned
/// and placed. A rim that lies at a limit would be held in part.
constexpr double kPastLimit = 1e-8;

bool contains(const PlaneRegion& region, const Eigen::Vector3d& point) {
  return std::abs(point[region.axis] - region.at) <= region.within + kPastLimit;
}
bool contains(const BelowRegion& region, const Eigen::Vector3d& point) {
  return point[region.axis] <= region.at + kPastLimit;
}
bool contains(const AboveRegion& region, const Eigen::Vector3d& point) {
  return point[region.axis] >= region.at - kPastLimit;
}
bool contains(const BoxRegion& region, const Eigen::Vector3d& point) {
  return (point.array() >= region.min.array() - kPastLimit).all() &&
         (point.array() <= region.max.array() + kPastLimit).all();
}
bool contains(const SphereRegion& region, const Eigen::Vector3d& point) {
  return (point - region.center).norm() <= region.radius + kPastLimit;
}
bool contains(const WholeRegion&, const Eigen::Vector3d&) {
  return true;
}

std::vector<bool> members(const GroupRegion& region, const SurfaceMesh& mesh) {
  const auto group = mesh.groups.find(region.name);
  if (group == mesh.groups.end()) throw std::out_of_range("the mesh has no group '" + region.name + "'");
  std::vector<bool> inside(mesh.vertices.size(), false);
  for (const int v : group->second) inside[v] = true;
  return inside;
}

std::vector<bool> members(const BoundaryRegion&, const SurfaceMesh& mesh) {
  const MeshTopology topology = topology_of(static_cast<int>(mesh.vertices.size()), mesh.triangles);
  std::vector<bool> inside(mesh.vertices.size(), false);
  for (const int edge : topology.open_edges) {
    for (const int v : topology.edges[edge]) inside[v] = true;
  }
  return inside;
}

template <typename Volume>
std::vector<bool> members(const Volume& region, const SurfaceMesh& mesh) {
  std::vector<bool> inside;
  inside.reserve(mesh.vertices.size());
  for (const Eigen::Vector3d& vertex : mesh.vertices) inside.push_back(contains(region, vertex));
  return inside;
}

template <typename Volume>
bool holds_triangle(const Volume& region, const std::vector<bool>&, const SurfaceMesh& mesh, const Eigen::Vector3i& t) {
  return contains(region, (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3);
}
bool holds_triangle(const GroupRegion&, const std::vector<bool>& inside, const SurfaceMesh&, const Eigen::Vector3i& t) {
  return inside[t[0]] && inside[t[1]] && inside[t[2]];
}
bool holds_triangle(const BoundaryRegion&, const std::vector<bool>& inside, const SurfaceMesh&,
                    const Eigen::Vector3i& t) {
  return inside[t[0]] && inside[t[1]] && inside[t[2]];
}

}  // namespace

std::vector<int> vertices_in(const Region& region, const SurfaceMesh& mesh) {
  const std::vector<bool> inside = std::visit([&](const auto& kind) { return members(kind, mesh); }, region);
  std::vector<int> vertices;
  for (int v = 0; v < static_cast<int>(inside.size()); ++v) {
    if (inside[v]) vertices.push_back(v);
  }
  return vertices;
}

std::vector<int> triangles_in(const Region& region, const SurfaceMesh& mesh) {
  const auto find = [&](const auto& kind) {
    const std::vector<bool> inside = members(kind, mesh);
    std::vector<int> triangles;
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
      if (holds_triangle(kind, inside, mesh, mesh.triangles[t])) triangles.push_back(t);
    }
    return triangles;
  };
  return std::visit(find, region);
}

}  // namespace thinwall
