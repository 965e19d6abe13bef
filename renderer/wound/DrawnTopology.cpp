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

/// (borders of the mesh), their points as they are drawn, from the start on.
std::vector<std::vector<std::uint32_t>> points_of_borders(const DrawnTopology& drawn) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> of_ends;
  for (std::uint32_t k = 0; k < drawn.mesh_borders.size(); ++k) {
    of_ends[{drawn.mesh_borders[k].start, drawn.mesh_borders[k].end}] = k;
  }
  std::vector<std::vector<std::uint32_t>> points(drawn.mesh_borders.size());
  auto vertex = static_cast<std::uint32_t>(drawn.smooth.mesh->rest_positions.size());
  for (const CurvePoint& point : drawn.smooth.points) {
    const auto along = of_ends.find({point.start, point.end}), against = of_ends.find({point.end, point.start});
    if (along != of_ends.end()) points[along->second].push_back(vertex);
    if (against != of_ends.end()) points[against->second].insert(points[against->second].begin(), vertex);
    ++vertex;
  }
  return points;
}

/// The part of a triangle of the mesh that has an edge.
std::uint32_t part_at(const DrawnTopology& drawn, std::uint32_t triangle, std::uint32_t start, std::uint32_t end) {
  const std::uint32_t last = drawn.first_part[triangle + 1] - 1;
  for (std::uint32_t t = drawn.first_part[triangle]; t < last; ++t) {
    const Triangle& corners = drawn.topology().triangles[t];
    for (std::size_t k = 0; k < 3; ++k) {
      if (corners[k] == start && corners[(k + 1) % 3] == end) return t;
    }
  }
  return last;
}

/// From those of the mesh: searching all triangles for edges without a neighbour takes longer than drawing.
void find_borders(DrawnTopology& drawn) {
  const std::vector<std::vector<std::uint32_t>> points = points_of_borders(drawn);
  for (std::uint32_t k = 0; k < drawn.mesh_borders.size(); ++k) {
    const auto& [start, end, triangle] = drawn.mesh_borders[k];
    const auto pieces = static_cast<std::uint32_t>(points[k].size() + 1);
    std::vector<std::uint32_t>& numbers = drawn.borders_of.emplace_back();
    for (std::uint32_t piece = 0; piece < pieces; ++piece) {
      const std::uint32_t from = piece == 0 ? start : points[k][piece - 1];
      const std::uint32_t to = piece + 1 == pieces ? end : points[k][piece];
      numbers.push_back(static_cast<std::uint32_t>(drawn.borders.size()));
      drawn.borders.push_back({.start = from, .end = to, .triangle = part_at(drawn, triangle, from, to)});
      drawn.border_parts.push_back(
          {.border = k, .from = static_cast<double>(piece) / pieces, .to = static_cast<double>(piece + 1) / pieces});
    }
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
