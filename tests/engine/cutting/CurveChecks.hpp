#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "engine/cutting/SurfaceCurve.hpp"

namespace thinwall {

/// Whether a point lies in a closed triangle.
inline bool is_in_triangle(const SurfaceView& surface, const SurfacePoint& point, int triangle) {
  for (int k = 0; k < 3; ++k) {
    const int vertex = surface.triangles[point.triangle][k];
    if (point.weights[k] != 0 && (surface.triangles[triangle].array() != vertex).all()) return false;
  }
  return true;
}

/// That weights are barycentric, that each two points that follow each other lie in the triangle between them, and that
/// none repeats the one before to within `apart`, metres.
inline void expect_connected(const SurfaceView& surface, const SurfaceCurve& curve, double apart) {
  const int size = static_cast<int>(curve.points.size());
  ASSERT_EQ(curve.triangles.size(), curve.points.size() - (curve.closed ? 0 : 1));
  for (const SurfacePoint& point : curve.points) {
    EXPECT_NEAR(point.weights.sum(), 1, 1e-14);
    EXPECT_GE(point.weights.minCoeff(), 0);
  }
  for (int k = 0; k < static_cast<int>(curve.triangles.size()); ++k) {
    const SurfacePoint &one = curve.points[k], &next = curve.points[(k + 1) % size];
    EXPECT_TRUE(is_in_triangle(surface, one, curve.triangles[k])) << "point " << k;
    EXPECT_TRUE(is_in_triangle(surface, next, curve.triangles[k])) << "point " << k + 1;
    EXPECT_GT((position_of(surface, one) - position_of(surface, next)).norm(), apart) << "point " << k;
  }
}

inline double length_of(const SurfaceView& surface, const SurfaceCurve& curve) {
  double sum = 0;
  const std::size_t size = curve.points.size();
  for (std::size_t k = 0; k < curve.triangles.size(); ++k) {
    sum += (position_of(surface, curve.points[k]) - position_of(surface, curve.points[(k + 1) % size])).norm();
  }
  return sum;
}

/// Whether a point lies on an edge of one triangle only.
inline bool is_on_border(const SurfaceView& surface, const SurfacePoint& point) {
  const auto has = [](const Eigen::Vector3i& triangle, int vertex) { return (triangle.array() == vertex).any(); };
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
    if (!is_in_triangle(surface, point, t)) continue;
    for (int k = 0; k < 3; ++k) {
      const int a = surface.triangles[t][k], b = surface.triangles[t][(k + 1) % 3];
      bool on_edge = true;
      for (int c = 0; c < 3; ++c) {
        const int vertex = surface.triangles[point.triangle][c];
        on_edge = on_edge && (point.weights[c] == 0 || vertex == a || vertex == b);
      }
      const auto count = std::ranges::count_if(
          surface.triangles, [&](const Eigen::Vector3i& other) { return has(other, a) && has(other, b); });
      if (on_edge && count == 1) return true;
    }
  }
  return false;
}

}  // namespace thinwall
