#include "studio/organs/ClosedCheck.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <vector>

#include "engine/mesh/MeshMeasures.hpp"
#include "engine/mesh/MeshTopology.hpp"
#include "studio/organs/ToldPlaces.hpp"

namespace thinwall {
namespace {

class ClosedCheck {
 public:
  ClosedCheck(const SurfaceMesh& mesh, const SurfaceOrigin& origin, const std::string& cure, int parts)
      : mesh_(mesh),
        parts_(parts),
        origin_(origin),
        cure_(cure),
        surface_(closed_surface(mesh)),
        topology_(topology_of(static_cast<int>(mesh.vertices.size()), surface_)) {}

  std::vector<Diagnostic> run() {
    check_open_edges();
    check_edges(topology_.crowded_edges, "shared by more than two triangles",
                parts_ > 1
                    ? "the wall branches there; give each chamber a closed wall of its own, with a gap between them"
                    : "the wall branches there; take the inner surfaces out of the mesh");
    check_edges(topology_.contrary_edges, "between triangles that face opposite ways", "turn one side of them over");
    check_vertices();
    check_components();
    return std::move(errors_);
  }

 private:
  void add(const std::string& what) {
    errors_.push_back({origin_.location, fmt::format("{}: {}: {}", origin_.key_path, origin_.name, what)});
  }

  std::string place_of(int vertex) const { return place_text(mesh_.vertices[vertex] / origin_.unit); }

  std::string edges_text(const std::vector<int>& edges) const {
    return told_places(
        edges, [&](int e) { return place_of(topology_.edges[e][0]) + " to " + place_of(topology_.edges[e][1]); },
        origin_.unit_name);
  }

  void check_open_edges() {
    if (topology_.open_edges.empty()) return;
    add(fmt::format(
        "the fluid needs a closed surface, but this has {} around {}: {}; {}, or say `contents: {{ "
        "fluid: none }}`",
        counted(topology_.open_edges.size(), "open edge", "open edges"),
        counted(topology_.boundary_loops.size(), "hole", "holes"), edges_text(topology_.open_edges), cure_));
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
        counted(vertices.size(), "vertex", "vertices"),
        told_places(
            vertices, [&](int v) { return place_of(v); }, origin_.unit_name)));
  }

  void check_components() {
    if (topology_.component_count <= parts_) return;
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
        fmt::format("a body with fluid is one closed surface, but this has {} separate ones: {}; keep one of them, "
                    "name each in `contents.chambers`, or make a body of each (parts of under 1 % of the area together "
                    "are left out by themselves)",
                    sizes.size(), text));
  }

  const SurfaceMesh& mesh_;
  int parts_;
  const SurfaceOrigin& origin_;
  const std::string& cure_;
  std::vector<Eigen::Vector3i> surface_;
  MeshTopology topology_;
  std::vector<Diagnostic> errors_;
};

}  // namespace

void check_closed_for_fluid(const SurfaceMesh& mesh, const SurfaceOrigin& origin, const std::string& cure, int parts) {
  std::vector<Diagnostic> errors = ClosedCheck(mesh, origin, cure, parts).run();
  if (!errors.empty()) throw InputErrors(std::move(errors));
}

}  // namespace thinwall
