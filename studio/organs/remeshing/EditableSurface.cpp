#include "studio/organs/remeshing/EditableSurface.hpp"

#include <algorithm>
#include <cassert>
#include <iterator>
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
      const int from = t[k];
      const int to = t[(k + 1) % 3];
      // An edge inside runs upwards in one of its triangles.
      if (from < to) {
        edges.push_back({from, to});
      } else if (triangle_along(to, from) < 0) {
        edges.push_back({to, from});
      }
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
  return triangle_along(a, b) >= 0 || triangle_along(b, a) >= 0;
}

bool EditableSurface::is_border(int a, int b) const {
  return (triangle_along(a, b) < 0) != (triangle_along(b, a) < 0);
}

bool EditableSurface::is_at_border(int vertex) const {
  const std::vector<int> around = neighbours(vertex);
  return around.size() != fans_[vertex].size();
}

std::vector<int> EditableSurface::neighbours(int vertex) const {
  std::vector<int> around;
  for (const int t : fans_[vertex]) {
    for (const int v : triangles_[t]) {
      if (v != vertex) around.push_back(v);
    }
  }
  std::sort(around.begin(), around.end());
  around.erase(std::unique(around.begin(), around.end()), around.end());
  return around;
}

bool EditableSurface::may_lose_triangle(int vertex) const {
  return valence(vertex) > (is_at_border(vertex) ? 1 : 3);
}

std::array<int, 2> EditableSurface::far_corners(int a, int b) const {
  const int left = triangle_along(a, b);
  const int right = triangle_along(b, a);
  assert(left >= 0 || right >= 0);
  return {left < 0 ? -1 : triangles_[left].sum() - a - b, right < 0 ? -1 : triangles_[right].sum() - a - b};
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
    if (t < 0) continue;
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
  const std::vector<int> of_a = neighbours(a);
  const std::vector<int> of_b = neighbours(b);
  std::vector<int> common;
  std::set_intersection(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(), std::back_inserter(common));
  int far_count = 0;
  for (const int far : far_corners(a, b)) {
    if (far < 0) continue;
    ++far_count;
    if (!may_lose_triangle(far)) return false;
  }
  if (static_cast<int>(common.size()) != far_count) return false;
  return far_count == 1 || !(is_at_border(a) && is_at_border(b));
}

void EditableSurface::collapse(int a, int b, const Eigen::Vector3d& position) {
  for (const int t : {triangle_along(a, b), triangle_along(b, a)}) {
    if (t >= 0) remove(t);
  }
  for (const int t : fans_[b]) {
    replace_corner(t, b, a);
    fans_[a].push_back(t);
  }
  fans_[b].clear();
  positions[a] = position;
}

bool EditableSurface::may_turn(int a, int b) const {
  const std::array<int, 2> far = far_corners(a, b);
  if (far[0] < 0 || far[1] < 0) return false;
  return may_lose_triangle(a) && may_lose_triangle(b) && !has_edge(far[0], far[1]);
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
