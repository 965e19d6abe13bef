#include "renderer/wound/SmoothSurface.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "renderer/snapshot/Float3.hpp"
#include "renderer/snapshot/Vector.hpp"
#include "renderer/wound/TriangleSplit.hpp"
#include "renderer/wound/VertexNormals.hpp"

namespace thinwall {
namespace {

/// Cosines of the angle by which a lip turns at a vertex: below the first it has a corner there, above the second none.
constexpr double kCorner = -0.3, kSmooth = 0.3;

/// How far the curve leaves an edge at most, over the edge's length.
constexpr double kMostBulge = 0.2;

/// (vertices), the next ones along the lips; kNone where there is none, or more than one, or the lip ends at a border
/// that was there before the cut.
std::vector<std::uint32_t> next_along(std::span<const char> is_lip, std::span<const BorderEdge> borders,
                                      bool backwards) {
  std::vector<std::uint32_t> next(is_lip.size(), CurvePoint::kNone);
  std::vector<int> counts(is_lip.size(), 0);
  for (const BorderEdge& edge : borders) {
    const auto [from, to] = backwards ? std::pair{edge.end, edge.start} : std::pair{edge.start, edge.end};
    next[from] = to;
    ++counts[from];
  }
  for (std::size_t v = 0; v < next.size(); ++v) {
    if (counts[v] != 1 || !is_lip[next[v]]) next[v] = CurvePoint::kNone;
  }
  return next;
}

/// Of the circle through three points, at the second one, of length one; the way from `at` to `other` where there is no
/// `neighbour` or a corner. `sense`: 1 where `other` comes after `at`, -1 before it.
Vector3 tangent_at(Vector3 at, Vector3 other, const Float3* neighbour, double sense) {
  const Vector3 way = sense * (other - at);
  const double ahead = length(way);
  const Vector3 along = normalized(way, {0, 0, 0});
  if (neighbour == nullptr) return along;
  const Vector3 back_way = sense * (at - vector3(*neighbour));
  const double behind = length(back_way);
  const Vector3 back = normalized(back_way, {0, 0, 0});
  const double share = std::clamp((dot(along, back) - kCorner) / (kSmooth - kCorner), 0.0, 1.0);
  // The nearer neighbour tells more of how it turns here.
  const Vector3 circle = normalized(behind * along + ahead * back, along);
  return normalized((1 - share) * along + share * circle, along);
}

/// A place off an edge by `bulge`, but by no more than a part of its length.
Vector3 off_edge(Vector3 straight, Vector3 bulge, double edge) {
  const double most = kMostBulge * edge, size = length(bulge);
  return straight + (size > most ? most / size : 1.0) * bulge;
}

Vector3 on_lip(const CurvePoint& point, std::span<const Float3> positions) {
  const Vector3 start = vector3(positions[point.start]), end = vector3(positions[point.end]);
  const auto neighbour = [&](std::uint32_t vertex) {
    return vertex == CurvePoint::kNone ? nullptr : &positions[vertex];
  };
  const double edge = length(end - start), s = point.part;
  const Vector3 leaves = edge * tangent_at(start, end, neighbour(point.before), 1);
  const Vector3 arrives = edge * tangent_at(end, start, neighbour(point.after), -1);
  const Vector3 straight = (1 - s) * start + s * end;
  const Vector3 curve = (1 + 2 * s) * (1 - s) * (1 - s) * start + s * (1 - s) * (1 - s) * leaves +
                        s * s * (3 - 2 * s) * end - s * s * (1 - s) * arrives;
  return off_edge(straight, curve - straight, edge);
}

/// How far the curve of a round wall lies off an edge at part `s` of it, metres. The normals are of length one.
Vector3 round_bulge(Vector3 start, Vector3 end, Vector3 start_normal, Vector3 end_normal, double s) {
  const Vector3 way = end - start;
  return -s * (1 - s) * ((1 - s) * dot(way, start_normal) * start_normal - s * dot(way, end_normal) * end_normal);
}

/// The same for both lips of a cut, to the last bit.
Float3 between(const Float3& a, const Float3& b, double part) {
  Float3 result{};
  for (std::size_t k = 0; k < 3; ++k) {
    result[k] = static_cast<float>((1 - part) * static_cast<double>(a[k]) + part * static_cast<double>(b[k]));
  }
  return result;
}

using EdgeKey = std::pair<std::uint32_t, std::uint32_t>;  // vertices, the smaller one first

EdgeKey key_of(std::uint32_t a, std::uint32_t b) {
  return std::minmax(a, b);
}

/// Edges that are drawn as curves, with the numbers of their points from the smaller vertex on.
using CurvedEdges = std::map<EdgeKey, std::vector<std::uint32_t>>;

double extent(const std::vector<Float3>& positions) {
  Vector3 low = vector3(positions.front()), high = low;
  for (const Float3& position : positions) {
    const Vector3 p = vector3(position);
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return length(high - low);
}

/// Ends of the edges of the wall, but for those at caps, that lie far enough off a round wall.
std::vector<EdgeKey> round_edges(const SnapshotTopology& mesh) {
  if (mesh.rest_positions.empty()) return {};
  const std::vector<Float3>& rest = mesh.rest_positions;
  const std::vector<Vector3> normals = vertex_normals(rest, mesh.triangles);
  const double least = kRoundness * extent(rest);
  std::set<EdgeKey> of_caps;
  for (const Triangle& cap : mesh.cap_triangles) {
    for (std::size_t k = 0; k < 3; ++k) of_caps.insert(key_of(cap[k], cap[(k + 1) % 3]));
  }
  std::vector<EdgeKey> edges;
  for (const Triangle& triangle : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = key_of(triangle[k], triangle[(k + 1) % 3]);
      const Vector3 bulge = round_bulge(vector3(rest[a]), vector3(rest[b]), normals[a], normals[b], 0.5);
      if (length(bulge) > least && !of_caps.contains({a, b})) edges.emplace_back(a, b);
    }
  }
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

/// Makes the surface finer point by point.
class Refinement {
 public:
  explicit Refinement(const std::shared_ptr<const SnapshotTopology>& mesh)
      : surface_{.mesh = mesh, .topology = mesh, .points = {}, .parts = {}},
        finer_(std::make_shared<SnapshotTopology>(*mesh)) {
    // The rest shapes are told by the positions here.
    finer_->rest_metric.clear();
  }

  bool has(EdgeKey edge) const { return curved_.contains(edge); }

  void add(CurvePoint edge, std::uint32_t pieces) {
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t k = 1; k < pieces; ++k) {
      edge.part = static_cast<double>(k) / pieces;
      numbers.push_back(static_cast<std::uint32_t>(finer_->rest_positions.size()));
      surface_.points.push_back(edge);
      finer_->rest_positions.push_back(
          between(finer_->rest_positions[edge.start], finer_->rest_positions[edge.end], edge.part));
      if (!finer_->cut_times.empty()) finer_->cut_times.push_back(cut_time(edge));
    }
    if (edge.start > edge.end) std::ranges::reverse(numbers);
    curved_.emplace(key_of(edge.start, edge.end), std::move(numbers));
  }

  SmoothSurface result() && {
    if (surface_.points.empty()) return unsmoothed_surface(surface_.mesh);
    const SnapshotTopology& mesh = *surface_.mesh;
    finer_->triangles.clear();
    finer_->thickness.clear();
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      split_triangle(mesh.triangles[t], points_along(mesh.triangles[t]), pieces_);
      for (const SplitTriangle& piece : pieces_) {
        finer_->triangles.push_back(piece.vertices);
        surface_.parts.push_back({.triangle = t, .corners = piece.weights});
        if (t < mesh.thickness.size()) finer_->thickness.push_back(mesh.thickness[t]);
      }
    }
    surface_.topology = std::move(finer_);
    return std::move(surface_);
  }

 private:
  float cut_time(const CurvePoint& point) const {
    if (!point.is_lip) return kNeverCut;
    const float start = finer_->cut_times[point.start], end = finer_->cut_times[point.end];
    if (start == kNeverCut || end == kNeverCut) return std::max(start, end);
    return static_cast<float>((1 - point.part) * start + point.part * end);
  }

  std::array<std::vector<std::uint32_t>, 3> points_along(const Triangle& triangle) const {
    std::array<std::vector<std::uint32_t>, 3> points;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = triangle[k], to = triangle[(k + 1) % 3];
      const auto found = curved_.find(key_of(from, to));
      if (found == curved_.end()) continue;
      points[k] = found->second;
      if (from > to) std::ranges::reverse(points[k]);
    }
    return points;
  }

  SmoothSurface surface_;
  std::shared_ptr<SnapshotTopology> finer_;
  CurvedEdges curved_;
  std::vector<SplitTriangle> pieces_;
};

}  // namespace

SmoothSurface unsmoothed_surface(const std::shared_ptr<const SnapshotTopology>& mesh) {
  SmoothSurface surface{.mesh = mesh, .topology = mesh, .points = {}, .parts = {}};
  for (std::uint32_t t = 0; t < mesh->triangles.size(); ++t) surface.parts.push_back({.triangle = t});
  return surface;
}

SmoothSurface smooth_surface(const std::shared_ptr<const SnapshotTopology>& mesh, std::span<const BorderEdge> borders,
                             std::span<const char> is_lip, bool rounds_walls) {
  Refinement refinement(mesh);
  if (std::ranges::any_of(is_lip, [](char lip) { return lip != 0; })) {
    const std::vector<std::uint32_t> next = next_along(is_lip, borders, false);
    const std::vector<std::uint32_t> previous = next_along(is_lip, borders, true);
    for (const auto& [start, end, triangle] : borders) {
      if (!is_lip[start] || !is_lip[end]) continue;
      refinement.add({.start = start, .end = end, .is_lip = true, .before = previous[start], .after = next[end]},
                     kLipPieces);
    }
  }
  if (!rounds_walls) return std::move(refinement).result();
  for (const auto& [start, end] : round_edges(*mesh)) {
    if (!refinement.has({start, end})) refinement.add({.start = start, .end = end}, kEdgePieces);
  }
  return std::move(refinement).result();
}

std::vector<Float3> smooth_positions(const SmoothSurface& surface, std::span<const Float3> positions) {
  std::vector<Float3> finer(positions.begin(), positions.end());
  std::vector<Vector3> normals;
  if (!std::ranges::all_of(surface.points, &CurvePoint::is_lip)) {
    normals = vertex_normals(positions, surface.mesh->triangles);
  }
  finer.reserve(positions.size() + surface.points.size());
  for (const CurvePoint& point : surface.points) {
    if (point.is_lip) {
      finer.push_back(float3(on_lip(point, positions)));
      continue;
    }
    const Vector3 start = vector3(positions[point.start]), end = vector3(positions[point.end]);
    const Vector3 bulge = round_bulge(start, end, normals[point.start], normals[point.end], point.part);
    finer.push_back(float3(off_edge((1 - point.part) * start + point.part * end, bulge, length(end - start))));
  }
  return finer;
}

WoundMap refined(WoundMap map, const SmoothSurface& surface) {
  for (const CurvePoint& point : surface.points) {
    const std::uint32_t nearer = map.from_lip[point.start] <= map.from_lip[point.end] ? point.start : point.end;
    const bool nearer_end = map.from_end[point.start] <= map.from_end[point.end];
    map.lip.push_back(point.is_lip ? static_cast<std::uint32_t>(map.lip.size()) : map.lip[nearer]);
    map.end_of.push_back(map.end_of[nearer_end ? point.start : point.end]);
  }
  map.from_lip = refined(std::move(map.from_lip), surface);
  map.from_end = refined(std::move(map.from_end), surface);
  return map;
}

}  // namespace thinwall
