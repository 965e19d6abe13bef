#include "engine/contact/ContactSites.hpp"

#include <algorithm>
#include <utility>

namespace thinwall {

std::vector<ContactSite> contact_sites(int vertices, std::span<const Eigen::Vector3i> triangles,
                                       std::span<const double> areas) {
  std::vector<ContactSite> corners(vertices), edges;
  std::vector<char> used(vertices, 0);
  // Edges by their lower vertex, in chains.
  std::vector<int> last_edge(vertices, -1), edge_before, higher_vertex;
  const std::size_t most_edges = 3 * triangles.size();
  edges.reserve(most_edges);
  edge_before.reserve(most_edges);
  higher_vertex.reserve(most_edges);
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int vertex = triangles[t][k];
      if (!used[vertex]) corners[vertex] = {.part = SitePart::kCorner, .triangle = t, .corner = k, .area = 0};
      used[vertex] = 1;
      corners[vertex].area += areas[t] / 3;
      const auto [low, high] = std::minmax(vertex, triangles[t][(k + 1) % 3]);
      int edge = last_edge[low];
      while (edge >= 0 && higher_vertex[edge] != high) edge = edge_before[edge];
      if (edge < 0) {
        edge = static_cast<int>(edges.size());
        edges.push_back({.part = SitePart::kEdge, .triangle = t, .corner = k, .area = 0});
        higher_vertex.push_back(high);
        edge_before.push_back(std::exchange(last_edge[low], edge));
      }
      edges[edge].area += areas[t] / 3;
    }
  }
  std::vector<ContactSite> sites;
  sites.reserve(corners.size() + edges.size() + triangles.size());
  for (int v = 0; v < vertices; ++v) {
    if (used[v]) sites.push_back(corners[v]);
  }
  sites.insert(sites.end(), edges.begin(), edges.end());
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
    sites.push_back({.part = SitePart::kFace, .triangle = t, .corner = 0, .area = areas[t]});
  }
  return sites;
}

}  // namespace thinwall
