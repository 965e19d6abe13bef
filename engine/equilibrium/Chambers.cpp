#include "engine/equilibrium/Chambers.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "engine/fluid/EnclosedVolume.hpp"
#include "engine/mesh/MeshMeasures.hpp"
#include "engine/mesh/UnionFind.hpp"

namespace thinwall {
namespace {

/// Part of each triangle; parts are numbered by their first triangle.
std::vector<int> connected_parts(std::size_t vertices, std::span<const Eigen::Vector3i> triangles) {
  UnionFind joined(vertices);
  for (const Eigen::Vector3i& triangle : triangles) joined.join(triangle);
  std::vector<int> number(vertices, -1), parts;
  int count = 0;
  for (const Eigen::Vector3i& triangle : triangles) {
    int& own = number[joined.find(triangle[0])];
    if (own < 0) own = count++;
    parts.push_back(own);
  }
  return parts;
}

std::vector<Eigen::Vector3d> centroids_of(std::span<const Eigen::Vector3d> vertices,
                                          std::span<const Eigen::Vector3i> triangles, const std::vector<int>& parts,
                                          const std::vector<double>& volumes) {
  std::vector<Eigen::Vector3d> centroids(volumes.size(), Eigen::Vector3d::Zero());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Eigen::Vector3i& corner = triangles[t];
    const std::array<Eigen::Vector3d, 3> corners = {vertices[corner[0]], vertices[corner[1]], vertices[corner[2]]};
    centroids[parts[t]] += volume_of(corners) / 4 * (corners[0] + corners[1] + corners[2]) / volumes[parts[t]];
  }
  return centroids;
}

/// The smallest part that a point lies in, or -1.
int part_around(const Eigen::Vector3d& point, std::span<const Eigen::Vector3d> vertices,
                std::span<const Eigen::Vector3i> triangles, const std::vector<int>& parts,
                const std::vector<double>& volumes) {
  std::vector<double> winding(volumes.size(), 0);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Eigen::Vector3i& corner = triangles[t];
    const double angle = solid_angle({vertices[corner[0]], vertices[corner[1]], vertices[corner[2]]}, point);
    winding[parts[t]] += angle / (4 * std::numbers::pi);
  }
  int best = -1;
  for (int part = 0; part < static_cast<int>(volumes.size()); ++part) {
    if (std::abs(winding[part]) > 0.5 && (best < 0 || volumes[part] < volumes[best])) best = part;
  }
  return best;
}

}  // namespace

Chambers find_chambers(std::span<const Eigen::Vector3d> vertices, std::span<const Eigen::Vector3i> triangles,
                       const FluidDefinition& fluid) {
  const std::vector<int> parts = connected_parts(vertices.size(), triangles);
  const int count = parts.empty() ? 0 : *std::max_element(parts.begin(), parts.end()) + 1;
  std::vector<double> volumes(count, 0);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Eigen::Vector3i& corner = triangles[t];
    volumes[parts[t]] += volume_of({vertices[corner[0]], vertices[corner[1]], vertices[corner[2]]});
  }
  const std::vector<Eigen::Vector3d> centroids = centroids_of(vertices, triangles, parts, volumes);
  Chambers result;
  std::vector<int> order(count, -1);
  for (const ChamberDefinition& chamber : fluid.chambers) {
    const int part =
        chamber.wall ? parts[*chamber.wall] : part_around(chamber.inside, vertices, triangles, parts, volumes);
    if (part < 0) throw std::invalid_argument("chamber `" + chamber.name + "`: its point lies in no closed part");
    if (order[part] >= 0) {
      throw std::invalid_argument("chambers `" + result.chambers[order[part]].name + "` and `" + chamber.name +
                                  "`: their points lie in the same closed part");
    }
    order[part] = static_cast<int>(result.chambers.size());
    result.chambers.push_back({chamber.name, volumes[part], centroids[part],
                               chamber.initial_pressure ? chamber.initial_pressure : fluid.initial_pressure});
  }
  for (int part = 0; part < count && fluid.other_chambers; ++part) {
    if (order[part] >= 0) continue;
    order[part] = static_cast<int>(result.chambers.size());
    result.chambers.push_back({"", volumes[part], centroids[part], fluid.initial_pressure});
  }
  for (const int part : parts) result.of_triangle.push_back(order[part]);
  return result;
}

}  // namespace thinwall
