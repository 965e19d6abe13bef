#include "renderer/ground_truth/MaterialMatch.hpp"

#include <algorithm>
#include <cmath>

namespace thinwall {
namespace {

/// Borders farther from a place than this part of their length are other borders.
constexpr double kSameBorder = 0.05;

bool is_same(const SnapshotTopology& a, const SnapshotTopology& b) {
  return &a == &b ||
         (a.rest_positions == b.rest_positions && a.triangles == b.triangles && a.cap_triangles == b.cap_triangles);
}

/// A place of a rim.
struct RimPlace {
  BorderPlace place;
  double depth = 0;  // 0 to 1, from outside
};

/// The two triangles of a border join outer start, inner start, outer end, and outer end, inner start, inner end.
RimPlace rim_place(std::uint32_t triangle, const std::array<double, 3>& weights) {
  if (triangle % 2 == 0) return {.place = {triangle / 2, weights[2]}, .depth = weights[1]};
  return {.place = {triangle / 2, weights[0] + weights[2]}, .depth = weights[1] + weights[2]};
}

ScenePlace on_rim(const RimPlace& place, std::uint32_t first_triangle) {
  const double s = place.place.along, d = place.depth;
  if (s + d <= 1) return {.triangle = first_triangle + 2 * place.place.border, .weights = {1 - s - d, d, s}};
  return {.triangle = first_triangle + 2 * place.place.border + 1, .weights = {1 - d, 1 - s, s + d - 1}};
}

struct RestEdge {
  Vector3 start, span;
};

RestEdge rest_edge(const SnapshotTopology& topology, const BorderEdge& border) {
  const Vector3 start = vector3(topology.rest_positions[border.start]);
  return {start, vector3(topology.rest_positions[border.end]) - start};
}

}  // namespace

struct MaterialMatch::Surface {
  bool same = false;  // whether all triangles are
  std::optional<TriangleMatch> wall;
  std::optional<TriangleMatch> caps;
};

MaterialMatch::MaterialMatch(const SceneMoment& from, const SceneMoment& to) : from_(from), to_(to) {
  for (std::size_t k = 0; k < from.snapshot.surfaces.size(); ++k) {
    const SnapshotTopology& before = *from.snapshot.surfaces[k].topology;
    const SnapshotTopology& after = *to.snapshot.surfaces[k].topology;
    Surface surface{.same = is_same(before, after), .wall = {}, .caps = {}};
    if (!surface.same) {
      surface.wall.emplace(RestSurface{before.rest_positions, before.triangles},
                           RestSurface{after.rest_positions, after.triangles});
      surface.caps.emplace(RestSurface{before.rest_positions, before.cap_triangles},
                           RestSurface{after.rest_positions, after.cap_triangles});
    }
    surfaces_.push_back(std::move(surface));
  }
  for (const ScenePart& part : from.geometry.parts) {
    const auto other = std::ranges::find_if(to.geometry.parts, [&](const ScenePart& candidate) {
      return candidate.kind == part.kind && candidate.owner == part.owner &&
             (part.kind != PartKind::kTool || candidate.triangle_count == part.triangle_count);
    });
    other_part_.push_back(
        other == to.geometry.parts.end() ? kNoIndex : static_cast<std::uint32_t>(other - to.geometry.parts.begin()));
  }
}

MaterialMatch::~MaterialMatch() = default;
MaterialMatch::MaterialMatch(MaterialMatch&&) noexcept = default;

std::optional<ScenePlace> MaterialMatch::find(const ScenePlace& place) const {
  const std::uint32_t index = from_.geometry.triangles[place.triangle].part;
  if (other_part_[index] == kNoIndex) return std::nullopt;
  const ScenePart& part = from_.geometry.parts[index];
  const ScenePart& other = to_.geometry.parts[other_part_[index]];
  const std::uint32_t triangle = place.triangle - part.first_triangle;
  if (part.kind == PartKind::kTool || surfaces_[part.owner].same) {
    return ScenePlace{.triangle = other.first_triangle + triangle, .weights = place.weights};
  }
  if (part.kind == PartKind::kRim) return find_on_rim(place, part, other);
  const bool turned = part.kind == PartKind::kLining;  // its triangles have their corners in the order 0 2 1
  const auto& [first, second, third] = place.weights;
  const Surface& surface = surfaces_[part.owner];
  const TriangleMatch& match = part.kind == PartKind::kCap ? *surface.caps : *surface.wall;
  const SurfacePlace drawn{.triangle = triangle,
                           .weights = turned ? std::array{first, third, second} : std::array{first, second, third}};
  const bool is_cap = part.kind == PartKind::kCap;
  const auto found = match.find(is_cap ? drawn : mesh_place(from_.geometry.drawn[part.owner], drawn));
  if (!found) return std::nullopt;
  const SurfacePlace there = is_cap ? *found : drawn_place(to_.geometry.drawn[part.owner], *found);
  const auto& [a, b, c] = there.weights;
  return ScenePlace{.triangle = other.first_triangle + there.triangle,
                    .weights = turned ? std::array{a, c, b} : std::array{a, b, c}};
}

/// The lips of a cut lie on each other at rest; their borders run in contrary senses.
std::optional<ScenePlace> MaterialMatch::find_on_rim(const ScenePlace& place, const ScenePart& part,
                                                     const ScenePart& other) const {
  const SnapshotTopology& before = *from_.snapshot.surfaces[part.owner].topology;
  const SnapshotTopology& after = *to_.snapshot.surfaces[part.owner].topology;
  const DrawnTopology& drawn_before = from_.geometry.drawn[part.owner];
  const DrawnTopology& drawn_after = to_.geometry.drawn[part.owner];
  RimPlace rim = rim_place(place.triangle - part.first_triangle, place.weights);
  const BorderPlace on_mesh = mesh_place(drawn_before, rim.place);
  const RestEdge edge = rest_edge(before, drawn_before.mesh_borders[on_mesh.border]);
  const Vector3 point = edge.start + on_mesh.along * edge.span;
  const std::vector<BorderEdge>& candidates = drawn_after.mesh_borders;
  double nearest = kSameBorder * length(edge.span);
  bool found = false;
  for (std::uint32_t k = 0; k < candidates.size(); ++k) {
    const RestEdge candidate = rest_edge(after, candidates[k]);
    if (dot(candidate.span, edge.span) <= 0) continue;
    const double along =
        std::clamp(dot(point - candidate.start, candidate.span) / dot(candidate.span, candidate.span), 0.0, 1.0);
    const double distance = length(candidate.start + along * candidate.span - point);
    if (distance >= nearest) continue;
    nearest = distance;
    rim.place = {.border = k, .along = along};
    found = true;
  }
  if (!found) return std::nullopt;
  rim.place = drawn_place(drawn_after, rim.place);
  return on_rim(rim, other.first_triangle);
}

}  // namespace thinwall
