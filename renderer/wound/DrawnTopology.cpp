#include "renderer/wound/DrawnTopology.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace thinwall {
namespace {

std::vector<DrawnTopology::Part> whole_triangles(std::size_t count) {
  std::vector<DrawnTopology::Part> parts(count);
  for (std::uint32_t t = 0; t < count; ++t) parts[t].triangle = t;
  return parts;
}

void find_triangles(const SnapshotTopology& mesh, DrawnTopology& drawn) {
  drawn.parts = whole_triangles(drawn.topology().triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) drawn.triangles_of.emplace_back().fill(t);
  for (const LipFan& fan : drawn.lips.fans) {
    for (std::uint32_t piece = 0; piece < kLipPieces; ++piece) {
      const std::uint32_t t = piece == 0 ? fan.triangle : fan.added + piece - 1;
      drawn.parts[t] = {.triangle = fan.triangle, .corner = fan.corner, .piece = piece};
      drawn.triangles_of[fan.triangle][piece] = t;
    }
  }
}

void find_borders(const SnapshotTopology& mesh, DrawnTopology& drawn) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> of_ends;
  for (std::uint32_t k = 0; k < drawn.mesh_borders.size(); ++k) {
    of_ends[{drawn.mesh_borders[k].start, drawn.mesh_borders[k].end}] = k;
  }
  drawn.borders_of.resize(drawn.mesh_borders.size());
  for (std::uint32_t k = 0; k < drawn.borders.size(); ++k) {
    const BorderEdge& edge = drawn.borders[k];
    const DrawnTopology::Part& part = drawn.parts[edge.triangle];
    const Triangle& triangle = drawn.topology().triangles[edge.triangle];
    const bool is_piece = part.corner != DrawnTopology::kWhole && edge.start == triangle[0] && edge.end == triangle[1];
    if (!is_piece) {
      const std::uint32_t border = of_ends.at({edge.start, edge.end});
      drawn.border_parts.push_back({.border = border});
      drawn.borders_of[border].fill(k);
      continue;
    }
    const Triangle& corners = mesh.triangles[part.triangle];
    const std::uint32_t border = of_ends.at({corners[part.corner], corners[(part.corner + 1) % 3]});
    constexpr double kPiece = 1.0 / kLipPieces;
    drawn.border_parts.push_back({.border = border, .from = kPiece * part.piece, .to = kPiece * (part.piece + 1)});
    drawn.borders_of[border][part.piece] = k;
  }
}

/// The piece of an edge in which a part of its length lies.
std::uint32_t piece_at(double along) {
  return static_cast<std::uint32_t>(std::clamp(std::floor(kLipPieces * along), 0.0, kLipPieces - 1.0));
}

}  // namespace

DrawnTopology drawn_topology(const std::shared_ptr<const SnapshotTopology>& mesh, DrawnLips lips) {
  DrawnTopology drawn;
  drawn.mesh_borders = border_edges(*mesh);
  drawn.is_lip = cut_lips(*mesh, drawn.mesh_borders);
  drawn.lips = {.topology = mesh, .points = {}, .fans = {}};
  if (lips == DrawnLips::kCurves) drawn.lips = smooth_lips(mesh, drawn.mesh_borders, drawn.is_lip);
  drawn.borders = drawn.lips.points.empty() ? drawn.mesh_borders : border_edges(drawn.topology());
  drawn.is_lip.resize(drawn.topology().rest_positions.size(), 1);
  find_triangles(*mesh, drawn);
  find_borders(*mesh, drawn);
  return drawn;
}

SnapshotSurface drawn_surface(const DrawnTopology& drawn, const SnapshotSurface& mesh) {
  return {.body = mesh.body,
          .topology = drawn.lips.topology,
          .positions = smooth_positions(drawn.lips, mesh.positions),
          .fields = {}};
}

SurfacePlace mesh_place(const DrawnTopology& drawn, const SurfacePlace& place) {
  const DrawnTopology::Part& part = drawn.parts[place.triangle];
  if (part.corner == DrawnTopology::kWhole) return {.triangle = part.triangle, .weights = place.weights};
  const double from = static_cast<double>(part.piece) / kLipPieces, to = (part.piece + 1.0) / kLipPieces;
  const auto& [first, second, apex] = place.weights;
  SurfacePlace result{.triangle = part.triangle};
  result.weights[part.corner] = (1 - from) * first + (1 - to) * second;
  result.weights[(part.corner + 1) % 3] = from * first + to * second;
  result.weights[(part.corner + 2) % 3] = apex;
  return result;
}

BorderPlace mesh_place(const DrawnTopology& drawn, const BorderPlace& place) {
  const DrawnTopology::BorderPart& part = drawn.border_parts[place.border];
  return {.border = part.border, .along = part.from + place.along * (part.to - part.from)};
}

SurfacePlace drawn_place(const DrawnTopology& drawn, const SurfacePlace& place) {
  const auto& pieces = drawn.triangles_of[place.triangle];
  const std::uint32_t corner = drawn.parts[pieces[0]].corner;
  if (corner == DrawnTopology::kWhole) return {.triangle = pieces[0], .weights = place.weights};
  const double start = place.weights[corner], end = place.weights[(corner + 1) % 3];
  const double on_lip = start + end;
  const double along = on_lip > 0 ? end / on_lip : 0;
  const std::uint32_t piece = piece_at(along);
  const double beyond = kLipPieces * along - piece;
  return {.triangle = pieces[piece],
          .weights = {on_lip * (1 - beyond), on_lip * beyond, place.weights[(corner + 2) % 3]}};
}

BorderPlace drawn_place(const DrawnTopology& drawn, const BorderPlace& place) {
  const std::uint32_t border = drawn.borders_of[place.border][piece_at(place.along)];
  const DrawnTopology::BorderPart& part = drawn.border_parts[border];
  return {.border = border, .along = (place.along - part.from) / (part.to - part.from)};
}

}  // namespace thinwall
