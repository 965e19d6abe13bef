#include "studio/organs/NestedParts.hpp"

#include <Eigen/Geometry>
#include <numbers>

#include "engine/mesh/MeshMeasures.hpp"

namespace thinwall {
namespace {

/// Half of what a closed surface spans around a point inside, steradian.
constexpr double kInside = 2 * std::numbers::pi;

struct Part {
  std::vector<int> triangles;
  Eigen::AlignedBox3d box;
  bool open = false;
};

std::vector<Part> parts_of(const RawSurface& surface, const MeshTopology& topology) {
  std::vector<char> at_border(surface.vertices.size(), 0);
  for (const std::vector<int>& loop : topology.boundary_loops) {
    for (const int vertex : loop) at_border[vertex] = 1;
  }
  std::vector<Part> parts(topology.component_count);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    Part& part = parts[topology.triangle_component[t]];
    part.triangles.push_back(static_cast<int>(t));
    for (const int vertex : surface.triangles[t]) {
      part.box.extend(surface.vertices[vertex]);
      part.open = part.open || at_border[vertex];
    }
  }
  return parts;
}

bool is_within(const RawSurface& surface, const Part& part, const Eigen::Vector3d& point) {
  if (part.open || !part.box.contains(point)) return false;
  double angle = 0;
  for (const int t : part.triangles) {
    const Eigen::Vector3i& corner = surface.triangles[t];
    angle +=
        solid_angle({surface.vertices[corner[0]], surface.vertices[corner[1]], surface.vertices[corner[2]]}, point);
  }
  return angle > kInside;
}

}  // namespace

std::vector<int> nested_parts(const RawSurface& surface) {
  const std::vector<Part> parts = parts_of(surface, topology_of_surface(surface));
  std::vector<int> nested;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const Eigen::Vector3d& point = surface.vertices[surface.triangles[parts[p].triangles.front()][0]];
    for (std::size_t other = 0; other < parts.size(); ++other) {
      if (other == p || !is_within(surface, parts[other], point)) continue;
      nested.push_back(static_cast<int>(p));
      break;
    }
  }
  return nested;
}

}  // namespace thinwall
