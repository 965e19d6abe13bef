#include "engine/cutting/PlaneSection.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "engine/cutting/SegmentChains.hpp"

namespace thinwall {
namespace {

/// Nearer to the plane than this, of the largest coordinate, a vertex lies in it: some hundred times round-off.
constexpr double kInPlane = 1e-13;

/// Height of each vertex over the plane, (vertices), metres; exactly zero where it lies in it.
std::vector<double> heights_over(const CuttingPlane& plane, const SurfaceView& surface) {
  const double least = kInPlane * scale_of(surface);
  std::vector<double> heights(static_cast<std::size_t>(surface.position.size() / 3));
  for (std::size_t v = 0; v < heights.size(); ++v) {
    const double height = plane.normal.dot(surface.position.segment<3>(static_cast<Eigen::Index>(3 * v)) - plane.point);
    heights[v] = std::abs(height) <= least ? 0 : height;
  }
  return heights;
}

/// Where a triangle's edge from corner k to the next crosses the plane; from either side of the edge the same point.
SurfacePoint crossing(const SurfaceView& surface, const std::vector<double>& heights, int triangle, int k) {
  const Eigen::Vector3i& vertices = surface.triangles[triangle];
  int low = k, high = (k + 1) % 3;
  if (vertices[low] > vertices[high]) std::swap(low, high);
  const double from = heights[vertices[low]], to = heights[vertices[high]];
  SurfacePoint point{.triangle = triangle};
  point.weights[high] = from / (from - to);
  point.weights[low] = 1 - point.weights[high];
  return point;
}

std::uint64_t edge_key(int a, int b) {
  const auto low = static_cast<std::uint64_t>(std::min(a, b)), high = static_cast<std::uint64_t>(std::max(a, b));
  return low << 32 | high;
}

}  // namespace

std::vector<SurfaceCurve> plane_section(const SurfaceView& surface, const CuttingPlane& plane, PlaneTies ties) {
  const std::vector<double> heights = heights_over(plane, surface);
  const auto in_front = [&](int vertex) {
    return ties == PlaneTies::kInFront ? heights[vertex] >= 0 : heights[vertex] > 0;
  };
  std::vector<SectionSegment> segments;
  std::vector<std::array<int, 2>> crossed;  // (segments x 2), edges of the triangle at the segment's ends
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
    const Eigen::Vector3i& vertices = surface.triangles[t];
    const std::array<bool, 3> front = {in_front(vertices[0]), in_front(vertices[1]), in_front(vertices[2])};
    if (front[0] == front[1] && front[1] == front[2]) continue;
    SectionSegment segment{.triangle = t};
    std::array<int, 2> own = {0, 0};
    int found = 0;
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3;
      if (front[k] == front[next]) continue;
      own[found] = k;
      segment.nodes[found++] = edge_key(vertices[k], vertices[next]);
    }
    segments.push_back(segment);
    crossed.push_back(own);
  }
  std::vector<SurfaceCurve> curves;
  for (const SegmentChain& chain : chains_of(segments)) {
    SurfaceCurve curve{.points = {}, .triangles = {}, .closed = chain.closed};
    for (const ChainStep& step : chain.steps) {
      const int triangle = segments[step.segment].triangle;
      curve.points.push_back(crossing(surface, heights, triangle, crossed[step.segment][step.from]));
      curve.triangles.push_back(triangle);
    }
    if (!chain.closed) {
      const ChainStep& last = chain.steps.back();
      curve.points.push_back(crossing(surface, heights, curve.triangles.back(), crossed[last.segment][1 - last.from]));
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace thinwall
