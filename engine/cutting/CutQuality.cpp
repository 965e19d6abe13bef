#include "engine/cutting/CutQuality.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

namespace thinwall {

double sharpness(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                 const Eigen::Vector3d& normal) {
  const Eigen::Vector3d ab = b - a, bc = c - b, ca = a - c;
  if (!(normal.dot(ab.cross(bc)) > 0)) return 1;
  const double lab = ab.norm(), lbc = bc.norm(), lca = ca.norm();
  return std::max({-ab.dot(ca) / (lab * lca), -ab.dot(bc) / (lab * lbc), -bc.dot(ca) / (lbc * lca)});
}

double sharpness(const CutPatch& patch, int triangle) {
  const Eigen::Vector3i& t = patch.triangles[triangle];
  return sharpness(patch.positions[t[0]], patch.positions[t[1]], patch.positions[t[2]],
                   patch.facet_normals[patch.facet[triangle]]);
}

double sharpness_around(const CutPatch& patch, int vertex) {
  double worst = -1;
  for (const PatchCorner& corner : patch.fan_of(vertex).corners) {
    worst = std::max(worst, sharpness(patch, corner.triangle));
  }
  return worst;
}

double least_angle(const CutPatch& patch) {
  double worst = -1;
  for (int t = 0; t < patch.triangle_count(); ++t) {
    if (!patch.frozen[t]) worst = std::max(worst, sharpness(patch, t));
  }
  return std::acos(std::clamp(worst, -1.0, 1.0));
}

namespace {

/// Strain energy, as strain_energy gives it, that a new triangle may have over the most that was in its place, and how
/// much is little: beside the tip of a cut in a taut wall the strain differs by as much from triangle to triangle.
constexpr double kStrained = 2;
constexpr double kLittleStrained = 0.1;

double angle_at(const CutPatch& patch, const PatchCorner& corner) {
  const Eigen::Vector3i& t = patch.triangles[corner.triangle];
  const Eigen::Vector3d& tip = patch.positions[t[corner.corner]];
  const Eigen::Vector3d a = patch.positions[t[(corner.corner + 1) % 3]] - tip;
  const Eigen::Vector3d b = patch.positions[t[(corner.corner + 2) % 3]] - tip;
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Angles between lines next to each other around one vertex; those between two borders do not count.
double least_meeting_angle_at(const CutPatch& patch, int vertex) {
  const PatchFan fan = patch.fan_of(vertex);
  if (fan.cut_off) return std::numbers::pi;
  const int count = static_cast<int>(fan.corners.size());
  // The side of corner i towards the next vertex begins it; a closed fan is entered at a side of the path.
  const auto begins_on_path = [&](int i) { return patch.on_path[fan.corners[i].triangle][fan.corners[i].corner] != 0; };
  int start = 0;
  if (fan.closed) {
    while (start < count && !begins_on_path(start)) ++start;
    if (start == count) return std::numbers::pi;  // no path here
  }
  double least = std::numbers::pi, sum = 0;
  bool from_path = begins_on_path(start);
  for (int i = 0; i < count; ++i) {
    const PatchCorner& corner = fan.corners[(start + i) % count];
    sum += angle_at(patch, corner);
    const bool to_path = patch.on_path[corner.triangle][(corner.corner + 2) % 3] != 0;
    const bool to_border = CutPatch::is_open(patch.neighbours[corner.triangle][(corner.corner + 2) % 3]);
    if (!to_path && !to_border) continue;
    if (to_path || from_path) least = std::min(least, sum);
    sum = 0;
    from_path = to_path;
  }
  return least;
}

/// Vertices of marked edges, each once.
std::vector<int> path_vertices(const CutPatch& patch) {
  std::vector<char> met(patch.positions.size(), 0);
  std::vector<int> vertices;
  for (int t = 0; t < patch.triangle_count(); ++t) {
    for (int k = 0; k < 3; ++k) {
      if (!patch.on_path[t][k]) continue;
      for (const int vertex : {patch.triangles[t][k], patch.triangles[t][(k + 1) % 3]}) {
        if (!met[vertex]) vertices.push_back(vertex);
        met[vertex] = 1;
      }
    }
  }
  return vertices;
}

/// Strain energy of an incompressible neo-Hookean triangle over mu / 2 and its volume, tr C + 1 / det C - 3.
double strain_energy(const std::array<Eigen::Vector3d, 3>& rest, const std::array<Eigen::Vector3d, 3>& now) {
  const Eigen::Vector3d along = rest[1] - rest[0], aside = rest[2] - rest[0];
  const double length = along.norm(), shift = aside.dot(along) / length, height = along.cross(aside).norm() / length;
  const Eigen::Vector3d first = (now[1] - now[0]) / length;
  const Eigen::Vector3d second = (now[2] - now[0] - shift * first) / height;
  const double determinant = first.cross(second).squaredNorm();
  return first.squaredNorm() + second.squaredNorm() + 1 / std::max(determinant, 1e-30) - 3;
}

/// Where a place on a patch is now, by that of the triangles that it lies in or closest to.
Eigen::Vector3d placed(const CutPatch& patch, std::span<const TriangleShare> triangles,
                       const Eigen::Vector3d& position) {
  Eigen::Vector3d weights = Eigen::Vector3d::Zero();
  int nearest = -1;
  for (const TriangleShare& share : triangles) {
    const Eigen::Vector3d here = patch.barycentric(share.triangle, position);
    if (nearest >= 0 && here.minCoeff() <= weights.minCoeff()) continue;
    nearest = share.triangle;
    weights = here;
  }
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k) place += weights[k] * patch.placement[patch.triangles[nearest][k]];
  return place;
}

}  // namespace

double least_meeting_angle(const CutPatch& patch) {
  double least = std::numbers::pi;
  for (const int vertex : path_vertices(patch)) least = std::min(least, least_meeting_angle_at(patch, vertex));
  return least;
}

void allow_angles_as_now(CutPatch& patch) {
  patch.least_allowed.assign(patch.positions.size(), kGoodAngle);
  for (int t = 0; t < patch.triangle_count(); ++t) {
    const double angle = std::acos(std::clamp(sharpness(patch, t), -1.0, 1.0));
    for (const int vertex : patch.triangles[t]) {
      patch.least_allowed[vertex] = std::min(patch.least_allowed[vertex], angle);
    }
  }
}

void allow_wedges(CutPatch& patch) {
  for (const int vertex : path_vertices(patch)) {
    patch.least_allowed[vertex] = std::min(patch.least_allowed[vertex], 0.5 * least_meeting_angle_at(patch, vertex));
  }
}

double allowed_sharpness(const CutPatch& patch, int triangle) {
  return std::cos(patch.allowed_at(triangle)) + 1e-12;
}

double allowed_sharpness(const CutPatch& before, const CutPatch& patch, const TriangleSource& source) {
  double allowed = kGoodAngle;
  for (const TriangleShare& share : source.before) allowed = std::min(allowed, before.allowed_at(share.triangle));
  for (const int vertex : patch.triangles[source.triangle]) {
    allowed = std::min(allowed, 0.5 * least_meeting_angle_at(patch, vertex));
  }
  return std::cos(allowed) + 1e-12;
}

bool is_strained(const CutPatch& before, const CutPatch& patch, const TriangleSource& source) {
  if (before.placement.empty()) return false;
  double most = 0;
  for (const TriangleShare& share : source.before) {
    const Eigen::Vector3i& t = before.triangles[share.triangle];
    most = std::max(most, strain_energy({before.positions[t[0]], before.positions[t[1]], before.positions[t[2]]},
                                        {before.placement[t[0]], before.placement[t[1]], before.placement[t[2]]}));
  }
  std::array<Eigen::Vector3d, 3> rest, now;
  for (int k = 0; k < 3; ++k) {
    rest[k] = patch.positions[patch.triangles[source.triangle][k]];
    now[k] = placed(before, source.before, rest[k]);
  }
  return strain_energy(rest, now) > kStrained * most + kLittleStrained;
}

}  // namespace thinwall
