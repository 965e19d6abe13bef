#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/cutting/CapRim.hpp"
#include "engine/cutting/Cut.hpp"
#include "engine/cutting/CutPatch.hpp"
#include "engine/mesh/SurfaceMesh.hpp"

namespace thinwall {

/// A triangulated wall that can be cut, again and again. All geometry is that of the rest shape.
///
/// Incidence is exact: what a path crosses is told by combinatorial positions (vertex, edge with parameter, facet), and
/// neighbours are kept across edges, never found again from coordinates. Predicates in floating point only choose among
/// changes within one flat piece (facet) of the original surface, where any choice is a valid mesh; so rounding can
/// cost quality, which is checked, but never consistency. Exact predicates would not do: the lines of a path are
/// rounded anyway as soon as its nodes are.
///
/// The snapping bound: a cut deviates from its path by at most the longest edge of the triangles around it, and by less
/// than a quarter of an edge nearly everywhere; where a path would be missed by more than three quarters with new nodes
/// and with the edges that are there, the nearer of the two is taken. In flat pieces larger than a triangle a cut
/// follows the path itself. With `CutOptions::edge_length` the edges there, and so the bound, become as small as
/// wanted, with `CutOptions::deviation` only where that is needed. A cut that ends within the wall may stop short by up
/// to about one edge length; `Cut::rest` leads on.
///
/// A cut costs what it touches: it is tried out on a patch of the surface and written back when it holds.
class CutSurface {
 public:
  /// The wall must be an oriented manifold. Throws std::invalid_argument otherwise.
  explicit CutSurface(SurfaceMesh mesh);

  const SurfaceMesh& mesh() const { return mesh_; }
  /// (wall triangles), the connected piece of the wall that each belongs to.
  std::span<const int> components() const { return component_; }
  int component_count() const { return component_count_; }
  /// (wall triangles x 3), the triangle across the side from corner k to corner k + 1; less than zero at an open edge.
  std::span<const Eigen::Vector3i> neighbours() const { return neighbours_; }
  /// Whether the side from corner k to corner k + 1 is open because a cut opened it.
  bool is_lip(int triangle, int side) const { return neighbours_[triangle][side] == CutPatch::kLip; }

  /// Cuts along a path on the surface as it is now and says what changed; nothing where the path has no length or is
  /// too short to be cut yet: then `rest` is the whole path. A path that comes back along itself or along an open
  /// border cuts nothing there; the rim of a cap is such a border: the wall does not come off its cap.
  /// Throws std::invalid_argument where the path leaves the surface.
  Cut cut(const CutPath& path, const CutOptions& options = {});

 private:
  struct PatchNumbers;
  struct Plan;

  SurfaceMesh mesh_;
  std::vector<Eigen::Vector3i> neighbours_;
  std::vector<int> vertex_triangle_;            // (vertices), -1: used by no wall triangle
  std::vector<int> facet_;                      // (wall triangles), into facet_normals_
  std::vector<Eigen::Vector3d> facet_normals_;  // unit
  std::vector<double> scale_;                   // (wall triangles), metres, mean edge length of the original triangle
  std::vector<int> component_;
  int component_count_ = 0;
  CapRim rim_;
  std::vector<std::pair<std::string, std::vector<char>>> is_member_;  // per group: (vertices)

  void check_path(const CutPath& path) const;
  std::vector<int> fan_of(int vertex) const;
  Eigen::Vector3d position_of(const SurfacePoint& point) const;
  std::vector<int> triangles_near(const CutPath& path, int rings) const;
  CutPatch extract(const CutPath& path, const CutOptions& options, int rings, PatchNumbers& numbers) const;
  double edge_length_at(const CutPath& path) const;
  Plan start_of(const CutPath& path, const CutOptions& options, int rings) const;
  Plan plan(const CutPath& path, const CutOptions& options) const;
  Plan plan_close(const CutPath& path, const CutOptions& options) const;
  void find_facets();

  void add_vertices(const CutPatch& before, const CutPatch& after, std::span<const int> originals,
                    PatchNumbers& numbers, Cut& result);
  void add_to_groups(int first_new, const PatchNumbers& numbers, const Cut& result);
  void change_rim(const std::vector<std::vector<int>>& chains, std::span<const RimOpening> rims,
                  const PatchNumbers& numbers);
  void write_back(const CutPatch& before, const CutPatch& after, PatchNumbers& numbers, Cut& result);
  void separate(Cut& result);
  std::vector<std::vector<int>> wound_loops(std::span<const Lips> lips) const;
  int next_on_border(int vertex) const;
};

}  // namespace thinwall
