#include "engine/cutting/SweptSection.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "engine/cutting/ExactGrid.hpp"
#include "engine/cutting/SegmentChains.hpp"

namespace thinwall {
namespace {

/// The two triangles of the swept surface, whose corners are the ends of the edge at its first place and then at its
/// last, and their sides: the first edge, the way of its end, the diagonal, the way of its beginning, the
/// last edge.
constexpr std::array<std::array<int, 3>, 2> kTriangles = {{{0, 1, 3}, {0, 3, 2}}};
constexpr std::array<std::array<int, 2>, 5> kSides = {{{0, 1}, {1, 3}, {0, 3}, {0, 2}, {2, 3}}};
constexpr std::array<std::array<int, 3>, 2> kTriangleSides = {{{0, 1, 2}, {2, 4, 3}}};

/// A triangle that is thinner than this over its whole length, in units of the grid, sweeps nothing.
constexpr double kThin = 8;

/// Where wall and blade meet.
struct Meeting {
  SurfacePoint point;
  double motion = 0, along = 0;
};

double to_double(WideInteger value) {
  return static_cast<double>(value);
}

/// A wall triangle in the grid.
struct GridTriangle {
  int index = 0;
  Eigen::Vector3i vertices = Eigen::Vector3i::Zero();
  std::array<GridPoint, 3> corners;
};

/// The swept surface against one wall.
class Sweep {
 public:
  Sweep(const ExactGrid& grid, const std::array<Eigen::Vector3d, 4>& corners) {
    for (int k = 0; k < 4; ++k) corners_[k] = grid.at(corners[k]);
    for (int k = 0; k < 2; ++k) {
      const auto [a, b, c] = kTriangles[k];
      const auto normal = cross(corners_[a], corners_[b], corners_[a], corners_[c]);
      const Eigen::Vector3d area(to_double(normal[0]), to_double(normal[1]), to_double(normal[2]));
      double longest = 0;
      for (const int side : kTriangleSides[k]) {
        const auto [from, to] = kSides[side];
        longest = std::max(longest, (corners[to] - corners[from]).norm() / grid.unit());
      }
      sweeps_[k] = area.norm() > kThin * longest;
    }
  }

  bool sweeps(int part) const { return sweeps_[part]; }

  /// The segment in which a part of the swept surface meets a wall triangle, if it does; its ends go to `meetings`.
  std::optional<SectionSegment> meet(const GridTriangle& wall, int part,
                                     std::map<std::uint64_t, Meeting>& meetings) const {
    SectionSegment segment{.triangle = wall.index};
    int found = 0;
    const auto add = [&](std::uint64_t key, const Meeting& meeting) {
      if (found < 2) segment.nodes[found] = key;
      ++found;
      meetings.emplace(key, meeting);
    };
    for (int k = 0; k < 3; ++k) {
      if (const auto meeting = wall_edge_through(wall, k, part)) {
        const std::uint64_t low = std::min(wall.vertices[k], wall.vertices[(k + 1) % 3]);
        const std::uint64_t high = std::max(wall.vertices[k], wall.vertices[(k + 1) % 3]);
        add((low << 32 | high) << 1 | static_cast<std::uint64_t>(part), *meeting);
      }
    }
    for (const int side : kTriangleSides[part]) {
      if (const auto meeting = side_through(wall, side)) {
        add(kOfSide | static_cast<std::uint64_t>(wall.index) << 3 | static_cast<std::uint64_t>(side), *meeting);
      }
    }
    // Two nodes or none, but in a wall triangle without area, which ends the curve.
    return found == 2 ? std::optional(segment) : std::nullopt;
  }

 private:
  /// When and where on the edge a point of the swept surface is met, by its weights at the surface's corners. Evenly
  /// over each of the two triangles; where one sweeps nothing, the edge turns about that end.
  void place(const Eigen::Vector4d& weights, Meeting& meeting) const {
    const double of_begin = weights[0] + weights[2], of_end = weights[1] + weights[3];
    meeting.along = of_end;
    meeting.motion = weights[2] + weights[3];
    if (!sweeps_[1]) meeting.motion = of_end > 0 ? weights[3] / of_end : 0;
    if (!sweeps_[0]) {
      meeting.along = weights[3];
      meeting.motion = of_begin > 0 ? weights[2] / of_begin : 0;
    }
  }

  /// Marks keys of nodes where a side of the swept surface meets a wall triangle.
  static constexpr std::uint64_t kOfSide = std::uint64_t{1} << 63;

  /// Side of a part's plane on which a wall vertex lies, and the volume that tells it.
  std::pair<int, WideInteger> side_of_part(const GridPoint& vertex, int part) const {
    const auto [a, b, c] = kTriangles[part];
    const WideInteger exact = volume(corners_[a], corners_[b], corners_[c], vertex);
    if (exact != 0) return {sign_of(exact), exact};
    return {-sign_of(cross(corners_[a], corners_[b], corners_[a], corners_[c])), exact};
  }

  /// Sense in which a wall edge passes a side of the swept surface, and the volume that tells it. Zero only where the
  /// two are parallel.
  std::pair<int, WideInteger> sense(const GridPoint& from, const GridPoint& to, int begin, int end) const {
    const WideInteger exact = volume(from, to, corners_[begin], corners_[end]);
    if (exact != 0) return {sign_of(exact), exact};
    return {sign_of(cross(from, to, corners_[end], corners_[begin])), exact};
  }

  std::optional<Meeting> wall_edge_through(const GridTriangle& wall, int k, int part) const {
    // From the vertex of the lower number, so that both triangles beside the edge find the same.
    int low = k, high = (k + 1) % 3;
    if (wall.vertices[low] > wall.vertices[high]) std::swap(low, high);
    const GridPoint &from = wall.corners[low], &to = wall.corners[high];
    const auto [from_side, from_volume] = side_of_part(from, part);
    const auto [to_side, to_volume] = side_of_part(to, part);
    if (from_side == to_side) return std::nullopt;
    Eigen::Vector4d weights = Eigen::Vector4d::Zero();  // of the swept surface's corners
    int senses = 0;
    for (int s = 0; s < 3; ++s) {
      const auto [own, exact] = sense(from, to, kTriangles[part][s], kTriangles[part][(s + 1) % 3]);
      senses += own;
      weights[kTriangles[part][(s + 2) % 3]] = std::abs(to_double(exact));
    }
    if (std::abs(senses) != 3) return std::nullopt;
    Meeting meeting{.point = {.triangle = wall.index}};
    place(weights / weights.sum(), meeting);
    const double before = std::abs(to_double(from_volume)), after = std::abs(to_double(to_volume));
    meeting.point.weights[high] = before / (before + after);
    meeting.point.weights[low] = 1 - meeting.point.weights[high];
    return meeting;
  }

  std::optional<Meeting> side_through(const GridTriangle& wall, int side) const {
    const auto [begin, end] = kSides[side];
    const auto& [p, q, r] = wall.corners;
    const auto side_of_wall = [&](int corner) -> std::pair<int, WideInteger> {
      const WideInteger exact = volume(p, q, r, corners_[corner]);
      return {exact != 0 ? sign_of(exact) : sign_of(cross(p, q, p, r)), exact};
    };
    const auto [begin_side, begin_volume] = side_of_wall(begin);
    const auto [end_side, end_volume] = side_of_wall(end);
    if (begin_side == end_side) return std::nullopt;
    Meeting meeting{.point = {.triangle = wall.index}};
    int senses = 0;
    for (int k = 0; k < 3; ++k) {
      const auto [own, exact] = sense(wall.corners[k], wall.corners[(k + 1) % 3], begin, end);
      senses += own;
      meeting.point.weights[(k + 2) % 3] = std::abs(to_double(exact));
    }
    if (std::abs(senses) != 3) return std::nullopt;
    meeting.point.weights /= meeting.point.weights.sum();
    const double before = std::abs(to_double(begin_volume)), after = std::abs(to_double(end_volume));
    Eigen::Vector4d weights = Eigen::Vector4d::Zero();
    weights[begin] = after / (before + after);
    weights[end] = 1 - weights[begin];
    place(weights, meeting);
    return meeting;
  }

  std::array<GridPoint, 4> corners_;
  std::array<bool, 2> sweeps_ = {false, false};
};

SweptCurve curve_of(const SegmentChain& chain, const std::vector<SectionSegment>& segments,
                    const std::map<std::uint64_t, Meeting>& meetings) {
  SweptCurve result;
  result.curve.closed = chain.closed;
  const auto add = [&](std::uint64_t node) {
    const Meeting& meeting = meetings.at(node);
    result.curve.points.push_back(meeting.point);
    result.motion.push_back(meeting.motion);
    result.along.push_back(meeting.along);
  };
  for (const ChainStep& step : chain.steps) {
    add(segments[step.segment].nodes[step.from]);
    result.curve.triangles.push_back(segments[step.segment].triangle);
  }
  if (!chain.closed) add(segments[chain.steps.back().segment].nodes[1 - chain.steps.back().from]);
  return result;
}

/// Turns a curve so that it runs along the motion.
void orient(SweptCurve& swept) {
  SurfaceCurve& curve = swept.curve;
  if (curve.closed) {
    const auto least = std::ranges::min_element(swept.motion) - swept.motion.begin();
    std::rotate(curve.points.begin(), curve.points.begin() + least, curve.points.end());
    std::rotate(curve.triangles.begin(), curve.triangles.begin() + least, curve.triangles.end());
    std::rotate(swept.motion.begin(), swept.motion.begin() + least, swept.motion.end());
    std::rotate(swept.along.begin(), swept.along.begin() + least, swept.along.end());
    return;
  }
  const std::pair begin(swept.motion.front(), swept.along.front()), end(swept.motion.back(), swept.along.back());
  if (begin <= end) return;
  std::ranges::reverse(curve.points);
  std::ranges::reverse(curve.triangles);
  std::ranges::reverse(swept.motion);
  std::ranges::reverse(swept.along);
}

/// Wall triangles whose boxes meet that of the swept surface, and the box that holds them and it.
struct NearWall {
  std::vector<int> triangles;
  Eigen::Vector3d low, high;  // metres
};

NearWall near_wall(const SurfaceView& surface, const std::array<Eigen::Vector3d, 4>& corners) {
  Eigen::Vector3d low = corners[0], high = corners[0];
  for (const Eigen::Vector3d& corner : corners) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  const double slack = 1e-9 * (scale_of(surface) + (high - low).maxCoeff());
  NearWall near{.triangles = {}, .low = low, .high = high};
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
    const auto [a, b, c] = corners_of(surface, t);
    const Eigen::Vector3d least = a.cwiseMin(b).cwiseMin(c), most = a.cwiseMax(b).cwiseMax(c);
    if ((most.array() < low.array() - slack).any() || (least.array() > high.array() + slack).any()) continue;
    near.triangles.push_back(t);
    near.low = near.low.cwiseMin(least);
    near.high = near.high.cwiseMax(most);
  }
  return near;
}

}  // namespace

std::vector<SweptCurve> swept_section(const SurfaceView& surface, const BladeEdge& first, const BladeEdge& last) {
  const std::array<Eigen::Vector3d, 4> corners = {first.begin, first.end, last.begin, last.end};
  const NearWall near = near_wall(surface, corners);
  if (near.triangles.empty()) return {};
  const ExactGrid grid(near.low, near.high);
  const Sweep sweep(grid, corners);
  std::vector<SectionSegment> segments;
  std::map<std::uint64_t, Meeting> meetings;
  for (const int t : near.triangles) {
    GridTriangle wall{.index = t, .vertices = surface.triangles[t], .corners = {}};
    for (int k = 0; k < 3; ++k) wall.corners[k] = grid.at(surface.position.segment<3>(3 * wall.vertices[k]));
    for (int part = 0; part < 2; ++part) {
      if (!sweep.sweeps(part)) continue;
      if (const auto segment = sweep.meet(wall, part, meetings)) segments.push_back(*segment);
    }
  }
  std::vector<SweptCurve> curves;
  for (const SegmentChain& chain : chains_of(segments)) {
    curves.push_back(curve_of(chain, segments, meetings));
    orient(curves.back());
  }
  std::ranges::stable_sort(
      curves, {}, [](const SweptCurve& swept) { return std::tuple(swept.motion.front(), swept.along.front()); });
  return curves;
}

}  // namespace thinwall
