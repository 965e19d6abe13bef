#pragma once

#include <vector>

#include "engine/cutting/SurfaceCurve.hpp"

namespace thinwall {

/// A run along a curve of a section, or over a gap.
struct TraceLeg {
  int from = 0, to = 0;       // stations, below
  double cost = 0;            // metres; of a gap three times its length
  int curve = -1;             // -1: a gap
  int first = 0, count = 0;   // points of the curve that are passed, from the index `first` on, `step` by `step`,
  int step = 1;               // wrapping around on a closed curve; the two points that are joined are not among them
  int triangle_at_from = -1;  // the triangle in which the station `from` and the first point lie, at kBegin
  int triangle_at_to = -1;    // likewise at kEnd
};

/// Stations: the two points that are joined, and four at the ends of each open curve, for a way that comes to an end
/// has to go on over a gap.
enum TraceStation { kBegin = 0, kEnd = 1, kFirstArrival = 2 };
constexpr int arrival_at(int curve, bool at_last) {
  return kFirstArrival + 4 * curve + (at_last ? 1 : 0);
}
constexpr int departure_from(int curve, bool at_last) {
  return arrival_at(curve, at_last) + 2;
}

/// The shortest chain of legs from `begin` to `end` along curves and over gaps; none when there is none.
std::vector<TraceLeg> shortest_legs(const SurfaceView& surface, const std::vector<SurfaceCurve>& curves,
                                    const SurfacePoint& begin, const SurfacePoint& end);

/// Whether a point lies in a closed triangle.
bool lies_in(const SurfaceView& surface, const SurfacePoint& point, int triangle);

}  // namespace thinwall
