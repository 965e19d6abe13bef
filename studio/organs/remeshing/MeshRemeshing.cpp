#include "studio/organs/remeshing/MeshRemeshing.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "engine/mesh/MeshTopology.hpp"
#include "studio/organs/remeshing/Remeshing.hpp"
#include "studio/organs/remeshing/SurfaceTree.hpp"

namespace thinwall {
namespace {

constexpr double kCreaseAngle = 50 * std::numbers::pi / 180;  // radians

/// Of the wanted edge length.
constexpr double kShortestCrease = 2;

/// Times that the surface is made anew with what it has left kept: what is kept leads other parts astray.
constexpr int kRoundsOfKeeping = 4;

/// Corners, and the middles of edges and triangles.
std::vector<Eigen::Vector3d> samples_of(const TriangleSurface& surface) {
  std::vector<Eigen::Vector3d> samples = surface.vertices;
  for (const Eigen::Vector3i& t : surface.triangles) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
      sum += surface.vertices[t[k]];
      samples.push_back((surface.vertices[t[k]] + surface.vertices[t[(k + 1) % 3]]) / 2);
    }
    samples.push_back(sum / 3);
  }
  return samples;
}

double largest_distance(const TriangleSurface& from, const SurfaceTree& to) {
  double largest = 0;
  for (const Eigen::Vector3d& point : samples_of(from)) largest = std::max(largest, to.closest(point).distance);
  return largest;
}

/// Makes corners of the vertices of `start`, and lines of its edges, that a surface made of it has left by more than
/// `most` metres, and says whether there were any.
bool keep_what_was_left(const TriangleSurface& start, const SurfaceTree& made, double most, FeatureLines& features) {
  bool any = false;
  const auto is_left = [&](const Eigen::Vector3d& point) { return made.closest(point).distance > most; };
  for (int v = 0; v < static_cast<int>(start.vertices.size()); ++v) {
    if (features.is_corner(v) || !is_left(start.vertices[v])) continue;
    features.keep(v);
    any = true;
  }
  for (const auto& [a, b] : edges_of(static_cast<int>(start.vertices.size()), start.triangles).edges) {
    if (features.has_edge(a, b) || !is_left((start.vertices[a] + start.vertices[b]) / 2)) continue;
    features.keep(start, a, b);
    any = true;
  }
  return any;
}

}  // namespace

RemeshedMesh remesh_to_length(const TriangleSurface& start, double edge_length) {
  const SurfaceTree tree(start);
  // What faces as the mesh does, as thin parts have two sides; what is farther than an edge belongs to another part.
  const auto project = [&](const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
    const NearestPoint facing = tree.closest_facing(point, normal);
    return facing.distance <= edge_length ? facing.position : tree.closest(point).position;
  };
  const SurfaceToFollow target{.project = project,
                               .normal = [](const Eigen::Vector3d&, const Eigen::Vector3d& normal) { return normal; }};
  RemeshingOptions options{.edge_length = edge_length,
                           .features = FeatureLines(start, kCreaseAngle, kShortestCrease * edge_length)};
  RemeshedMesh result;
  result.surface = remesh(start, target, options);
  for (int round = 0; round < kRoundsOfKeeping; ++round) {
    if (!keep_what_was_left(start, SurfaceTree(result.surface), kMostMoved * edge_length, options.features)) break;
    result.surface = remesh(start, target, options);
  }
  for (const Eigen::Vector3i& t : result.surface.triangles) {
    const Eigen::Vector3d& a = result.surface.vertices[t[0]];
    const Eigen::Vector3d& b = result.surface.vertices[t[1]];
    const Eigen::Vector3d& c = result.surface.vertices[t[2]];
    result.source.push_back(tree.closest_facing((a + b + c) / 3, (b - a).cross(c - a)).triangle);
  }
  result.largest_distance =
      std::max(largest_distance(result.surface, tree), largest_distance(start, SurfaceTree(result.surface)));
  return result;
}

}  // namespace thinwall
