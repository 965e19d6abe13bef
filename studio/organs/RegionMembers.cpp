#include "studio/organs/RegionMembers.hpp"

#include <fmt/core.h>

#include "engine/mesh/MeshMeasures.hpp"
#include "studio/organs/SpanWords.hpp"
#include "studio/schema/Wording.hpp"

namespace thinwall {
std::vector<int> RegionMembers::triangles(const Region& region, const std::string& path,
                                          const SourceLocation& location) {
  if (!is_known(region, path, location)) return {};
  std::vector<int> found = triangles_in(region, mesh_);
  check_found(found, "wall triangle", region, path, location);
  return found;
}

std::vector<int> RegionMembers::vertices(const Region& region, const std::string& path,
                                         const SourceLocation& location) {
  if (!is_known(region, path, location)) return {};
  std::vector<int> found = vertices_in(region, mesh_);
  check_found(found, "vertex", region, path, location);
  return found;
}

void RegionMembers::edges(const Region& region, const std::string& path, const SourceLocation& location) {
  const std::vector<int> found = vertices(region, path, location);
  if (found.empty()) return;
  std::vector<char> inside(mesh_.vertices.size(), 0);
  for (const int vertex : found) inside[vertex] = 1;
  const auto has_edge = [&](const Eigen::Vector3i& corners) {
    return inside[corners[0]] + inside[corners[1]] + inside[corners[2]] >= 2;
  };
  if (std::ranges::any_of(mesh_.triangles, has_edge)) return;
  errors_.push_back({location, fmt::format("{}: holds {} of the surface, but no edge with both ends; take a larger "
                                           "region, or a `force`",
                                           path, found.size() == 1 ? "a vertex" : "vertices")});
}

void RegionMembers::check_found(const std::vector<int>& found, const char* what, const Region& region,
                                const std::string& path, const SourceLocation& location) {
  if (!found.empty()) return;
  if (std::holds_alternative<BoundaryRegion>(region)) {
    const bool is_open = !vertices_in(region, mesh_).empty();
    errors_.push_back(
        {location, fmt::format("{}: holds no {}: {}", path, what,
                               is_open ? "none has all three corners on open edges; take `plane`, `box` or "
                                         "`sphere` for the triangles beside them"
                                       : "the wall has no open edges")});
  } else {
    errors_.push_back({location, fmt::format("{}: holds no {} of the surface, which spans {}", path, what,
                                             span_words(bounding_box(mesh_.vertices)))});
  }
}

bool RegionMembers::is_known(const Region& region, const std::string& path, const SourceLocation& location) {
  const auto* group = std::get_if<GroupRegion>(&region);
  if (group == nullptr || mesh_.groups.contains(group->name)) return true;
  std::vector<std::string> names;
  for (const auto& [name, vertices] : mesh_.groups) names.push_back(name);
  errors_.push_back(
      {location, fmt::format("{}: the surface has no group {}{}; it has {}", path, in_backticks(group->name),
                             did_you_mean(group->name, names), list_in_backticks(names))});
  return false;
}

}  // namespace thinwall
