#include "studio/organs/ClosedCheck.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/mesh/MeshMeasures.hpp"
#include "engine/mesh/MeshTopology.hpp"

namespace thinwall {
namespace {

/// How many edges, vertices or components are told before the rest is only counted.
constexpr std::size_t kToldAtMost = 3;

class ClosedCheck {
 public:
  ClosedCheck(const SurfaceMesh& mesh, const SurfaceOrigin& origin)
      : mesh_(mesh),
        origin_(origin),
        surface_(closed_surface(mesh)),
        topology_(topology_of(static_cast<int>(mesh.vertices.size()), surface_)) {}

  std::vector<Diagnostic> run() {
    check_open_edges();
    check_edges(topology_.crowded_edges, "shared by more than two triangles",
                "the wall branches there; take the inner surfaces out of the mesh");
    check_edges(topology_.contrary_edges, "between triangles that face opposite ways", "turn one side of them over");
    check_vertices();
    check_components();
    return std::move(errors_);
  }

 private:
  void add(const std::string& what) {
    errors_.push_back({origin_.location, fmt::format("{}: {}: {}", origin_.key_path, origin_.name, what)});
  }

  std::string place_of(int vertex) const {
    const Eigen::Vector3d p = mesh_.vertices[vertex] / origin_.unit;
    // Adding zero turns -0 into 0.
    const auto tidy = [](double x) { return std::abs(x) < 1e-12 ? 0.0 : x; };
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", tidy(p[0]), tidy(p[1]), tidy(p[2]));
  }

  template <typename Describe>
  std::string list(const std::vector<int>& items, const Describe& describe) const {
    std::string text;
    for (std::size_t i = 0; i < std::min(items.size(), kToldAtMost); ++i) {
      text += (i == 0 ? "" : ", ") + describe(items[i]);
    }
    if (items.size() > kToldAtMost) text += fmt::format(" and {} more", items.size() - kToldAtMost);
    return text + ", in " + origin_.unit_name;
  }

  std::string edges_text(const std::vector<int>& edges) const {
    return list(edges,
                [&](int e) { return place_of(topology_.edges[e][0]) + " to " + place_of(topology_.edges[e][1]); });
  }

  void check_open_edges() {
    if (topology_.open_edges.empty()) return;
    add(
        fmt::format("the fluid needs a closed surface, but this has {} around {}: {}; close the surface, or say "
                    "`contents: {{ fluid: none }}`",
                    counted(topology_.open_edges.size(), "open edge", "open edges"),
                    counted(topology_.boundary_loops.size(), "hole", "holes"), edges_text(topology_.open_edges)));
  }

  void check_edges(const std::vector<int>& edges, const char* fault, const char* cure) {
    if (edges.empty()) return;
    add(fmt::format("the fluid needs a surface with one inside, but this has {} {}: {}; {}",
                    counted(edges.size(), "edge", "edges"), fault, edges_text(edges), cure));
  }

  void check_vertices() {
    // At the end of a crowded edge the vertex is at fault too; telling it again would hide what is to be mended.
    if (topology_.non_manifold_vertices.empty() || !topology_.crowded_edges.empty()) return;
    const std::vector<int>& vertices = topology_.non_manifold_vertices;
    add(fmt::format(
        "the fluid needs a surface that touches itself nowhere, but this has {} in which parts of it touch: "
        "{}; move the parts apart there",
        counted(vertices.size(), "vertex", "vertices"), list(vertices, [&](int v) { return place_of(v); })));
  }

  void check_components() {
    if (topology_.component_count < 2) return;
    std::vector<int> sizes(topology_.component_count, 0);
    std::vector<double> areas(topology_.component_count, 0);
    const std::vector<double> triangle_area = triangle_areas(mesh_.vertices, surface_);
    double whole = 0;
    for (std::size_t t = 0; t < surface_.size(); ++t) {
      ++sizes[topology_.triangle_component[t]];
      areas[topology_.triangle_component[t]] += triangle_area[t];
      whole += triangle_area[t];
    }
    std::vector<int> order(sizes.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return areas[a] > areas[b]; });
    std::string text;
    for (std::size_t i = 0; i < std::min(order.size(), kToldAtMost); ++i) {
      text += fmt::format("{}{} triangles with {:.1f} % of the area", i == 0 ? "" : ", ", sizes[order[i]],
                          100 * areas[order[i]] / whole);
    }
    if (order.size() > kToldAtMost) text += fmt::format(" and {} more", order.size() - kToldAtMost);
    add(
        fmt::format("a body with fluid is one closed surface, but this has {} separate ones: {}; keep one of them, or "
                    "make a body of each (parts of under 1 % of the area together are left out by themselves)",
                    sizes.size(), text));
  }

  const SurfaceMesh& mesh_;
  const SurfaceOrigin& origin_;
  std::vector<Eigen::Vector3i> surface_;
  MeshTopology topology_;
  std::vector<Diagnostic> errors_;
};

}  // namespace

void check_closed_for_fluid(const SurfaceMesh& mesh, const SurfaceOrigin& origin) {
  std::vector<Diagnostic> errors = ClosedCheck(mesh, origin).run();
  if (!errors.empty()) throw InputErrors(std::move(errors));
}

}  // namespace thinwall
