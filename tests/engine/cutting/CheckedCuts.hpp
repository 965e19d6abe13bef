#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "engine/cutting/CutSurface.hpp"
#include "engine/mesh/Shapes.hpp"
#include "tests/engine/cutting/CutInvariants.hpp"

namespace thinwall {

using Places = std::vector<Eigen::Vector3d>;

/// A square of side 2 about the origin.
inline CutSurface sheet() {
  return CutSurface(make_sheet(2, 2, 400));
}

/// The point of the wall nearest to a place in space, among triangles whose plane comes that near; with a `side` among
/// those whose middle has a y of that sign.
inline SurfacePoint nearest_point(const SurfaceMesh& mesh, const Eigen::Vector3d& place, double side = 0) {
  SurfacePoint best;
  double best_value = std::numeric_limits<double>::infinity();
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const Eigen::Vector3d &a = mesh.vertices[mesh.triangles[t][0]], &b = mesh.vertices[mesh.triangles[t][1]],
                          &c = mesh.vertices[mesh.triangles[t][2]];
    if ((a + b + c).y() * side < 0) continue;
    const Eigen::Vector3d n = (b - a).cross(c - a);
    Eigen::Vector3d weights(n.dot((b - place).cross(c - place)), n.dot((c - place).cross(a - place)),
                            n.dot((a - place).cross(b - place)));
    weights /= n.squaredNorm();
    for (double& weight : weights) weight = std::abs(weight) < 1e-12 ? 0 : weight;
    weights = weights.cwiseMax(0);
    weights /= weights.sum();
    const double value = (weights[0] * a + weights[1] * b + weights[2] * c - place).norm();
    if (value >= best_value - 1e-12) continue;
    best_value = value;
    best = {.triangle = t, .weights = weights};
  }
  return best;
}

inline std::vector<SurfacePoint> points_at(const SurfaceMesh& mesh, const Places& places) {
  std::vector<SurfacePoint> points;
  for (const Eigen::Vector3d& place : places) points.push_back(nearest_point(mesh, place));
  return points;
}

/// Cuts, and holds the cut against every rule.
inline Cut cut_well(CutSurface& surface, const CutPath& path, const CutOptions& options = {}) {
  const SurfaceMesh before = surface.mesh();
  Cut cut = surface.cut(path, options);
  for (const std::string& rule : broken_rules(before, surface, cut)) ADD_FAILURE() << rule;
  return cut;
}

inline Cut cut_through(CutSurface& surface, const Places& places) {
  return cut_well(surface, {.from = {}, .points = points_at(surface.mesh(), places)});
}

}  // namespace thinwall
