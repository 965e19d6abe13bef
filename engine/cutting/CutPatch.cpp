#include "engine/cutting/CutPatch.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <limits>

namespace thinwall {

int CutPatch::corner_of(int triangle, int vertex) const {
  for (int k = 0; k < 3; ++k) {
    if (triangles[triangle][k] == vertex) return k;
  }
  return -1;
}

PatchFan CutPatch::fan_of(int vertex) const {
  PatchFan fan;
  const int start = vertex_triangle[vertex];
  int t = start, c = corner_of(t, vertex);
  for (;;) {  // clockwise to the first triangle of an open fan
    const int next = neighbours[t][c];
    if (next < 0) break;
    t = next;
    c = corner_of(t, vertex);
    if (t == start) {
      fan.closed = true;
      break;
    }
  }
  fan.cut_off = neighbours[t][c] == kFrame;
  const int first = t;
  do {
    fan.corners.push_back({t, c});
    const int next = neighbours[t][(c + 2) % 3];
    if (next == kFrame) fan.cut_off = true;
    if (next < 0) break;
    t = next;
    c = corner_of(t, vertex);
  } while (t != first);
  return fan;
}

PatchCorner CutPatch::side_between(int from, int to) const {
  for (const PatchCorner& corner : fan_of(from).corners) {
    if (triangles[corner.triangle][(corner.corner + 1) % 3] == to) return corner;
  }
  return {};
}

bool CutPatch::are_joined(int a, int b) const {
  return side_between(a, b).triangle >= 0 || side_between(b, a).triangle >= 0;
}

double CutPatch::orientation(int its_facet, const Eigen::Vector3d& p, const Eigen::Vector3d& q,
                             const Eigen::Vector3d& r) const {
  return facet_normals[its_facet].dot((q - p).cross(r - p));
}

Eigen::Vector3d CutPatch::barycentric(int triangle, const Eigen::Vector3d& p) const {
  const Eigen::Vector3i& corners = triangles[triangle];
  const Eigen::Vector3d &a = positions[corners[0]], &b = positions[corners[1]], &c = positions[corners[2]];
  const int f = facet[triangle];
  const Eigen::Vector3d weights(orientation(f, p, b, c), orientation(f, p, c, a), orientation(f, p, a, b));
  return weights / weights.sum();
}

std::pair<int, Eigen::Vector3d> CutPatch::locate(int its_facet, const Eigen::Vector3d& position) const {
  std::pair<int, Eigen::Vector3d> best{-1, Eigen::Vector3d::Zero()};
  double best_weight = -std::numeric_limits<double>::infinity();
  for (int t = 0; t < triangle_count(); ++t) {
    if (facet[t] != its_facet) continue;
    const Eigen::Vector3d weights = barycentric(t, position);
    if (!(weights.minCoeff() > best_weight)) continue;
    best_weight = weights.minCoeff();
    best = {t, weights};
  }
  return best;
}

bool CutPatch::is_crease(int triangle, int side) const {
  const int next = neighbours[triangle][side];
  return next < 0 || facet[next] != facet[triangle];
}

bool CutPatch::is_held(int triangle, int side) const {
  return is_crease(triangle, side) || on_path[triangle][side] || frozen[triangle] || frozen[neighbours[triangle][side]];
}

int CutPatch::add_vertex(const Eigen::Vector3d& position, VertexFreedom its_freedom, double allowed) {
  positions.push_back(position);
  vertex_triangle.push_back(-1);
  freedom.push_back(its_freedom);
  line.push_back(Eigen::Vector3d::Zero());
  least_allowed.push_back(allowed);
  ++splits;
  return vertex_count() - 1;
}

int CutPatch::add_triangle_like(int triangle) {
  triangles.push_back(triangles[triangle]);
  neighbours.push_back(neighbours[triangle]);
  facet.push_back(facet[triangle]);
  scale.push_back(scale[triangle]);
  frozen.push_back(0);
  changed.push_back(1);
  on_path.push_back(on_path[triangle]);
  changed[triangle] = 1;
  return triangle_count() - 1;
}

/// Makes two triangles neighbours across a side of the first; the second's side is the one with the same vertices.
void CutPatch::join(int triangle, int side, int neighbour) {
  neighbours[triangle][side] = neighbour;
  if (neighbour < 0) return;
  const int end = triangles[triangle][(side + 1) % 3];
  neighbours[neighbour][corner_of(neighbour, end)] = triangle;
}

int CutPatch::split_side(int t, int k, const Eigen::Vector3d& position) {
  assert(!frozen[t] && neighbours[t][k] != kFrame);
  const bool crease = is_crease(t, k);
  const int n = neighbours[t][k];
  const double allowed = n < 0 ? allowed_at(t) : std::min(allowed_at(t), allowed_at(n));
  const int m = add_vertex(position, crease || on_path[t][k] ? VertexFreedom::kFixed : VertexFreedom::kFree, allowed);
  const int b = triangles[t][(k + 1) % 3];
  // t = (a, b, c) becomes (a, m, c) and (m, b, c).
  const int t2 = add_triangle_like(t);
  const int beyond = neighbours[t][(k + 1) % 3];
  triangles[t][(k + 1) % 3] = m;
  on_path[t][(k + 1) % 3] = 0;
  triangles[t2][k] = m;
  on_path[t2][(k + 2) % 3] = 0;
  join(t2, (k + 1) % 3, beyond);
  join(t, (k + 1) % 3, t2);
  vertex_triangle[m] = t;
  vertex_triangle[b] = t2;
  if (n < 0) {
    neighbours[t2][k] = n;
    return m;
  }
  // n = (b, a, d) becomes (m, a, d) and (b, m, d).
  assert(!frozen[n]);
  const int j = corner_of(n, b);
  const int n2 = add_triangle_like(n);
  const int beyond_n = neighbours[n][(j + 2) % 3];
  triangles[n][j] = m;
  on_path[n][(j + 2) % 3] = 0;
  triangles[n2][(j + 1) % 3] = m;
  on_path[n2][(j + 1) % 3] = 0;
  join(n2, (j + 2) % 3, beyond_n);
  join(n, (j + 2) % 3, n2);
  join(t, k, n);
  join(t2, k, n2);
  return m;
}

int CutPatch::split_triangle(int t, const Eigen::Vector3d& position) {
  assert(!frozen[t]);
  const int m = add_vertex(position, VertexFreedom::kFree, allowed_at(t));
  const Eigen::Vector3i corners = triangles[t], around = neighbours[t];
  const std::array<char, 3> marks = on_path[t];
  const std::array<int, 3> parts = {t, add_triangle_like(t), add_triangle_like(t)};
  for (int k = 0; k < 3; ++k) {
    triangles[parts[k]] = {corners[k], corners[(k + 1) % 3], m};
    on_path[parts[k]] = {marks[k], 0, 0};
  }
  for (int k = 0; k < 3; ++k) {
    join(parts[k], 0, around[k]);
    neighbours[parts[k]][1] = parts[(k + 1) % 3];
    neighbours[parts[k]][2] = parts[(k + 2) % 3];
    vertex_triangle[corners[k]] = parts[k];
  }
  vertex_triangle[m] = t;
  return m;
}

bool CutPatch::can_flip(int t, int k) const {
  if (neighbours[t][k] < 0 || is_held(t, k)) return false;
  const int n = neighbours[t][k];
  const int a = triangles[t][k], b = triangles[t][(k + 1) % 3], c = triangles[t][(k + 2) % 3];
  const int d = triangles[n][(corner_of(n, b) + 2) % 3];
  const int f = facet[t];
  const Eigen::Vector3d &pa = positions[a], &pb = positions[b], &pc = positions[c], &pd = positions[d];
  const double least = 1e-9 * (pb - pa).squaredNorm();
  return orientation(f, pc, pa, pd) > least && orientation(f, pd, pb, pc) > least && !are_joined(c, d);
}

void CutPatch::flip(int t, int k) {
  const int n = neighbours[t][k];
  const int a = triangles[t][k], b = triangles[t][(k + 1) % 3], c = triangles[t][(k + 2) % 3];
  const int j = corner_of(n, b), d = triangles[n][(j + 2) % 3];
  const int bc = neighbours[t][(k + 1) % 3], ca = neighbours[t][(k + 2) % 3];
  const int ad = neighbours[n][(j + 1) % 3], db = neighbours[n][(j + 2) % 3];
  const char mark_bc = on_path[t][(k + 1) % 3], mark_ca = on_path[t][(k + 2) % 3];
  const char mark_ad = on_path[n][(j + 1) % 3], mark_db = on_path[n][(j + 2) % 3];
  triangles[t] = {a, d, c};
  triangles[n] = {d, b, c};
  on_path[t] = {mark_ad, 0, mark_ca};
  on_path[n] = {mark_db, mark_bc, 0};
  join(t, 0, ad);
  join(t, 2, ca);
  join(n, 0, db);
  join(n, 1, bc);
  neighbours[t][1] = n;
  neighbours[n][2] = t;
  vertex_triangle[a] = t;
  vertex_triangle[b] = n;
  vertex_triangle[c] = t;
  vertex_triangle[d] = t;
  changed[t] = changed[n] = 1;
  ++flips;
}

void CutPatch::set_on_path(int a, int b) {
  for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
    const PatchCorner side = side_between(from, to);
    if (side.triangle >= 0) on_path[side.triangle][side.corner] = 1;
  }
}

void CutPatch::find_freedom(int first) {
  for (int v = first; v < vertex_count(); ++v) {
    freedom[v] = VertexFreedom::kFixed;
    const PatchFan fan = fan_of(v);
    if (!fan.closed) continue;
    std::vector<Eigen::Vector3d> creases;
    for (const PatchCorner& corner : fan.corners) {
      if (!is_crease(corner.triangle, corner.corner)) continue;
      const int end = triangles[corner.triangle][(corner.corner + 1) % 3];
      creases.push_back((positions[end] - positions[v]).normalized());
    }
    if (creases.empty()) freedom[v] = VertexFreedom::kFree;
    constexpr double kStraight = 1e-11;  // sine of an angle: what moves along the line stays on the surface
    if (creases.size() != 2 || (creases[0] + creases[1]).norm() > kStraight) continue;
    freedom[v] = VertexFreedom::kLine;
    line[v] = creases[0];
  }
}

double CutPatch::allowed_at(int triangle) const {
  const Eigen::Vector3i& t = triangles[triangle];
  return std::min({least_allowed[t[0]], least_allowed[t[1]], least_allowed[t[2]]});
}

double CutPatch::mean_edge(int triangle) const {
  const Eigen::Vector3i& t = triangles[triangle];
  double sum = 0;
  for (int k = 0; k < 3; ++k) sum += (positions[t[(k + 1) % 3]] - positions[t[k]]).norm();
  return sum / 3;
}

}  // namespace thinwall
