#include "engine/equilibrium/CapFans.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "engine/equilibrium/HeldAxes.hpp"
#include "engine/mesh/MeshTopology.hpp"
#include "engine/mesh/UnionFind.hpp"

namespace thinwall {
namespace {

/// Sine of the angle between the planes of two triangles of a flat cap.
constexpr double kCoplanar = 1e-6;

/// Components of a unit normal below this do not ask for a fixed axis.
constexpr double kAskedFor = 1e-6;

Eigen::Vector3d normal_of(const SurfaceMesh& mesh, const Eigen::Vector3i& triangle) {
  const Eigen::Vector3d& first = mesh.vertices[triangle[0]];
  return (mesh.vertices[triangle[1]] - first).cross(mesh.vertices[triangle[2]] - first).normalized();
}

bool is_one_plane(const Eigen::Vector3d& one, const Eigen::Vector3d& other) {
  return one.dot(other) > 0 && one.cross(other).norm() < kCoplanar;
}

/// Numbers of cap triangles that lie beside each other in a plane.
std::vector<std::vector<int>> flat_caps(const SurfaceMesh& mesh) {
  const std::vector<Eigen::Vector3i>& caps = mesh.cap_triangles;
  const MeshEdges edges = edges_of(static_cast<int>(mesh.vertices.size()), caps);
  UnionFind joined(caps.size());
  for (std::size_t edge = 0; edge < edges.edges.size(); ++edge) {
    const std::span<const int> beside = triangles_at(edges, static_cast<int>(edge));
    if (beside.size() != 2) continue;
    if (is_one_plane(normal_of(mesh, caps[beside[0]]), normal_of(mesh, caps[beside[1]]))) {
      joined.join(beside[0], beside[1]);
    }
  }
  std::map<int, std::vector<int>> parts;
  for (int t = 0; t < static_cast<int>(caps.size()); ++t) parts[joined.find(t)].push_back(t);
  std::vector<std::vector<int>> flat;
  for (auto& [root, part] : parts) flat.push_back(std::move(part));
  return flat;
}

bool is_held_along(const Eigen::Vector3d& normal, const std::array<bool, 3>& held) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(normal[axis]) > kAskedFor && !held[axis]) return false;
  }
  return true;
}

/// The rim of a cap that can leave its plane, in the sense of its triangles; none where it cannot, or is not one ring.
std::vector<int> free_rim(const SurfaceMesh& mesh, const std::vector<Eigen::Vector3i>& cap,
                          const std::vector<std::array<bool, 3>>& held) {
  const MeshPieces pieces = pieces_of(static_cast<int>(mesh.vertices.size()), cap);
  if (cap.size() < 2 || pieces.boundary_loops.size() != 1) return {};
  const std::vector<int>& rim = pieces.boundary_loops.front();
  if (rim.size() != cap.size() + 2) return {};
  const Eigen::Vector3d normal = normal_of(mesh, cap.front());
  const auto is_held = [&](int vertex) { return is_held_along(normal, held[vertex]); };
  return std::ranges::all_of(rim, is_held) ? std::vector<int>{} : rim;
}

/// Adds the fans from all vertices of a rim.
void add_fans(const SurfaceMesh& mesh, const std::vector<int>& rim, int cap, CapSurface& surface) {
  const int count = static_cast<int>(rim.size());
  std::vector<double> share(count, 0);  // of each vertex in the mean point
  double length = 0;
  for (int k = 0; k < count; ++k) {
    const int next = (k + 1) % count;
    const double edge = (mesh.vertices[rim[next]] - mesh.vertices[rim[k]]).norm();
    share[k] += edge / 2;
    share[next] += edge / 2;
    length += edge;
  }
  for (int from = 0; from < count; ++from) {
    for (int k = 0; k < count; ++k) {
      const int next = (k + 1) % count;
      if (k == from || next == from) continue;
      surface.triangles.emplace_back(rim[from], rim[k], rim[next]);
      surface.share.push_back(share[from] / length);
      surface.cap.push_back(cap);
    }
  }
}

}  // namespace

CapSurface spread_caps(const SurfaceMesh& mesh, std::span<const FixedRegion> fixed) {
  CapSurface surface;
  if (mesh.cap_triangles.empty()) return surface;
  const std::vector<std::array<bool, 3>> held = held_axes(mesh, fixed);
  std::vector<char> is_spread(mesh.cap_triangles.size(), 0);
  CapSurface fans;
  for (const std::vector<int>& part : flat_caps(mesh)) {
    std::vector<Eigen::Vector3i> cap;
    for (const int t : part) cap.push_back(mesh.cap_triangles[t]);
    const std::vector<int> rim = free_rim(mesh, cap, held);
    if (rim.empty()) continue;
    for (const int t : part) is_spread[t] = 1;
    add_fans(mesh, rim, part.front(), fans);
  }
  for (int t = 0; t < static_cast<int>(mesh.cap_triangles.size()); ++t) {
    if (is_spread[t]) continue;
    surface.triangles.push_back(mesh.cap_triangles[t]);
    surface.share.push_back(1);
    surface.cap.push_back(t);
  }
  surface.triangles.insert(surface.triangles.end(), fans.triangles.begin(), fans.triangles.end());
  surface.share.insert(surface.share.end(), fans.share.begin(), fans.share.end());
  surface.cap.insert(surface.cap.end(), fans.cap.begin(), fans.cap.end());
  return surface;
}

bool has_free_corner(const SurfaceMesh& mesh, std::span<const FixedRegion> fixed) {
  const std::vector<Eigen::Vector3i>& caps = mesh.cap_triangles;
  const MeshEdges edges = edges_of(static_cast<int>(mesh.vertices.size()), caps);
  const std::vector<std::array<bool, 3>> held = held_axes(mesh, fixed);
  for (std::size_t edge = 0; edge < edges.edges.size(); ++edge) {
    const std::span<const int> beside = triangles_at(edges, static_cast<int>(edge));
    if (beside.size() != 2) continue;
    const Eigen::Vector3d one = normal_of(mesh, caps[beside[0]]), other = normal_of(mesh, caps[beside[1]]);
    if (is_one_plane(one, other)) continue;
    for (const int vertex : edges.edges[edge]) {
      if (!is_held_along(one, held[vertex]) || !is_held_along(other, held[vertex])) return true;
    }
  }
  return false;
}

}  // namespace thinwall
