#include "engine/cutting/SurfaceTrace.hpp"

#include <Eigen/Geometry>
#include <numeric>
#include <utility>

#include "engine/cutting/PlaneSection.hpp"
#include "engine/cutting/SurfaceNormals.hpp"
#include "engine/cutting/TraceGraph.hpp"

namespace thinwall {
namespace {

/// Points nearer to each other than this, of the largest coordinate, are the same.
constexpr double kSamePoint = 1e-12;

/// Sines below this do not tell a plane apart from its neighbours.
constexpr double kNoPlane = 1e-4;

/// A triangle in which two points lie, on its edges and corners included; -1 when there is none.
int common_triangle(const SurfaceView& surface, const SurfacePoint& one, const SurfacePoint& other) {
  if (lies_in(surface, other, one.triangle)) return one.triangle;
  if (lies_in(surface, one, other.triangle)) return other.triangle;
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
    if (lies_in(surface, one, t) && lies_in(surface, other, t)) return t;
  }
  return -1;
}

/// Grows the pieces of a trace point by point and leaves out points that repeat the one before.
class PieceBuilder {
 public:
  explicit PieceBuilder(const SurfaceView& surface) : surface_(surface), same_(kSamePoint * scale_of(surface)) {}

  /// `triangle`: in which this point and the one before lie. A `kept` point stays, whatever stands beside it.
  void add(const SurfacePoint& point, int triangle, bool kept) {
    const Eigen::Vector3d position = position_of(surface_, point);
    // Where one of two points in the same place may go, both triangles beside the one that stays must have it.
    if (places_.size() > 1 && !kept_.back() && repeats(places_[places_.size() - 2], places_.back()) &&
        lies_in(surface_, piece_.points[piece_.points.size() - 2], triangle)) {
      drop_last();
    } else if (places_.size() > 1 && !kept_.back() && repeats(position, places_.back()) &&
               lies_in(surface_, point, piece_.triangles.back())) {
      triangle = piece_.triangles.back();
      drop_last();
    }
    if (!places_.empty()) piece_.triangles.push_back(triangle);
    has_length_ = has_length_ || (!places_.empty() && !repeats(position, places_.front()));
    piece_.points.push_back(point);
    places_.push_back(position);
    kept_.push_back(kept);
  }

  /// Ends the piece. One without length shrinks to its point `stays`, or is left out without one.
  void close(const SurfacePoint* stays) {
    if (has_length_) {
      pieces.push_back(std::move(piece_));
    } else if (stays != nullptr) {
      pieces.push_back({.points = {*stays}, .triangles = {}});
    }
    piece_ = {};
    places_.clear();
    kept_.clear();
    has_length_ = false;
  }

  std::vector<SurfaceCurve> pieces;

 private:
  bool repeats(const Eigen::Vector3d& one, const Eigen::Vector3d& other) const { return (one - other).norm() <= same_; }

  void drop_last() {
    piece_.points.pop_back();
    piece_.triangles.pop_back();
    places_.pop_back();
    kept_.pop_back();
  }

  const SurfaceView& surface_;
  double same_;  // metres
  SurfaceCurve piece_;
  std::vector<Eigen::Vector3d> places_;  // (points of the piece)
  std::vector<bool> kept_;               // (points of the piece)
  bool has_length_ = false;
};

/// The pieces of a way along legs.
std::vector<SurfaceCurve> pieces_of(const SurfaceView& surface, const std::vector<SurfaceCurve>& curves,
                                    const std::vector<TraceLeg>& legs, const SurfacePoint& from,
                                    const SurfacePoint& to) {
  PieceBuilder builder(surface);
  builder.add(from, -1, true);
  for (const TraceLeg& leg : legs) {
    if (leg.curve < 0) {
      builder.close(builder.pieces.empty() ? &from : nullptr);
      continue;
    }
    const SurfaceCurve& curve = curves[leg.curve];
    const int size = static_cast<int>(curve.points.size()), segments = static_cast<int>(curve.triangles.size());
    int triangle = leg.triangle_at_from;
    for (int k = 0; k < leg.count; ++k) {
      const int index = (leg.first + leg.step * k + size) % size;
      const bool at_lip = (k == 0 && leg.from != kBegin) || (k + 1 == leg.count && leg.to != kEnd);
      builder.add(curve.points[index], triangle, at_lip);
      // The segment that comes next, which on the way back is the one before the point.
      const int segment = leg.step > 0 ? index : index - 1 + segments;
      if (k + 1 < leg.count) triangle = curve.triangles[segment % segments];
    }
    if (leg.to == kEnd) builder.add(to, leg.triangle_at_to, true);
  }
  builder.close(&to);
  return std::move(builder.pieces);
}

double length_of(const std::vector<TraceLeg>& legs) {
  return std::accumulate(legs.begin(), legs.end(), 0.0, [](double sum, const TraceLeg& leg) { return sum + leg.cost; });
}

}  // namespace

SurfacePoint snapped_to_edges(const SurfaceView& surface, SurfacePoint point) {
  const double least = kSamePoint * scale_of(surface);
  const Eigen::Vector3i& vertices = surface.triangles[point.triangle];
  const auto corner = [&](int k) -> Eigen::Vector3d { return surface.position.segment<3>(3 * vertices[k % 3]); };
  const double area = (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm();
  for (int k = 0; k < 3; ++k) {
    const double side = (corner(k + 2) - corner(k + 1)).norm();
    if (point.weights[k] * area <= least * side) point.weights[k] = 0;
  }
  point.weights /= point.weights.sum();
  return point;
}

SurfaceTrace trace(const SurfaceView& surface, const SurfacePoint& from, const SurfacePoint& to) {
  const SurfacePoint begin = snapped_to_edges(surface, from), end = snapped_to_edges(surface, to);
  const Eigen::Vector3d start = position_of(surface, begin), way = position_of(surface, end) - start;
  if (way.norm() <= kSamePoint * scale_of(surface)) return {.pieces = {{.points = {begin}, .triangles = {}}}};
  if (const int triangle = common_triangle(surface, begin, end); triangle >= 0) {
    return {.pieces = {{.points = {begin, end}, .triangles = {triangle}}}};
  }
  const Eigen::Vector3d mean = smooth_normal(surface, begin) + smooth_normal(surface, end);
  const Eigen::Vector3d across = way.normalized().cross(mean);
  if (across.norm() < kNoPlane) return {.pieces = {}, .refusal = TraceRefusal::kAlongNormal};
  const CuttingPlane plane{.point = start, .normal = across.normalized()};
  std::vector<SurfaceCurve> best_curves;
  std::vector<TraceLeg> best;
  for (const PlaneTies ties : {PlaneTies::kInFront, PlaneTies::kBehind}) {
    std::vector<SurfaceCurve> curves = plane_section(surface, plane, ties);
    const std::vector<TraceLeg> legs = shortest_legs(surface, curves, begin, end);
    if (legs.empty() || (!best.empty() && length_of(legs) >= length_of(best))) continue;
    best = legs;
    best_curves = std::move(curves);
  }
  if (best.empty()) return {.pieces = {}, .refusal = TraceRefusal::kNotJoined};
  return {.pieces = pieces_of(surface, best_curves, best, begin, end)};
}

}  // namespace thinwall
