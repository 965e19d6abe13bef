#include "studio/organs/generator/EditableSurface.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace thinwall {

EditableSurface::EditableSurface(TriangleSurface surface)
    : positions(std::move(surface.vertices)),
      triangles_(std::move(surface.triangles)),
      fans_(positions.size()),
      triangle_count_(static_cast<int>(triangles_.size())) {
  for (int t = 0; t < triangle_count_; ++t) {
    for (const int v : triangles_[t]) fans_[v].push_back(t);
  }
}

TriangleSurface EditableSurface::compact() const {
  TriangleSurface surface;
  std::vector<int> place(positions.size(), -1);
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (fans_[v].empty()) continue;
    place[v] = static_cast<int>(surface.vertices.size());
    surface.vertices.push_back(positions[v]);
  }
  for (const Eigen::Vector3i& t : triangles_) {
    if (t[0] >= 0) surface.triangles.emplace_back(place[t[0]], place[t[1]], place[t[2]]);
  }
  return surface;
}

std::vector<std::array<int, 2>> EditableSurface::edges() const {
  std::vector<std::array<int, 2>> edges;
  for (const Eigen::Vector3i& t : triangles_) {
    for (int k = 0; k < 3 && t[0] >= 0; ++k) {
      // Each edge of a closed surface runs upwards in one of its triangles.
      if (t[k] < t[(k + 1) % 3]) edges.push_back({t[k], t[(k + 1) % 3]});
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

int EditableSurface::triangle_along(int a, int b) const {
  for (const int t : fans_[a]) {
    for (int k = 0; k < 3; ++k) {
      if (triangles_[t][k] == a && triangles_[t][(k + 1) % 3] == b) return t;
    }
  }
  return -1;
}

bool EditableSurface::has_edge(int a, int b) const {
  return triangle_along(a, b) >= 0;
}

std::array<int, 2> EditableSurface::far_corners(int a, int b) const {
  const int left = triangle_along(a, b);
  const int right = triangle_along(b, a);
  assert(left >= 0 && right >= 0);
  return {triangles_[left].sum() - a - b, triangles_[right].sum() - a - b};
}

void EditableSurface::replace_corner(int t, int from, int to) {
  for (int& corner : triangles_[t]) {
    if (corner == from) corner = to;
  }
}

void EditableSurface::drop_from_fan(int vertex, int t) {
  std::vector<int>& fan = fans_[vertex];
  fan.erase(std::find(fan.begin(), fan.end(), t));
}

void EditableSurface::remove(int t) {
  for (const int v : triangles_[t]) drop_from_fan(v, t);
  triangles_[t] = {-1, -1, -1};
  --triangle_count_;
}

int EditableSurface::split(int a, int b, const Eigen::Vector3d& position) {
  const int middle = static_cast<int>(positions.size());
  positions.push_back(position);
  fans_.emplace_back();
  for (const int t : {triangle_along(a, b), triangle_along(b, a)}) {
    const int added = static_cast<int>(triangles_.size());
    triangles_.push_back(triangles_[t]);
    replace_corner(t, b, middle);
    replace_corner(added, a, middle);
    const int far = triangles_[t].sum() - a - middle;
    drop_from_fan(b, t);
    fans_[b].push_back(added);
    fans_[far].push_back(added);
    fans_[middle].push_back(t);
    fans_[middle].push_back(added);
    ++triangle_count_;
  }
  return middle;
}

bool EditableSurface::may_collapse(int a, int b) const {
  int common = 0;
  for (const int t : fans_[a]) {
    for (int k = 0; k < 3; ++k) {
      // Around a vertex of a closed surface each neighbour follows it in one triangle.
      if (triangles_[t][k] == a && has_edge(triangles_[t][(k + 1) % 3], b)) ++common;
    }
  }
  const std::array<int, 2> far = far_corners(a, b);
  return common == 2 && valence(far[0]) > 3 && valence(far[1]) > 3;
}

void EditableSurface::collapse(int a, int b, const Eigen::Vector3d& position) {
  remove(triangle_along(a, b));
  remove(triangle_along(b, a));
  for (const int t : fans_[b]) {
    replace_corner(t, b, a);
    fans_[a].push_back(t);
  }
  fans_[b].clear();
  positions[a] = position;
}

bool EditableSurface::may_turn(int a, int b) const {
  const std::array<int, 2> far = far_corners(a, b);
  return valence(a) > 3 && valence(b) > 3 && !has_edge(far[0], far[1]);
}

void EditableSurface::turn(int a, int b) {
  const int left = triangle_along(a, b);
  const int right = triangle_along(b, a);
  const std::array<int, 2> far = far_corners(a, b);
  replace_corner(left, b, far[1]);
  replace_corner(right, a, far[0]);
  drop_from_fan(b, left);
  drop_from_fan(a, right);
  fans_[far[1]].push_back(left);
  fans_[far[0]].push_back(right);
}

}  // namespace thinwall
