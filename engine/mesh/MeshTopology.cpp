#include "engine/mesh/MeshTopology.hpp"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <map>
#include <numeric>

namespace thinwall {
namespace {

/// A half-edge under its lower vertex: its higher vertex and, behind that, its number, 3 t + k from corner k of
/// triangle t to the next.
using HalfEdge = std::uint64_t;

int higher_vertex_of(HalfEdge half_edge) {
  return static_cast<int>(half_edge >> 32);
}
std::uint32_t number_of(HalfEdge half_edge) {
  return static_cast<std::uint32_t>(half_edge);
}

struct HalfEdges {
  std::vector<std::size_t> begin;  // (vertices + 1), into `sorted`
  std::vector<HalfEdge> sorted;    // (3 triangles), by their vertices, the lower first, then by their numbers
};

HalfEdges half_edges_of(int vertex_count, std::span<const Eigen::Vector3i> triangles) {
  HalfEdges result{.begin = std::vector<std::size_t>(static_cast<std::size_t>(vertex_count) + 1, 0),
                   .sorted = std::vector<HalfEdge>(3 * triangles.size())};
  const auto for_each = [&](const auto& visit) {
    std::uint32_t number = 0;
    for (const Eigen::Vector3i& triangle : triangles) {
      for (int k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax({triangle[k], triangle[(k + 1) % 3]});
        assert(low != high);
        visit(low, static_cast<HalfEdge>(high) << 32 | number++);
      }
    }
  };
  for_each([&](int low, HalfEdge) { ++result.begin[static_cast<std::size_t>(low) + 1]; });
  std::partial_sum(result.begin.begin(), result.begin.end(), result.begin.begin());
  std::vector<std::size_t> next(result.begin.begin(), result.begin.end() - 1);
  for_each([&](int low, HalfEdge half_edge) { result.sorted[next[low]++] = half_edge; });
  for (std::size_t v = 0; v < next.size(); ++v) {
    const auto at = [&](std::size_t k) { return result.sorted.begin() + static_cast<std::ptrdiff_t>(k); };
    std::sort(at(result.begin[v]), at(result.begin[v + 1]));
  }
  return result;
}

}  // namespace

MeshEdges edges_of(int vertex_count, std::span<const Eigen::Vector3i> triangles) {
  const HalfEdges half_edges = half_edges_of(vertex_count, triangles);
  const std::vector<HalfEdge>& sorted = half_edges.sorted;
  MeshEdges mesh;
  mesh.triangle_edges.resize(triangles.size());
  mesh.edges.reserve(sorted.size() / 2);
  mesh.edge_triangle_begin.reserve(sorted.size() / 2 + 1);
  mesh.edge_triangles.reserve(sorted.size());
  for (int low = 0; low < vertex_count; ++low) {
    for (std::size_t begin = half_edges.begin[low], end = begin; begin < half_edges.begin[low + 1]; begin = end) {
      const int edge = static_cast<int>(mesh.edges.size()), high = higher_vertex_of(sorted[begin]);
      mesh.edges.push_back({low, high});
      mesh.edge_triangle_begin.push_back(static_cast<int>(begin));
      int ascending = 0;  // those that go from the lower vertex to the higher
      for (; end < half_edges.begin[low + 1] && higher_vertex_of(sorted[end]) == high; ++end) {
        const std::uint32_t triangle = number_of(sorted[end]) / 3, corner = number_of(sorted[end]) % 3;
        mesh.edge_triangles.push_back(static_cast<int>(triangle));
        mesh.triangle_edges[triangle][corner] = edge;
        if (triangles[triangle][corner] == low) ++ascending;
      }
      const std::size_t count = end - begin;
      if (count == 1) mesh.open_edges.push_back(edge);
      if (count > 2) mesh.crowded_edges.push_back(edge);
      if (count == 2 && ascending != 1) mesh.contrary_edges.push_back(edge);
    }
  }
  mesh.edge_triangle_begin.push_back(static_cast<int>(sorted.size()));
  return mesh;
}

namespace {

void collect_components(MeshPieces& topology) {
  const int triangle_count = static_cast<int>(topology.triangle_edges.size());
  topology.triangle_component.assign(triangle_count, -1);
  std::vector<int> waiting;
  for (int seed = 0; seed < triangle_count; ++seed) {
    if (topology.triangle_component[seed] >= 0) continue;
    topology.triangle_component[seed] = topology.component_count;
    waiting.push_back(seed);
    while (!waiting.empty()) {
      const int t = waiting.back();
      waiting.pop_back();
      for (const int edge : topology.triangle_edges[t]) {
        for (const int neighbour : triangles_at(topology, edge)) {
          if (topology.triangle_component[neighbour] >= 0) continue;
          topology.triangle_component[neighbour] = topology.component_count;
          waiting.push_back(neighbour);
        }
      }
    }
    ++topology.component_count;
  }
}

/// One fan: its triangles are joined across the edges at the vertex, and at most one gap is left. `reached`: memory.
bool is_one_fan(int vertex, std::span<const int> fan, const MeshTopology& topology, std::vector<int>& reached) {
  reached.assign(1, fan.front());
  int open_edges = 0;
  for (std::size_t i = 0; i < reached.size(); ++i) {
    for (const int edge : topology.triangle_edges[reached[i]]) {
      const std::array<int, 2>& ends = topology.edges[edge];
      if (ends[0] != vertex && ends[1] != vertex) continue;
      const std::span<const int> neighbours = triangles_at(topology, edge);
      if (neighbours.size() > 2) return false;
      if (neighbours.size() == 1) ++open_edges;
      for (const int neighbour : neighbours) {
        if (std::find(reached.begin(), reached.end(), neighbour) == reached.end()) reached.push_back(neighbour);
      }
    }
  }
  return reached.size() == fan.size() && open_edges <= 2;
}

void check_vertices(int vertex_count, std::span<const Eigen::Vector3i> triangles, MeshTopology& topology) {
  std::vector<int> fan_begin(static_cast<std::size_t>(vertex_count) + 1, 0), fans(3 * triangles.size()), reached;
  for (const Eigen::Vector3i& triangle : triangles) {
    for (const int vertex : triangle) ++fan_begin[vertex + 1];
  }
  std::partial_sum(fan_begin.begin(), fan_begin.end(), fan_begin.begin());
  std::vector<int> next(fan_begin.begin(), fan_begin.end() - 1);
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
    for (const int vertex : triangles[t]) fans[next[vertex]++] = t;
  }
  int used = 0;
  for (int v = 0; v < vertex_count; ++v) {
    const auto fan = std::span<const int>(fans).subspan(fan_begin[v], fan_begin[v + 1] - fan_begin[v]);
    if (fan.empty()) continue;
    ++used;
    if (!is_one_fan(v, fan, topology, reached)) topology.non_manifold_vertices.push_back(v);
  }
  topology.euler_characteristic =
      used - static_cast<int>(topology.edges.size()) + static_cast<int>(topology.triangle_edges.size());
}

void collect_boundary_loops(std::span<const Eigen::Vector3i> triangles, MeshPieces& topology) {
  std::map<int, std::vector<int>> following;  // vertex -> the ends of open edges that start there
  for (const int edge : topology.open_edges) {
    const int t = triangles_at(topology, edge).front();
    for (int k = 0; k < 3; ++k) {
      if (topology.triangle_edges[t][k] == edge) following[triangles[t][k]].push_back(triangles[t][(k + 1) % 3]);
    }
  }
  for (auto& [start, ends] : following) {
    while (!ends.empty()) {
      std::vector<int> loop = {start};
      for (int v = start;;) {
        const auto found = following.find(v);
        // Only where triangles of contrary sense meet at the rim does a walk end before it closes.
        if (found == following.end() || found->second.empty()) break;
        v = found->second.front();
        found->second.erase(found->second.begin());
        if (v == start) break;
        loop.push_back(v);
      }
      topology.boundary_loops.push_back(std::move(loop));
    }
  }
}

}  // namespace

MeshPieces pieces_of(int vertex_count, std::span<const Eigen::Vector3i> triangles) {
  MeshPieces pieces{edges_of(vertex_count, triangles), {}, {}, 0};
  collect_components(pieces);
  collect_boundary_loops(triangles, pieces);
  return pieces;
}

MeshTopology topology_of(int vertex_count, std::span<const Eigen::Vector3i> triangles) {
  MeshTopology topology{pieces_of(vertex_count, triangles), {}, 0};
  check_vertices(vertex_count, triangles, topology);
  return topology;
}

std::vector<Eigen::Vector3i> closed_surface(const SurfaceMesh& mesh) {
  std::vector<Eigen::Vector3i> surface = mesh.triangles;
  surface.insert(surface.end(), mesh.cap_triangles.begin(), mesh.cap_triangles.end());
  return surface;
}

}  // namespace thinwall
