#include "renderer/wound/DrawnTopology.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace thinwall {
namespace {

void find_triangles(DrawnTopology& drawn) {
  drawn.first_part.assign(drawn.smooth.mesh->triangles.size() + 1, 0);
  for (const TrianglePart& part : drawn.parts()) ++drawn.first_part[part.triangle + 1];
  std::partial_sum(drawn.first_part.begin(), drawn.first_part.end(), drawn.first_part.begin());
}

/// Part of the way along an edge of the mesh at which a drawn vertex lies.
double part_of(const DrawnTopology& drawn, std::uint32_t vertex, std::uint32_t start) {
  const std::size_t of_mesh = drawn.smooth.mesh->rest_positions.size();
  if (vertex < of_mesh) return vertex == start ? 0 : 1;
  const CurvePoint& point = drawn.smooth.points[vertex - of_mesh];
  return point.start == start ? point.part : 1 - point.part;
}

void find_borders(DrawnTopology& drawn) {
  using Ends = std::pair<std::uint32_t, std::uint32_t>;
  std::map<Ends, std::uint32_t> of_ends;
  for (std::uint32_t k = 0; k < drawn.mesh_borders.size(); ++k) {
    of_ends[{drawn.mesh_borders[k].start, drawn.mesh_borders[k].end}] = k;
  }
  const std::size_t of_mesh = drawn.smooth.mesh->rest_positions.size();
  drawn.borders_of.resize(drawn.mesh_borders.size());
  for (std::uint32_t k = 0; k < drawn.borders.size(); ++k) {
    const BorderEdge& edge = drawn.borders[k];
    Ends ends{edge.start, edge.end};
    if (const std::uint32_t added = std::max(edge.start, edge.end); added >= of_mesh) {
      const CurvePoint& point = drawn.smooth.points[added - of_mesh];
      ends = {point.start, point.end};
      if (!of_ends.contains(ends)) std::swap(ends.first, ends.second);
    }
    const std::uint32_t border = of_ends.at(ends);
    drawn.border_parts.push_back(
        {.border = border, .from = part_of(drawn, edge.start, ends.first), .to = part_of(drawn, edge.end, ends.first)});
    drawn.borders_of[border].push_back(k);
  }
  for (std::vector<std::uint32_t>& pieces : drawn.borders_of) {
    std::ranges::sort(pieces, {}, [&](std::uint32_t k) { return drawn.border_parts[k].from; });
  }
}

/// Weights of a part's corners at a place with `weights` of its triangle's.
std::array<double, 3> within(const TrianglePart& part, const std::array<double, 3>& weights) {
  const auto column = [&](std::size_t corner) {
    return Vector3{part.corners[corner][0], part.corners[corner][1], part.corners[corner][2]};
  };
  const Vector3 a = column(0), b = column(1), c = column(2), place{weights[0], weights[1], weights[2]};
  const double whole = dot(a, cross(b, c));
  return {dot(place, cross(b, c)) / whole, dot(place, cross(c, a)) / whole, dot(place, cross(a, b)) / whole};
}

}  // namespace

DrawnTopology drawn_topology(const std::shared_ptr<const SnapshotTopology>& mesh, DrawnEdges edges) {
  DrawnTopology drawn;
  drawn.mesh_borders = border_edges(*mesh);
  drawn.is_lip = cut_lips(*mesh, drawn.mesh_borders);
  drawn.smooth = edges == DrawnEdges::kStraight
                     ? unsmoothed_surface(mesh)
                     : smooth_surface(mesh, drawn.mesh_borders, drawn.is_lip, edges == DrawnEdges::kCurves);
  drawn.borders = drawn.smooth.points.empty() ? drawn.mesh_borders : border_edges(drawn.topology());
  for (const CurvePoint& point : drawn.smooth.points) drawn.is_lip.push_back(point.is_lip);
  find_triangles(drawn);
  find_borders(drawn);
  return drawn;
}

SnapshotSurface drawn_surface(const DrawnTopology& drawn, const SnapshotSurface& mesh) {
  return {.body = mesh.body,
          .topology = drawn.smooth.topology,
          .positions = smooth_positions(drawn.smooth, mesh.positions),
          .fields = {}};
}

SurfacePlace mesh_place(const DrawnTopology& drawn, const SurfacePlace& place) {
  const TrianglePart& part = drawn.parts()[place.triangle];
  SurfacePlace result{.triangle = part.triangle};
  for (std::size_t corner = 0; corner < 3; ++corner) {
    for (std::size_t k = 0; k < 3; ++k) result.weights[k] += place.weights[corner] * part.corners[corner][k];
  }
  return result;
}

BorderPlace mesh_place(const DrawnTopology& drawn, const BorderPlace& place) {
  const DrawnTopology::BorderPart& part = drawn.border_parts[place.border];
  return {.border = part.border, .along = part.from + place.along * (part.to - part.from)};
}

SurfacePlace drawn_place(const DrawnTopology& drawn, const SurfacePlace& place) {
  const std::uint32_t first = drawn.first_part[place.triangle], end = drawn.first_part[place.triangle + 1];
  if (end == first + 1) return {.triangle = first, .weights = place.weights};
  SurfacePlace found;
  double inside = -1;
  for (std::uint32_t t = first; t < end; ++t) {
    const std::array<double, 3> weights = within(drawn.parts()[t], place.weights);
    const double least = std::ranges::min(weights);
    if (least <= inside) continue;
    inside = least;
    found = {.triangle = t, .weights = weights};
  }
  for (double& weight : found.weights) weight = std::max(weight, 0.0);
  return found;
}

BorderPlace drawn_place(const DrawnTopology& drawn, const BorderPlace& place) {
  const std::vector<std::uint32_t>& pieces = drawn.borders_of[place.border];
  const auto count = static_cast<double>(pieces.size());
  const auto piece = static_cast<std::size_t>(std::clamp(std::floor(count * place.along), 0.0, count - 1));
  const DrawnTopology::BorderPart& part = drawn.border_parts[pieces[piece]];
  return {.border = pieces[piece], .along = (place.along - part.from) / (part.to - part.from)};
}

}  // namespace thinwall
