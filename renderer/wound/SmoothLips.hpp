#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "renderer/snapshot/BorderEdges.hpp"
#include "renderer/wound/WoundMap.hpp"

namespace thinwall {

/// A place on the curve that a cut's lip is drawn as, between two of its vertices.
struct LipPoint {
  static constexpr std::uint32_t kNone = 0xffffffff;
  std::uint32_t before = kNone, start = 0, end = 0,
                after = kNone;  // vertices along the lip, kNone where it forks or ends
  double part = 0;              // of the way from `start` to `end`
};

inline constexpr std::uint32_t kLipPieces = 4;  // that an edge of a lip is drawn as

/// A triangle at a lip that is drawn as several, from the corner opposite the lip.
struct LipFan {
  std::uint32_t triangle = 0;  // of the given surface, and the number of the first piece
  std::uint32_t corner = 0;    // of that triangle, where the lip's edge starts: 0, 1 or 2
  std::uint32_t added = 0;     // number of the second piece; the others follow
};

/// A surface whose lips are finer, so that they can be drawn as curves instead of as the edges of the mesh.
struct SmoothLips {
  /// Its vertices are those of the given surface and, after them, one for each of `points`. A triangle at a lip is
  /// several from its opposite corner, of which the first keeps its number; each has the lip's points as its first two
  /// corners.
  std::shared_ptr<const SnapshotTopology> topology;
  std::vector<LipPoint> points;
  std::vector<LipFan> fans;
};

/// Kept as it is where nothing is cut: no `points`, and the given topology. `borders`, `is_lip`: what border_edges and
/// cut_lips give.
SmoothLips smooth_lips(const std::shared_ptr<const SnapshotTopology>& topology, std::span<const BorderEdge> borders,
                       std::span<const char> is_lip);

/// `positions` (metres) and those of the points: on a curve that passes through the lip's vertices and turns evenly
/// there (Hermite's, its tangents those of the circle through a vertex and its neighbours). It leaves the edge by no
/// more than a fifth of its length, and stays with it where the lip turns sharply, as at the ends of a cut.
std::vector<Float3> smooth_positions(const SmoothLips& lips, std::span<const Float3> positions);

/// What the map of the given surface says of the finer one.
WoundMap refined(WoundMap map, const SmoothLips& lips);

/// Likewise for a number of each vertex: between those of an edge's ends.
template <typename Number>
std::vector<Number> refined(std::vector<Number> values, const SmoothLips& lips) {
  for (const LipPoint& point : lips.points) {
    values.push_back(static_cast<Number>((1 - point.part) * values[point.start] + point.part * values[point.end]));
  }
  return values;
}

}  // namespace thinwall
