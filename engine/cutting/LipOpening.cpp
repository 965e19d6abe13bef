#include "engine/cutting/LipOpening.hpp"

#include <algorithm>
#include <cassert>
#include <set>

namespace thinwall {
namespace {

/// A marked edge from both sides; the sides stay where they are when vertices are renumbered.
struct MarkedEdge {
  PatchCorner left, right;
};

std::vector<std::vector<MarkedEdge>> runs_of(const CutPatch& patch, std::span<const int> path, OpenedLips& opened) {
  std::vector<std::vector<MarkedEdge>> runs;
  std::set<std::pair<int, int>> met;
  bool going_on = false;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const PatchCorner left = patch.side_between(path[i], path[i + 1]);
    const bool marked = left.triangle >= 0 && patch.on_path[left.triangle][left.corner];
    if (!marked || !met.insert(std::minmax(path[i], path[i + 1])).second) {
      going_on = false;
      continue;
    }
    if (!going_on) runs.emplace_back();
    going_on = true;
    const int across = patch.neighbours[left.triangle][left.corner];
    runs.back().push_back({left, {across, patch.corner_of(across, path[i + 1])}});
    opened.length += (patch.positions[path[i + 1]] - patch.positions[path[i]]).norm();
  }
  opened.euler_change = -static_cast<int>(met.size());
  std::set<int> vertices;
  for (const auto& [a, b] : met) vertices.insert({a, b});
  opened.may_separate = met.size() >= vertices.size();
  return runs;
}

struct Renumbering {
  PatchCorner corner;
  int vertex = 0;
};

/// Gives each sector of a vertex's fan a vertex.
void split_fan(CutPatch& patch, int vertex, OpenedLips& opened, std::vector<Renumbering>& renumberings) {
  const PatchFan fan = patch.fan_of(vertex);
  const int count = static_cast<int>(fan.corners.size());
  assert(count > 0);
  const auto begins_on_path = [&](int i) {
    const PatchCorner& corner = fan.corners[i % count];
    return patch.on_path[corner.triangle][corner.corner] != 0;
  };
  int start = 0;
  if (fan.closed) {
    while (start < count && !begins_on_path(start)) ++start;
  }
  int current = vertex;
  for (int i = start; i < start + count; ++i) {
    if (i > start && begins_on_path(i)) {
      current = patch.vertex_count();
      patch.positions.push_back(Eigen::Vector3d(patch.positions[vertex]));
      patch.vertex_triangle.push_back(fan.corners[i % count].triangle);
      patch.freedom.push_back(VertexFreedom::kFixed);
      patch.line.push_back(Eigen::Vector3d::Zero());
      patch.least_allowed.push_back(double(patch.least_allowed[vertex]));
      opened.originals.push_back(vertex);
      ++opened.euler_change;
    }
    if (current != vertex) renumberings.push_back({fan.corners[i % count], current});
  }
  patch.vertex_triangle[vertex] = fan.corners[start % count].triangle;
  if (fan.closed || current == vertex) return;
  const PatchCorner &first = fan.corners.front(), &last = fan.corners.back();
  opened.rims.push_back({.before = patch.triangles[last.triangle][(last.corner + 2) % 3],
                         .vertex = vertex,
                         .after = patch.triangles[first.triangle][(first.corner + 1) % 3],
                         .last = current});
}

}  // namespace

OpenedLips open_lips(CutPatch& patch, std::span<const int> path) {
  OpenedLips opened;
  const auto runs = runs_of(patch, path, opened);
  std::set<int> vertices;
  for (const auto& run : runs) {
    for (const MarkedEdge& edge : run) {
      const Eigen::Vector3i& t = patch.triangles[edge.left.triangle];
      vertices.insert({t[edge.left.corner], t[(edge.left.corner + 1) % 3]});
    }
  }
  std::vector<Renumbering> renumberings;
  for (const int vertex : vertices) split_fan(patch, vertex, opened, renumberings);
  for (const Renumbering& one : renumberings) patch.triangles[one.corner.triangle][one.corner.corner] = one.vertex;
  for (const auto& run : runs) {
    Lips lips;
    const auto add = [&](int left, int right) {
      lips.left.push_back(left);
      lips.right.push_back(right);
    };
    for (const auto& [left, right] : run) {
      const Eigen::Vector3i &l = patch.triangles[left.triangle], &r = patch.triangles[right.triangle];
      const int begin_left = l[left.corner], begin_right = r[(right.corner + 1) % 3];
      if (!lips.left.empty() && (lips.left.back() != begin_left || lips.right.back() != begin_right)) {
        opened.lips.push_back(std::move(lips));  // another line of the cut meets this one here
        lips = {};
      }
      if (lips.left.empty()) add(begin_left, begin_right);
      add(l[(left.corner + 1) % 3], r[right.corner]);
      patch.neighbours[left.triangle][left.corner] = CutPatch::kLip;
      patch.neighbours[right.triangle][right.corner] = CutPatch::kLip;
    }
    opened.lips.push_back(std::move(lips));
  }
  opened.may_separate = opened.may_separate || opened.rims.size() >= 2;
  return opened;
}

}  // namespace thinwall
