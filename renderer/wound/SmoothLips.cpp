#include "renderer/wound/SmoothLips.hpp"

#include <algorithm>
#include <utility>

#include "renderer/picture/Float3.hpp"
#include "renderer/picture/Vector.hpp"

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
  std::vector<std::uint32_t> next(is_lip.size(), LipPoint::kNone);
  std::vector<int> counts(is_lip.size(), 0);
  for (const BorderEdge& edge : borders) {
    const auto [from, to] = backwards ? std::pair{edge.end, edge.start} : std::pair{edge.start, edge.end};
    next[from] = to;
    ++counts[from];
  }
  for (std::size_t v = 0; v < next.size(); ++v) {
    if (counts[v] != 1 || !is_lip[next[v]]) next[v] = LipPoint::kNone;
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

Vector3 on_curve(const LipPoint& point, std::span<const Float3> positions) {
  const Vector3 start = vector3(positions[point.start]), end = vector3(positions[point.end]);
  const auto neighbour = [&](std::uint32_t vertex) { return vertex == LipPoint::kNone ? nullptr : &positions[vertex]; };
  const double edge = length(end - start), s = point.part;
  const Vector3 leaves = edge * tangent_at(start, end, neighbour(point.before), 1);
  const Vector3 arrives = edge * tangent_at(end, start, neighbour(point.after), -1);
  const Vector3 straight = (1 - s) * start + s * end;
  const Vector3 curve = (1 + 2 * s) * (1 - s) * (1 - s) * start + s * (1 - s) * (1 - s) * leaves +
                        s * s * (3 - 2 * s) * end - s * s * (1 - s) * arrives;
  const Vector3 bulge = curve - straight;
  const double most = kMostBulge * edge, size = length(bulge);
  return straight + (size > most ? most / size : 1.0) * bulge;
}

/// The same for both lips of a cut, to the last bit.
Float3 between(const Float3& a, const Float3& b, double part) {
  Float3 result{};
  for (std::size_t k = 0; k < 3; ++k) {
    result[k] = static_cast<float>((1 - part) * static_cast<double>(a[k]) + part * static_cast<double>(b[k]));
  }
  return result;
}

/// Cuts the triangle beside `edge` into a fan whose outer corners are the edge's ends and the points from `first` on.
LipFan append_fan(const BorderEdge& edge, std::uint32_t first, SnapshotTopology& topology) {
  Triangle& triangle = topology.triangles[edge.triangle];
  const auto corner = static_cast<std::uint32_t>(std::ranges::find(triangle, edge.start) - triangle.begin());
  const std::uint32_t apex = triangle[(corner + 2) % 3];
  const LipFan fan{
      .triangle = edge.triangle, .corner = corner, .added = static_cast<std::uint32_t>(topology.triangles.size())};
  triangle = {edge.start, first, apex};
  for (std::uint32_t k = 1; k < kLipPieces; ++k) {
    const std::uint32_t from = first + k - 1, to = k + 1 < kLipPieces ? from + 1 : edge.end;
    topology.triangles.push_back({from, to, apex});
    if (edge.triangle < topology.thickness.size()) topology.thickness.push_back(topology.thickness[edge.triangle]);
  }
  return fan;
}

}  // namespace

SmoothLips smooth_lips(const std::shared_ptr<const SnapshotTopology>& topology, std::span<const BorderEdge> borders,
                       std::span<const char> is_lip) {
  SmoothLips lips{.topology = topology, .points = {}, .fans = {}};
  if (std::ranges::none_of(is_lip, [](char lip) { return lip != 0; })) return lips;
  auto finer = std::make_shared<SnapshotTopology>(*topology);
  // The rest shapes are told by the positions here.
  finer->rest_metric.clear();
  const std::vector<std::uint32_t> next = next_along(is_lip, borders, false);
  const std::vector<std::uint32_t> previous = next_along(is_lip, borders, true);
  std::vector<char> is_done(topology->triangles.size(), 0);
  for (const BorderEdge& edge : borders) {
    // A triangle with two edges at lips is a fan from one corner only.
    if (!is_lip[edge.start] || !is_lip[edge.end] || is_done[edge.triangle]) continue;
    is_done[edge.triangle] = 1;
    const auto first = static_cast<std::uint32_t>(finer->rest_positions.size());
    for (std::uint32_t k = 1; k < kLipPieces; ++k) {
      const double part = static_cast<double>(k) / kLipPieces;
      lips.points.push_back({.before = previous[edge.start],
                             .start = edge.start,
                             .end = edge.end,
                             .after = next[edge.end],
                             .part = part});
      finer->rest_positions.push_back(
          between(topology->rest_positions[edge.start], topology->rest_positions[edge.end], part));
      if (topology->cut_times.empty()) continue;
      const float start = topology->cut_times[edge.start], end = topology->cut_times[edge.end];
      finer->cut_times.push_back(start == kNeverCut || end == kNeverCut
                                     ? std::max(start, end)
                                     : static_cast<float>((1 - part) * start + part * end));
    }
    lips.fans.push_back(append_fan(edge, first, *finer));
  }
  lips.topology = std::move(finer);
  return lips;
}

std::vector<Float3> smooth_positions(const SmoothLips& lips, std::span<const Float3> positions) {
  std::vector<Float3> finer(positions.begin(), positions.end());
  for (const LipPoint& point : lips.points) finer.push_back(float3(on_curve(point, positions)));
  return finer;
}

WoundMap refined(WoundMap map, const SmoothLips& lips) {
  for (const LipPoint& point : lips.points) {
    const std::uint32_t nearer = map.from_end[point.start] <= map.from_end[point.end] ? point.start : point.end;
    map.lip.push_back(static_cast<std::uint32_t>(map.lip.size()));
    map.from_lip.push_back(0);
    map.end_of.push_back(map.end_of[nearer]);
  }
  map.from_end = refined(std::move(map.from_end), lips);
  return map;
}

}  // namespace thinwall
