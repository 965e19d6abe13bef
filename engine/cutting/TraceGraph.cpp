#include "engine/cutting/TraceGraph.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace thinwall {
namespace {

constexpr double kGapCost = 3;  // times the length of a gap
// Of the longest side at the lips, for any gap: at a cut's tip, where lips meet, no way need cross.
constexpr double kAnyGapCost = 1e-9;
constexpr double kForwards = 0.25;  // cosine of the largest angle between a curve and the gap that it crosses
constexpr double kOverlap = 0.5;    // of the longest side of a triangle at the lip: so far a gap may go backwards
constexpr double kNoWay = 1e-3;     // of that side: points of a curve nearer to its lip tell no direction

/// A curve with the positions of its points and the length along it.
struct MeasuredCurve {
  const SurfaceCurve* curve = nullptr;
  std::vector<Eigen::Vector3d> positions;
  std::vector<double> lengths;  // (points), metres from the first
  double whole = 0;             // metres, of a closed curve with the way back to the first point

  int size() const { return static_cast<int>(positions.size()); }
};

MeasuredCurve measured(const SurfaceView& surface, const SurfaceCurve& curve) {
  MeasuredCurve result{.curve = &curve, .positions = {}, .lengths = {}};
  for (const SurfacePoint& point : curve.points) {
    const Eigen::Vector3d position = position_of(surface, point);
    if (!result.positions.empty()) result.whole += (position - result.positions.back()).norm();
    result.positions.push_back(position);
    result.lengths.push_back(result.whole);
  }
  if (curve.closed) result.whole += (result.positions.front() - result.positions.back()).norm();
  return result;
}

/// All legs between the stations of a surface's section.
class LegFinder {
 public:
  LegFinder(const SurfaceView& surface, const std::vector<SurfaceCurve>& curves, const SurfacePoint& begin,
            const SurfacePoint& end)
      : surface_(surface), begin_(position_of(surface, begin)), end_(position_of(surface, end)) {
    for (const SurfaceCurve& curve : curves) curves_.push_back(measured(surface, curve));
    for (int c = 0; c < static_cast<int>(curves_.size()); ++c) add_curve(c, begin, end);
    add_gaps();
  }

  std::vector<TraceLeg> legs;

 private:
  std::vector<int> segments_at(const SurfacePoint& point, int c) const {
    std::vector<int> found;
    const std::vector<int>& triangles = curves_[c].curve->triangles;
    for (int k = 0; k < static_cast<int>(triangles.size()); ++k) {
      if (lies_in(surface_, point, triangles[k])) found.push_back(k);
    }
    return found;
  }

  void add_curve(int c, const SurfacePoint& begin, const SurfacePoint& end) {
    const MeasuredCurve& curve = curves_[c];
    const std::vector<int> begins = segments_at(begin, c), ends = segments_at(end, c);
    for (const int from : begins) {
      for (const int to : ends) add_between(c, from, to);
    }
    if (curve.curve->closed) return;
    add_whole(c);
    for (const int k : begins) add_outward(c, k);
    for (const int k : ends) add_inward(c, k);
  }

  /// Legs along a whole curve, both ways.
  void add_whole(int c) {
    const MeasuredCurve& curve = curves_[c];
    const int last = curve.size() - 1;
    add({.from = departure_from(c, false),
         .to = arrival_at(c, true),
         .cost = curve.whole,
         .curve = c,
         .first = 0,
         .count = last + 1});
    add({.from = departure_from(c, true),
         .to = arrival_at(c, false),
         .cost = curve.whole,
         .curve = c,
         .first = last,
         .count = last + 1,
         .step = -1});
  }

  /// Legs from the beginning, which lies at a segment of a curve, to both of the curve's ends.
  void add_outward(int c, int k) {
    const MeasuredCurve& curve = curves_[c];
    const double back = (begin_ - curve.positions[k]).norm() + curve.lengths[k];
    const double forth = (begin_ - curve.positions[k + 1]).norm() + curve.whole - curve.lengths[k + 1];
    const int triangle = curve.curve->triangles[k];
    add({.from = kBegin,
         .to = arrival_at(c, false),
         .cost = back,
         .curve = c,
         .first = k,
         .count = k + 1,
         .step = -1,
         .triangle_at_from = triangle});
    add({.from = kBegin,
         .to = arrival_at(c, true),
         .cost = forth,
         .curve = c,
         .first = k + 1,
         .count = curve.size() - 1 - k,
         .triangle_at_from = triangle});
  }

  /// Legs from both ends of a curve to the end, which lies at a segment of it.
  void add_inward(int c, int k) {
    const MeasuredCurve& curve = curves_[c];
    const int last = curve.size() - 1;
    const double forth = (end_ - curve.positions[k]).norm() + curve.lengths[k];
    const double back = (end_ - curve.positions[k + 1]).norm() + curve.whole - curve.lengths[k + 1];
    const int triangle = curve.curve->triangles[k];
    add({.from = departure_from(c, false),
         .to = kEnd,
         .cost = forth,
         .curve = c,
         .first = 0,
         .count = k + 1,
         .triangle_at_to = triangle});
    add({.from = departure_from(c, true),
         .to = kEnd,
         .cost = back,
         .curve = c,
         .first = last,
         .count = last - k,
         .step = -1,
         .triangle_at_to = triangle});
  }

  /// Legs between the two points on one curve, from a segment to another one.
  void add_between(int c, int from, int to) {
    const MeasuredCurve& curve = curves_[c];
    const bool closed = curve.curve->closed;
    const int size = curve.size();
    if (from == to) return;  // both in one triangle: joined without any section
    const auto add_way = [&](int first, int last, int step) {
      const int count = (step * (last - first) + size) % size + 1;
      double along = step * (curve.lengths[last] - curve.lengths[first]);
      if (along < 0) along += curve.whole;
      const double cost = (begin_ - curve.positions[first]).norm() + along + (end_ - curve.positions[last]).norm();
      add({.from = kBegin,
           .to = kEnd,
           .cost = cost,
           .curve = c,
           .first = first,
           .count = count,
           .step = step,
           .triangle_at_from = curve.curve->triangles[from],
           .triangle_at_to = curve.curve->triangles[to]});
    };
    if (closed || to > from) add_way((from + 1) % size, to, 1);
    if (closed || to < from) add_way(from, (to + 1) % size, -1);
  }

  /// Where a curve ends.
  struct Lip {
    int curve = 0;
    bool at_last = false;
    int arrival = 0, departure = 0;  // stations
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    double side = 0;  // metres, longest side of the triangle there
  };

  Lip lip_of(int c, bool at_last) const {
    const MeasuredCurve& curve = curves_[c];
    Lip lip{.curve = c, .at_last = at_last, .arrival = arrival_at(c, at_last), .departure = departure_from(c, at_last)};
    lip.position = at_last ? curve.positions.back() : curve.positions.front();
    const Eigen::Vector3i& vertices =
        surface_.triangles[at_last ? curve.curve->triangles.back() : curve.curve->triangles.front()];
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d side =
          surface_.position.segment<3>(3 * vertices[k]) - surface_.position.segment<3>(3 * vertices[(k + 1) % 3]);
      lip.side = std::max(lip.side, side.norm());
    }
    return lip;
  }

  /// Unit vector along which a curve leaves the surface, from the first point of it that is `reach` (metres) from the
  /// lip; zero without one.
  Eigen::Vector3d outward(const Lip& lip, double reach) const {
    const MeasuredCurve& curve = curves_[lip.curve];
    const int size = curve.size();
    for (int k = 1; k < size; ++k) {
      const Eigen::Vector3d way = lip.position - curve.positions[lip.at_last ? size - 1 - k : k];
      if (way.norm() >= reach) return way.normalized();
    }
    return Eigen::Vector3d::Zero();
  }

  bool leads_forwards(const Lip& from, const Lip& to, const Eigen::Vector3d& gap) const {
    const double length = gap.norm();
    const auto goes_on = [&](const Eigen::Vector3d& out, const Eigen::Vector3d& in) {
      return gap.dot(out) >= kForwards * length && gap.dot(in) >= kForwards * length;
    };
    // Points that follow each other closely, as around a vertex, tell no direction; a lip may be crumpled, which from
    // as far as the gap is wide is not seen.
    if (goes_on(outward(from, kNoWay * from.side), -outward(to, kNoWay * to.side))) return true;
    if (goes_on(outward(from, length), -outward(to, length))) return true;
    // All borders of a closed body are lips, which may hang in: then the two points tell the direction.
    const Eigen::Vector3d way = (end_ - begin_).stableNormalized();
    return !surface_.open && goes_on(way, way);
  }

  void add_gaps() {
    std::vector<Lip> lips;
    for (int c = 0; c < static_cast<int>(curves_.size()); ++c) {
      if (curves_[c].curve->closed) continue;
      lips.push_back(lip_of(c, false));
      lips.push_back(lip_of(c, true));
    }
    for (const Lip& from : lips) {
      for (const Lip& to : lips) {
        if (from.arrival == to.arrival) continue;
        const Eigen::Vector3d gap = to.position - from.position;
        const double length = gap.norm(), side = std::min(from.side, to.side);
        if (length > kOverlap * side && !leads_forwards(from, to, gap)) continue;
        add({.from = from.arrival, .to = to.departure, .cost = kGapCost * length + kAnyGapCost * side});
      }
    }
  }

  void add(const TraceLeg& leg) { legs.push_back(leg); }

  const SurfaceView& surface_;
  Eigen::Vector3d begin_, end_;
  std::vector<MeasuredCurve> curves_;
};

}  // namespace

bool lies_in(const SurfaceView& surface, const SurfacePoint& point, int triangle) {
  const Eigen::Vector3i &own = surface.triangles[point.triangle], &other = surface.triangles[triangle];
  for (int k = 0; k < 3; ++k) {
    if (point.weights[k] != 0 && (other.array() != own[k]).all()) return false;
  }
  return true;
}

std::vector<TraceLeg> shortest_legs(const SurfaceView& surface, const std::vector<SurfaceCurve>& curves,
                                    const SurfacePoint& begin, const SurfacePoint& end) {
  const std::vector<TraceLeg> legs = LegFinder(surface, curves, begin, end).legs;
  // Bellman and Ford: stations are few, and the order of the legs alone decides between ways of equal cost.
  const std::size_t stations = kFirstArrival + 4 * curves.size();
  std::vector<double> cost(stations, std::numeric_limits<double>::infinity());
  std::vector<int> via(stations, -1);
  cost[kBegin] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (int k = 0; k < static_cast<int>(legs.size()); ++k) {
      const double reached = cost[legs[k].from] + legs[k].cost;
      if (!(reached < cost[legs[k].to])) continue;
      cost[legs[k].to] = reached;
      via[legs[k].to] = k;
      changed = true;
    }
  }
  std::vector<TraceLeg> way;
  if (via[kEnd] < 0) return way;
  for (int station = kEnd; station != kBegin; station = legs[via[station]].from) way.push_back(legs[via[station]]);
  std::reverse(way.begin(), way.end());
  return way;
}

}  // namespace thinwall
