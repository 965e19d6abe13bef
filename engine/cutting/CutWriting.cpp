// How a cut that holds on its patch is written back to the surface.

#include <algorithm>
#include <map>
#include <set>

#include "engine/cutting/CutBooks.hpp"
#include "engine/cutting/CutSurface.hpp"
#include "engine/cutting/PatchNumbers.hpp"

namespace thinwall {

void CutSurface::add_vertices(const CutPatch& before, const CutPatch& after, std::span<const int> originals,
                              PatchNumbers& numbers, Cut& result) {
  for (int v = before.vertex_count(); v < after.vertex_count(); ++v) {
    numbers.vertices.push_back(static_cast<int>(mesh_.vertices.size()));
    mesh_.vertices.push_back(after.positions[v]);
    vertex_triangle_.push_back(-1);
  }
  result.vertices = vertex_sources(before, after, result.triangles, originals);
  for (VertexSource& source : result.vertices) {
    mesh_.vertices[numbers.vertices[source.vertex]] = after.positions[source.vertex];
    source.vertex = numbers.vertices[source.vertex];
    if (source.original) source.original = numbers.vertices[*source.original];
  }
}

/// A doubled vertex is a member where its original is. One on an edge is where both ends are and the edge is a border
/// or lies at a triangle that is wholly inside; one in a face where all corners are. Triangles here are still the old
/// ones.
void CutSurface::add_to_groups(int first_new, const PatchNumbers& numbers, const Cut& result) {
  for (auto& [name, is_member] : is_member_) {
    is_member.resize(mesh_.vertices.size(), 0);
    std::vector<int>& members = mesh_.groups[name];
    const auto is_inside = [&](int vertex) { return is_member[vertex] != 0; };
    const auto all_inside = [&](int t) { return t >= 0 && std::ranges::all_of(mesh_.triangles[t], is_inside); };
    const auto belongs = [&](const VertexSource& source) {
      if (source.original) return is_inside(*source.original);
      const int t = numbers.triangles[source.before.triangle];
      for (int k = 0; k < 3; ++k) {
        if (source.before.weights[(k + 2) % 3] > 0) continue;
        const int next = neighbours_[t][k];
        return is_inside(mesh_.triangles[t][k]) && is_inside(mesh_.triangles[t][(k + 1) % 3]) &&
               (next < 0 || all_inside(t) || all_inside(next));
      }
      return all_inside(t);
    };
    for (const VertexSource& source : result.vertices) {
      if (source.vertex < first_new || !belongs(source)) continue;
      is_member[source.vertex] = 1;
      members.push_back(source.vertex);
    }
  }
}

void CutSurface::change_rim(const std::vector<std::vector<int>>& chains, std::span<const RimOpening> rims,
                            const PatchNumbers& numbers) {
  for (const std::vector<int>& chain : chains) {
    std::vector<int> vertices;
    for (const int vertex : chain) vertices.push_back(numbers.vertices[vertex]);
    rim_.split_edge(mesh_.cap_triangles, vertices);
  }
  std::map<int, int> opened;  // vertex -> what stands in its place towards the vertex before it
  for (const RimOpening& rim : rims) {
    const auto renamed = opened.find(rim.after);
    const int after = renamed == opened.end() ? rim.after : renamed->second;
    rim_.open(mesh_.cap_triangles, {.before = numbers.vertices[rim.before],
                                    .vertex = numbers.vertices[rim.vertex],
                                    .after = numbers.vertices[after],
                                    .last = numbers.vertices[rim.last]});
    opened[rim.vertex] = rim.last;
  }
}

void CutSurface::write_back(const CutPatch& before, const CutPatch& after, PatchNumbers& numbers, Cut& result) {
  const int old = before.triangle_count();
  for (TriangleSource& source : result.triangles) {
    for (TriangleShare& share : source.before) share.triangle = numbers.triangles[share.triangle];
  }
  for (int t = old; t < after.triangle_count(); ++t) {
    numbers.triangles.push_back(static_cast<int>(mesh_.triangles.size()));
    mesh_.triangles.emplace_back();
    neighbours_.push_back(Eigen::Vector3i::Constant(CutPatch::kBorder));
    scale_.push_back(after.scale[t]);
    facet_.push_back(numbers.facets[after.facet[t]]);
    component_.push_back(-1);
  }
  for (int t = 0; t < after.triangle_count(); ++t) {
    const int number = numbers.triangles[t];
    for (int k = 0; k < 3; ++k) {
      mesh_.triangles[number][k] = numbers.vertices[after.triangles[t][k]];
      const int next = after.neighbours[t][k];
      if (next != CutPatch::kFrame) neighbours_[number][k] = next < 0 ? next : numbers.triangles[next];
    }
    const bool only_opened = t < old && !after.changed[t] && after.triangles[t] != before.triangles[t];
    if (only_opened) result.triangles.push_back({.triangle = t, .before = {{number, 1.0}}});
  }
  for (int v = 0; v < after.vertex_count(); ++v) {
    vertex_triangle_[numbers.vertices[v]] = numbers.triangles[after.vertex_triangle[v]];
  }
  for (TriangleSource& source : result.triangles) {
    source.triangle = numbers.triangles[source.triangle];
    int& component = component_[source.triangle];
    if (component < 0) component = component_[source.before.front().triangle];
  }
  std::ranges::sort(result.triangles, {}, &TriangleSource::triangle);
  for (Lips& lips : result.lips) {
    for (std::vector<int>* side : {&lips.left, &lips.right}) {
      for (int& vertex : *side) vertex = numbers.vertices[vertex];
    }
  }
  for (SurfacePoint& point : result.rest) point.triangle = numbers.triangles[point.triangle];
}

/// Floods the pieces that touch the new lips; of those that were one before, the largest keeps its number.
void CutSurface::separate(Cut& result) {
  std::vector<int> reached(mesh_.triangles.size(), -1);
  std::vector<std::vector<int>> pieces;
  for (const Lips& lips : result.lips) {
    for (const std::vector<int>* side : {&lips.left, &lips.right}) {
      for (const int vertex : *side) {
        const int seed = vertex_triangle_[vertex];
        if (reached[seed] >= 0) continue;
        std::vector<int> piece = {seed};
        reached[seed] = static_cast<int>(pieces.size());
        for (std::size_t i = 0; i < piece.size(); ++i) {
          for (const int next : neighbours_[piece[i]]) {
            if (next < 0 || reached[next] >= 0) continue;
            reached[next] = static_cast<int>(pieces.size());
            piece.push_back(next);
          }
        }
        pieces.push_back(std::move(piece));
      }
    }
  }
  std::map<int, std::vector<const std::vector<int>*>> of_component;
  for (const std::vector<int>& piece : pieces) of_component[component_[piece.front()]].push_back(&piece);
  for (const auto& [component, parts] : of_component) {
    const auto largest = std::ranges::max_element(parts, {}, [](const auto* piece) { return piece->size(); });
    for (const auto* piece : parts) {
      if (piece == *largest) continue;
      for (const int t : *piece) component_[t] = component_count_;
      result.separated.push_back(component_count_++);
    }
  }
}

/// The vertex after one on the border of wall and caps; -1 where there is no such border.
int CutSurface::next_on_border(int vertex) const {
  int t = vertex_triangle_[vertex];
  const int start = t;
  const auto corner_of = [&](int triangle) {
    return static_cast<int>(std::ranges::find(mesh_.triangles[triangle], vertex) - mesh_.triangles[triangle].begin());
  };
  while (neighbours_[t][corner_of(t)] >= 0) {
    t = neighbours_[t][corner_of(t)];
    if (t == start) return -1;
  }
  const int next = mesh_.triangles[t][(corner_of(t) + 1) % 3];
  if (!rim_.has_edge(next, vertex)) return next;
  return rim_.open_edge_from(mesh_.cap_triangles, vertex, next).value_or(-1);
}

std::vector<std::vector<int>> CutSurface::wound_loops(std::span<const Lips> lips) const {
  std::vector<std::vector<int>> loops;
  std::set<int> met;
  for (const Lips& one : lips) {
    for (const std::vector<int>* side : {&one.left, &one.right}) {
      for (const int start : *side) {
        if (met.count(start)) continue;
        std::vector<int> loop;
        for (int v = start; v >= 0 && met.insert(v).second; v = next_on_border(v)) loop.push_back(v);
        loops.push_back(std::move(loop));
      }
    }
  }
  return loops;
}

}  // namespace thinwall
