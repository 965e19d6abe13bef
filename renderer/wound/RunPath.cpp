#include "renderer/wound/RunPath.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "renderer/snapshot/HalfEdges.hpp"
#include "renderer/wound/RestNormals.hpp"

namespace thinwall {
namespace {

constexpr double kLeastSlope = 0.25;  // sine; flatter, a drop stays
constexpr double kUnder = 0.75;       // cosine between the outside and down, from where it drips
constexpr double kInertia = 0.6;      // of the sense in which it already runs
constexpr double kMostRise = 0.1;     // sine; steeper, what is pushed out does not go up

/// A run finds its way between what it wets and what it does not: it swerves from the slope, in long and short bends.
struct Bend {
  double angle = 0;   // radians, at most
  double length = 0;  // metres
  double turns = 0;   // by which runs differ, times their chance
};
constexpr std::array kBends = {Bend{.angle = 0.34, .length = 0.0105, .turns = 1},
                               Bend{.angle = 0.22, .length = 0.0041, .turns = 3}};
constexpr double kStraight = 0.003;  // metres, over which it begins to swerve

/// The stress-free wall as runs follow it.
struct Slope {
  const SnapshotTopology& topology;
  std::vector<Float3> normals;                         // (vertices), of length one, outward
  std::vector<std::array<std::uint32_t, 3>> opposite;  // (triangles), across the edge that faces each corner
};

std::vector<std::array<std::uint32_t, 3>> opposite_triangles(const std::vector<Triangle>& triangles) {
  const HalfEdges halves({triangles});
  std::vector<std::array<std::uint32_t, 3>> opposite;
  opposite.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles) {
    opposite.push_back({halves.triangle_of(c, b), halves.triangle_of(a, c), halves.triangle_of(b, a)});
  }
  return opposite;
}

/// What the weights of a triangle change by along `way`, which is brought into its plane.
Double3 weights_along(const Slope& slope, std::uint32_t triangle, Vector3 way) {
  const Triangle& corners = slope.topology.triangles[triangle];
  const Vector3 a = vector3(slope.topology.rest_positions[corners[0]]);
  const Vector3 u = vector3(slope.topology.rest_positions[corners[1]]) - a;
  const Vector3 v = vector3(slope.topology.rest_positions[corners[2]]) - a;
  const Vector3 area = cross(u, v);
  const double squared = dot(area, area);
  if (!(squared > 0)) return {0, 0, 0};
  const double second = dot(cross(way, v), area) / squared, third = dot(cross(u, way), area) / squared;
  return {-second - third, second, third};
}

/// Moves a place along `way` over the edges that it meets. False where the wall ends.
bool move(const Slope& slope, WallPlace& place, Vector3 way) {
  double left = 1;
  for (int crossings = 0; crossings < 32; ++crossings) {
    const Double3 change = weights_along(slope, place.triangle, way);
    double reach = left;
    std::size_t leaves = 3;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!(change[k] < 0) || place.weights[k] + reach * change[k] >= 0) continue;
      reach = std::max(0.0, -place.weights[k] / change[k]);
      leaves = k;
    }
    for (std::size_t k = 0; k < 3; ++k) place.weights[k] = std::max(0.0, place.weights[k] + reach * change[k]);
    if (leaves == 3) return true;
    left -= reach;
    const std::uint32_t next = slope.opposite[place.triangle][leaves];
    if (next == HalfEdges::kNone) return false;
    const Triangle &from = slope.topology.triangles[place.triangle], &to = slope.topology.triangles[next];
    Double3 weights = {0, 0, 0};
    for (std::size_t k = 0; k < 3; ++k) {
      if (k == leaves) continue;
      weights[static_cast<std::size_t>(std::ranges::find(to, from[k]) - to.begin())] = place.weights[k];
    }
    place = {.triangle = next, .corners = to, .weights = weights};
  }
  return false;
}

/// Radians by which a run of that `chance` has turned off the slope after `along` metres.
double swerve(double along, double chance) {
  double angle = 0;
  for (const Bend& bend : kBends) {
    angle += bend.angle * std::sin(2 * std::numbers::pi * (along / bend.length + bend.turns * chance));
  }
  return std::min(1.0, along / kStraight) * angle;
}

/// How much what is pushed out gives way to a slope that is not steep enough for it to run down by itself.
constexpr double kGivesWay = 1.5;

/// Radians off the way straight from the lip, which what is pushed out may take: also a slit across the ridge of an
/// organ lets it out to its sides.
constexpr std::array kTurns = {0.0, 0.7, -0.7, 1.4, -1.4};

/// The way over level wall on which a lip pushes, to where the wall falls. It gives way to what slope there is. Empty
/// where it finds none within `push` metres. `place`: from there, and where it ends.
std::vector<WallPlace> push_over(const Slope& slope, WallPlace& place, Vector3 down, double push, Vector3 away) {
  std::vector<WallPlace> path = {place};
  const auto steps = static_cast<std::size_t>(push / kRunStep);
  for (;;) {
    const Vector3 normal = normalized(point_at(place, slope.normals));
    const Vector3 fall = down - dot(down, normal) * normal;
    if (length(fall) >= kLeastSlope || dot(down, normal) >= 0) return path;
    const Vector3 straight = normalized(away - dot(away, normal) * normal);
    if (path.size() > steps || dot(fall, straight) < -kMostRise) return {};
    if (!move(slope, place, kRunStep * normalized(straight + kGivesWay * fall))) return {};
    path.push_back(place);
  }
}

/// The shortest of such ways.
std::vector<WallPlace> pushed_out(const Slope& slope, WallPlace& place, Vector3 down, double push, Vector3 away) {
  const Vector3 aside = cross(normalized(point_at(place, slope.normals)), away);
  std::vector<WallPlace> shortest;
  WallPlace end = place;
  for (const double turn : kTurns) {
    WallPlace reached = place;
    std::vector<WallPlace> path = push_over(slope, reached, down, push, std::cos(turn) * away + std::sin(turn) * aside);
    if (path.empty() || (!shortest.empty() && path.size() >= shortest.size())) continue;
    shortest = std::move(path);
    end = reached;
  }
  place = end;
  return shortest;
}

/// Sine of the slope that counts as much as the sense from the lip.
constexpr double kSpreadSlope = 0.12;

/// What wells over a lip where the wall is level: away from it at first, then also along what slope there is, farther
/// here than there by `chance`. Empty where it does not come over, or the lip is on the upper side of the wound.
/// `place`: from there, and where it ends.
std::vector<WallPlace> creep(const Slope& slope, WallPlace& place, Vector3 down, double level, Vector3 away,
                             double chance) {
  constexpr double kLeastChance = 0.35;
  constexpr double kOverLip = 0.002;     // metres, over which it turns from the lip to where it spreads
  constexpr double kLeastCosine = 0.45;  // between both
  // Lips that lie opposite each other have the same chance: over one of them it comes, here and there another one.
  constexpr Vector3 kOneSide = {0.31, -0.95, 0.1};
  const bool is_over_one_side = std::fmod(16 * chance, 1.0) < 0.5;
  if (chance < kLeastChance || is_over_one_side != (dot(away, kOneSide) > 0)) return {};
  std::vector<WallPlace> path = {place};
  for (double along = 0; along < level * chance; along += kRunStep) {
    const Vector3 normal = normalized(point_at(place, slope.normals));
    const Vector3 fall = down - dot(down, normal) * normal;
    if (length(fall) >= kLeastSlope) break;
    const Vector3 spread = normalized(fall + kSpreadSlope * normalized(away - dot(away, normal) * normal));
    if (along == 0 && dot(away, spread) < kLeastCosine) return {};
    const double at_lip = std::exp(-along / kOverLip), angle = swerve(along, chance);
    const Vector3 ahead = normalized(at_lip * away + (1 - at_lip) * spread);
    if (!move(slope, place, kRunStep * (std::cos(angle) * ahead + std::sin(angle) * cross(normal, ahead)))) break;
    path.push_back(place);
  }
  return path;
}

/// How a run goes; along nothing where neither push nor creeping brings it on.
struct RunWay {
  std::vector<WallPlace> path;
  Vector3 falls;        // where it comes to a slope or ends
  bool creeps = false;  // first
};

/// From a lip on, pushed `away` from it while the wall is level, or creeping over that.
RunWay follow(const Slope& slope, WallPlace place, Vector3 down, const RunReach& reach, Vector3 away, double chance) {
  RunWay way{.path = pushed_out(slope, place, down, reach.push, away), .falls = {}};
  way.creeps = way.path.empty() && reach.level > 0;
  if (way.creeps) way.path = creep(slope, place, down, reach.level, away, chance);
  std::vector<WallPlace>& path = way.path;
  if (path.empty()) return way;
  way.falls = point_at(place, slope.topology.rest_positions);
  const std::size_t level = path.size();
  Vector3 sense = level > 1 ? normalized(point_at(path[level - 1], slope.topology.rest_positions) -
                                         point_at(path[level - 2], slope.topology.rest_positions))
                            : Vector3{};
  while (static_cast<double>(path.size()) * kRunStep < reach.longest) {
    const Vector3 normal = normalized(point_at(place, slope.normals));
    const Vector3 fall = down - dot(down, normal) * normal;
    if (length(fall) < kLeastSlope || dot(down, normal) > kUnder) break;
    const double angle = swerve(static_cast<double>(path.size() - 1) * kRunStep, chance);
    const Vector3 ahead = normalized(fall);
    sense = normalized(std::cos(angle) * ahead + std::sin(angle) * cross(normal, ahead) + kInertia * sense);
    if (!move(slope, place, kRunStep * sense)) break;
    path.push_back(place);
  }
  return way;
}

/// 0 to 1, from the place alone.
double chance_of(const Float3& place) {
  std::uint32_t bits = 2166136261U;
  for (const float part : place) {
    bits = (bits ^ static_cast<std::uint32_t>(std::lround(1e6F * part))) * 16777619U;
    bits ^= bits >> 15U;
  }
  bits *= 2246822519U;
  return static_cast<double>(bits >> 8U) / 16777216.0;
}

WallPlace middle_of(const BorderEdge& edge, const SnapshotTopology& topology) {
  WallPlace place{.triangle = edge.triangle, .corners = topology.triangles[edge.triangle], .weights = {0, 0, 0}};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t vertex = place.corners[k];
    place.weights[k] = vertex == edge.start || vertex == edge.end ? 0.5 : 0;
  }
  return place;
}

/// From the middle of a lip into its triangle.
Vector3 away_from(const BorderEdge& edge, const SnapshotTopology& topology) {
  const Vector3 start = vector3(topology.rest_positions[edge.start]), end = vector3(topology.rest_positions[edge.end]);
  Vector3 inner;
  for (const std::uint32_t corner : topology.triangles[edge.triangle]) {
    if (corner != edge.start && corner != edge.end) inner = vector3(topology.rest_positions[corner]);
  }
  const Vector3 along = normalized(end - start), way = inner - start;
  return normalized(way - dot(way, along) * along);
}

/// Not beside an end from which the cut may go on: what lies there now will lie farther off.
bool is_near_begin(const BorderEdge& lip, const RunReach& reach) {
  if (reach.map == nullptr) return false;
  const auto is_near = [&](std::uint32_t vertex) {
    const double way = reach.map->from_end[vertex];
    return way < reach.off_begin && !(reach.map->ends[reach.map->end_of[vertex]].speed > 0);
  };
  return is_near(lip.start) || is_near(lip.end);
}

bool is_near_an_end(const BorderEdge& lip, const RunReach& reach) {
  if (reach.map == nullptr) return false;
  return std::min(reach.map->from_end[lip.start], reach.map->from_end[lip.end]) < reach.off_ends;
}

/// A lip, and when it was cut, seconds.
using TimedLip = std::pair<double, std::size_t>;

/// When the cut that came to the first of these had gone on by `off` metres; as long as it has not, when it came there.
double left_behind(const SnapshotTopology& topology, std::span<const BorderEdge> borders,
                   std::span<const TimedLip> lips, double off) {
  const auto middle = [&](const TimedLip& lip) {
    return point_at(middle_of(borders[lip.second], topology), topology.rest_positions);
  };
  const Vector3 place = middle(lips.front());
  const auto later =
      std::ranges::find_if(lips, [&](const TimedLip& lip) { return length(middle(lip) - place) >= off; });
  return later == lips.end() ? lips.front().first : later->first;
}

/// Where a run may begin.
struct LipPoint {
  Vector3 place;  // stress-free
  Vector3 away;   // from the wound
  Vector3 falls;  // where its run comes to a slope, stress-free

  bool is_near(const LipPoint& other, double spacing) const { return length(other.place - place) < spacing; }

  /// The opposite lip, whose runs go the other way, is not beside it.
  bool is_beside(const LipPoint& other, double spacing) const {
    return is_near(other, spacing) && dot(other.away, away) > -0.5;
  }

  /// What both lips of a small hole let out to the same side runs together.
  bool runs_into(const LipPoint& other, double spacing) const {
    return length(other.place - place) < spacing && length(other.falls - falls) < 0.5 * spacing;
  }
};

}  // namespace

Vector3 point_at(const WallPlace& place, std::span<const Float3> points) {
  Vector3 sum;
  for (std::size_t k = 0; k < 3; ++k) sum = sum + place.weights[k] * vector3(points[place.corners[k]]);
  return sum;
}

std::vector<FluidRun> find_runs(const SnapshotTopology& topology, std::span<const BorderEdge> borders,
                                std::span<const char> is_lip, Vector3 down, const RunReach& reach) {
  if (topology.cut_times.empty()) return {};
  std::vector<TimedLip> lips;
  for (std::size_t k = 0; k < borders.size(); ++k) {
    const auto& [start, end, triangle] = borders[k];
    if (is_lip[start] && is_lip[end])
      lips.emplace_back(std::max(topology.cut_times[start], topology.cut_times[end]), k);
  }
  if (lips.empty()) return {};
  std::ranges::sort(lips);
  const Slope slope{
      .topology = topology, .normals = rest_normals(topology), .opposite = opposite_triangles(topology.triangles)};
  std::vector<FluidRun> runs;
  std::vector<LipPoint> taken;
  for (auto next = lips.begin(); next != lips.end(); ++next) {
    const std::size_t k = next->second;
    if (is_near_an_end(borders[k], reach)) continue;
    const WallPlace start = middle_of(borders[k], topology);
    LipPoint lip{
        .place = point_at(start, topology.rest_positions), .away = away_from(borders[k], topology), .falls = {}};
    if (std::ranges::any_of(taken, [&](const LipPoint& other) { return lip.is_beside(other, reach.spacing); }))
      continue;
    const double chance = chance_of(topology.rest_positions[borders[k].start]);
    RunWay way = follow(slope, start, down, reach, lip.away, chance);
    if (way.path.size() < 4 || (way.creeps && is_near_begin(borders[k], reach))) continue;
    lip.falls = way.falls;
    if (way.creeps &&
        std::ranges::any_of(taken, [&](const LipPoint& other) { return lip.is_near(other, reach.spacing); }))
      continue;
    if (std::ranges::any_of(taken, [&](const LipPoint& other) { return lip.runs_into(other, reach.spacing); }))
      continue;
    taken.push_back(lip);
    runs.push_back({.path = std::move(way.path),
                    .born = left_behind(topology, borders, {next, lips.end()}, reach.off_ends),
                    .chance = chance,
                    .creeps = way.creeps});
  }
  return runs;
}

}  // namespace thinwall
