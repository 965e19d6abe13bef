#include "engine/equilibrium/HeldWall.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <utility>

#include "engine/contact/SolidGap.hpp"

namespace thinwall {
namespace {

/// Part of a unit vector along an axis that is rounding.
constexpr double kNoPart = 1e-9;

/// By what the vertices of a flat wall may lie off its plane, over the length of its edges: rounding.
constexpr double kNoHeight = 1e-9;

/// By what a segment may miss a triangle, or end before it, over their sizes: what is met at an edge, or at the end of
/// a segment where the next begins, is met.
constexpr double kNoMiss = 1e-9;

/// The vertices of a site, from its corner on.
std::vector<int> vertices_of(const BodyModel& model, const ContactSite& site) {
  const int count = vertex_count_of(site.part);
  std::vector<int> vertices;
  for (int k = 0; k < count; ++k) vertices.push_back(model.surface[site.triangle][(site.corner + k) % 3]);
  return vertices;
}

}  // namespace

std::vector<char> held_against(const BodyModel& model, const Eigen::Vector3d& direction) {
  std::vector<char> held(model.vertices(), 1);
  for (int v = 0; v < model.vertices(); ++v) {
    for (int axis = 0; axis < 3; ++axis) {
      if (std::abs(direction[axis]) > kNoPart && !model.fixed[3 * v + axis]) held[v] = 0;
    }
  }
  return held;
}

bool is_held_in_its_plane(const BodyModel& model) {
  const std::vector<Eigen::Vector3d>& vertices = model.definition.mesh.vertices;
  for (int axis = 0; axis < 3; ++axis) {
    const bool is_flat = std::ranges::all_of(vertices, [&](const Eigen::Vector3d& vertex) {
      return std::abs(vertex[axis] - vertices.front()[axis]) <= kNoHeight * model.edge_length;
    });
    if (is_flat && std::ranges::all_of(held_against(model, Eigen::Vector3d::Unit(axis)), std::identity{})) return true;
  }
  return false;
}

std::vector<char> sites_in_the_way(const BodyModel& model, const Eigen::VectorXd& position, const ToolSolid& tool,
                                   const std::vector<char>& held) {
  std::vector<char> in_the_way(model.sites.size(), 0);
  std::vector<char> is_met(model.vertices(), 0);
  std::set<std::pair<int, int>> met_edges;  // vertices, the lower first
  for (std::size_t s = 0; s < model.sites.size(); ++s) {
    const ContactSite& site = model.sites[s];
    const std::vector<int> vertices = vertices_of(model, site);
    if (!std::ranges::all_of(vertices, [&](int vertex) { return held[vertex] != 0; })) continue;
    in_the_way[s] = 1;
    if (site.part == SitePart::kFace) continue;
    const auto corners = corners_of(model.surface[site.triangle], position);
    if (!solid_gap(tool, 0, corners, site.part, site.corner, GapTerms::kGradient)) continue;
    if (site.part == SitePart::kCorner) is_met[vertices[0]] = 1;
    if (site.part == SitePart::kEdge) met_edges.insert(std::minmax(vertices[0], vertices[1]));
  }
  for (std::size_t s = 0; s < model.sites.size(); ++s) {
    const std::vector<int> vertices = vertices_of(model, model.sites[s]);
    for (std::size_t k = 0; k < vertices.size(); ++k) {
      const std::pair<int, int> edge = std::minmax(vertices[k], vertices[(k + 1) % vertices.size()]);
      if (is_met[vertices[k]] || (vertices.size() == 3 && met_edges.contains(edge))) in_the_way[s] = 1;
    }
  }
  return in_the_way;
}

std::optional<SurfacePoint> held_crossing(const BodyModel& model, const Eigen::VectorXd& position,
                                          const Eigen::Vector3d& begin, const Eigen::Vector3d& end,
                                          const std::vector<char>& held, const std::vector<char>& is_free) {
  std::optional<SurfacePoint> first;
  double nearest = 1 + kNoMiss;  // part of the segment
  for (int t = 0; t < model.triangles(); ++t) {
    const Eigen::Vector3i& triangle = model.surface[t];
    if (is_free[t] || !std::ranges::any_of(triangle, [&](int vertex) { return held[vertex] != 0; })) continue;
    const auto corners = corners_of(triangle, position);
    Eigen::Matrix3d system;
    system << corners[1] - corners[0], corners[2] - corners[0], begin - end;
    const Eigen::FullPivLU<Eigen::Matrix3d> factor(system);
    if (!factor.isInvertible()) continue;
    const Eigen::Vector3d found = factor.solve(begin - corners[0]);
    const Eigen::Vector3d weights(1 - found[0] - found[1], found[0], found[1]);
    if (weights.minCoeff() < -kNoMiss || found[2] < -kNoMiss || found[2] > nearest) continue;
    nearest = found[2];
    const Eigen::Vector3d within = weights.cwiseMax(0);
    first = SurfacePoint{.triangle = t, .weights = within / within.sum()};
  }
  return first;
}

}  // namespace thinwall
