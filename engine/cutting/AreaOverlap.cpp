#include "engine/cutting/AreaOverlap.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace thinwall {
namespace {

Eigen::AlignedBox3d box_of(const CutPatch& patch, int triangle) {
  Eigen::AlignedBox3d box;
  for (const int vertex : patch.triangles[triangle]) box.extend(patch.positions[vertex]);
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(1e-9 * box.diagonal().norm());  // it may be flat
  return {box.min() - margin, box.max() + margin};
}

using Polygon = std::vector<Eigen::Vector2d>;

/// Coordinates in the plane of a facet.
struct FacetFrame {
  Eigen::Vector3d origin, x, y;

  FacetFrame(const CutPatch& patch, int triangle) {
    const Eigen::Vector3i& t = patch.triangles[triangle];
    origin = patch.positions[t[0]];
    x = (patch.positions[t[1]] - origin).normalized();
    y = patch.facet_normals[patch.facet[triangle]].cross(x).normalized();
  }
  Polygon polygon(const CutPatch& patch, int triangle) const {
    Polygon corners;
    for (const int vertex : patch.triangles[triangle]) {
      const Eigen::Vector3d off = patch.positions[vertex] - origin;
      corners.emplace_back(off.dot(x), off.dot(y));
    }
    return corners;
  }
};

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

double area_of(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    twice += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  }
  return 0.5 * twice;
}

/// Sutherland and Hodgman: the part of a polygon to the left of the line from a to b.
Polygon left_part(const Polygon& polygon, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  Polygon part;
  const auto height = [&](const Eigen::Vector2d& p) { return cross(b - a, p - a); };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double hp = height(p), hq = height(q);
    if (hp >= 0) part.push_back(p);
    if ((hp > 0 && hq < 0) || (hp < 0 && hq > 0)) part.push_back(p + hp / (hp - hq) * (q - p));
  }
  return part;
}

double common_area(Polygon polygon, const Polygon& triangle) {
  for (int k = 0; k < 3 && polygon.size() >= 3; ++k) polygon = left_part(polygon, triangle[k], triangle[(k + 1) % 3]);
  return polygon.size() < 3 ? 0 : std::max(0.0, area_of(polygon));
}

}  // namespace

std::vector<TriangleSource> overlaps(const CutPatch& before, const CutPatch& after) {
  constexpr double kNoShare = 1e-13;  // rounding of triangles that only touch
  std::vector<int> replaced;
  for (int t = 0; t < before.triangle_count(); ++t) {
    if (after.changed[t]) replaced.push_back(t);
  }
  std::vector<TriangleSource> sources;
  for (int t = 0; t < after.triangle_count(); ++t) {
    if (!after.changed[t]) continue;
    TriangleSource source{.triangle = t, .before = {}};
    const FacetFrame frame(after, t);
    const Eigen::AlignedBox3d box = box_of(after, t);
    const Polygon polygon = frame.polygon(after, t);
    double sum = 0;
    for (const int old : replaced) {
      if (before.facet[old] != after.facet[t] || !box.intersects(box_of(before, old))) continue;
      const double area = common_area(polygon, frame.polygon(before, old));
      if (area <= kNoShare * area_of(polygon)) continue;
      source.before.push_back({old, area});
      sum += area;
    }
    for (TriangleShare& share : source.before) share.share /= sum;
    sources.push_back(std::move(source));
  }
  return sources;
}

}  // namespace thinwall
