#include "engine/contact/ContactSites.hpp"

#include <algorithm>
#include <map>

namespace thinwall {

std::vector<ContactSite> contact_sites(int vertices, std::span<const Eigen::Vector3i> triangles,
                                       std::span<const double> areas) {
  std::vector<ContactSite> corners(vertices), edges;
  std::vector<char> used(vertices, 0);
  std::map<std::pair<int, int>, std::size_t> edge_index;
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int vertex = triangles[t][k];
      if (!used[vertex]) corners[vertex] = {.part = SitePart::kCorner, .triangle = t, .corner = k, .area = 0};
      used[vertex] = 1;
      corners[vertex].area += areas[t] / 3;
      const auto [place, is_new] = edge_index.emplace(std::minmax(vertex, triangles[t][(k + 1) % 3]), edges.size());
      if (is_new) edges.push_back({.part = SitePart::kEdge, .triangle = t, .corner = k, .area = 0});
      edges[place->second].area += areas[t] / 3;
    }
  }
  std::vector<ContactSite> sites;
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
