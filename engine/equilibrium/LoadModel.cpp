#include "engine/equilibrium/LoadModel.hpp"

#include <stdexcept>

#include "engine/mesh/MeshTopology.hpp"

namespace thinwall {
namespace {

/// An edge of the wall in a region.
struct RegionEdge {
  std::array<int, 2> vertices;
  int triangle;   // one of its triangles
  int edge;       // index
  double length;  // metres
};

/// Edges with both ends in the region: the open ones only where there are any, because a load on a border is not meant
/// for the row of edges that runs into it.
std::vector<RegionEdge> edges_in(const Region& region, const SurfaceMesh& mesh) {
  std::vector<char> inside(mesh.vertices.size(), 0);
  for (const int vertex : vertices_in(region, mesh)) inside[vertex] = 1;
  const MeshEdges edges = edges_of(static_cast<int>(mesh.vertices.size()), mesh.triangles);
  std::vector<RegionEdge> open, all;
  for (int edge = 0; edge < static_cast<int>(edges.edges.size()); ++edge) {
    const auto [a, b] = edges.edges[edge];
    if (!inside[a] || !inside[b]) continue;
    const auto triangles = triangles_at(edges, edge);
    all.push_back({{a, b}, triangles[0], edge, (mesh.vertices[a] - mesh.vertices[b]).norm()});
    if (triangles.size() == 1) open.push_back(all.back());
  }
  return open.empty() ? all : open;
}

double length_of(const std::vector<RegionEdge>& edges) {
  double length = 0;
  for (const RegionEdge& edge : edges) length += edge.length;
  return length;
}

[[noreturn]] void refuse(const char* what) {
  throw std::invalid_argument(std::string("the region holds no ") + what + " that the load could act on");
}

/// Weight of each vertex in an even load on triangles, edges or else the vertices of the region: metres^2, metres or 1.
Eigen::VectorXd vertex_shares(const Region& region, const SurfaceMesh& mesh, const std::vector<double>& area) {
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(mesh.vertices.size()));
  for (const int t : triangles_in(region, mesh)) {
    for (const int vertex : mesh.triangles[t]) shares[vertex] += area[t] / 3;
  }
  if (shares.sum() > 0) return shares;
  for (const RegionEdge& edge : edges_in(region, mesh)) {
    for (const int vertex : edge.vertices) shares[vertex] += edge.length / 2;
  }
  if (shares.sum() > 0) return shares;
  for (const int vertex : vertices_in(region, mesh)) shares[vertex] = 1;
  if (shares.sum() == 0) refuse("vertices");
  return shares;
}

Eigen::VectorXd spread(const Eigen::VectorXd& shares, const Eigen::Vector3d& force) {
  Eigen::VectorXd all(3 * shares.size());
  for (Eigen::Index v = 0; v < shares.size(); ++v) all.segment<3>(3 * v) = shares[v] * force;
  return all;
}

Eigen::VectorXd surface_force(const LoadDefinition& load, const SurfaceMesh& mesh, const std::vector<double>& weight) {
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(mesh.vertices.size()));
  for (const int t : triangles_in(load.region, mesh)) {
    for (const int vertex : mesh.triangles[t]) shares[vertex] += weight[t] / 3;
  }
  if (shares.sum() == 0) refuse("triangles");
  return spread(shares, load.vector);
}

Eigen::VectorXd line_force(const LoadDefinition& load, const SurfaceMesh& mesh) {
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(mesh.vertices.size()));
  for (const RegionEdge& edge : edges_in(load.region, mesh)) {
    for (const int vertex : edge.vertices) shares[vertex] += edge.length / 2;
  }
  if (shares.sum() == 0) refuse("edges");
  return spread(shares, load.vector);
}

std::vector<MomentLever> moment_levers(const LoadDefinition& load, const SurfaceMesh& mesh) {
  const std::vector<RegionEdge> edges = edges_in(load.region, mesh);
  if (edges.empty()) refuse("edges");
  const double whole = length_of(edges);
  std::vector<MomentLever> levers;
  for (const RegionEdge& edge : edges) {
    MomentLever lever{.triangle = edge.triangle, .moment = load.vector.norm() * edge.length / whole, .edge = edge.edge};
    for (int k = 0; k < 3; ++k) {
      const int vertex = mesh.triangles[edge.triangle][k];
      lever.weights[k] = vertex == edge.vertices[0] || vertex == edge.vertices[1] ? -0.5 : 1;
    }
    levers.push_back(lever);
  }
  return levers;
}

}  // namespace

LoadModel make_load_model(const LoadDefinition& load, const SurfaceMesh& mesh, const std::vector<double>& area,
                          const std::vector<double>& thickness) {
  LoadModel model{.kind = load.kind, .force = {}, .pressure = load.pressure, .triangles = {}, .levers = {}};
  std::vector<double> volume(area);
  for (std::size_t t = 0; t < volume.size(); ++t) volume[t] *= thickness[t];
  switch (load.kind) {
    case LoadKind::kFollowerPressure:
      model.triangles = triangles_in(load.region, mesh);
      if (model.triangles.empty()) refuse("triangles");
      break;
    case LoadKind::kDeadTraction:
      model.force = surface_force(load, mesh, area);
      break;
    case LoadKind::kDeadBodyForce:
      model.force = surface_force(load, mesh, volume);
      break;
    case LoadKind::kDeadLineForce:
      model.force = line_force(load, mesh);
      break;
    case LoadKind::kDeadForce: {
      const Eigen::VectorXd shares = vertex_shares(load.region, mesh, area);
      model.force = spread(shares / shares.sum(), load.vector);
      break;
    }
    case LoadKind::kDeadMoment:
      if (load.vector.isZero()) break;
      model.axis = load.vector.normalized();
      model.levers = moment_levers(load, mesh);
      break;
  }
  return model;
}

void add_turns(const SurfaceMesh& mesh, std::span<const BendingRest> bending, LoadModel& load) {
  if (bending.empty()) return;
  for (MomentLever& lever : load.levers) {
    const BendingRest& triangle = bending[lever.triangle];
    for (int side = 0; side < 3; ++side) {
      const BendingSide& own = triangle.sides[side];
      if (triangle.edges[side] != lever.edge || own.share != 0) continue;
      const Eigen::Vector3d along =
          mesh.vertices[triangle.vertices[(side + 1) % 3]] - mesh.vertices[triangle.vertices[side]];
      // A side that bends towards the normal turns against its own sense.
      lever.turn = -own.turn_share * along.normalized().dot(load.axis);
    }
  }
}

}  // namespace thinwall
